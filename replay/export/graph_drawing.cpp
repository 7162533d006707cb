#include "continua/replay/export/graph_drawing.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace continua {
namespace {

// Pixels. Widths of characters are those of wide fonts: a reader's own may be narrower.
constexpr double name_px = 12, small_name_px = 9.6, name_column = 0.61, name_line = 1.2;
constexpr double name_padding = 14, small_name_padding = 9, name_air = 12, small_name_air = 8;
constexpr double label_column = 5.7, label_line = 12, label_padding = 6;
constexpr double badge_height = 13, badge_padding = 7.5;
constexpr double head_length = 7, ring = 3;
constexpr double loop_height = 20, loop_reach = 8, loop_gap = 5;
constexpr double start_length = 18;
constexpr double thinnest = 1, thickest = 4;
constexpr std::size_t name_columns = 14, small_name_columns = 10;
constexpr double points_px = 3;  ///< between points along a line

std::string kind_of(const char* what, std::optional<std::size_t> visits) {
  return std::string(what) + (!visits ? "" : *visits > 0 ? " taken" : " never");
}

std::size_t widest(const std::vector<std::string>& lines) {
  std::size_t longest = 0;
  for (const auto& line : lines) longest = std::max(longest, columns(line));
  return longest;
}

std::vector<PagePoint> dense(const Curve& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  const auto pieces = std::max<std::size_t>((line.size() - 1) / 3, 1);
  return points_along(line, static_cast<std::size_t>(length / points_px) / pieces + 2);
}

// Where a curve comes to the pill.
PagePoint entry_of(const Curve& curve, const Pill& pill, double grown) {
  const auto before = before_entering(curve, pill, grown);
  return before.empty() ? pill.centre : before.back();
}

}  // namespace

GraphDrawing::GraphDrawing(const StateGraph& graph, const std::vector<Arrow>& arrows, const GraphLook& look)
    : graph_(graph), arrows_(arrows), look_(look), labels_(labels_of(arrows, look.labels)) {
  for (const auto& state : graph.states) add_box(state.name, description(state), state.accepting ? ring : 0);
  if (std::any_of(arrows_.begin(), arrows_.end(), [](const auto& arrow) { return !arrow.from; }))
    add_box("any state", "every state", 0);
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    const auto& arrow = arrows_[i];
    most_visits_ = std::max(most_visits_, arrow.visits.value_or(0));
    if (!arrow.loops()) continue;
    auto& box = boxes_[arrow.to];
    (arrow.epsilon || arrow.rejected ? box.below : box.above).push_back(i);
  }
}

void GraphDrawing::add_box(const std::string& name, const std::string& title, double grown) {
  Box box{broken_name(name, look_.small ? small_name_columns : name_columns), title};
  const double size = look_.small ? small_name_px : name_px;
  box.pill.width = std::max(
      size * name_column * static_cast<double>(widest(box.lines)) + (look_.small ? small_name_padding : name_padding),
      2 * size);
  box.pill.height =
      size * name_line * static_cast<double>(box.lines.size()) + (look_.small ? small_name_air : name_air);
  box.grown = grown;
  boxes_.push_back(std::move(box));
}

GraphDrawing::Size GraphDrawing::size_of_label(std::size_t arrow) const {
  const auto& [lines, number] = labels_[arrow];
  const double width = label_column * static_cast<double>(widest(lines));
  if (number > 0) return {std::max(width + badge_padding, badge_height), badge_height};
  return {width + label_padding, label_line * static_cast<double>(lines.size())};
}

double GraphDrawing::height_of_loops(const std::vector<std::size_t>& loops) const {
  double height = 0;
  for (const auto loop : loops) height += loop_height + loop_gap + size_of_label(loop).height;
  return height;
}

LayoutNode GraphDrawing::room_for(std::size_t index) const {
  const auto& box = boxes_[index];
  double width = box.pill.width + 2 * box.grown;
  for (const auto* loops : {&box.above, &box.below})
    for (std::size_t i = 0; i < loops->size(); ++i)
      width = std::max({width, size_of_label((*loops)[i]).width, 3 * loop_reach * static_cast<double>(i + 1)});
  if (graph_.start == index) width += 2 * start_length;
  // Both sides alike, since the state is in the middle.
  return {width, box.pill.height + 2 * (box.grown + std::max(height_of_loops(box.above), height_of_loops(box.below)))};
}

double GraphDrawing::least_area() const {
  double area = 0;
  for (std::size_t i = 0; i < boxes_.size(); ++i) area += room_for(i).width * room_for(i).height;
  for (std::size_t i = 0; i < arrows_.size(); ++i)
    if (!arrows_[i].loops()) area += size_of_label(i).width * size_of_label(i).height;
  return area;
}

Outcome GraphDrawing::draw() {
  std::vector<LayoutNode> nodes;
  for (std::size_t i = 0; i < boxes_.size(); ++i) nodes.push_back(room_for(i));
  std::vector<LayoutEdge> edges;
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    if (arrows_[i].loops()) continue;
    const auto [width, height] = labels_[i].number > 0 ? Size{} : size_of_label(i);
    edges.push_back({index_of(arrows_[i].from), arrows_[i].to, width, height > 0 ? height + 4 : 0});
  }
  const auto layout = lay_out(nodes, edges, graph_.start.value_or(0), look_.layout);
  if (!layout) return Error{graph_.name, layout.error().sentence};
  place_lines(*layout);
  place_badges();
  // Lines come first: none crosses a label or a state.
  draw_lines();
  for (const auto& box : boxes_) {
    draw_loops(box, box.above, -1);
    draw_loops(box, box.below, 1);
  }
  draw_start();
  for (std::size_t i = 0; i < arrows_.size(); ++i) draw_label(i);
  for (std::size_t i = 0; i < boxes_.size(); ++i) draw_box(i);
  return std::nullopt;
}

void GraphDrawing::place_lines(const Layout& layout) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i].pill.centre = layout.nodes[i];
  lines_.assign(arrows_.size(), {});
  tips_.assign(arrows_.size(), {});
  label_places_.assign(arrows_.size(), {});
  std::size_t placed = 0;
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    if (arrows_[i].loops()) continue;
    const auto& edge = layout.edges[placed++];
    const auto &from = boxes_[index_of(arrows_[i].from)], &to = boxes_[arrows_[i].to];
    const auto rest = after_leaving(edge.curve, from.pill, from.grown);
    lines_[i] = before_entering(rest, to.pill, to.grown + head_length);
    tips_[i] = entry_of(rest, to.pill, to.grown);
    label_places_[i] = edge.label;
  }
  for (const auto& box : boxes_)
    for (const double up : {-1.0, 1.0}) {
      double y = box.pill.centre.y + up * (box.pill.height / 2 + box.grown);
      for (const auto loop : up < 0 ? box.above : box.below) {
        const auto height = size_of_label(loop).height;
        const double beside = labels_[loop].number > 0 ? 0 : height / 2 + 2;  // a number stands on its line
        label_places_[loop] = {box.pill.centre.x, y + up * (loop_height + beside)};
        y += up * (loop_height + height + loop_gap);
      }
    }
}

std::vector<PageBox> GraphDrawing::taken_boxes() const {
  std::vector<PageBox> taken;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const auto& [centre, width, height] = boxes_[i].pill;
    taken.push_back({centre, width + 2 * boxes_[i].grown, height + 2 * boxes_[i].grown});
    const double above = height_of_loops(boxes_[i].above), below = height_of_loops(boxes_[i].below);
    if (above > 0) taken.push_back({{centre.x, centre.y - (height + above) / 2}, 4 * loop_reach, above});
    if (below > 0) taken.push_back({{centre.x, centre.y + (height + below) / 2}, 4 * loop_reach, below});
  }
  for (std::size_t i = 0; i < arrows_.size(); ++i)
    if (arrows_[i].loops() || labels_[i].number == 0)
      taken.push_back({label_places_[i], size_of_label(i).width, size_of_label(i).height});
  // The heads of arrows tell where they end.
  for (std::size_t i = 0; i < arrows_.size(); ++i)
    if (!lines_[i].empty()) taken.push_back({tips_[i], head_length, head_length});
  return taken;
}

void GraphDrawing::place_badges() {
  std::vector<Badge> badges;
  std::vector<std::size_t> of;
  std::vector<std::vector<PagePoint>> others;
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    if (lines_[i].empty()) continue;
    if (labels_[i].number == 0) {
      others.push_back(dense(lines_[i]));
      continue;
    }
    badges.push_back({dense(lines_[i]), size_of_label(i).width, size_of_label(i).height});
    of.push_back(i);
  }
  const auto places = badge_places(badges, taken_boxes(), others);
  for (std::size_t i = 0; i < of.size(); ++i) label_places_[of[i]] = places.centres[i];
  apart_ = places.apart;
}

// `what`: the class of the element, an arrow's line or its label.
void GraphDrawing::begin(const char* what, std::size_t index) {
  const auto& arrow = arrows_[index];
  auto title =
      fmt::format("{} → {}", arrow.from ? graph_.states[*arrow.from].name : "any state", graph_.states[arrow.to].name);
  for (const auto& one : arrow.full) title += "\n" + one;
  canvas_.begin_group(kind_of(what, arrow.visits) + (arrow.rejected ? " rejected" : ""), title);
}

// By the square root of its use: the rare are to be told from the frequent, and all are to be seen.
double GraphDrawing::thickness_of(const Arrow& arrow) const {
  if (arrow.visits.value_or(0) == 0) return 0;
  return thinnest +
         (thickest - thinnest) * std::sqrt(static_cast<double>(*arrow.visits) / static_cast<double>(most_visits_));
}

void GraphDrawing::draw_lines() {
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    if (arrows_[i].loops()) continue;
    begin("arrow", i);
    canvas_.arrow(lines_[i], tips_[i], thickness_of(arrows_[i]));
    canvas_.end_group();
  }
}

// `up`: -1 above the state, 1 below.
void GraphDrawing::draw_loops(const Box& box, const std::vector<std::size_t>& loops, double up) {
  const double x = box.pill.centre.x, edge = box.pill.centre.y + up * (box.pill.height / 2 + box.grown);
  double inner = 0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double outer = inner + loop_height, half = loop_reach * static_cast<double>(i + 1);
    // A Bézier curve reaches three quarters of the way to its inner points.
    const double bow = edge + up * outer * 4 / 3;
    begin("arrow", loops[i]);
    canvas_.arrow({{x - half, edge}, {x - 2 * half, bow}, {x + 2 * half, bow}, {x + half + 1, edge + up * head_length}},
                  {x + half, edge}, thickness_of(arrows_[loops[i]]));
    canvas_.end_group();
    inner = outer + size_of_label(loops[i]).height + loop_gap;
  }
}

void GraphDrawing::draw_start() {
  if (!graph_.start) return;
  const auto& box = boxes_[*graph_.start];
  const PagePoint tip{box.pill.centre.x - box.pill.width / 2 - box.grown, box.pill.centre.y};
  const PagePoint base{tip.x - head_length, tip.y}, from{tip.x - start_length, tip.y};
  canvas_.begin_group("arrow start", "start");
  canvas_.arrow({from, from, base, base}, tip);
  canvas_.end_group();
}

void GraphDrawing::draw_box(std::size_t index) {
  const auto& box = boxes_[index];
  std::string kind = "state everywhere";
  if (index < graph_.states.size()) {
    const auto& state = graph_.states[index];
    kind = state.visits && graph_.start == index ? "state taken" : kind_of("state", state.visits);
  }
  canvas_.begin_group(kind + (look_.small ? " small" : ""), box.title);
  if (box.grown > 0) canvas_.pill("ring", box.pill, box.grown);
  canvas_.pill("box", box.pill, 0);
  canvas_.text(box.lines, box.pill.centre, (look_.small ? small_name_px : name_px) * name_line, box.pill.width);
  canvas_.end_group();
}

void GraphDrawing::draw_label(std::size_t index) {
  const auto& [lines, number] = labels_[index];
  const auto [width, height] = size_of_label(index);
  begin(number > 0 ? "label number" : "label", index);
  if (number > 0) canvas_.pill("badge", {label_places_[index], width, height}, 0);
  canvas_.text(lines, label_places_[index], label_line, width);
  canvas_.end_group();
}

}  // namespace continua
