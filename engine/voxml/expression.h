// VoxML's notation for events, conditions, places and parts, as published documents write it in the attributes of
// subevents and affordances: grasp(x,y), hold(x,y)^!at(y,z), put(x, on([1])), def(loc(y),as('l1')).
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct Expression {
  enum class Kind {
    name,       ///< x, z, E_y, VoxSimPlatform.Pathfinding.AStarSearch.PlanPath
    call,       ///< name(arguments)
    component,  ///< [2]: the part of the voxeme that has this number; the number is in `name`
    text,       ///< '…', without its quotation marks
    negation,   ///< !a
    both,       ///< a ^ b
    either,     ///< a | b
  };
  Kind kind = Kind::name;
  std::string name;  ///< y, handle[2], or a place in numbers: <0.5; 0.9; -0.1>
  std::vector<Expression> arguments;

  friend bool operator==(const Expression&, const Expression&) = default;
};

/// As documents write it, with a space after commas and around ^ and |. REQUIRES two or more arguments of `both` and
/// `either`, one of `negation`.
std::string print(const Expression& expression);

/// Also written: && and ∧ for ^, || and ∨ for |, ¬ and ~ for !, → for ->, "…" for '…', `;` for the comma of lists. A
/// chain of ^ or of | is one list, however it was bracketed. Errors name the text found, the text expected and the
/// character of `text`; brackets more than 100 deep are an error.
Result<Expression> parse_expression(std::string_view text);

/// One step of a program (SEMANTICS.md §4).
struct Subevent {
  enum class When {
    always,  ///< event
    once,    ///< if(condition):event, or condition->event
    during,  ///< while(condition):event, or while(condition, event)
  };
  When when = When::always;
  Expression condition;  ///< of `once` and `during`
  Expression event;      ///< of `during`, an empty name where the document gives none: while(hold(x,y)^!at(y,z))

  friend bool operator==(const Subevent&, const Subevent&) = default;
};
std::string print(const Subevent& subevent);

/// Brackets around the whole and closing ones that are missing at the end or too many are tolerated, as published
/// documents have them: [while(hold(x,y),move(x)].
/// A label before a step is passed over: E1 = grasp(x,y).
Result<Subevent> parse_subevent(std::string_view text);
/// Steps in one text, with semicolons between them; there is at least one.
Result<std::vector<Subevent>> parse_subevents(std::string_view text);

/// An affordance of an object: habitat -> [event] result (VoxML §5; H[4],hold(x,[1])->[stir([1])]).
struct Affordance {
  std::string habitat;                 ///< number of the habitat that must hold; empty: any (a bare H)
  std::vector<Expression> conditions;  ///< that must hold besides it
  Expression event;                    ///< several as `both` of them
  std::vector<Expression> results;     ///< conditions that hold afterwards; may be empty

  friend bool operator==(const Affordance&, const Affordance&) = default;
};
std::string print(const Affordance& affordance);
/// Its habitat as H, H2, H_2, H[2] or H_[2]; without any before the arrow it is a bare H. Several events, conditions or
/// results stand between , ; or ^. Closing brackets as in parse_subevent.
Result<Affordance> parse_affordance(std::string_view text);

}  // namespace continua
