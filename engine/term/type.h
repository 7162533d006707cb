// Types of terms: e (object), loc (place or region), t (truth value, event description), num, text, lists a*, dot types
// a • b (both at once, until a type selects one half: a pointing is e* • loc), functions a -> b, and `term`, the
// dynamic type: a term of any type, which is not checked at load (a stack slot for commands of various shapes).
// SEMANTICS.md §2.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

/// An immutable value; copying shares.
class Type {
 public:
  enum class Kind { base, list, dot, function, variable };

  static Type base(std::string name);
  static Type list(Type element);
  /// The compound of two types (Pustejovsky's dot object; paper, figure of [[point]]: physobj[] • location).
  static Type dot(Type first, Type second);
  static Type function(Type from, Type to);
  /// A type variable of a polymorphic constant, such as a in `head : a* -> a`.
  static Type variable(int index);

  static const Type& entity();     ///< e
  static const Type& location();   ///< loc
  static const Type& region();     ///< region, a place with an extent; to the checker the same as loc
  static const Type& truth();      ///< t
  static const Type& number();     ///< num
  static const Type& text_type();  ///< text
  static const Type& term();       ///< term, consistent with every type
  static const Type& pointing();   ///< e* • loc, things and the place

  Kind kind() const;
  const std::string& name() const;  ///< REQUIRES base
  const Type& element() const;      ///< REQUIRES list
  const Type& first() const;        ///< REQUIRES dot
  const Type& second() const;       ///< REQUIRES dot
  const Type& from() const;         ///< REQUIRES function
  const Type& to() const;           ///< REQUIRES function
  int index() const;                ///< REQUIRES variable

  /// Whether the type contains a type variable.
  bool polymorphic() const;

  bool operator==(const Type& other) const;
  /// The very same node, which is quicker to ask than equality.
  bool same_node(const Type& other) const { return node_ == other.node_; }

  /// "e -> (loc -> t)*", "loc -> e* • loc"; arrows associate to the right, `*` binds tightest, then `•`; variables
  /// print as 'a, 'b, ….
  std::string text() const;
  /// Reads the notation of text(). `entity` and `location` are other names of e and loc. An unknown name is an error;
  /// `extra`: base types besides the built-in ones. Errors name the column; the first column is `first_column`.
  static Result<Type> parse(std::string_view text, const std::vector<std::string>& extra = {},
                            std::size_t first_column = 1);

 private:
  struct Node;
  explicit Type(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

/// Whether a value of one type may stand in a place of the other. `term` and type variables are consistent with every
/// type. `region` and `loc` are consistent: the value shows whether a place has an extent (term/raising.h).
bool consistent(const Type& a, const Type& b);

}  // namespace continua
