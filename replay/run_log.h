// Writes run logs (RUNLOG.md): numbers the lines and keeps the digests that the last line states.
#pragma once

#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "core/digest.h"
#include "core/located_json.h"
#include "core/sim_time.h"

namespace continua {

/// What of a record must be equal on every machine and in every world: {"kind", "fields", "t"}. Nothing, if nothing
/// must.
std::optional<Json> decision_of(const Json& record);

class RunLog {
 public:
  /// Every line is written to `out` at once and whole; `out` must outlive the log.
  explicit RunLog(std::ostream& out) : out_(out) {}

  /// Writes one record and returns its number. `fields` follow `kind`, `n`, `t` and `cause` in their order.
  int write(std::string_view kind, SimTime t, const Json& fields, std::optional<int> cause = std::nullopt);

  /// Writes the last line.
  void finish(SimTime t);

  /// How many records of each kind there are.
  const std::map<std::string, int>& counts() const { return counts_; }

 private:
  std::ostream& out_;
  int next_ = 0;
  std::map<std::string, int> counts_;
  RunningDigest all_, decisions_, physics_;
  std::map<std::int64_t, std::string> outcomes_;  ///< decision line of the latest state of each act
};

}  // namespace continua
