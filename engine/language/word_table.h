// The words of a lexicon by the texts that its keys stand for. Keys are short for many texts, "(can|could) you
// [please]": each is kept as an automaton over words (Glushkov's), so a table is as large as what is written.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/language/category.h"
#include "continua/term/term.h"

namespace continua {

/// One use of a word. Its term is closed, in normal form and of the category's type.
struct WordSense {
  Category category;
  Term term;
  double cost = 0;
};

/// A word, or several with spaces between them.
struct WordEntry {
  std::vector<WordSense> senses;
  std::optional<double> skip;   ///< the cost of leaving it out; empty if it must not be left out
  std::optional<double> aside;  ///< the cost of leaving it out with all words up to the next comma or the end
};

class WordTable {
 public:
  /// Makes the texts that `key` stands for (spellings.h) have `entry`, after the entries that they have already. False,
  /// and no text has it, if the key cannot be taken apart or stands for a text without words.
  bool add(std::string_view key, WordEntry entry);

  /// Where words said one after another may stand within texts.
  class Walk {
   public:
    explicit Walk(const WordTable& table) : table_(&table) {}
    /// One word further. False if no text begins with the words so far.
    bool step(std::string_view word);
    /// The entries of the words so far, in the order of add(). They hold as long as the table is not changed.
    std::vector<const WordEntry*> entries() const;

   private:
    const WordTable* table_;
    std::optional<std::vector<int>> places_;  // none before the first word
  };

  /// The entries of a word, or of several words with single spaces between them, as a walk finds them.
  std::vector<const WordEntry*> find(std::string_view words) const;

  /// All texts that have an entry, in alphabetical order.
  std::set<std::string> texts() const;

  /// The single words that the texts are made of, each with its number.
  const std::map<std::string, int, std::less<>>& parts() const { return parts_; }

  /// Number of words of the longest text; 1 for none.
  std::size_t most_words() const { return most_words_; }

 private:
  struct Build;

  // A word as it is written in a key.
  struct Place {
    int part = 0;
    int entry = 0;
    bool is_last = false;        // a text may end with it
    std::vector<int> next = {};  // places that may follow, in the order of their parts
  };

  std::map<std::string, int, std::less<>> parts_;
  std::vector<Place> places_;
  std::vector<std::vector<int>> first_;  // by part: places that texts begin with
  std::vector<WordEntry> entries_;
  std::size_t most_words_ = 1;
};

/// The single words of an entry.
std::vector<std::string_view> parts_of_entry(std::string_view words);

}  // namespace continua
