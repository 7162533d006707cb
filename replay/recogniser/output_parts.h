// A recogniser's output in parts, each of which can be read by itself, as they come.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace continua {

/// The parts that an output consists of.
enum class PartKind {
  json,   ///< values, one after the other, on one line or many
  xml,    ///< documents, one after the other
  lines,  ///< lines
};

struct OutputPart {
  std::string text;
  std::size_t line = 1;  ///< on which it begins
};

/// Cuts a stream into parts. A broken part ends where it can be seen to be broken, so what follows is not lost: a JSON
/// value before a brace that cannot stand there, or with the line on which a text does not end; a document before
/// another's first line.
class OutputParts {
 public:
  explicit OutputParts(PartKind kind) : kind_(kind) {}

  void add(std::string_view text) { rest_ += text; }
  /// The next part that is there as a whole; none: more is needed.
  std::optional<OutputPart> next();
  /// The remainder once there is no more: a part that was cut short.
  std::optional<OutputPart> last();

 private:
  void pass_blanks();
  std::optional<std::size_t> json_end();
  std::optional<std::size_t> xml_end();
  OutputPart take(std::size_t length);

  PartKind kind_;
  std::string rest_;
  std::size_t line_ = 1;    // of the beginning of rest_
  std::size_t looked_ = 0;  // as far as rest_ has no end of the part
  // Within a JSON value, at looked_: the brackets that are open, the last character but blanks, whether in a text.
  std::string open_;
  char before_ = 0;
  bool quoted_ = false;
};

}  // namespace continua
