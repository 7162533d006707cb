// From a reading to its meaning here and now, in continuation-passing style (paper §3, SEMANTICS.md §2): each noun
// phrase and pro-form is a computation that gives its referent to the rest of the sentence. Where there is no referent,
// or more than one, the rest of the sentence is captured as a term that still waits for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/language/reading.h"
#include "continua/language/reference.h"
#include "continua/term/raising.h"

namespace continua {

/// Something that the meaning still waits for: a variable of it.
struct Gap {
  enum class Why {
    unsaid,   ///< nothing says what it is: "put the knife", "put it there" without pointing
    several,  ///< more than one thing is meant by the words
    none,     ///< nothing is: "the blue plate" where none is blue
  };
  Why why = Why::unsaid;
  Type type = Type::entity();
  std::vector<std::string> choices;  ///< why == several: the referents, likeliest first
  std::string words;                 ///< of the noun, without its determiner ("blue plate"); empty if unsaid
};

/// The meaning given to a noun phrase or pro-form, for the log.
struct Resolution {
  enum class By { words, focus, pointed, topic, presence };  ///< presence: you, me
  Term phrase;                                               ///< as in the reading: the(\x. knife(x)), it, there
  std::string words;                                         ///< "the knife"
  Term value;                                                ///< knife, <0.1, 0.2, 0>; null where it stays open
  By by = By::words;
  std::optional<std::size_t> showing;  ///< the one of the context that was drawn on
  Reference reference;                 ///< of noun phrases

  /// Whether `reference` lists the candidates: true of a noun phrase, false of a pro-form.
  bool has_referents() const { return !reference.referents.empty() || !reference.ruled_out.empty(); }
};

/// An application and the inputs that its parts drew on, so that the log can name who said or showed it.
struct Applying {
  Application application;
  std::vector<Resolution::By> by;
};

struct Interpretation {
  /// The reading's term with objects and places in place of its noun phrases. It has a lambda for each gap, in the
  /// order in which programs take them, then for the gaps of the reading itself (which are unsaid).
  /// - A noun phrase alone gives its referent, or \x. x with the gap that says why there is none.
  /// - A noun alone ("cup") is a noun phrase that may mean any, and counts pointing.
  /// - A plural gives its list to the rest of the sentence; where the rest holds of each (`each : e* -> e`,
  ///   FUNCTIONS.md), it is done for each: put(each(those(\x. block(x))), v) is [put(block1, v), put(block2, v)].
  /// - In a list of commands the objects of each are in focus for the next.
  /// Null for a reading of more than 1000 nodes.
  Term meaning;
  std::vector<Gap> gaps;
  std::vector<Resolution> resolutions;  ///< in the order of their effects: arguments before functions
  std::vector<Applying> applied;        ///< in order, each by cpsApply
};

/// `utterance_words` are those that the reading's spans count.
Interpretation interpret(const Reading& reading, const std::vector<std::string>& utterance_words,
                         const Context& context, const Meanings& meanings, const RaisingRules& raising);

/// Of readings of one fragment whose noun phrases all find something the first that takes sides least loosely (Sides),
/// else the first: the world decides between "the block on the plate" as one thing and as a thing and a place.
std::size_t preferred(const std::vector<Interpretation>& interpretations);

}  // namespace continua
