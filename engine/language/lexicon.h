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
#include "continua/term/term_text.h"
#include "continua/world/world_snapshot.h"

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
  std::optional<double> skip;  ///< the cost of leaving it out, where it may be left out
};

/// How a value of an attribute becomes a word: its sense is that of `term` applied to the value's constant.
struct WordTemplate {
  Category category;
  Term term;
  double cost = 0;
  bool plural = false;
};

/// An attribute that scenes state of objects, such as color.
struct WordAttribute {
  std::string name;
  Term meaning;  ///< of type text* -> e -> t: the attribute has one of these values
  std::vector<WordTemplate> words;
  /// Values that can always be spoken of, each with those that mean the same; the first of a group names its constant.
  std::vector<std::vector<std::string>> values;
};

/// How a name that the human gave becomes a word: its sense is that of `term` applied to the constant of the name, of
/// type `type`.
struct NameTemplate {
  Type type = Type::truth();
  Category category;
  Term term;
  double cost = 0;
};

/// A phrase of one category may be used as one of another.
struct UnaryRule {
  std::string name;
  Category from, to;
  Term term;  ///< of type type(from) -> type(to)
  double cost = 0;
};

/// Sentences and how they have to be read.
struct LexiconExample {
  std::string where;                           ///< file:line:column
  std::vector<std::string> say;                ///< each is read the same way
  std::optional<std::vector<Term>> readings;   ///< all of the only fragment, the likeliest first
  std::optional<std::vector<Term>> fragments;  ///< the first of each
  std::optional<Term> reading;                 ///< the first of the only fragment
  std::optional<std::string> move;             ///< of the first reading
  std::optional<std::vector<Type>> missing;    ///< the gaps of the first reading, in order
  std::vector<std::string> unknown;
};

/// Words by their text, several words with a space between them.
using WordTable = std::map<std::string, WordEntry, std::less<>>;

struct Lexicon {
  Atoms atoms;
  Signature names;  ///< types of all names that readings may contain, the term language's and the facts included
  Operators operators;
  std::map<std::string, Term, std::less<>> definitions;  ///< names that compute
  WordTable words;
  std::vector<WordAttribute> attributes;
  std::vector<std::pair<std::string, std::string>> plurals;  ///< ending of the singular and of the plural; first wins
  std::vector<UnaryRule> rules;
  std::vector<NameTemplate> learned;  ///< for programs that were named
  std::vector<NameTemplate> unknown;  ///< for words that are no words yet, as texts: "call that (hoist)"
  std::vector<LexiconExample> examples;
  std::vector<ObjectState> sample;  ///< the objects in whose scene the examples are read
  std::string digest;               ///< of its files
};

/// Reads all *.json of the folder. `facts` are the names of facts of the world; terms may use them besides the term
/// language and the lexicon's own declarations. The error is the first problem.
Result<Lexicon> load_lexicon(const std::string& folder, const Signature& facts);

/// Every problem of the folder, file by file, each as "file:line:column: found, expected".
std::vector<Error> check_lexicon(const std::string& folder, const Signature& facts);

/// The examples that are not read as they say, each with its place.
std::vector<Error> check_examples(const Lexicon& lexicon);

}  // namespace continua
