// The parser's result: an utterance in fragments, each with its readings.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "continua/term/term.h"

namespace continua {

/// Consecutive words of an utterance, [begin, end).
struct WordSpan {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

/// A noun phrase or noun of a reading: a part of its term, and the words it came from.
struct Phrase {
  Term term;  ///< occurs in the reading's term
  WordSpan words;
};

/// A sense that a reading uses, from the lexicon or from an attribute of the scene.
struct UsedSense {
  std::string words;     ///< the words of the entry, several with spaces between them
  std::string category;  ///< the category of the entry; empty if the words were passed over
  Term term;             ///< null if the words were passed over
  double cost = 0;
};

/// One way to understand some words. The term still contains phrases such as `the(\x. cup(x) and blue(x))` and `it`;
/// interpretation finds their meaning (language/interpretation.h). An argument that a command lacks is a variable: "put
/// the knife" is \v. put(the(\x. knife(x)), v) of type loc -> t.
struct Reading {
  Term term;
  std::string category;            ///< of the words as a whole: "S", "NP", "S/PP"
  std::string move;                ///< the kind of move, from the lexicon: V, N, P, y, n, …
  double cost = 0;                 ///< smaller is likelier
  std::vector<Phrase> phrases;     ///< in order of their words, longer ones first
  std::vector<Phrase> taken_back;  ///< things and nouns that it has no more: "the cup, I mean the plate"; also in order
  std::vector<UsedSense> senses;   ///< in order of their words
  std::vector<std::string> rules;  ///< names of the lexicon's unary rules that it uses, in order of their words
};

/// Words that belong together, with their readings, the likeliest first; there is at least one.
struct Fragment {
  WordSpan words;
  std::vector<Reading> readings;
};

struct Utterance {
  std::vector<std::string> words;     ///< in lower case, without punctuation
  std::vector<Fragment> fragments;    ///< in order of their words; empty if nothing was understood
  std::vector<std::size_t> unknown;   ///< words that the lexicon does not have
  std::vector<std::size_t> unused;    ///< known words that fit nowhere
  std::vector<std::size_t> repaired;  ///< unknown words that were read as known ones which are spelt almost like them
  std::vector<std::size_t> guessed;   ///< repaired words that may have been others
  std::vector<std::size_t> ends;      ///< of its sentences: the number of words up to each
  std::vector<std::size_t> quoted;    ///< the numbers of the words in quotation marks; empty if all are
  bool cut = false;                   ///< words after the first most_words were not read
};

}  // namespace continua
