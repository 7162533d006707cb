// A run with changes: the request, and the changed trace, made of the run's log alone.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// The latest instant that a request may name, seconds.
inline constexpr double latest_s = 1e9;

/// An input that was something else, or was not.
struct InputEdit {
  std::size_t n = 0;             ///< of its record
  Json event;                    ///< as the log has events, without `t`; null: taken out
  std::optional<double> t = {};  ///< seconds: when it came; otherwise when it did
};

struct WhatIfRequest {
  std::string run;             ///< its id
  std::optional<double> from;  ///< seconds; the request counts from then on
  std::vector<InputEdit> edits;
  std::map<int, std::string> forced;  ///< step → transition
  std::optional<std::uint64_t> seed;
  std::string choice;  ///< empty: the run's own
};

/// {"run", "from", "edits": [{"n", "event", "t"}], "force": {"STEP": "TRANSITION"}, "seed", "choice"}, all but `run`,
/// `n` and `event` optional. The error is a sentence.
Result<WhatIfRequest> what_if_request(const Json& json);

/// The lines of a trace after its first: inputs as edited, other agents' deeds, expectations, and the end of the run.
/// They stand on the lines where they stood in the run's own trace, as far as the log tells. The error is a sentence:
/// an edit is of no input of the trace, or of one before `from`, or moves one there; there are two of one input.
Result<std::string> trace_lines(const RunIndex& run, const WhatIfRequest& request);

/// Replays runs, for those who ask for it without knowing the engine.
class RunWhatIf {
 public:
  virtual ~RunWhatIf() = default;

  struct Replayed {
    std::string log;                    ///< path of the new run log, in the folder given
    std::vector<std::string> warnings;  ///< why it may differ from the run for other reasons
  };
  /// Writes its files, and the log, into `folder`, which exists and is empty. May be called from several threads. Gives
  /// up when `stop` becomes true. The error names the fault of the request, or of the log.
  virtual Result<Replayed> replay(const RunIndex& run, const WhatIfRequest& request, const std::string& folder,
                                  const std::atomic<bool>& stop) = 0;
  /// Replays a trace that somebody handed over, with physics, within the same limits. It can only name scenes, machines
  /// and languages of the program. The error names its fault.
  virtual Result<Replayed> replay_trace(const std::string& trace, const std::string& folder,
                                        const std::atomic<bool>& stop) = 0;
};

}  // namespace continua
