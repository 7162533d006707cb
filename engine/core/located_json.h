// JSON that remembers where it came from, so that an error about a value names its file and line.
// The only place where nlohmann/json is included.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/result.h"

namespace continua {

/// Keys keep the order in which they were written: what is printed is the same on every machine.
using Json = nlohmann::ordered_json;

/// One line of compact JSON. Bytes that are not UTF-8 become U+FFFD.
std::string compact(const Json& value);

/// Values nested deeper than this are refused by the readers below: printing and comparing a value recurse, and
/// the stack must not depend on what a file contains.
inline constexpr int max_json_depth = 200;

/// One line of a JSON Lines file, read as a value. An error is placed at "name:line:column".
Result<Json> parse_json_line(std::string_view text, const std::string& name, std::size_t line);

/// A JSON document with the line and column of each of its values.
class LocatedJson {
 public:
  /// `name` stands for the document in errors. An error names line, column, what was found and expected.
  /// A byte order mark at the beginning is skipped.
  static Result<LocatedJson> parse(std::string_view text, std::string name);

  /// Reads the whole file; missing, unreadable and empty files are errors too.
  static Result<LocatedJson> read(const std::string& path);

  const Json& root() const { return root_; }
  const std::string& name() const { return name_; }

  /// "name:line:column" of the value at `pointer` ("/transitions/3/when", RFC 6901), or of its nearest
  /// enclosing value that has one.
  std::string where(std::string_view pointer) const;

  Error error(std::string_view pointer, std::string sentence) const { return {where(pointer), std::move(sentence)}; }

 private:
  struct Place {
    std::size_t line, column;
  };
  Json root_;
  std::string name_;
  std::unordered_map<std::string, Place> places_;
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
