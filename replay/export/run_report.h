// A page that shows how a run differs from the approved one: the verdict in a sentence, the dialogue of both side by
// side, the records that differ, the machine's graph with the run's visits, and the way to reproduce it.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/log/run_index.h"

namespace continua {

struct RunReport {
  std::string trace;     ///< its path
  std::string verdict;   ///< "changed"
  std::string sentence;  ///< why
  const RunIndex* run = nullptr;
  const RunIndex* approved = nullptr;  ///< null: there is none, or only its digests
  const RunDiff* diff = nullptr;       ///< of the approved run and the run; null where `approved` is
  std::vector<std::string> commands;   ///< that reproduce it
};

/// The page, as run_html.h has pages. REQUIRES a run. May be called from several threads.
std::string report_page(const RunReport& report);

}  // namespace continua
