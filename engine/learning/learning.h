// The human's lessons: the meaning of a gesture, the actions of a word (SEMANTICS.md §5, examples 8 and 9; paper §4).
// An overlay of values on the knowledge folder, whose files no lesson changes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/term/term.h"

namespace continua {

/// An action composed of others: \x: e. \v: loc. [grasp(x), put(x, v)].
struct Program {
  Term acts;  ///< closed; below lambdas of type e, then of type loc, a list of acts

  std::vector<Type> parameters() const;
  /// Of the program's name, with which it is used as any other: e -> loc -> t.
  Type type() const;
  bool operator==(const Program&) const = default;
};

inline constexpr std::size_t most_things = 3, most_points = 2;  ///< parameters of a program
inline constexpr std::size_t most_acts = 1000;                  ///< that one act may come to

/// Makes a program of acts. The things acted on (the first object among each act's arguments) become parameters
/// wherever they stand, in order of first appearance; after them each literal point. Other landmarks stay: [grasp(cup),
/// put(cup, on(plate)), slide(cup, <0.1, 0, 0>)] gives \x: e. \v: loc. [grasp(x), put(x, on(plate)), slide(x, v)].
/// Errors: no act, one that is null or lacks an argument, too many things or points.
Result<Program> composed(const std::vector<Term>& acts);

/// The acts of the program with these things and places. Errors: another number of them, or other types.
Result<std::vector<Term>> applied(const Program& program, const std::vector<Term>& arguments);

/// All that was taught: a value.
struct Learned {
  std::map<std::string, Term, std::less<>> gestures;     ///< name, as recognisers tell it → meaning
  std::map<std::string, Program, std::less<>> programs;  ///< word → program

  bool knows(std::string_view name) const { return gestures.contains(name) || programs.contains(name); }
  /// The latest lesson counts. Errors: those of composed(), and a program that would lead back to itself.
  Outcome learn_program(const std::string& name, Program program);
  /// The acts behind an act, step by step: an act that was not learned is itself, a learned one the acts of its
  /// program. Errors: those of applied(), more than most_acts.
  Result<std::vector<Term>> acts_of(const Term& act) const;

  bool operator==(const Learned&) const = default;
};

}  // namespace continua
