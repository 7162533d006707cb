// A record as the line of a log, for tests.
#pragma once

#include <string>

#include "continua/replay/log/record_text.h"

namespace continua {

inline std::string line_of(const log::Stamp& stamp, const log::Record& record) {
  std::string line, decision;
  log::add_text(stamp, record, line, decision);
  return line;
}

}  // namespace continua
