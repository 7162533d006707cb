// The inputs that records of a run came of, by following `because` (RUNLOG.md).
#pragma once

#include <cstddef>
#include <optional>
#include <set>

#include "continua/core/located_json.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Collects inputs. Each record behind those that are added is read at most once.
class RunSources {
 public:
  /// `run` must outlive it.
  explicit RunSources(const RunIndex& run) : run_(run) {}

  /// Adds the inputs that the `because` of record n names, and those behind the registers and symbols that it names.
  /// The error is that of a line that cannot be read.
  std::optional<Error> add(std::size_t n, const Json& record);

  const std::set<std::size_t>& inputs() const { return inputs_; }

 private:
  const RunIndex& run_;
  std::set<std::size_t> inputs_, followed_;
};

}  // namespace continua
