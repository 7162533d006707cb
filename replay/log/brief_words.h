// Words that brief() of several kinds of records needs.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "continua/core/located_json.h"

namespace continua::log {

/// The parts that are not empty, with blanks between.
inline std::string joined(std::initializer_list<std::string_view> parts) {
  std::string out;
  for (const auto part : parts) {
    if (part.empty()) continue;
    if (!out.empty()) out += ' ';
    out += part;
  }
  return out;
}

/// A number as the log has it.
inline std::string number_text(double value) { return compact(Json(value)); }

}  // namespace continua::log
