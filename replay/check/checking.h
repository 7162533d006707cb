// The check of one file after another, or of several at once.
#pragma once

#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/check/check.h"
#include "continua/replay/check/check_items.h"
#include "continua/replay/check/check_report.h"
#include "continua/replay/pictures/frame_cache.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/terminal/progress.h"

namespace continua {

struct CheckOptions {
  std::vector<std::string> paths;  ///< machines, lexicons, traces, or folders of them; empty: the knowledge folder
  std::string learned;             ///< file of lessons, for traces; empty: none
  std::string knowledge;           ///< folder; empty: the program's own
  std::string language;            ///< for traces; empty: their own
  Json settings = Json::object();  ///< for the machines of traces (machine_settings.h)
  std::optional<bool> physics;  ///< false: the kinematic world; nullopt: the kinematic one if runs are to be approved
  int jobs = 1;
  Shard shard;
  std::string junit, report, summary;  ///< files to write; empty: none
  std::string failures;                ///< folder for the evidence of failing traces; empty: none
  std::vector<std::string> merge;      ///< reports to be told as one; empty: check
  bool strict = false;                 ///< the same decisions are not enough
  bool github = false;                 ///< tell failures as GitHub's annotations too
  bool approve = false;
  bool yes = false;  ///< approve without asking
};

/// Checks files, several at once; their lines come out in order.
class Checking {
 public:
  /// `options` must outlive it.
  Checking(const CheckOptions& options, const DataPaths& data, std::vector<CheckItem> items);

  void run();

  /// After the run: the results, one for each item, with the checks of traces that can be approved or whose run fails.
  std::vector<CheckCase> cases() const;
  const TraceCheck* trace(std::size_t index) const;

 private:
  struct Finding {
    CheckCase told;
    std::optional<TraceCheck> trace;
  };
  Finding check(std::size_t index);
  Finding trace_finding(std::size_t index);
  void finish(std::size_t index, Finding finding);
  /// Writes the evidence of a failure into a folder of its own. Gives the path of the page.
  Result<std::string> keep_failure(std::size_t index, const TraceCheck& check) const;

  const CheckOptions& options_;
  const DataPaths& data_;
  const std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  const std::shared_ptr<RunFrames> frames_ = drawn_frames();
  std::vector<CheckItem> items_;
  std::mutex mutex_;
  std::vector<std::optional<Finding>> findings_;
  Progress progress_;
  std::set<std::string> warned_;
  std::size_t printed_ = 0;
};

/// Prints a case's line, its faults on standard error, and the place of the evidence.
void tell(const CheckCase& one, bool github);

}  // namespace continua
