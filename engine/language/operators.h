// The words whose meaning depends on the conversation: determiners and pro-forms. A lexicon declares them as data
// (language/LEXICON.md); C++ knows their properties, not their names.
#pragma once

#include <map>
#include <string>

#include "continua/term/term.h"

namespace continua {

/// The type of a property of things, e -> t.
inline const Type& property() {
  static const Type type = Type::function(Type::entity(), Type::truth());
  return type;
}

/// A determiner: a constant of type (e -> t) -> e, or (e -> t) -> e* for several objects.
struct Determiner {
  bool definite = false;  ///< presupposes one thing or one group: with more the avatar asks, with none it says so
  bool many = false;      ///< means all that fit: those, all
  bool deictic = false;   ///< goes with pointing: this, that
  bool other = false;     ///< excludes the object in focus: another
  int count = 0;          ///< the number of things meant: two; 0: no number
};

/// A word that stands for something said, shown or present.
struct Proform {
  enum class Source {
    focus,    ///< it, them: the objects being talked about
    pointed,  ///< here, there: the place where the human points
    topic,    ///< one: the noun that was last used; a constant of type e -> t
    other,    ///< a constant of type e -> t: true of all objects except the first in focus that fits; in a nested noun
              ///< phrase, except the object that the outer phrase describes
    avatar,   ///< you
    human,    ///< me
    handled,  ///< the objects that the avatar acted on, the latest first; a constant of type e*, for conditions
  };
  Source source = Source::focus;
};

struct Operators {
  std::map<std::string, Determiner, std::less<>> determiners;
  std::map<std::string, Proform, std::less<>> proforms;
  /// The name, of type e*, for the objects that "leftmost" and its like compare. The lexicon defines it as all objects;
  /// in the answer to a question it means the objects asked about. Empty: there is no such name.
  std::string compared;
};

/// The determiner of a noun phrase determiner(condition); nullptr if the term is not a noun phrase.
const Determiner* determiner_of(const Term& term, const Operators& operators);
/// The pro-form that the constant names; nullptr if the term is not a pro-form.
const Proform* proform_of(const Term& term, const Operators& operators);
/// Whether the term contains a pro-form of type e -> t with this source ("one", "other").
bool says(const Term& term, Proform::Source source, const Operators& operators);

}  // namespace continua
