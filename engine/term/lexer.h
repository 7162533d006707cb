// The words of the term notation, read one at a time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

struct Token {
  enum class Kind {
    end,
    number,
    text,
    name,
    sign,  ///< brackets, operators, `\`, and the words and, or, not
  };
  Kind kind = Kind::end;
  std::size_t begin = 0;  ///< byte of the text where it begins
  std::string text;       ///< name, sign, or the characters of the text without quotes and escapes
  double number = 0;
  bool quoted = false;  ///< a name in backquotes: never a keyword or a variable

  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
  /// "'put'", "the number 3", "the end"
  std::string described() const;
};

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  Result<Token> next();
  /// The text up to the next `stop` or to the end; reading goes on from there.
  std::string_view raw_until(char stop);
  std::size_t at() const { return at_; }
  void skip_space();

 private:
  Result<Token> number();
  Result<Token> quoted(char quote);
  Error error(std::size_t at, std::string sentence) const;

  std::string_view text_;
  std::size_t at_ = 0;
};

/// "column N", the first being 1.
std::string column(std::size_t byte);

/// Whether it can be written as a name without quotes: a letter or _, then letters, digits, _, and primes at the end.
bool is_plain_name(std::string_view name);
/// null true false and or not
bool is_keyword(std::string_view name);

}  // namespace continua
