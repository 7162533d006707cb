// The words of a language and their meanings: data, read from a folder of JSON files (language/LEXICON.md).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/language/category.h"
#include "continua/language/operators.h"
#include "continua/language/word_table.h"
#include "continua/term/term_text.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// How a value of an attribute becomes a word. The word's term is `term` applied to the value's constant.
struct WordTemplate {
  Category category;
  Term term;
  double cost = 0;
  bool plural = false;
};

/// An attribute that a scene gives its objects, such as color.
struct WordAttribute {
  std::string name;
  Term meaning;  ///< of type text* -> e -> t: the attribute has one of these values
  std::vector<WordTemplate> words;
  /// Values that can always be said, each in a group with its synonyms; the first of a group names its constant.
  std::vector<std::vector<std::string>> values;
};

/// How a name that the human gave becomes a word. The word's term is `term` applied to the name, which has type `type`.
struct NameTemplate {
  Type type = Type::truth();
  Category category;
  Term term;
  double cost = 0;
  bool plural = false;  ///< of a noun: for its plural; the others are for its singular
};

/// A rule by which a phrase of category `from` is also one of category `to`.
struct UnaryRule {
  std::string name;
  Category from, to;
  Term term;  ///< of type type(from) -> type(to)
  double cost = 0;
};

/// Sentences and their expected reading.
struct LexiconExample {
  std::string where;                           ///< file:line:column
  std::vector<std::string> say;                ///< sentences, each with this same reading
  std::optional<std::vector<Term>> readings;   ///< all readings of the only fragment, the likeliest first
  std::optional<std::vector<Term>> fragments;  ///< the first reading of each fragment
  std::optional<Term> reading;                 ///< the first reading of the only fragment
  std::optional<std::string> move;             ///< of the first reading
  std::optional<std::vector<Type>> missing;    ///< types of the arguments that the first reading lacks, in order
  std::vector<std::string> unknown;
};

struct Lexicon {
  Atoms atoms;
  Signature names;  ///< types of all names that readings may contain, the term language's and the facts included
  Operators operators;
  std::map<std::string, Term, std::less<>> definitions;  ///< defined names with their terms
  WordTable words;
  std::vector<WordAttribute> attributes;
  std::vector<std::pair<std::string, std::string>> plurals;  ///< ending of the singular and of the plural; first wins
  /// Endings of two forms of a verb, "capping" and "cap": a taught verb is known in all its forms.
  std::vector<std::pair<std::string, std::string>> forms;
  /// Endings of words with another word contracted into them, and that word: "'s" is "is".
  std::vector<std::pair<std::string, std::string>> contracted;
  /// Endings of words that are often written without their apostrophe, and the same with it: "nt" is "n't".
  std::vector<std::pair<std::string, std::string>> apostrophes;
  std::vector<UnaryRule> rules;
  std::vector<NameTemplate> learned;  ///< for programs that the human named
  std::vector<NameTemplate> unknown;  ///< for unknown words, as texts: "call that (hoist)"
  std::vector<NameTemplate> taken;    ///< for known words in place of a new name: "call the block (cup)"
  std::vector<NameTemplate> nouns;    ///< for nouns that the human taught: "put (bob) on the plate"
  std::vector<NameTemplate> numbers;  ///< for numbers in digits: "(10) centimetres"
  std::vector<ObjectState> sample;    ///< the objects of the scene in which the examples are read
  std::string digest;                 ///< of its files
  std::vector<std::string> folders;   ///< of its files; that of the lexicon which another one is based on comes before
};

/// Reads all *.json of the folder but for their examples, after those of the lexicon that it is based on (LEXICON.md,
/// Words of one's own). `facts`: the facts of the world, which terms may use besides the names of the term language and
/// of the lexicon. `known`: the folder of the lexicons that have names. The error is the first problem.
Result<Lexicon> load_lexicon(const std::string& folder, const Signature& facts, const std::string& known = "");

/// Every problem of the folder, those of its examples too, file by file, as "file:line:column: found …, expected …".
std::vector<Error> check_lexicon(const std::string& folder, const Signature& facts, const std::string& known = "");

/// The examples of a loaded lexicon, from the files of its folders. Only who checks or counts them needs them. The
/// error is the first problem.
Result<std::vector<LexiconExample>> load_examples(const Lexicon& lexicon);

/// An error for each example sentence that the lexicon reads otherwise than expected, with the place of the example.
std::vector<Error> check_examples(const std::vector<LexiconExample>& examples, const Lexicon& lexicon);

}  // namespace continua
