// Reads the notation of voxml/expression.h from left to right.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/voxml/expression.h"

namespace continua {

class ExpressionReader {
 public:
  /// A lenient reader accepts missing closing brackets at the end, or before a ']'.
  ExpressionReader(std::string_view text, bool lenient) : text_(text), lenient_(lenient) {}

  Result<Expression> expression();

  /// Reads a sign if it comes next: a bracket, `,` `;` `:` `=`, or "!", "^", "|" and "->" in any of their spellings.
  bool take(std::string_view sign);
  bool comes(std::string_view sign) const { return sign_length(sign) > 0; }
  /// Reads a word and its bracket if both come next: the `while(` of while(…).
  bool take_opening(std::string_view word);
  /// Reads this closing bracket.
  Outcome close(std::string_view bracket);
  /// Reads all closing brackets that come next.
  void skip_closing();
  bool at_end() const { return rest().empty(); }

  /// "found …, expected …", at the next character.
  Error expected(std::string_view what) const;

  std::size_t at() const { return at_; }
  void go_back(std::size_t at) { at_ = at; }

 private:
  std::string_view rest() const;
  std::size_t sign_length(std::string_view sign) const;
  std::size_t name_length() const;
  void skip(std::size_t length);
  Result<Expression> joined(Expression::Kind kind);
  Result<Expression> negated();
  Result<Expression> primary();
  Result<Expression> bracket();
  Result<Expression> quoted();
  Result<Expression> vector();
  Result<Expression> vector_onto(Expression vector);
  Result<Expression> named();

  std::string_view text_;
  bool lenient_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace continua
