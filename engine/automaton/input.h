// An input of the automaton: a symbol, and its content.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "continua/term/term.h"

namespace continua {

/// Terms that an input does not carry are null.
struct Input {
  int serial = 0;            ///< names the input in `because`
  std::vector<int> because;  ///< serials of other inputs that it draws on: a pointing that goes with its words
  std::string symbol;
  double confidence = 1;
  double now_s = 0;

  Term target;   ///< loc: where it points
  Term said;     ///< text: its words
  Term gesture;  ///< text: the name of the gesture
  Term pointed;  ///< loc: where the human pointed last, if that was just now

  Term act;        ///< t: of the end of an act, its program
  Term reason;     ///< text: of the end of an act, the reason for its status, in the words of the log; null without a
                   ///< reason
  Term why;        ///< text: the code of that reason
  Term concerned;  ///< e*: the objects and participants that the reason is about, the most important first

  // Of another avatar that was observed after this input (Machine::implied).
  Term observed_speech;    ///< text: its last words
  Term observed_gestures;  ///< term*
  Term observed_acts;      ///< term*

  // Content that was understood, for machines with a lexicon (automaton/FORMAT.md, Understanding).
  Term move;       ///< text: the kind of move: 'V', 'N', 'δ', …
  Term reading;    ///< the words as a term, noun phrases included: put(the(\x. knife(x)), there)
  Term meaning;    ///< their meaning here and now: \v: loc. put(knife, v)
  Term choices;    ///< e**: for each argument that `meaning` lacks, the objects it may be
  Term wanted;     ///< text*: for each, the words that were to name it; '' where nothing was said
  Term referents;  ///< e*: what the noun phrase or the pointing can mean, the likeliest first
  Term named;      ///< (e -> t)*: the nouns for the objects spoken of, each with its adjectives, then alone
  Term next;       ///< text: the kind of the next move in the same utterance; null after the last
  Term unknown;    ///< text*: words near it that the lexicon does not have
  Term left_out;   ///< text*: words of its sentence that are unknown or fit nowhere
};

/// A term that inputs carry, as machines know it.
struct Carried {
  const char* name;
  const char* type;
  Term Input::*term;
  bool understood = false;  ///< known only to machines with a lexicon
};
std::span<const Carried> carried_terms();

}  // namespace continua
