// How much noise a conversation bears: what becomes of its run where recognisers err.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/noise/vary.h"
#include "continua/replay/session/session.h"

namespace continua {

/// How a run under noise ends, held against the run without. The first answer that is another decides: the human of a
/// trace goes on as if it had been the same, so the rest of such a run means little.
enum class RunEnd {
  same,       ///< the same acts, in the same order; points of them less than 0.1 m apart are the same
  asks,       ///< the avatar says something that it did not say before; all acts until then are those of the other run
  less,       ///< acts are missing, and nothing was said of it
  otherwise,  ///< an act that the other run does not have there
};
inline constexpr std::size_t run_ends = 4;
inline constexpr std::array<const char*, run_ends> run_end_names{"same", "asks", "less", "otherwise"};

/// One thing that happened in a run: an act that was asked for, an utterance, or that the human said or showed
/// something. An act that the body refused before any of its steps was done is none: nothing moved.
struct Happened {
  enum class Kind { act, utterance, human } kind;
  std::string text;
};

/// From a run's log, in order.
std::vector<Happened> happenings_of(std::string_view log);

RunEnd run_end(const std::vector<Happened>& whole, const std::vector<Happened>& noisy);

struct RobustOptions {
  Noise noise;  ///< at strength 1
  std::vector<double> strengths{0.25, 0.5, 1, 2};
  int count = 10;          ///< runs of each trace for each kind and strength
  std::uint64_t seed = 0;  ///< together with the trace's text
};

/// The ends of runs under one kind of noise.
struct RobustPoint {
  std::string kind;
  double strength = 0;
  std::array<int, run_ends> ends{};

  int runs() const;
  double share(RunEnd end) const;
};

/// A smallest change that made a run do something else.
struct Break {
  std::string trace, kind;
  double strength = 0;
  std::vector<std::string> sentences;  ///< of its edits
  std::vector<std::string> acts;       ///< that the run without noise does not have
  Trace with;                          ///< the trace with these edits alone
};

struct Robustness {
  std::vector<RobustPoint> points;  ///< by kind, then strength
  std::vector<Break> breaks;        ///< for each kind that has one, of the weakest noise and the first seed
};

/// The runs of one trace, in the world of the session's options.
Result<Robustness> robustness_of(Session& session, const RobustOptions& options);

/// Adds the figures of another trace; breaks of the same kind all stay.
void add(Robustness& sum, Robustness more);

}  // namespace continua
