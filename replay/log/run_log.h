// Writes run logs (RUNLOG.md): numbers the lines and keeps the digests that the last line states.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/record_text.h"
#include "continua/replay/log/record_writer.h"
#include "continua/replay/log/records.h"

namespace continua {

/// Whether records of this kind are decisions (RUNLOG.md, `decisions`).
bool is_decision(std::string_view kind);

/// Takes the records of a run one after another and gives the parts of them that must be equal on every machine and in
/// every world, {"kind", "fields", "t"}, in the order in which they count.
class DecisionOrder {
 public:
  /// Nothing, if the record is no decision, or tells how an act goes on.
  std::optional<Json> next(const Json& record);
  /// After the last record: the outcome of each act, by the acts' numbers.
  std::vector<Json> outcomes() const;

 private:
  std::map<std::int64_t, Json> outcomes_;
};

/// Every so many records the last one is a `block`, which states a digest of the others.
inline constexpr int records_per_block = 256;

/// A decision nearer than this to another one is fragile: the smallest step that decisions see of the world, metres
/// (world/geometry.h), and as much of any other number that was compared.
inline constexpr double fragile_margin = 1e-4;

class RunLog {
 public:
  /// Every line is written to `out` whole; whether it is in a file at once is up to `out`, which must outlive the log.
  /// Where `out` has no buffer, records are counted and thrown away.
  explicit RunLog(std::ostream& out);

  /// Writes one record and returns its number. `cause`: number of the record that brought it about. `measured`: its
  /// time follows from the end of an act.
  int write(const log::Record& record, SimTime t, std::optional<int> cause = std::nullopt, bool measured = false);

  /// Writes the last line.
  void finish(SimTime t);

  /// How many records of each kind there are.
  const std::map<std::string, std::int64_t, std::less<>>& counts() const { return counts_; }
  /// How many decisions were fragile so far.
  std::size_t fragile() const { return fragile_.size(); }

 private:
  int write_line(const log::Record& record, SimTime t, std::optional<int> cause = std::nullopt, bool measured = false);
  void count(std::string_view kind);
  void decide(const log::Record& record);
  void close_block(SimTime t);
  void add_block_to_all();

  std::ostream& out_;
  int next_ = 0;
  std::vector<log::FragileDecision> fragile_;
  std::map<std::string, std::int64_t, std::less<>> counts_;  ///< by kind
  log::RecordWriter writer_;
  log::RecordText block_;        ///< the digest of the block before, and the lines so far
  std::size_t block_begin_ = 0;  ///< of the lines in it
  log::RecordText decision_;     ///< of the record that is being written
  RunningDigest all_, decisions_, physics_;
  std::map<std::int64_t, std::string> outcomes_;  ///< of acts, by their numbers
};

}  // namespace continua
