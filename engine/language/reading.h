// The parser's result: fragments of an utterance, each with its readings.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "continua/term/term.h"

namespace continua {

/// Words of an utterance, [begin, end), counted in its words.
struct WordSpan {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

/// A part of a reading's term and the words it came from: the noun phrases and the nouns in it.
struct Phrase {
  Term term;  ///< occurs in the reading's term
  WordSpan words;
};

/// A sense of a word that a reading uses, from the lexicon or from an attribute of the scene.
struct UsedSense {
  std::string words;     ///< as the entry has them, several with spaces between them
  std::string category;  ///< as the entry has it; empty: they were passed over, as it allows
  Term term;             ///< null where they were passed over
  double cost = 0;
};

/// One way to understand some words. The term still says `the(\x. cup(x) and blue(x))` and `it`: interpretation
/// (language/interpretation.h) finds their referents. A gap of a command is a variable: "put the knife" is \v.
/// put(the(\x. knife(x)), v) of type loc -> t.
struct Reading {
  Term term;
  std::string category;            ///< of the words as a whole: "S", "NP", "S/PP"
  std::string move;                ///< the kind of move, as the lexicon says: V, N, P, y, n, …
  double cost = 0;                 ///< smaller is likelier
  std::vector<Phrase> phrases;     ///< in order of their words, longer ones first
  std::vector<UsedSense> senses;   ///< in order of their words
  std::vector<std::string> rules;  ///< names of the lexicon's unary rules that it takes, in order of their words
};

/// Words that belong together, with their readings, the likeliest first; never without one.
struct Fragment {
  WordSpan words;
  std::vector<Reading> readings;
};

struct Utterance {
  std::vector<std::string> words;    ///< as said, in lower case, without punctuation
  std::vector<Fragment> fragments;   ///< in order of their words; empty if nothing was understood
  std::vector<std::size_t> unknown;  ///< words that the lexicon does not have
  std::vector<std::size_t> unused;   ///< known words that fit nowhere
  std::vector<std::size_t> ends;     ///< of its sentences: the number of words up to each
  bool cut = false;                  ///< words after the first most_words were not read
};

}  // namespace continua
