#include "continua/replay/export/csv_cell.h"

#include <string>

namespace continua {

void write_cell(std::string_view text, std::ostream& out) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out << text;
    return;
  }
  out << '"';
  for (const char c : text) {
    if (c == '"') out << '"';
    out << c;
  }
  out << '"';
}

void write_value(const Json& value, std::ostream& out) {
  if (value.is_null()) return;
  if (const auto* text = value.get_ptr<const std::string*>())
    write_cell(*text, out);
  else
    write_cell(value.dump(-1, ' ', false, Json::error_handler_t::replace), out);
}

}  // namespace continua
