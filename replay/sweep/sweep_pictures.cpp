#include "continua/replay/sweep/sweep_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "continua/core/markup.h"
#include "continua/replay/sweep/sweep_axes.h"
#include "continua/replay/terminal/terminal.h"

namespace continua {
namespace {

constexpr std::size_t most_axes = 8;
constexpr double cell_width = 52, cell_height = 26, gap = 14, margin = 16, head_height = 54;
constexpr double level_width = 44;   // of the names of levels beside the rows
constexpr double name_column = 7.4;  // of a letter of a value's name
constexpr double quiet_letter_width = 6.4;
constexpr double curve_width = 240, curve_height = 150, scale_width = 56, foot_height = 46;

constexpr const char* style = R"(<style>
  text { font: 11px Helvetica, Arial, "DejaVu Sans", sans-serif; fill: #1b1f24; text-anchor: middle; }
  .paper { fill: #ffffff; }
  .title { font-size: 15px; font-weight: bold; text-anchor: start; }
  .quiet { fill: #57606a; text-anchor: start; }
  .name { font-weight: bold; }
  .right { text-anchor: end; }
  .on-dark { fill: #ffffff; }
  .on-light { fill: #1b1f24; }
  .frame { fill: none; stroke: #8c959f; }
  .band { fill: #0a58ca; opacity: 0.18; }
  .line { fill: none; stroke: #0a58ca; stroke-width: 2px; }
  .dot { fill: #0a58ca; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e3e6ea; }
    .paper { fill: #15181c; }
    .quiet { fill: #9aa4af; }
    .band, .dot { fill: #6ea8fe; }
    .line { stroke: #6ea8fe; }
  }
</style>
)";

std::string number(double value) { return fmt::format("{}", std::round(value * 10) / 10 + 0.0); }

// As short as its neighbours allow: long names and values are cut in the middle of a picture, whole in its tooltips.
std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  auto end = most - 1;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

class Picture {
 public:
  void text(double x, double y, const std::string& kind, const std::string& content) {
    body_ +=
        fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, number(x), number(y), in_markup(content));
  }
  void add(const std::string& svg) { body_ += svg + "\n"; }

  // The picture under a title and a line about it, both of which have room.
  std::string document(const std::string& title, const std::string& about, double width, double height) {
    text(margin, 24, "title", title);
    text(margin, 41, "quiet", about);
    width = std::max(width, 2 * margin + quiet_letter_width * static_cast<double>(about.size()));
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">\n"
        "<title>{2}</title>\n{3}<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n{4}</svg>\n",
        number(width), number(height), in_markup(title), style, body_);
  }

 private:
  std::string body_;
};

struct Range {
  double low = 0, high = 0;

  void reach(double value, bool first) {
    low = first ? value : std::min(low, value);
    high = first ? value : std::max(high, value);
  }
  double part(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

// Viridis, which is even in lightness and safe for the colour-blind.
std::string colour(double part) {
  constexpr std::array<std::array<double, 3>, 5> stops = {
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
  const auto at = part * static_cast<double>(stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const auto mixed = [&](std::size_t c) {
    return static_cast<int>(std::lround(stops[i][c] + (stops[i + 1][c] - stops[i][c]) * (at - static_cast<double>(i))));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

struct Cell {
  double x = 0, y = 0;
  std::string where;
  SweepMean mean;
};

const char* words_of_interval(const std::vector<SweptPoint>& points) {
  return has_seeds(points) ? "the band is the 95 % interval of the mean over seeds"
                           : "the band reaches from the lowest to the highest value";
}

double extent(const SweepAxis& axis, double of_level) { return static_cast<double>(axis.levels.size()) * of_level; }

// The room beside the rows, in which their names are whole.
double room_for_names(const std::vector<SweepAxis>& axes) {
  std::size_t longest = 0;
  for (std::size_t down = 1; down < axes.size(); ++down) longest = std::max(longest, axes[down].name.size());
  return level_width + name_column * static_cast<double>(longest) + 6;
}

// Level names along the axes of a matrix of panels, and the cells of each panel.
std::vector<Cell> lay_out(Picture& picture, const std::vector<SweptPoint>& points, const std::string& figure,
                          const std::vector<SweepAxis>& axes, double& width, double& height) {
  std::vector<Cell> cells;
  const double left = margin + room_for_names(axes);
  double y = head_height;
  for (std::size_t down = 1; down < axes.size(); ++down) {
    const auto& rows = axes[down];
    picture.text(left - level_width, y + extent(rows, cell_height) / 2 + 4, "name right", rows.name);
    for (std::size_t row = 0; row < rows.levels.size(); ++row)
      picture.text(left - 6, y + cell_height * (static_cast<double>(row) + 0.5) + 4, "right",
                   shortened(rows.levels[row], 7));
    double x = left;
    for (std::size_t across = 0; across < down; ++across) {
      const auto& columns = axes[across];
      for (std::size_t row = 0; row < rows.levels.size(); ++row)
        for (std::size_t column = 0; column < columns.levels.size(); ++column)
          cells.push_back(
              {x + cell_width * static_cast<double>(column), y + cell_height * static_cast<double>(row),
               fmt::format("{} = {}, {} = {}", columns.name, columns.levels[column], rows.name, rows.levels[row]),
               mean_at(points, figure, columns, column, rows, row)});
      x += extent(columns, cell_width) + gap;
    }
    y += extent(rows, cell_height) + gap;
  }
  double x = left;
  for (std::size_t across = 0; across + 1 < axes.size(); ++across) {
    const auto& columns = axes[across];
    for (std::size_t column = 0; column < columns.levels.size(); ++column)
      picture.text(x + cell_width * (static_cast<double>(column) + 0.5), y + 2, "",
                   shortened(columns.levels[column], 8));
    const auto room = static_cast<std::size_t>(extent(columns, cell_width) / 7);
    picture.text(x + extent(columns, cell_width) / 2, y + 20, "name", shortened(columns.name, room));
    x += extent(columns, cell_width) + gap;
  }
  width = std::max(x - gap + margin, 420.0);
  height = y + 20 + margin;
  return cells;
}

// A frame with the curve, its band and the names of its levels.
void draw_curve(Picture& picture, const SweepAxis& axis, const std::vector<SweepMean>& means, const Range& range,
                double left, double top) {
  const auto x = [&](std::size_t level) {
    return number(left + curve_width * (static_cast<double>(level) + 0.5) / static_cast<double>(means.size()));
  };
  const auto y = [&](double value) { return top + curve_height * (0.95 - 0.9 * range.part(value)); };
  std::string upper, lower, line, dots;
  for (std::size_t level = 0; level < means.size(); ++level) {
    const auto& mean = means[level];
    if (mean.points == 0) continue;
    upper += fmt::format("{},{} ", x(level), number(y(mean.high)));
    lower = fmt::format("{},{} ", x(level), number(y(mean.low))) + lower;
    line += fmt::format("{},{} ", x(level), number(y(mean.mean)));
    dots += fmt::format(
        "\n<circle class=\"dot\" cx=\"{}\" cy=\"{}\" r=\"3\"><title>{} = {}: {:.4g}, {:.4g} – {:.4g} "
        "({})</title></circle>",
        x(level), number(y(mean.mean)), in_markup(axis.name), in_markup(axis.levels[level]), mean.mean, mean.low,
        mean.high, counted(mean.points, "point"));
  }
  picture.add(fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", number(left),
                          number(top), number(curve_width), number(curve_height)));
  picture.add(fmt::format("<polygon class=\"band\" points=\"{}{}\"/><polyline class=\"line\" points=\"{}\"/>{}", upper,
                          lower, line, dots));
  for (const auto value : {range.low, range.high})
    picture.text(left - 6, y(value) + 4, "right", fmt::format("{:.4g}", value));
  for (std::size_t level = 0; level < means.size(); ++level)
    picture.text(left + curve_width * (static_cast<double>(level) + 0.5) / static_cast<double>(means.size()),
                 top + curve_height + 14, "",
                 shortened(axis.levels[level], std::max<std::size_t>(3, 36 / means.size())));
  picture.text(left + curve_width / 2, top + curve_height + 30, "name", shortened(axis.name, 34));
}

}  // namespace

std::string heat_maps(const std::vector<SweptPoint>& points, const std::string& figure) {
  auto axes = axes_of(points);
  if (axes.size() < 2) return "";
  axes.resize(std::min(axes.size(), most_axes));
  Picture picture;
  double width = 0, height = 0;
  const auto cells = lay_out(picture, points, figure, axes, width, height);
  Range range;
  bool first = true;
  for (const auto& cell : cells)
    if (cell.mean.points > 0) range.reach(cell.mean.mean, std::exchange(first, false));
  for (const auto& cell : cells) {
    if (cell.mean.points == 0) continue;
    const auto part = range.part(cell.mean.mean);
    picture.add(fmt::format(
        "<g><title>{}: {:.4g} ({})</title><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>"
        "<text class=\"{}\" x=\"{}\" y=\"{}\">{:.4g}</text></g>",
        in_markup(cell.where), cell.mean.mean, counted(cell.mean.points, "point"), number(cell.x), number(cell.y),
        number(cell_width), number(cell_height), colour(part), part < 0.6 ? "on-dark" : "on-light",
        number(cell.x + cell_width / 2), number(cell.y + cell_height / 2 + 4), cell.mean.mean));
  }
  const auto title = fmt::format("{} for each two values", figure);
  const auto about = fmt::format("mean over all other values and seeds; {}; from {:.4g} to {:.4g}",
                                 counted(points.size(), "point"), range.low, range.high);
  return picture.document(title, about, width, height);
}

std::string curves(const std::vector<SweptPoint>& points, const std::string& figure) {
  const auto axes = axes_of(points);
  if (axes.empty()) return "";
  std::vector<std::vector<SweepMean>> means;
  Range range;
  bool first = true;
  for (const auto& axis : axes) {
    means.emplace_back();
    for (std::size_t level = 0; level < axis.levels.size(); ++level) {
      const auto mean = mean_at(points, figure, axis, level);
      means.back().push_back(mean);
      if (mean.points == 0) continue;
      range.reach(mean.low, std::exchange(first, false));
      range.reach(mean.high, false);
    }
  }
  Picture picture;
  const auto columns = std::min<std::size_t>(axes.size(), 3), rows = (axes.size() + columns - 1) / columns;
  for (std::size_t i = 0; i < axes.size(); ++i)
    draw_curve(picture, axes[i], means[i], range,
               margin + scale_width + static_cast<double>(i % columns) * (curve_width + scale_width),
               head_height + static_cast<double>(i / columns) * (curve_height + foot_height));
  const auto title = fmt::format("{} by each value", figure);
  return picture.document(title, fmt::format("mean over all other values; {}", words_of_interval(points)),
                          2 * margin + static_cast<double>(columns) * (curve_width + scale_width),
                          head_height + static_cast<double>(rows) * (curve_height + foot_height) + margin);
}

}  // namespace continua
