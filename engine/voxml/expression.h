// VoxML's notation for events, conditions, places and parts, as published documents write it in attributes of subevents
// and affordances: grasp(x,y), hold(x,y)^!at(y,z), put(x, on([1])), def(loc(y),as('l1')).
#pragma once

#include <string>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct Expression {
  enum class Kind {
    name,       ///< x, z, E_y, VoxSimPlatform.Pathfinding.AStarSearch.PlanPath
    call,       ///< name(arguments); vec(x -> y × z), a vector from x through y onto z, has the arguments x, y, z
    component,  ///< [2]: the part of the voxeme with this number; the number is in `name`
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

/// Whether it is a vector from an agent through a finger onto a place: vec(x -> y × z).
bool is_vector(const Expression& expression);

/// Prints the notation of documents, with a space after commas and around ^ and |. REQUIRES two or more arguments of
/// `both` and `either`, one of `negation`.
std::string print(const Expression& expression);

/// Other spellings are read too: * for × in vectors, && and ∧ for ^, || and ∨ for |, ¬ and ~ for !, → for ->, "…" for
/// '…', `;` for the comma of lists. The operands of ^ or | become one list, however they were bracketed. Errors name
/// the found and the expected text, and the character of `text`. Brackets more than 100 deep are an error.
Result<Expression> parse_expression(std::string_view text);

/// A step of a program (SEMANTICS.md §4).
struct Subevent {
  enum class When {
    always,  ///< event
    once,    ///< if(condition):event, or condition->event
    during,  ///< while(condition):event, or while(condition, event)
  };
  When when = When::always;
  Expression condition;  ///< of `once` and `during`
  Expression event;      ///< `during`: an empty name if the document has none: while(hold(x,y)^!at(y,z))

  friend bool operator==(const Subevent&, const Subevent&) = default;
};
std::string print(const Subevent& subevent);

/// Tolerates faults of published documents: brackets around the whole, and missing or surplus closing brackets at the
/// end: [while(hold(x,y),move(x)]. A label before a step is skipped: E1 = grasp(x,y).
Result<Subevent> parse_subevent(std::string_view text);
/// Reads steps with semicolons between them; there is at least one.
Result<std::vector<Subevent>> parse_subevents(std::string_view text);

/// An affordance of an object: habitat -> [event] result (VoxML §5; H[4],hold(x,[1])->[stir([1])]).
struct Affordance {
  std::string habitat;                 ///< number of the habitat that must hold; empty: any (a bare H)
  std::vector<Expression> conditions;  ///< further conditions that must hold
  Expression event;                    ///< several events are one `both`
  std::vector<Expression> results;     ///< conditions that hold afterwards; may be empty

  friend bool operator==(const Affordance&, const Affordance&) = default;
};
std::string print(const Affordance& affordance);
/// Reads an affordance. Its habitat is H, H2, H_2, H[2] or H_[2]; without a habitat before the arrow it is a bare H.
/// Several events, conditions or results are separated by , ; or ^. Closing brackets as in parse_subevent().
Result<Affordance> parse_affordance(std::string_view text);

}  // namespace continua
