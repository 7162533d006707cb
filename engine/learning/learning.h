// The lessons of the human: meanings of gestures, and actions composed under a name (SEMANTICS.md §5, one-shot learning
// and actions in sequence; paper §4). They are values besides the knowledge folder; teaching changes none of its files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/core/shape.h"
#include "continua/term/evaluate.h"
#include "continua/term/term.h"

namespace continua {

/// An action composed of others: \x: e. \v: loc. [grasp(x), put(x, v)].
struct Program {
  Term acts;              ///< closed: a list of acts below lambdas over e, then over loc
  std::string word = {};  ///< the word that the human taught for it; if empty, its name

  std::vector<Type> parameters() const;
  /// The type of the program's name, which is used like that of any other program: e -> loc -> t.
  Type type() const;
  bool operator==(const Program&) const = default;
};

inline constexpr std::size_t most_things = 3, most_points = 2;  ///< parameters of a program
inline constexpr std::size_t most_acts = 1000;                  ///< acts that one act may expand to

/// Makes a program of acts. The theme of each act, its first object argument, becomes a parameter everywhere, in order
/// of first appearance; after these each literal point becomes one. Other landmarks stay: [grasp(cup), put(cup,
/// on(plate)), slide(cup, <0.1, 0, 0>)] gives \x: e. \v: loc. [grasp(x), put(x, on(plate)), slide(x, v)]. Errors: no
/// act, an act that is null or lacks an argument, too many things or points.
Result<Program> composed(const std::vector<Term>& acts);

/// The acts of the program with these things and places; each application is added to `made`. Errors: a wrong number of
/// arguments, or wrong types.
Result<std::vector<Term>> applied(const Program& program, const std::vector<Term>& arguments,
                                  std::vector<Application>& made);

/// All lessons: a value.
struct Learned {
  std::map<std::string, Term, std::less<>> gestures;  ///< recognisers' name of the gesture → its meaning
  /// Name of a gesture → its exemplars, the shapes that it had when it was taught (learning/shapes.h).
  std::map<std::string, std::vector<Shape>, std::less<>> shapes;
  std::map<std::string, Program, std::less<>> programs;  ///< name in terms → its program; mostly the word itself
  std::map<std::string, Term, std::less<>> nouns;        ///< word → what it is said of: \x. x = block1

  bool knows(std::string_view name) const {
    return gestures.contains(name) || program_called(name) || nouns.contains(name);
  }
  /// The program of the name, or else of the word; nullptr if there is none.
  const Program* program_called(std::string_view name) const;
  /// Adds an exemplar, unless the gesture has it already. REQUIRES !shape.empty().
  void learn_shape(const std::string& gesture, const Shape& shape);
  /// Adds or replaces the program of a name. Error: the program would lead back to itself.
  Outcome learn_program(const std::string& name, Program program);
  /// Expands an act: a taught program is replaced by its acts, these again, and so on; other acts stay. Its
  /// applications to things and places are added to `made`. Errors: those of applied(), more than most_acts.
  Result<std::vector<Term>> acts_of(const Term& act, std::vector<Application>& made) const;

  bool operator==(const Learned&) const = default;
};

}  // namespace continua
