// The records of a run that bear on one of them, for its explanation. Each is read at most once, and only when asked
// for.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/time_text.h"

namespace continua {

/// A chain of causes, and the turns of the inputs that contributed. A turn is all that one input brought about, up to
/// the next input on the way.
class ExplainScope {
 public:
  /// REQUIRES n < run.size(); `run` must outlive the scope.
  ExplainScope(const RunIndex& run, std::size_t n);

  const RunIndex& run() const { return run_; }
  std::size_t n() const { return chain_.front(); }

  /// The record, or an empty object where its line cannot be read.
  const Json& record(std::size_t n);

  /// The words for the run's ids, places, gestures and programs; after tell_raw() the ids themselves.
  const RunWords& words();
  void tell_raw() { words_.emplace(RunWords::raw()); }

  /// n, its cause, the cause of that, and so on.
  const std::vector<std::size_t>& chain() const { return chain_; }

  /// The input that the turn of record n belongs to: n itself or the nearest among its causes; none before the first.
  std::optional<std::size_t> input_of(std::size_t n) const;

  /// The inputs in the chain, and those that its records and their percepts and readings say they go back to, in order.
  const std::vector<std::size_t>& inputs() const { return inputs_; }

  /// Records of a kind, up to n, in the turn of one of `inputs()`, in order.
  std::vector<std::size_t> of_turn(std::size_t input, std::string_view kind) const;

  /// The same of all those turns, the latest first.
  std::vector<std::size_t> latest(std::string_view kind) const;

 private:
  const RunIndex& run_;
  std::map<std::size_t, Json> records_;
  std::optional<RunWords> words_;
  std::vector<std::size_t> chain_, inputs_;
  std::map<std::size_t, std::vector<std::size_t>> turns_;  // input -> records
};

/// The numbers of records that a member lists, without those that are no record before `before`.
std::vector<std::size_t> record_numbers(const Json& object, const char* key, std::size_t before);

/// A member of the log's header, null where it has none. The header carries the whole machine, so that reading all of
/// it takes most of the time of an explanation.
Json header_member(const RunIndex& run, const char* name);

}  // namespace continua
