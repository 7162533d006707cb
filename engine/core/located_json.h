// JSON values with their places, so that an error about a value names its file and line. The only file that includes
// nlohmann/json.
#pragma once

#include <compare>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "continua/core/result.h"

namespace continua {

/// Keys keep the order of the file, so that output is the same on every machine.
using Json = nlohmann::ordered_json;

}  // namespace continua

// Compiled once, in located_json.cpp. Otherwise every file that reads JSON would take seconds to compile it again.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace continua::detail {

/// The way in which the library reads a std::string or a view of one.
using TextOfString = decltype(nlohmann::detail::input_adapter(std::declval<const std::string&>()));
using TextOfView = decltype(nlohmann::detail::input_adapter(std::declval<const std::string_view&>()));

}  // namespace continua::detail

// The tests are not optimised; where they instantiate a template too, the linker would take theirs for the whole
// program.
extern template class nlohmann::detail::lexer<continua::Json, continua::detail::TextOfString>;
extern template class nlohmann::detail::lexer<continua::Json, continua::detail::TextOfView>;
extern template class nlohmann::detail::serializer<continua::Json>;

namespace continua {

/// One line of compact JSON. Bytes that are not UTF-8 become U+FFFD.
std::string compact(const Json& value);

/// The readers below refuse values nested deeper than this: printing and comparing a value recurse, and the use of the
/// call stack must not depend on a file.
inline constexpr int max_json_depth = 200;
/// Objects with more members are refused too: finding a member takes time in proportion to the number of members.
inline constexpr std::size_t max_json_members = 10000;

/// A place in a text, counted from 1; columns are bytes.
struct TextPlace {
  std::size_t line = 1, column = 1;
  auto operator<=>(const TextPlace&) const = default;
};

/// Reads a line of a JSON Lines file as a value. The place of an error is "name:line:column".
Result<Json> parse_json_line(std::string_view text, const std::string& name, std::size_t line);

/// A JSON document with the line and column of each of its values.
class LocatedJson {
 public:
  /// `name` stands for the document in errors. An error has line, column, and the found and expected text. A byte order
  /// mark at the beginning is skipped.
  static Result<LocatedJson> parse(std::string_view text, std::string name);

  /// Reads the whole file; missing, unreadable and empty files are errors too.
  static Result<LocatedJson> read(const std::string& path);

  const Json& root() const { return root_; }
  const std::string& name() const { return name_; }

  /// The place of the value at `pointer` ("/transitions/3/when", RFC 6901), or of its nearest enclosing value with one.
  TextPlace place(std::string_view pointer) const;
  /// The place of the key of the member at `pointer`; for an element, of the element itself.
  TextPlace key_place(std::string_view pointer) const;
  /// The place of the byte number `byte` of the text at `pointer`; escapes before it in the document are accounted for.
  TextPlace place_in_text(std::string_view pointer, std::size_t byte) const;

  /// An error at "name:line:column".
  Error error(TextPlace place, std::string sentence) const;
  Error error(std::string_view pointer, std::string sentence) const {
    return error(place(pointer), std::move(sentence));
  }
  std::string where(std::string_view pointer) const { return error(pointer, "").where; }

  /// A key that its object has already. The last value of a key counts.
  struct Duplicate {
    TextPlace place;
    std::string key;
  };
  const std::vector<Duplicate>& duplicates() const { return duplicates_; }

 private:
  struct Location {
    TextPlace value, key;
    std::size_t offset;  ///< first byte of the value in text_
  };
  struct Locations;
  const Location* location(std::string_view pointer) const;

  Json root_;
  std::string name_, text_;
  std::shared_ptr<Locations> locations_;  ///< found when they are first asked for: few documents have problems
  std::vector<Duplicate> duplicates_;
};

/// Reads a whole file. Errors: it is missing, a folder, or unreadable. An empty file is an empty string.
Result<std::string> read_file(const std::string& path);

/// `text` without a UTF-8 byte order mark at its beginning.
std::string_view without_byte_order_mark(std::string_view text);

/// `text` in single quotes, for a sentence of one line: at most 60 bytes of it, with \xNN for bytes that are not
/// printable ASCII or UTF-8.
std::string in_quotes(std::string_view text);

/// The letters (bytes) to insert, delete, replace, or exchange with the next one to make one text of the other. No
/// letter is changed twice (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name in `known` nearest to `name` by edit distance, as " (did you mean 'x'?)"; empty if no name is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

}  // namespace continua
