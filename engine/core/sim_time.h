// Simulated time: whole microseconds since the start of the trace. No wall clock enters the engine.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace continua {

struct SimTime {
  std::int64_t us = 0;

  static SimTime from_seconds(double seconds) { return {static_cast<std::int64_t>(std::llround(seconds * 1e6))}; }
  double seconds() const { return static_cast<double>(us) / 1e6; }

  friend auto operator<=>(const SimTime&, const SimTime&) = default;
  friend SimTime operator+(SimTime a, SimTime b) { return {a.us + b.us}; }
  friend SimTime operator-(SimTime a, SimTime b) { return {a.us - b.us}; }
};

}  // namespace continua
