// An input of the automaton: a symbol, and the terms that come with it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "continua/term/term.h"

namespace continua {

/// Terms that an input does not carry are null.
struct Input {
  int serial = 0;            ///< names the input in `because`
  std::vector<int> because;  ///< other sources that it draws on, such as a pointing bound to its words (stack.h)
  std::string symbol;
  double confidence = 1;
  double now_s = 0;

  Term target;    ///< loc: where it points
  Term said;      ///< text: its words
  Term gesture;   ///< text: the name of the gesture
  Term sign;      ///< text: the taught gesture that was shown last, this one or an earlier one
  Term sign_at;   ///< num: when that was, seconds
  Term pointing;  ///< e* • loc: of a pointing alone, the things there and the place, until a type selects a half
  Term pointed;   ///< loc: where the human pointed last, if that was just now
  Term pointed_confidence;  ///< num: the recogniser's, of that pointing

  Term act;        ///< t: at the end of an act, its program
  Term reason;     ///< text: at the end of an act, the reason of its outcome in the log's words; null without a reason
  Term why;        ///< text: the code of that reason
  Term concerned;  ///< e*: the objects and participants that the reason is about, the most important first

  // For the input `unsure`: the readings that the recogniser is not sure of, the surest first.
  Term doubted;           ///< num*: their numbers, for the effect `attend`
  Term doubted_words;     ///< text*: their words; '' for gestures
  Term doubted_meanings;  ///< term*: their meanings; the kind of the move if it has no other

  // Moves of another avatar that was observed after this input (Machine::implied).
  Term observed_speech;    ///< text: its latest utterance
  Term observed_gestures;  ///< term*
  Term observed_acts;      ///< term*

  // The understanding, for machines with a lexicon (automaton/FORMAT.md, Understanding).
  Term move;       ///< text: the kind of move: 'V', 'N', 'δ', …
  Term reading;    ///< the words as a term, with noun phrases: put(the(\x. knife(x)), there)
  Term meaning;    ///< their meaning here and now: \v: loc. put(knife, v)
  Term choices;    ///< e**: for each argument that `meaning` lacks, the objects it may be
  Term wanted;     ///< text*: for each argument that `meaning` lacks, the words that were to name it, or ''
  Term referents;  ///< e*: possible objects of the noun phrase or the pointing, the likeliest first
  Term named;      ///< (e -> t)*: the nouns of the words, each with its adjectives, then alone
  Term next;       ///< text: the kind of the utterance's next move after this one; null if there is none
  Term previous;   ///< text: the kind of its move before this one; null if this is the first
  Term joined;     ///< text: the words between it and the move before it in its sentence; null if it is the first there
  Term quoted;     ///< t: whether all its words stand in quotation marks, and others of its utterance do not
  Term following;  ///< text*: the kinds of the moves that follow it in its sentence
  Term later;      ///< text*: the kinds of the moves in later sentences of its utterance
  Term unknown;    ///< text*: words near it that the lexicon does not have
  Term repaired;   ///< text*: misspelt words that were read as others
  Term left_out;   ///< text*: words of its sentence that are unknown, not surely repaired, or fit nowhere
};

/// A term of an input, with the name and type under which machines know it.
struct Carried {
  const char* name;
  const char* type;
  Term Input::*term;
  bool understood = false;  ///< known only to machines with a lexicon
};
std::span<const Carried> carried_terms();

}  // namespace continua
