#include "continua/replay/export/picture_width.h"

#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "continua/core/located_json.h"

namespace continua {
namespace {

constexpr double narrowest_mm = 40, widest_mm = 2000;
constexpr std::array<std::pair<std::string_view, double>, 5> units = {
    {{"", 1}, {"mm", 1}, {"cm", 10}, {"px", 25.4 / 96}, {"pt", 25.4 / 72}}};

}  // namespace

Result<double> picture_width(const std::string& text, const std::string& where) {
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  auto unit = std::string_view(text).substr(static_cast<std::size_t>(end - text.data()));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  for (const auto& [name, mm] : units)
    if (problem == std::errc() && unit == name && number * mm >= narrowest_mm && number * mm <= widest_mm)
      return number * mm;
  return Error{where, fmt::format("found {}; expected a width from {} to {} mm, such as 85, 85mm, 8.5cm or 320px",
                                  in_quotes(text), narrowest_mm, widest_mm)};
}

}  // namespace continua
