// The results of a check, file by file: as lines for people, as JSON, and several shards as one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/terminal/shard.h"
#include "continua/replay/terminal/terminal.h"

namespace continua {

/// The result for one file.
struct CheckCase {
  std::string path;
  bool is_trace = false;
  std::string verdict;          ///< of a trace as check.h has it; else "true", "not true", "cannot be used"
  std::string sentence;         ///< what its line tells: "3 expectations, same", "changed: …", "12 examples"
  int status = exit_done;       ///< an ExitStatus
  std::size_t line = 0;         ///< of a trace, where the sentence belongs; 0: to the whole
  std::vector<Error> problems;  ///< each is told on a line of its own
  std::string details;          ///< Markdown: the differences; may be empty
  std::string page;             ///< path of an HTML report; empty: no report
};

struct CheckReport {
  Shard shard;
  std::size_t files = 0;             ///< of all shards together
  std::vector<std::size_t> numbers;  ///< of its files among them, from 0, ascending
  double seconds = 0;                ///< that it took
  std::vector<CheckCase> cases;      ///< of its files

  /// The worst of its cases.
  int status() const;
};

/// "ok   talk.trace.jsonl: 3 expectations, same".
std::string line_of(const CheckCase& one);

/// Of the traces, or of the other files: how many came to which verdict, from the best to the worst.
std::vector<std::pair<std::string, std::size_t>> verdicts_of(const CheckReport& report, bool traces);

/// "41 traces: 38 same, 2 same decisions, 1 changed; 9 other files: 9 true; in 12.3 s".
std::string total_of(const CheckReport& report);

/// {"check": 1, "shard": [I, N], "files", "numbers", "seconds", "cases": [{"path", "trace", "verdict", "sentence",
/// "status", "line", "problems" [{"where", "sentence"}], "details", "page"}]}; fields that are empty are left out.
Json json_of(const CheckReport& report);

/// Reads the output of json_of. `name` stands for the file in errors.
Result<CheckReport> read_report(std::string_view text, const std::string& name);

struct MergedReports {
  CheckReport report;           ///< of all shards; its cases in the order of a check that is not shared
  std::vector<Error> problems;  ///< shards that are missing, doubled or of another check
};

/// Of `names` and `reports`, of the same size; at least one.
MergedReports merged(const std::vector<std::string>& names, const std::vector<CheckReport>& reports);

}  // namespace continua
