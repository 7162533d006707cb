// From a reading to its meaning here and now, in continuation-passing style (paper §3, SEMANTICS.md §2): each noun
// phrase and pro-form is a computation that gives its referent to the rest of the sentence. Without a referent, or with
// several, the rest of the sentence is captured as a term that still waits for one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/language/reading.h"
#include "continua/language/reference.h"
#include "continua/term/raising.h"

namespace continua {

/// A variable of the meaning, which still waits for its value.
struct Gap {
  enum class Why {
    unsaid,   ///< the value is neither said nor shown: "put the knife", "put it there" without pointing
    several,  ///< the words fit more than one thing
    none,     ///< the words fit nothing: "the blue plate" without a blue plate
  };
  Why why = Why::unsaid;
  Type type = Type::entity();
  std::vector<std::string> choices;  ///< why == several: the referents, likeliest first
  std::string words;                 ///< of the noun, without its determiner ("blue plate"); empty if unsaid
  bool unshown = false;              ///< a demonstrative without a pointing: "this one"
};

/// How a noun phrase or pro-form was understood, for the log.
struct Resolution {
  enum class By { words, focus, pointed, topic, presence };  ///< presence: you, me
  Term phrase;                                               ///< as in the reading: the(\x. knife(x)), it, there
  std::string words;                                         ///< "the knife"
  Term value;                                                ///< knife, <0.1, 0.2, 0>; null where it stays open
  By by = By::words;
  std::optional<std::size_t> showing;  ///< number of the used pointing in Context::showings
  Reference reference;                 ///< of noun phrases

  /// Whether `reference` lists objects: it does for noun phrases, and for pro-forms that mean a pointed object.
  bool has_referents() const { return !reference.referents.empty() || !reference.ruled_out.empty(); }
};

/// An application with the sources of its parts, so that the log can name who said or showed them.
struct Applying {
  Application application;
  std::vector<Resolution::By> by;
};

struct Interpretation {
  /// The reading's term with objects and places in place of its noun phrases. Null for a reading of more than 1000
  /// nodes.
  /// - Each gap is a lambda, in the order in which programs take their arguments; the lambdas of the reading itself
  ///   come last, and their gaps are `unsaid`.
  /// - A noun phrase alone gives its referent, or \x. x with a gap that tells why there is none. A noun alone ("cup")
  ///   is a noun phrase for which any object that fits may be meant, and pointing counts.
  /// - A plural gives its list to the rest of the sentence. If the rest is said of each (`each : e* -> e`,
  ///   FUNCTIONS.md), it is repeated: put(each(those(\x. block(x))), v) is [put(block1, v), put(block2, v)].
  /// - In a list of commands, the objects of each command are in focus for the next.
  Term meaning;
  std::vector<Gap> gaps;
  std::vector<Resolution> resolutions;  ///< in the order of their effects: arguments before functions
  std::vector<Applying> applied;        ///< in order, each by cpsApply
};

/// `utterance_words`: the words that the reading's spans count.
Interpretation interpret(const Reading& reading, const std::vector<std::string>& utterance_words,
                         const Context& context, const Meanings& meanings, const RaisingRules& raising);

/// Index of the preferred interpretation among the readings of one fragment. Interpretations in which every noun phrase
/// fits something win; among them those that miss no pointing, then the strictest sense of Sides; ties go to the
/// earlier. So the world decides whether "the block on the plate" is one thing, or a thing and a place.
std::size_t preferred(const std::vector<Interpretation>& interpretations);

}  // namespace continua
