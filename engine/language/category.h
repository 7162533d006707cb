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

/// An atom as the lexicon declares it.
struct Atom {
  std::vector<Type> types;  ///< of its terms; functions over it take the first
  std::string move;     ///< the kind of move that words of this category make alone; empty if they cannot stand alone
  bool open = false;    ///< a command may lack it
  bool phrase = false;  ///< its words are kept with the reading: noun phrases and nouns
  std::vector<std::string> features;  ///< that distinguish kinds of it, such as number
};
using Atoms = std::map<std::string, Atom, std::less<>>;

/// An immutable value; copying shares. An atom that could have a feature and names none goes with each, and all such
/// atoms of its name in one category with the same: N/N makes N[plural] of N[plural], NP/N makes any NP of it.
class Category {
 public:
  enum class Slash { forward, backward };

  /// Slashes associate to the left: S/PP/NP is (S/PP)/NP. `/*` and `\*` only apply, they do not compose. An error names
  /// the column, the text found there and the nearest atom.
  static Result<Category> parse(std::string_view text, const Atoms& atoms);
  /// `result/argument`, or `result\argument`.
  static Category function(Category result, Slash slash, Category argument, bool composes = true);

  bool is_atom() const;
  Name name() const;               ///< REQUIRES is_atom()
  const Category& result() const;  ///< REQUIRES !is_atom(), like those below
  const Category& argument() const;
  Slash slash() const;
  bool composes() const;

  bool operator==(const Category& other) const;
  /// As parse() reads it.
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

/// Whether a function's argument is the category next to it, and which features that settles: one for each atom of each
/// side that names none, such as the gender of N and the case of NP.
class Agreement {
 public:
  bool agree(const Category& one, const Category& other);
  /// `category`, a part of `one` or of `other`, with the features that were settled for that side.
  Category settled_one(const Category& category) const { return settled(category, one_); }
  Category settled_other(const Category& category) const { return settled(category, other_); }

 private:
  using Features = std::vector<std::pair<Name, Name>>;  // of atoms, by their names; there are few

  static std::optional<Name> feature_of(const Category& atom, const Features& features);
  static Category settled(const Category& category, const Features& features);

  Features one_, other_;
};

/// The type of terms of this category: functions take the first type of their arguments. For the atom that is made in
/// the end its type number `choice` is taken, or its last.
Type type_of(const Category& category, const Atoms& atoms, std::size_t choice = 0);

/// The atom that is made when all arguments are found.
const Category& target(const Category& category);

}  // namespace continua
