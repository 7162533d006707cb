#include "continua/replay/export/svg_canvas.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "continua/core/markup.h"

namespace continua {
namespace {

constexpr double head_width = 6;
constexpr double line_height = 12;          ///< of a line of text
constexpr std::size_t points_of_piece = 8;  ///< of a curve, by which its extent is found

constexpr const char* drawing_style = R"(<style>
  svg { color: #1b1f24; }
  .paper { fill: #ffffff; }
  text { fill: currentColor; text-anchor: middle; }
  .state text { font: 12px Helvetica, Arial, "DejaVu Sans", sans-serif; }
  .small text { font-size: 9.6px; }
  .label text, .told { font: 9.4px "DejaVu Sans Mono", Menlo, Consolas, "Liberation Mono", monospace; }
  .label text { stroke: #ffffff; stroke-width: 3px; stroke-linejoin: round; paint-order: stroke; }
  .number text, .heading { font: bold 9.4px Helvetica, Arial, "DejaVu Sans", sans-serif; }
  .number text { stroke: none; }
  .number .badge { fill: #ffffff; stroke: currentColor; stroke-width: 0.8px; }
  .heading, .told { text-anchor: start; white-space: pre; }
  .box { fill: #f3f5f8; stroke: currentColor; stroke-width: 1.2px; }
  .ring { fill: none; stroke: currentColor; stroke-width: 1.2px; }
  .everywhere .box { fill: none; stroke-dasharray: 2 3; }
  .line { fill: none; stroke: currentColor; stroke-width: 1px; }
  .head { fill: currentColor; }
  .rejected .line { stroke-dasharray: 5 3; }
  .taken .line { stroke: #0a58ca; stroke-width: 2px; }
  .taken .head { fill: #0a58ca; }
  .taken .box { fill: #dbe8fb; stroke: #0a58ca; stroke-width: 2px; }
  .never { opacity: 0.45; }
  @media (prefers-color-scheme: dark) {
    svg { color: #e3e6ea; }
    .paper { fill: #15181c; }
    .label text { stroke: #15181c; }
    .number .badge { fill: #15181c; }
    .box { fill: #23282f; }
    .taken .line { stroke: #6ea8fe; }
    .taken .head { fill: #6ea8fe; }
    .taken .box { fill: #1c2f4d; stroke: #6ea8fe; }
  }
</style>
)";

// To a tenth of a pixel.
std::string number(double value) { return fmt::format("{}", std::round(value * 10) / 10 + 0.0); }

std::string pair(const PagePoint& p) { return number(p.x) + "," + number(p.y); }

}  // namespace

void SvgCanvas::begin_group(std::string_view kind, std::string_view title) {
  body_ += fmt::format("<g class=\"{}\"><title>{}</title>", kind, in_markup(title));
}

void SvgCanvas::end_group() { body_ += "</g>\n"; }

void SvgCanvas::arrow(const Curve& line, const PagePoint& tip, double thickness) {
  if (line.empty()) return;
  body_ += "<path class=\"line\"";
  if (thickness > 0) body_ += fmt::format(" style=\"stroke-width:{}px\"", number(thickness));
  body_ += " d=\"M" + pair(line[0]);
  for (std::size_t i = 1; i < line.size(); ++i) body_ += (i % 3 == 1 ? " C" : " ") + pair(line[i]);
  for (const auto& point : points_along(line, points_of_piece)) reach(point);
  const auto& base = line.back();
  const double length = std::max(std::hypot(tip.x - base.x, tip.y - base.y), 1e-6);
  const double half_width = head_width / 2 + thickness / 2;
  const double x = (tip.x - base.x) / length * half_width, y = (tip.y - base.y) / length * half_width;
  body_ += fmt::format("\"/><path class=\"head\" d=\"M{} L{} L{} Z\"/>", pair(tip), pair({base.x - y, base.y + x}),
                       pair({base.x + y, base.y - x}));
}

void SvgCanvas::pill(std::string_view kind, const Pill& pill, double grown) {
  const double width = pill.width + 2 * grown, height = pill.height + 2 * grown;
  const PagePoint corner{pill.centre.x - width / 2, pill.centre.y - height / 2};
  body_ += fmt::format(R"(<rect class="{}" x="{}" y="{}" width="{}" height="{}" rx="{}"/>)", kind, number(corner.x),
                       number(corner.y), number(width), number(height), number(pill.radius() + grown));
  reach(corner);
  reach({corner.x + width, corner.y + height});
}

void SvgCanvas::text(const std::vector<std::string>& lines, const PagePoint& centre, double line_height, double width) {
  const double height = line_height * static_cast<double>(lines.size()), top = centre.y - height / 2;
  body_ += "<text>";
  for (std::size_t i = 0; i < lines.size(); ++i)
    body_ += fmt::format(R"(<tspan x="{}" y="{}">{}</tspan>)", number(centre.x),
                         number(top + line_height * (static_cast<double>(i) + 0.78)), in_markup(lines[i]));
  body_ += "</text>";
  reach({centre.x - width / 2, top});
  reach({centre.x + width / 2, top + height});
}

void SvgCanvas::line_of_text(std::string_view kind, std::string_view text, const PagePoint& from, double width) {
  body_ += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, number(from.x), number(from.y),
                       in_markup(text));
  reach({from.x, from.y - line_height});
  reach({from.x + width, from.y});
}

std::string SvgCanvas::document(std::string_view title, const std::vector<Layer>& layers) {
  double width = 0, height = picture_margin;
  std::string body;
  for (const auto& [canvas, scale] : layers) width = std::max(width, canvas.width() * scale);
  for (const auto& [canvas, scale] : layers) {
    if (canvas.is_empty()) continue;
    const PagePoint corner{picture_margin + (width - canvas.width() * scale) / 2 - canvas.low_.x * scale,
                           height - canvas.low_.y * scale};
    body += fmt::format("<g transform=\"translate({} {}) scale({:.4f})\">\n{}</g>\n", number(corner.x),
                        number(corner.y), scale, canvas.body_);
    height += canvas.height() * scale + picture_margin;
  }
  width += 2 * picture_margin;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.1f}mm\" height=\"{:.1f}mm\" viewBox=\"0 0 {} {}\" "
      "role=\"img\">\n<title>{}</title>\n{}<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n{}</svg>\n",
      width / pixels_per_mm, height / pixels_per_mm, number(width), number(height), in_markup(title), drawing_style,
      number(width), number(height), body);
}

void SvgCanvas::reach(const PagePoint& p) {
  low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
  high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
}

}  // namespace continua
