// The figures of a sweep's points: each point is one line of JSON, and all that is shown is made from such lines.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/score/score.h"

namespace continua {

/// The counts of one trace's run at a point: of the replay, and of its score where something was observed.
struct SweptTrace {
  std::string trace;  ///< its path
  int inputs = 0, refusals = 0, utterances = 0, acts = 0, acts_done = 0, expectations = 0, expectations_met = 0,
      problems = 0;
  Score score;

  /// Counts of 0 are left out.
  Json json() const;
};

/// A figure of a point, over all its traces.
struct SweepFigure {
  const char *name, *about;
};

/// The figures, in the order of tables. SWEEP.md defines them.
const std::vector<SweepFigure>& sweep_figures();

/// {name: value}; a share of nothing is left out.
Json figures_of(const std::vector<SweptTrace>& traces);

/// A line of a sweep: {"point": N, "set", "policy", "seed", "figures", "traces"}.
struct SweptPoint {
  std::size_t number = 0;  ///< from 1
  Json set;
  std::string policy, seed;  ///< empty: none was given
  std::map<std::string, double> figures;

  /// The values under which it ran, by name: those of `set`, and "policy".
  std::map<std::string, Json> values() const;
};

/// Reads a line. `name` stands for the file in errors.
Result<SweptPoint> read_swept_point(std::string_view text, const std::string& name, std::size_t line);

/// The names in the points' values(), in the order in which they first come.
std::vector<std::string> names_of_values(const std::vector<SweptPoint>& points);

/// The figures that any of the points has, in the order of sweep_figures().
std::vector<std::string> names_of_figures(const std::vector<SweptPoint>& points);

/// A value as text; without quotation marks.
std::string text_of_value(const Json& value);

/// A row for each point: its number, values, seed, figures. As CSV, and for a person.
std::string sweep_csv(const std::vector<SweptPoint>& points);
std::string sweep_text(const std::vector<SweptPoint>& points);

}  // namespace continua
