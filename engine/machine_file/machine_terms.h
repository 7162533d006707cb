// Reads the terms of a machine file: definitions, conditions, templates, wordings.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"
#include "continua/term/raising.h"

namespace continua {

/// Reads terms with the names declared so far.
class TermReader {
 public:
  /// Its names are those of the term language, of the moment (FORMAT.md) and of `facts`, the facts of the world.
  /// `raising` must outlive the reader.
  explicit TermReader(const Signature& facts, const RaisingRules* raising = nullptr);

  /// A reader with the names of the term language and `programs` only, for terms without a moment and a world.
  static TermReader of_programs(const Signature& programs);

  /// Adds the names for machines with a lexicon only: the understood parts of an input.
  void add_understood();
  /// Adds a name. A name that is taken already is a problem at the key of `at`.
  void declare(const Item& at, const std::string& name, const Type& type);

  /// A term of the type; nothing if the item is absent or, after a problem, if it is not such a term.
  std::optional<Term> term(const Item& item, const Type& expected) const;
  /// The content of a slot or register of the type: a term of that type, or of one that a raising rule lifts to it.
  std::optional<Term> content(const Item& item, const Type& type) const;
  /// A text with terms in braces.
  std::optional<Template> text_template(const Item& item) const { return text_template(item, ""); }

  struct Definitions {
    std::map<std::string, Term, std::less<>> terms;
    std::map<std::string, std::map<std::string, Term, std::less<>>, std::less<>> tables;
  };
  /// Declares the definitions and reads them; they may use one another in any order.
  Definitions definitions(const Item& item);
  std::vector<Wording> wordings(const Item& item) const;

 private:
  TermReader() = default;

  /// `text` begins at the byte `from` of the item's own text. `binders`, such as "\x y. ", are put before it.
  std::optional<Term> part(const Item& item, std::size_t from, const std::string& text, const Type& expected,
                           const std::string& binders) const;
  std::optional<Template> text_template(const Item& item, const std::string& binders) const;
  std::optional<Wording> wording(const Item& item) const;

  Signature facts_, scope_;  ///< scope_: every name that a term may use
  const RaisingRules* raising_ = nullptr;
};

}  // namespace continua
