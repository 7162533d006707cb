// The words that can be understood in a scene: those of the lexicon and those that the scene's attributes make.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "continua/language/lexicon.h"

namespace continua {

class Vocabulary {
 public:
  Vocabulary(std::shared_ptr<const Lexicon> lexicon, const WorldSnapshot& world);

  /// The human named a program: from now on its name is a word, as the lexicon's `learned` says. A word of the lexicon
  /// keeps its other senses. REQUIRES that it has not been learned before.
  void learn(const std::string& name, const Type& type);

  const Lexicon& lexicon() const { return *lexicon_; }
  /// The meaning of a word, or of several with spaces between them; nullptr if it has none.
  const WordEntry* find(std::string_view words) const;
  /// All that find() knows, in the order of the alphabet.
  std::set<std::string> words() const;
  /// Words that nobody knows, as names to be given.
  WordEntry as_name(const std::string& words) const;
  /// Whether the word is one, or a part of several that are one.
  bool knows(std::string_view word) const { return parts_.contains(word); }
  /// Of the longest entry.
  std::size_t most_words() const { return most_words_; }

  /// Types of all names that readings may contain, those of the scene's attributes included; its objects are not.
  const Signature& names() const { return names_; }
  /// The meaning of a name that computes; nullptr if it has none. A body of the scene may have the same name: such a
  /// constant is of type e, and not meant here.
  const Term* definition(std::string_view name) const;
  const Operators& operators() const { return lexicon_->operators; }

 private:
  void add_value(const WordAttribute& attribute, const std::vector<std::string>& group);
  void add_word(const std::string& word, WordSense sense);
  void add_parts(std::string_view words);
  std::string plural(const std::string& word) const;

  std::shared_ptr<const Lexicon> lexicon_;
  WordTable scene_words_;  ///< of attributes; with the lexicon's senses where it has the word too
  Signature names_;
  std::map<std::string, Term, std::less<>> definitions_;
  std::set<std::string, std::less<>> parts_;
  std::size_t most_words_ = 1;
};

}  // namespace continua
