// A trace replayed in the kinematic world, and the records of its run.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/session/session.h"
#include "support/catch.h"

namespace continua {

struct Played {
  ReplaySummary summary;
  std::vector<Json> records;

  std::vector<Json> all(const std::string& kind) const {
    std::vector<Json> found;
    for (const auto& record : records)
      if (record["kind"] == kind) found.push_back(record);
    return found;
  }
};

inline Played play(const std::filesystem::path& trace) {
  ReplayOptions options;
  options.physics = false;
  std::stringstream log;
  auto session = Session::load(trace.string(), options);
  if (!session) FAIL(session.error().text());
  Played played{session->run(log), {}};
  for (std::string line; std::getline(log, line);) played.records.push_back(Json::parse(line));
  return played;
}

}  // namespace continua
