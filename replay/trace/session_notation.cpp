#include "continua/replay/trace/session_notation.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "continua/core/trimmed.h"

namespace continua {
namespace {

constexpr double scale = 0.4;
constexpr double voxsim_table_top_m = 0.740948;

// How VoxSim spreads a pointing sample over its table: X = -x · 1.54 / 0.9146, Z = (y - 0.77) · 0.3333.
constexpr double sample_x_to_m = 1.54 / 0.9146, sample_y_to_m = 0.3333, sample_y_middle = 0.77;

// The recogniser calls a weak match "low"; it is a gesture all the same, believed less.
constexpr double confidence_of_low = 0.3;

double micrometres(double length_m) {
  const double rounded = std::round(length_m * 1e6) / 1e6;
  return rounded == 0 ? 0 : rounded;  // never -0
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end), " "));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<Vec3> sample(std::string_view x, std::string_view y) {
  const auto at_x = finite_number(x), at_y = finite_number(y);
  if (!at_x || !at_y) return std::nullopt;
  return table_point_of_sample(*at_x, *at_y);
}

// "x; y; z" as "x, y, z" in W; nothing if it is not three numbers.
std::optional<std::string> place_from_voxsim(std::string_view inside) {
  const auto parts = split(inside, ';');
  if (parts.size() != 3) return std::nullopt;
  const auto x = finite_number(parts[0]), y = finite_number(parts[1]), z = finite_number(parts[2]);
  if (!x || !y || !z) return std::nullopt;
  const Vec3 p_W = point_from_voxsim(*x, *y, *z);
  return fmt::format("{}, {}, {}", p_W.x(), p_W.y(), p_W.z());
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::optional<double> finite_number(std::string_view text) {
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

Vec3 point_from_voxsim(double x, double y, double z) {
  return {micrometres(-scale * x), micrometres(-scale * z), micrometres(scale * (y - voxsim_table_top_m))};
}

Vec3 table_point_of_sample(double x, double y) {
  Vec3 p_W = point_from_voxsim(-x * sample_x_to_m, 0, (y - sample_y_middle) * sample_y_to_m);
  p_W.z() = 0;
  return p_W;
}

std::string notation_from_voxsim(std::string_view content) {
  // The system once performed the text of a message that it had received.
  if (content.starts_with("G "))
    if (const auto gesture = gesture_from_voxsim(content.substr(2))) return "'" + symbol_of(gesture->event) + "'";
  if (content.find('(') == std::string_view::npos) return std::string(content);
  std::string out;
  for (std::size_t at = 0; at < content.size(); ++at) {
    const char c = content[at];
    const auto close = c == '<' ? content.find('>', at) : std::string_view::npos;
    const auto place =
        close == std::string_view::npos ? std::nullopt : place_from_voxsim(content.substr(at + 1, close - at - 1));
    if (place) {
      out += '<' + *place + '>';
      at = close;
    } else {
      out += c;
      if (c == ',' && at + 1 < content.size() && content[at + 1] != ' ') out += ' ';
    }
  }
  return out;
}

std::optional<ImportedGesture> gesture_from_voxsim(std::string_view content) {
  ImportedGesture imported;
  InputEvent& event = imported.event;
  event.modality = Modality::gesture;

  const auto comma = content.find(',');
  if (comma != std::string_view::npos) {
    const auto numbers = split(content.substr(comma + 1), ',');
    if (numbers.size() == 2) event.target_W = sample(numbers[0], numbers[1]);
    imported.point_unread = !event.target_W;
  }

  auto words = split(content.substr(0, comma), ' ');
  words.erase(std::remove(words.begin(), words.end(), std::string_view()), words.end());
  if (words.size() > 1 && is_one_of(words.front(), {"left", "right"})) {
    event.hand = words.front();
    words.erase(words.begin());
  }
  if (words.size() > 1 && is_one_of(words.back(), {"high", "low", "start", "stop"})) {
    event.phase = words.back() == "stop" ? "stop" : "start";
    if (words.back() == "low") event.confidence = confidence_of_low;
    words.pop_back();
  }
  if (words.size() > 1 && is_one_of(words.back(), {"left", "right", "front", "back", "up", "down"})) {
    event.direction = words.back();
    words.pop_back();
  }
  if (words.empty()) return std::nullopt;
  for (const auto word : words) {
    if (!event.name.empty()) event.name += '_';
    event.name += word;
  }
  return imported;
}

std::optional<InputEvent> pointing_from_voxsim(std::string_view content) {
  const auto parts = split(content, ',');
  if (parts.size() != 3 || !is_one_of(parts[0], {"l", "r"})) return std::nullopt;
  InputEvent event;
  event.modality = Modality::pointing;
  event.hand = parts[0] == "l" ? "left" : "right";
  event.target_W = sample(parts[1], parts[2]);
  if (!event.target_W) return std::nullopt;
  return event;
}

}  // namespace continua
