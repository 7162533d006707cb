// Random objects put at random places, and the outcomes, judged by others than the body itself: the reach of a place by
// the measures of the arm, the places of things by the world's snapshot, their depth in one another by contacts
// computed anew from the reported poses.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "continua/body/body.h"
#include "continua/body/placement.h"
#include "continua/simulation/scene.h"

namespace continua {

/// One put and its outcome. Lengths in metres.
struct PutTrial {
  std::string what;       ///< "put(block4, <0.1, -0.02, 0>)"
  ActReport end;          ///< of a put in steps, that of the first step that was not done
  bool counted = false;   ///< the arm surely reaches, and a person would find it possible
  bool hopeless = false;  ///< the arm surely does not reach
  bool refused = false;   ///< it ended as it began, and nothing had moved
  bool at_goal = false;   ///< measured: the object stands still where it was wanted
  /// Distance of the object's centre from a goal that is a point, seen from above.
  std::optional<double> error_m;
  std::string measured;  ///< why it is not at its goal, or how far off
  double deepest_m = 0;  ///< depth of an object in the table or in another object, at any reported pose
  std::string deepest;   ///< which two
  double seconds = 0;    ///< that it took, of the world's time
};

/// The scene at `path` set out anew every few puts, at random; then puts of random objects: three of five at points of
/// the table that are drawn uniformly, free or not, else by a relation to another object. Every third is told in steps,
/// as programs tell it. Of puts that do not count, three in ten are done. It ends when `counted` puts count, or hardly
/// any do.
/// REQUIRES a scene that loads.
std::vector<PutTrial> random_puts(const std::string& path, std::uint64_t seed, int counted);

/// The bounds that many puts together must keep.
struct PutFigures {
  int trials = 0, counted = 0, done = 0;  ///< done of those counted
  int refused = 0;                        ///< of all trials
  double median_m = 0, most_m = 0;        ///< errors of those done at a point: the median, and the 95th percentile
  double deepest_m = 0;
  double seconds = 0;
  std::vector<std::string> failures;  ///< counted puts that were not done
  std::vector<std::string> lies;      ///< reports that are not true
  std::vector<std::string> depths;    ///< things in one another
};
PutFigures figures_of(const std::vector<PutTrial>& trials);

}  // namespace continua
