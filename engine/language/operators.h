// The words whose meaning depends on the conversation: determiners and pro-forms. A lexicon declares them as data
// (language/LEXICON.md); C++ knows their meanings, not their names.
#pragma once

#include <map>
#include <string>

#include "continua/term/term.h"

namespace continua {

/// e -> t: a property of things.
inline const Type& property() {
  static const Type type = Type::function(Type::entity(), Type::truth());
  return type;
}

/// A determiner: a constant of type (e -> t) -> e, or (e -> t) -> e* for several objects.
struct Determiner {
  bool definite = false;  ///< presupposes that one thing (or one group) is meant: more are a question, none is told
  bool many = false;      ///< all that fit are meant: those, all
  bool deictic = false;   ///< goes with pointing: this, that
  bool other = false;     ///< not the one of them in focus: another
  int count = 0;          ///< so many are meant: two; 0: says nothing
};

/// A word that stands for something said, shown or present.
struct Proform {
  enum class Source {
    focus,    ///< it, them: the thing under discussion
    pointed,  ///< here, there: where the human points
    topic,    ///< one: the noun that was last used; a constant of type e -> t
    other,  ///< a constant of type e -> t: true of all but the first in focus that fits, or but the subject of the noun
            ///< around is about
    avatar,  ///< you
    human,   ///< me
  };
  Source source = Source::focus;
};

struct Operators {
  std::map<std::string, Determiner, std::less<>> determiners;
  std::map<std::string, Proform, std::less<>> proforms;
  /// The name, of type e*, of the things that "leftmost" and its like compare. It is defined as all there is; in a noun
  /// phrase that answers a question, as the things asked about. Empty: there is no such name.
  std::string compared;
};

/// The determiner of a noun phrase, determiner(condition); null if the term is no noun phrase.
const Determiner* determiner_of(const Term& term, const Operators& operators);
/// The pro-form of the constant; null if the term is no pro-form.
const Proform* proform_of(const Term& term, const Operators& operators);
/// Whether a pro-form of type e -> t with this source ("one", "other") occurs in it.
bool says(const Term& term, Proform::Source source, const Operators& operators);

}  // namespace continua
