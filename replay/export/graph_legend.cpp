#include "continua/replay/export/graph_legend.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace continua {
namespace {

// Pixels.
constexpr double column_px = 5.7, line_px = 12, between_columns = 14, narrowest_column = 220, space_before = 3;
constexpr double indent_px = 22;

constexpr std::size_t too_much = 4;  ///< lines that a column may have over its share, rather than part an entry

struct Line {
  std::string text, number;
  bool is_heading = false;
};

// An entry is a heading, with its number, and a line or more for each of its labels.
std::vector<Line> lines_of(const StateGraph& graph, const std::vector<Arrow>& arrows,
                           const std::vector<ArrowLabel>& labels, std::size_t text_columns) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < arrows.size(); ++i)
    if (labels[i].number > 0) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return labels[a].number < labels[b].number; });
  std::vector<Line> lines;
  for (const auto i : order) {
    const auto& arrow = arrows[i];
    auto number = labels[i].lines.front();
    const auto from = arrow.from ? graph.states[*arrow.from].name : "any state";
    for (auto& line : broken(from + " → " + graph.states[arrow.to].name, text_columns)) {
      lines.push_back({std::move(line), number, true});
      number.clear();
    }
    for (const auto& label : arrow.full)
      for (auto& line : broken(label, text_columns, "  ")) lines.push_back({std::move(line), "", false});
  }
  return lines;
}

}  // namespace

SvgCanvas legend_of(const StateGraph& graph, const std::vector<Arrow>& arrows, const std::vector<ArrowLabel>& labels,
                    double width) {
  const auto count = std::max(std::floor((width + between_columns) / (narrowest_column + between_columns)), 1.0);
  const double step = (width + between_columns) / count, text_width = step - between_columns - indent_px;
  const auto lines = lines_of(graph, arrows, labels, static_cast<std::size_t>(std::max(text_width / column_px, 8.0)));
  const auto share = (lines.size() + static_cast<std::size_t>(count) - 1) / static_cast<std::size_t>(count);
  SvgCanvas canvas;
  double x = 0, y = 0;
  std::size_t in_column = 0;
  for (const auto& [text, number, is_heading] : lines) {
    if (in_column >= share + (is_heading ? 0 : too_much)) {
      x += step;
      y = 0;
      in_column = 0;
    }
    if (!number.empty() && in_column > 0) y += space_before;
    y += line_px;
    ++in_column;
    if (!number.empty()) canvas.line_of_text("heading", number, {x, y}, indent_px);
    canvas.line_of_text(is_heading ? "heading" : "told", text, {x + indent_px, y}, text_width);
  }
  return canvas;
}

}  // namespace continua
