// Reads a lexicon from the documents of its folder. Notes every problem with its place, and goes on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "continua/core/document_reader.h"
#include "continua/language/lexicon.h"

namespace continua {

class LexiconReader {
 public:
  /// `facts` as for load_lexicon(). Both must outlive the reader.
  LexiconReader(const std::vector<LocatedJson>& documents, const Signature& facts);

  /// The lexicon, as far as it is sound.
  Lexicon read();
  /// All problems, document by document, each in its order.
  std::vector<Error> problems() const { return reader_.problems(); }

 private:
  /// The members or elements of a section in all documents, one after another.
  std::vector<NamedItem> members_of(const std::string& section, const char* what) const;
  std::vector<Item> elements_of(const std::string& section, const char* what) const;

  // lexicon_declarations.cpp: the parts of senses
  void read_atoms();
  void read_names();
  void read_determiners();
  void read_proforms();
  void read_definitions();
  void read_scope();
  void declare(const Item& at, const std::string& name, const Type& type);

  // lexicon_words.cpp
  void read_words();
  void read_attributes();
  void read_plurals();
  void read_forms();
  void read_contracted();
  void read_apostrophes();
  void read_rules();
  std::vector<NameTemplate> read_name_templates(const std::string& section);
  /// `at`: the member of that key.
  void add_entry(const Item& at, const std::string& key, WordEntry entry);
  std::optional<Category> read_category(const Item& item);
  std::optional<Term> read_term(const Item& item, const Type& expected);
  /// A term of the category's type; with `argument`, a function from `argument` to that type.
  std::optional<Term> read_term(const Item& item, const Category& category, const std::optional<Type>& argument);

  // lexicon_examples.cpp
  void read_sample();

  DocumentReader reader_;
  std::vector<Item> roots_;  ///< one for each document
  const Signature& facts_;
  Lexicon lexicon_;
};

/// The *.json of the folder in the order of their names; or the first problem.
Result<std::vector<LocatedJson>> documents_in(const std::filesystem::path& folder);

/// The examples in the documents of this lexicon. `reader` notes their problems.
std::vector<LexiconExample> read_examples(const std::vector<LocatedJson>& documents, const Lexicon& lexicon,
                                          DocumentReader& reader);

/// Notes the error of a parser that read the item's text; the sentence quotes the text.
void problem_with_quote(const Item& item, const Error& error);

}  // namespace continua
