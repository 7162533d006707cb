#include "continua/term/lexer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

namespace continua {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::string_view lambda_utf8 = "\xCE\xBB";

// A sign stands before the signs that it begins with.
constexpr std::array<std::string_view, 20> signs = {"!=", "<=", ">=", "(", ")", "[", "]", "<", ">",
                                                    ",",  ".",  ":",  "=", "+", "-", "*", "/", "\\"};

// Length in bytes of the name at the beginning of `text`.
std::size_t name_length(std::string_view text) {
  if (text.empty() || !is_letter(text.front())) return 0;
  std::size_t length = 1;
  while (length < text.size() && (is_letter(text[length]) || is_digit(text[length]))) ++length;
  while (length < text.size() && text[length] == '\'') ++length;
  return length;
}

}  // namespace

std::string Token::described() const {
  switch (kind) {
    case Kind::end:
      return "the end";
    case Kind::number:
      return fmt::format("the number {}", number);
    case Kind::text:
      return "a text";
    default:
      return fmt::format("'{}'", text);
  }
}

std::string column(std::size_t byte) { return fmt::format("column {}", byte + 1); }

bool is_plain_name(std::string_view name) { return !name.empty() && name_length(name) == name.size(); }

bool is_keyword(std::string_view name) {
  return name == "null" || name == "true" || name == "false" || name == "and" || name == "or" || name == "not";
}

Error Lexer::error(std::size_t at, std::string sentence) const { return {column(at), std::move(sentence)}; }

void Lexer::skip_space() {
  while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
}

std::string_view Lexer::raw_until(char stop) {
  const auto from = at_;
  at_ = std::min(text_.find(stop, from), text_.size());
  return text_.substr(from, at_ - from);
}

Result<Token> Lexer::next() {
  skip_space();
  Token token;
  token.begin = at_;
  if (at_ == text_.size()) return token;
  const auto rest = text_.substr(at_);
  if (is_digit(rest.front())) return number();
  if (rest.front() == '\'' || rest.front() == '`') return quoted(rest.front());
  if (const auto length = name_length(rest)) {
    token.text = rest.substr(0, length);
    token.kind =
        token.text == "and" || token.text == "or" || token.text == "not" ? Token::Kind::sign : Token::Kind::name;
    at_ += length;
    return token;
  }
  token.kind = Token::Kind::sign;
  if (rest.substr(0, lambda_utf8.size()) == lambda_utf8) {
    token.text = "\\";
    at_ += lambda_utf8.size();
    return token;
  }
  for (const auto sign : signs) {
    if (sign.empty() || rest.substr(0, sign.size()) != sign) continue;
    token.text = sign;
    at_ += sign.size();
    return token;
  }
  if (std::isprint(static_cast<unsigned char>(rest.front())))
    return error(at_, fmt::format("found '{}', which begins no part of a term", rest.front()));
  return error(at_, fmt::format("found byte {:#04x}, which begins no part of a term",
                                static_cast<unsigned>(static_cast<unsigned char>(rest.front()))));
}

Result<Token> Lexer::number() {
  Token token;
  token.kind = Token::Kind::number;
  token.begin = at_;
  auto end = at_;
  const auto skip_digits = [&] {
    while (end < text_.size() && is_digit(text_[end])) ++end;
  };
  skip_digits();
  if (end + 1 < text_.size() && text_[end] == '.' && is_digit(text_[end + 1])) {
    ++end;
    skip_digits();
  }
  if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
    const auto mark = end++;
    if (end < text_.size() && (text_[end] == '+' || text_[end] == '-')) ++end;
    if (end < text_.size() && is_digit(text_[end]))
      skip_digits();
    else
      end = mark;
  }
  const auto read = std::from_chars(text_.data() + at_, text_.data() + end, token.number);
  if (read.ec == std::errc::result_out_of_range)
    return error(at_, "found a number that is too large or too small to be held");
  at_ = end;
  if (name_length(text_.substr(at_)) > 0)
    return error(at_,
                 fmt::format("found '{}' right after a number", text_.substr(at_, name_length(text_.substr(at_)))));
  return token;
}

Result<Token> Lexer::quoted(char quote) {
  Token token;
  token.kind = quote == '`' ? Token::Kind::name : Token::Kind::text;
  token.quoted = quote == '`';
  token.begin = at_++;
  for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
    if (text_[at_] == '\\') {
      ++at_;
      if (at_ == text_.size()) break;
      if (text_[at_] != quote && text_[at_] != '\\')
        return error(at_ - 1, fmt::format("found '\\{0}', expected \\{1} or \\\\", text_[at_], quote));
    }
    token.text += text_[at_];
  }
  if (at_ == text_.size())
    return error(token.begin,
                 fmt::format("the {} that begins here has no closing {}", quote == '`' ? "name" : "text", quote));
  ++at_;
  if (token.quoted && token.text.empty()) return error(token.begin, "found a name without characters");
  return token;
}

}  // namespace continua
