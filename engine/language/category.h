// Categories of the grammar: atoms such as NP, and functions between them, as in combinatory categorial grammar
// (Steedman, The Syntactic Process, 2000). X/Y looks for a Y to its right and makes an X, X\Y looks to its left.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/term/name.h"
#include "continua/term/type.h"

namespace continua {

/// A lexicon's declaration of an atom.
struct Atom {
  std::vector<Type> types;            ///< of its terms; functions over this atom take the first
  std::string move;                   ///< the move that its words make alone; empty if they cannot stand alone
  bool open = false;                  ///< a command may lack it
  bool phrase = false;                ///< its words are kept with the reading: noun phrases and nouns
  std::vector<std::string> features;  ///< distinguish kinds of the atom, such as number
};
using Atoms = std::map<std::string, Atom, std::less<>>;

/// An immutable value; copying shares. An atom that could have a feature and names none agrees with every feature. All
/// such atoms of one name in a category get the same feature: N/N makes N[plural] of N[plural], NP/N makes any NP of
/// N[plural].
class Category {
 public:
  enum class Slash { forward, backward };

  /// Slashes associate to the left: S/PP/NP is (S/PP)/NP. `/*` and `\*` only apply, they do not compose. An error
  /// names the column, the text found there and the nearest atom.
  static Result<Category> parse(std::string_view text, const Atoms& atoms);
  /// `result/argument`, or `result\argument`.
  static Category function(Category result, Slash slash, Category argument, bool composes = true);

  bool is_atom() const;
  Name name() const;               ///< REQUIRES is_atom()
  const Category& result() const;  ///< REQUIRES !is_atom(), like those below
  const Category& argument() const;
  Slash slash() const;
  bool composes() const;
  /// The atom that remains when all arguments have been taken: its name, and its place among the atoms of parse().
  Name target() const;
  std::size_t target_number() const;

  bool operator==(const Category& other) const;
  /// In the notation of parse().
  std::string text() const;
  /// Number of atoms in it.
  std::size_t size() const;

 private:
  friend class CategoryParser;
  friend class Agreement;
  struct Node;
  explicit Category(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

/// Tests whether a function's argument agrees with the category next to it. Agreement settles features: one for each
/// atom that names none, on each side, such as the gender of N and the case of NP.
class Agreement {
 public:
  bool agree(const Category& one, const Category& other);
  /// `category`, a part of `one` (of `other`), with the features settled for that side.
  Category settled_one(const Category& category) const { return settled(category, one_); }
  Category settled_other(const Category& category) const { return settled(category, other_); }

 private:
  using Features = std::vector<std::pair<Name, Name>>;  // atom and feature; a vector, because there are few

  static std::optional<Name> feature_of(const Category& atom, const Features& features);
  static Category settled(const Category& category, const Features& features);

  Features one_, other_;
};

/// The type of terms of this category. Arguments have the first type of their atom; the target atom has its type number
/// `choice`, or its last.
Type type_of(const Category& category, const Atoms& atoms, std::size_t choice = 0);

}  // namespace continua
