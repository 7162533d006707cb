// JSON that remembers where it came from, so that an error about a value names its file and line.
// The only place where nlohmann/json is included.
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <nlohmann/json.hpp>

#include "continua/core/result.h"

namespace continua {

/// Keys keep the order in which they were written, so printed JSON is the same on every machine.
using Json = nlohmann::ordered_json;

}  // namespace continua

// Compiled once, in located_json.cpp: every file that reads JSON would take seconds to compile it again.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace continua {

/// One line of compact JSON. Bytes that are not UTF-8 become U+FFFD.
std::string compact(const Json& value);

/// Values nested deeper than this are refused by the readers below: printing and comparing a value recurse, and
/// the stack must not depend on what a file contains.
inline constexpr int max_json_depth = 200;
/// Objects with more members are refused too: finding a member takes time in proportion to their number.
inline constexpr std::size_t max_json_members = 10000;

/// A place in a text, counted from 1; columns are bytes.
struct TextPlace {
  std::size_t line = 1, column = 1;
  auto operator<=>(const TextPlace&) const = default;
};

/// One line of a JSON Lines file, read as a value. An error is placed at "name:line:column".
Result<Json> parse_json_line(std::string_view text, const std::string& name, std::size_t line);

/// A JSON document with the line and column of each of its values.
class LocatedJson {
 public:
  /// `name` stands for the document in errors. An error names line, column, the text found and the text expected. A
  /// byte order mark at the beginning is skipped.
  static Result<LocatedJson> parse(std::string_view text, std::string name);

  /// Reads the whole file; missing, unreadable and empty files are errors too.
  static Result<LocatedJson> read(const std::string& path);

  const Json& root() const { return root_; }
  const std::string& name() const { return name_; }

  /// Of the value at `pointer` ("/transitions/3/when", RFC 6901), or of its nearest enclosing value that has a place.
  TextPlace place(std::string_view pointer) const;
  /// Place of the key of the member at `pointer`; of an element, its own place.
  TextPlace key_place(std::string_view pointer) const;
  /// Place of byte `byte` of the text at `pointer`, whatever escapes stand before it in the document.
  TextPlace place_in_text(std::string_view pointer, std::size_t byte) const;

  /// Error at "name:line:column".
  Error error(TextPlace place, std::string sentence) const;
  Error error(std::string_view pointer, std::string sentence) const {
    return error(place(pointer), std::move(sentence));
  }
  std::string where(std::string_view pointer) const { return error(pointer, "").where; }

  /// A key that its object has already; the last value of a key counts.
  struct Duplicate {
    TextPlace place;
    std::string key;
  };
  const std::vector<Duplicate>& duplicates() const { return duplicates_; }

 private:
  struct Location {
    TextPlace value, key;
    std::size_t offset;  ///< byte of text_ where the value begins
  };
  const Location* location(std::string_view pointer) const;

  Json root_;
  std::string name_, text_;
  std::unordered_map<std::string, Location> locations_;
  std::vector<Duplicate> duplicates_;
};

/// Reads a whole file, or says why it could not: missing, a folder, unreadable. An empty file is an empty string.
Result<std::string> read_file(const std::string& path);

/// `text` without the UTF-8 byte order mark that it may begin with.
std::string_view without_byte_order_mark(std::string_view text);

/// `text` in single quotes, fit for a sentence of one line: at most 60 bytes of it, bytes that are not printable
/// ASCII or UTF-8 as \xNN.
std::string in_quotes(std::string_view text);

/// The name among `known` nearest to `name` by edit distance, as " (did you mean 'x'?)", or empty when none is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace continua
