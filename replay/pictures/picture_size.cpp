#include "continua/replay/pictures/picture_size.h"

#include <charconv>

#include <fmt/format.h>

#include "continua/core/located_json.h"

namespace continua {
namespace {

constexpr int least_side = 16;

bool read_side(std::string_view text, int& side) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), side);
  return problem == std::errc() && end == text.data() + text.size() && side >= least_side && side <= max_image_side;
}

}  // namespace

Result<ImageSize> picture_size(std::string_view text) {
  const auto by = std::min(text.find('x'), text.size());
  ImageSize size;
  if (by < text.size() && read_side(text.substr(0, by), size.width) && read_side(text.substr(by + 1), size.height))
    return size;
  return Error{"", fmt::format("found {}; expected WIDTHxHEIGHT in pixels, each from {} to {}", in_quotes(text),
                               least_side, max_image_side)};
}

}  // namespace continua
