#include "continua/replay/log/time_text.h"

#include <cmath>

#include <fmt/format.h>

namespace continua {
namespace {

// "5.050" is "5.05", "5.000" is "5".
std::string without_zeros(std::string text) {
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string time_text(double seconds) {
  const auto ms = std::llround(seconds * 1000);
  return fmt::format("{}:{}", ms / 60'000,
                     without_zeros(fmt::format("{:06.3f}", static_cast<double>(ms % 60'000) / 1000)));
}

std::string seconds_text(double seconds) { return without_zeros(fmt::format("{:.3f}", seconds)) + " s"; }

}  // namespace continua
