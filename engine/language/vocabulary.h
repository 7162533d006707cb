// The words that can be understood in a scene: the lexicon's words, and words from the attributes of the scene.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/language/lexicon.h"

namespace continua {

class Vocabulary {
 public:
  Vocabulary(std::shared_ptr<const Lexicon> lexicon, const WorldSnapshot& world);

  /// Makes the word a verb for the program of that name, by the lexicon's `learned` templates. A word that the lexicon
  /// has already loses its other senses: the human was asked. REQUIRES that the name has not been learned before.
  void learn(const std::string& word, const std::string& name, const Type& type);

  /// Makes a noun that the human taught a word, by the lexicon's `nouns` templates. `condition`: e -> t.
  void learn_noun(const std::string& name, const Term& condition);

  const Lexicon& lexicon() const { return *lexicon_; }
  /// What is known of a word, or of several words with spaces between them; none if nothing is. They hold until the
  /// next word is learned.
  std::vector<const WordEntry*> entries(std::string_view words) const;
  /// The same of words said one after another.
  class Walk {
   public:
    explicit Walk(const Vocabulary& vocabulary) : vocabulary_(vocabulary), known_(vocabulary.lexicon_->words) {}
    /// One word further: what is known of all words so far.
    std::vector<const WordEntry*> step(std::string_view word);
    /// True: further words find nothing.
    bool is_over() const { return !is_known_ && count_ >= vocabulary_.most_scene_words_; }

   private:
    const Vocabulary& vocabulary_;
    WordTable::Walk known_;
    std::string text_;
    std::size_t count_ = 0;
    bool is_known_ = true;
  };
  /// The senses of entries.
  static std::vector<const WordSense*> senses(const std::vector<const WordEntry*>& entries);
  /// All words that have entries, in alphabetical order.
  std::set<std::string> words() const;
  /// The senses of words as a name that the human is about to give: by the lexicon's `unknown` templates, or, for a
  /// word that is known already, by its `taken` templates.
  WordEntry as_name(const std::string& words, bool known) const;
  /// The senses of a number in digits, by the lexicon's `numbers` templates; none if the word is no number.
  WordEntry as_number(const std::string& word) const;
  /// A word that an unknown one may stand for, and whether that is sure enough not to ask.
  struct Resemblance {
    std::string word;
    bool sure = false;
    friend bool operator==(const Resemblance&, const Resemblance&) = default;
  };
  /// The known word that is spelt most like this unknown one, preferably one for a thing of the scene or for one of its
  /// attributes; none if none resembles it, or two do equally. Other words must differ by a slip of the fingers alone.
  std::optional<Resemblance> resembling(const std::string& word) const;
  /// Whether the word is an entry, or a part of an entry of several words.
  bool knows(std::string_view word) const { return lexicon_->words.parts().contains(word) || parts_.contains(word); }
  /// Whether the word by itself means something. One that is only part of other entries ("wait a minute"), or that is
  /// only left out, has no meaning to lose.
  bool means(std::string_view word) const;

  /// Types of all names that readings may contain. Attributes of the scene are included, its objects are not.
  const Signature& names() const { return names_; }
  /// The definition of a name; nullptr if there is none. An object of the scene may have the same name; its constant is
  /// of type e and is not looked up here.
  const Term* definition(std::string_view name) const;
  const Operators& operators() const { return lexicon_->operators; }

 private:
  void add_value(const WordAttribute& attribute, const std::vector<std::string>& group);
  void lose_senses(const std::string& word);
  std::set<std::string> forms_of(const std::string& verb) const;
  void add_word(const std::string& word, WordSense sense);
  void add_parts(std::string_view words);
  std::string plural(const std::string& word) const;
  std::optional<std::string> singular(const std::string& word) const;  ///< empty if it is no plural
  void add_noun(const std::string& word, bool plural, const Term& constant, double cost);
  std::optional<Resemblance> resembling_thing(const std::string& word) const;
  std::optional<Resemblance> resembling_word(const std::string& word) const;
  void note_said_of_scene(const WorldSnapshot& world);

  std::shared_ptr<const Lexicon> lexicon_;
  struct SceneWord {
    WordEntry entry;
    bool alone = false;  ///< it has lost what the lexicon knows of it
  };
  std::map<std::string, SceneWord, std::less<>> scene_words_;  ///< words from attributes and learned names
  Signature names_;
  std::map<std::string, Term, std::less<>> definitions_;
  std::set<std::string, std::less<>> parts_;  ///< of entries that the lexicon lacks, but the parts that it has
  std::set<std::string> said_of_scene_;       ///< single words for what the objects of the scene are
  std::size_t most_scene_words_ = 0;          ///< number of words of the longest of scene_words_
};

}  // namespace continua
