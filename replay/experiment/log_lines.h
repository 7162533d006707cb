// Records of a log in memory, one after the other.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/located_json.h"
#include "continua/replay/log/line_scan.h"

namespace continua {

/// The text of a record's member; empty where it has none that is a text.
inline std::string text_in(std::string_view record, std::string_view name) {
  const auto value = member_in(record, name);
  return value.empty() || value.front() != '"' ? "" : Json::parse(value).get<std::string>();
}

template <class See>
void each_line(std::string_view log, See see) {
  for (auto end = log.find('\n'); end != std::string_view::npos; end = log.find('\n')) {
    see(log.substr(0, end));
    log.remove_prefix(end + 1);
  }
}

}  // namespace continua
