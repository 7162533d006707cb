// A page that shows how a run differs from the approved one: the verdict in a sentence, the expectations that are not
// met, pictures of both scenes, the dialogue of both side by side, the records that differ, the machine's graph with
// the run's visits, and the way to reproduce it and to look into it.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// The scene of both runs at an instant, or why there is no picture.
struct WorldPictures {
  std::string title;  ///< "where they part"
  struct Side {
    std::string title;  ///< "A: approved, at 0:04"
    std::string png;    ///< in base64; empty: none
    std::string trouble = {};
  };
  std::vector<Side> sides;
};

struct RunReport {
  std::string trace;     ///< its path
  std::string verdict;   ///< "changed"
  std::string sentence;  ///< why
  const RunIndex* run = nullptr;
  const RunIndex* approved = nullptr;  ///< null: there is none, or only its digests
  const RunDiff* diff = nullptr;       ///< of the approved run and the run; null where `approved` is
  std::vector<std::string> commands;   ///< that reproduce it
  std::vector<WorldPictures> worlds = {};
};

/// The page, as run_html.h has pages. REQUIRES a run. May be called from several threads.
std::string report_page(const RunReport& report);

}  // namespace continua
