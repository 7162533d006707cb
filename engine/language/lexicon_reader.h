// Reads a lexicon from located documents: notes every problem with its place, and goes on.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/located_json.h"
#include "language/lexicon.h"

namespace continua {

class LexiconReader {
 public:
  LexiconReader(const std::vector<LocatedJson>& documents, const Signature& facts);

  Lexicon read();
  /// All that is wrong, document by document, each in its order.
  std::vector<Error> problems();

 private:
  // A value of a document and where it stands.
  struct Item {
    const LocatedJson* document = nullptr;
    const Json* json = nullptr;
    std::string pointer;
  };
  using Visit = std::function<void(const std::string& key, const Item& item)>;

  // lexicon_declarations.cpp: what the other parts are made of
  void read_atoms();
  void read_names();
  void read_operators();
  void read_definitions();
  void declare(const Item& at, const std::string& name, const Type& type);
  Type read_type(const Item& item);

  // lexicon_words.cpp
  void read_words();
  void read_attributes();
  void read_attribute(const std::string& name, const Item& item);
  void read_plurals();
  void read_rules();
  void read_names_given(const std::string& section, std::vector<NameTemplate>& templates);
  WordEntry& entry(const Item& at, const std::string& word);
  std::optional<Category> read_category(const Item& item);
  std::optional<Term> read_term(const Item& item, const Type& expected);
  /// A term of the category's type, or of a function to it.
  std::optional<Term> read_term(const Item& item, const Category& category, const std::optional<Type>& argument);
  double read_cost(const Item& item);

  // lexicon_examples.cpp
  void read_sample();
  void read_examples();
  void read_example(const Item& item, const Signature& names);

  // lexicon_reader.cpp. Where a shape is wrong each notes a problem, and visits nothing or gives a default.
  void each_section(const std::string& key, const std::function<void(const Item&)>& visit);
  void each_member(const Item& object, const char* what, const Visit& visit);
  void each_element(const Item& array, const char* what, const std::function<void(const Item&)>& visit);
  Item member(const Item& object, const std::string& key) const;
  Item required(const Item& object, const std::string& key, const char* what);
  Item element(const Item& array, std::size_t index) const;
  bool expect_object(const Item& item, const char* what, const std::vector<std::string>& keys);
  bool expect_array(const Item& item, const char* what);
  std::string text_of(const Item& item, const char* what);
  std::vector<std::string> texts_of(const Item& item, const char* what);
  bool truth_of(const Item& item, bool otherwise);
  bool mismatch(const Item& item, const std::string& expected);
  void problem(const Item& at, std::string sentence);
  void problem_at_key(const Item& at, std::string sentence);
  void problem_in_text(const Item& at, const Error& error);
  void note(const LocatedJson& document, TextPlace place, std::string sentence);

  struct Problem {
    const LocatedJson* document;
    TextPlace place;
    std::string sentence;
  };
  std::vector<Problem> problems_;
  const std::vector<LocatedJson>& documents_;
  const Signature& facts_;
  Lexicon lexicon_;
};

/// `text` split at each '|', without spaces around the parts.
std::vector<std::string> alternatives(const std::string& text);

}  // namespace continua
