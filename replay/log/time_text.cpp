#include "continua/replay/log/time_text.h"

#include <charconv>
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

std::optional<double> seconds_of(std::string_view instant) {
  const auto colon = instant.find(':');
  if (colon == std::string_view::npos || colon == 0) return std::nullopt;
  if (instant.find_first_not_of("0123456789.:") != std::string_view::npos) return std::nullopt;
  const auto minutes_text = instant.substr(0, colon), rest = instant.substr(colon + 1);
  int minutes = 0;
  double seconds = 0;
  const auto minutes_end = minutes_text.data() + minutes_text.size(), rest_end = rest.data() + rest.size();
  if (std::from_chars(minutes_text.data(), minutes_end, minutes).ptr != minutes_end) return std::nullopt;
  if (rest.empty() || rest.front() == '.' || std::from_chars(rest.data(), rest_end, seconds).ptr != rest_end ||
      seconds >= 60)
    return std::nullopt;
  return 60.0 * minutes + seconds;
}

std::string seconds_text(double seconds) { return without_zeros(fmt::format("{:.3f}", seconds)) + " s"; }

}  // namespace continua
