// A record as the line of a log, for tests.
#pragma once

#include <string>

#include "continua/replay/log/record_writer.h"

namespace continua {

inline std::string line_of(const log::Stamp& stamp, const log::Record& record) {
  log::RecordText line, decision;
  log::RecordWriter().add(stamp, record, line, decision);
  return std::string(line.view());
}

}  // namespace continua
