// All ways to build phrases from neighbouring words: a chart (CKY) over combinatory categorial grammar, with
// application, harmonic composition, the lexicon's unary rules, and words that may be left out at no cost.
//
// Derivations that only repeat another one in a different order are left out (Eisner, Efficient normal-form parsing for
// combinatory categorial grammar, 1996). Entries of equal category and term are one entry. Spans and entries of a span
// are bounded, so time grows linearly with the number of words.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "continua/language/prospects.h"
#include "continua/language/reading.h"
#include "continua/language/vocabulary.h"

namespace continua {

class Chart {
 public:
  enum class Rule { word, apply_forward, apply_backward, compose_forward, compose_backward, unary, skip };

  struct Entry {
    Category category;
    Term term;
    double cost = 0;
    WordSpan words;
    Rule rule = Rule::word;
    /// The numbers of its parts; with one part, `right` is `left`.
    std::size_t left = 0, right = 0;
    int unary = 0;                          ///< unary rules at its top
    const UnaryRule* changed_by = nullptr;  ///< under Rule::unary
  };

  /// Longest phrase, in words; most entries of a span, and of one category among them.
  static constexpr std::size_t longest_span = 40, most_entries = 80, most_of_category = 8;

  /// A word of the utterance, not yet looked up.
  struct Word {
    std::string text;
    bool before_unknown = false;  ///< unknown words after it were left out: "the" has lost its noun
    WordEntry name = {};          ///< further senses of an unknown word, as a name
  };

  Chart(const std::vector<Word>& words, const Vocabulary& vocabulary);

  const Entry& entry(std::size_t number) const { return entries_[number]; }
  /// Numbers of the entries of these words: cheapest first, then those made by unary rules.
  const std::vector<std::size_t>& at(std::size_t begin, std::size_t end) const;
  /// The end of the longest span from `begin` that may have entries.
  std::size_t last_end(std::size_t begin) const { return begin + cells_[begin].size(); }

  struct Skippable {
    std::size_t count;  ///< words
    double cost;
    bool known = true;   ///< the lexicon allows leaving it out; false: it has lost the word that it belonged to
    bool aside = false;  ///< with unknown words among them
  };
  /// The words that may be left out from `begin` on; inside a phrase, only
  /// those that cost nothing or are not `known`, and no asides.
  const std::vector<Skippable>& skippable(std::size_t begin) const { return skippable_[begin]; }

 private:
  /// The atoms that remain of an entry's category and, of a function, of its argument: without equal ones two entries
  /// do not combine.
  struct Signs {
    Name made, wanted;
  };
  struct Candidate {
    Category category;
    double cost;
    Rule rule;
    std::size_t left, right;
    const Term* word = nullptr;
  };

  void look_up(const std::vector<Word>& words);
  void keep(const std::vector<PlacedSense>& senses);
  void add_aside(const std::vector<Word>& words, std::size_t begin, std::size_t opening, double cost);
  void fill(std::size_t begin, std::size_t end);
  void combine(std::size_t left, std::size_t right);
  void add_candidates();
  bool add(Entry entry);
  void change_categories();
  Term term_of(const Candidate& candidate) const;

  const Vocabulary& vocabulary_;
  const Lexicon& lexicon_;
  std::vector<std::vector<std::vector<std::size_t>>> cells_;       ///< by begin and length - 1
  std::vector<std::vector<std::vector<const WordSense*>>> words_;  ///< by begin and length - 1; those with prospects
  std::vector<std::vector<Skippable>> skippable_;
  std::vector<Entry> entries_;
  std::vector<Signs> signs_;  ///< of the entries
  std::vector<Candidate> candidates_;
  std::vector<std::size_t>* cell_ = nullptr;  ///< the cell that fill() works on
  WordSpan span_;
};

}  // namespace continua
