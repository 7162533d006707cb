// Types of terms: e (object), loc (place or region), t (truth value, event description), num, text, lists a*, functions
// a -> b, and `term`, the dynamic type: a term of any type, about which nothing is checked at load (a stack slot that
// holds commands of various shapes). SEMANTICS.md §2.
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
  enum class Kind { base, list, function, variable };

  static Type base(std::string name);
  static Type list(Type element);
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

  Kind kind() const;
  const std::string& name() const;  ///< REQUIRES base
  const Type& element() const;      ///< REQUIRES list
  const Type& from() const;         ///< REQUIRES function
  const Type& to() const;           ///< REQUIRES function
  int index() const;                ///< REQUIRES variable

  /// True when a type variable occurs in it.
  bool polymorphic() const;

  bool operator==(const Type& other) const;

  /// "e -> (loc -> t)*"; arrows associate to the right, `*` binds tightest; variables print as 'a, 'b, ….
  std::string text() const;
  /// Reads the notation that text() writes. `entity` and `location` are other names of e and loc. An unknown name is an
  /// error; `extra` are base types beyond the built-in ones. Errors name the column, the first being `first_column`.
  static Result<Type> parse(std::string_view text, const std::vector<std::string>& extra = {},
                            std::size_t first_column = 1);

 private:
  struct Node;
  explicit Type(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

/// May a value of the one type stand where the other is expected? `term` and type variables go with everything, and
/// `region` goes with `loc` both ways: whether a place has an extent is seen from its value (term/raising.h).
bool consistent(const Type& a, const Type& b);

}  // namespace continua
