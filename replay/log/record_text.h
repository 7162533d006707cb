// The text of records while it grows: pieces of JSON put at its end, the same bytes as the library for JSON writes.
#pragma once

#include <charconv>
#include <concepts>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "continua/core/located_json.h"

namespace continua::log {

class RecordText {
 public:
  std::string_view view() const { return {text_.data(), text_.size()}; }
  std::size_t size() const { return text_.size(); }
  void clear() { text_.clear(); }
  /// For so many characters no memory is asked for any more.
  void reserve(std::size_t size) { text_.reserve(size); }

  /// The piece as it is.
  void put(std::string_view piece) { set_end(copied(piece, room(piece.size()))); }
  void put(char c) { text_.push_back(c); }
  /// In quotes, with the escapes that it needs.
  void put_text(std::string_view text);
  /// A member's name, which needs no escapes, with its colon, and a comma before it if it is not the `first`.
  void put_name(std::string_view name, bool first) {
    auto* to = room(name.size() + 4);
    if (!first) *to++ = ',';
    *to++ = '"';
    to = copied(name, to);
    *to++ = '"';
    *to++ = ':';
    set_end(to);
  }
  template <std::integral Number>
  void put_number(Number number) {
    constexpr std::size_t most_digits = 20;
    auto* to = room(most_digits);
    set_end(std::to_chars(to, to + most_digits, number).ptr);
  }
  /// `null` if it is not finite.
  void put_number(double number);
  void put_json(const Json& value);

 private:
  // A place for as many characters at the end; set_end() says where they ended.
  char* room(std::size_t size) {
    text_.reserve(text_.size() + size);
    return text_.data() + text_.size();
  }
  void set_end(const char* end) { text_.resize(static_cast<std::size_t>(end - text_.data())); }

  // The first and the last `part` bytes, which may have some in common.
  template <std::size_t part>
  static void copy_ends(std::string_view text, char* to) {
    std::memcpy(to, text.data(), part);
    std::memcpy(to + text.size() - part, text.data() + text.size() - part, part);
  }
  // Where the copy ends. Most texts of a log are short: a call of memcpy takes longer than they do.
  static char* copied(std::string_view text, char* to) {
    const auto size = text.size();
    if (size > 32)
      std::memcpy(to, text.data(), size);
    else if (size >= 16)
      copy_ends<16>(text, to);
    else if (size >= 8)
      copy_ends<8>(text, to);
    else if (size >= 4)
      copy_ends<4>(text, to);
    else
      for (std::size_t i = 0; i < size; ++i) to[i] = text[i];
    return to + size;
  }

  fmt::memory_buffer text_;
};

}  // namespace continua::log
