#include "continua/replay/export/graph_svg.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "continua/replay/export/graph_layout.h"
#include "continua/replay/export/svg_canvas.h"

namespace continua {
namespace {

// Pixels.
constexpr double name_column = 7.6, name_padding = 30, state_height = 32, ring = 3.5;
constexpr double label_column = 6.05, label_line = 12, label_padding = 8;
constexpr double head_length = 7;
constexpr double loop_height = 24, loop_reach = 9, loop_gap = 6;
constexpr double start_length = 24;

std::string kind_of(const char* what, std::optional<std::size_t> visits) {
  return std::string(what) + (!visits ? "" : *visits > 0 ? " taken" : " never");
}

double width_of(const Arrow& arrow) {
  std::size_t longest = 0;
  for (const auto& line : arrow.lines) longest = std::max(longest, columns(line));
  return label_padding + label_column * static_cast<double>(longest);
}

double height_of(const Arrow& arrow) { return label_line * static_cast<double>(arrow.lines.size()); }

// A state, or the box that stands for every state, with its loops nested from the inside out.
struct Box {
  std::string name;
  std::vector<const Arrow*> above, below;
  Pill pill{};
  double grown = 0;  ///< how far its outermost line is from the pill's

  double room() const {
    const auto sum = [](const std::vector<const Arrow*>& loops) {
      double height = 0;
      for (const auto* loop : loops) height += loop_height + loop_gap + height_of(*loop);
      return height;
    };
    return std::max(sum(above), sum(below));
  }
};

class Drawing {
 public:
  explicit Drawing(const StateGraph& graph) : graph_(graph), arrows_(arrows_of(graph)) {
    for (const auto& state : graph.states) add_box(state.name, state.accepting ? ring : 0);
    if (std::any_of(arrows_.begin(), arrows_.end(), [](const auto& arrow) { return !arrow.from; }))
      add_box("any state", 0);
    for (const auto& arrow : arrows_) {
      if (!arrow.loops()) continue;
      auto& box = boxes_[arrow.to];
      (arrow.epsilon || arrow.rejected ? box.below : box.above).push_back(&arrow);
    }
  }

  Outcome place() {
    std::vector<LayoutNode> nodes;
    for (const auto& box : boxes_) nodes.push_back(room_for(box));
    nodes[graph_.start].width += 2 * start_length;
    std::vector<LayoutEdge> edges;
    for (const auto& arrow : arrows_)
      if (!arrow.loops()) edges.push_back({index_of(arrow.from), arrow.to, width_of(arrow), height_of(arrow) + 4});
    auto layout = lay_out(nodes, edges, graph_.start);
    if (!layout) return Error{graph_.name, layout.error().sentence};
    for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i].pill.centre = layout->nodes[i];
    placed_ = std::move(layout->edges);
    return std::nullopt;
  }

  // Lines come first: none crosses a label or a state.
  std::string text() {
    std::size_t placed = 0;
    for (const auto& arrow : arrows_)
      if (!arrow.loops()) draw_between(arrow, placed_[placed++]);
    for (const auto& box : boxes_) {
      draw_loops(box, box.above, -1);
      draw_loops(box, box.below, 1);
    }
    draw_start();
    for (const auto& [arrow, centre] : labels_) draw_label(*arrow, centre);
    for (std::size_t i = 0; i < boxes_.size(); ++i) draw_box(i);
    return canvas_.document(graph_.name);
  }

 private:
  void add_box(const std::string& name, double grown) {
    const double width = name_padding + name_column * static_cast<double>(columns(name));
    boxes_.push_back({name, {}, {}, {{}, width, state_height}, grown});
  }

  static LayoutNode room_for(const Box& box) {
    double width = box.pill.width + 2 * box.grown;
    for (const auto* loops : {&box.above, &box.below})
      for (const auto* loop : *loops) width = std::max(width, width_of(*loop));
    // Both sides alike, since the state is in the middle.
    return {width, state_height + 2 * (box.grown + box.room())};
  }

  std::size_t index_of(std::optional<std::size_t> from) const { return from.value_or(graph_.states.size()); }

  // `what`: the class of the element, an arrow's line or its label.
  void begin(const char* what, const Arrow& arrow) {
    auto title = fmt::format("{} → {}", boxes_[index_of(arrow.from)].name, boxes_[arrow.to].name);
    for (const auto& one : arrow.full) title += "\n" + one;
    canvas_.begin_group(kind_of(what, arrow.visits) + (arrow.rejected ? " rejected" : ""), title);
  }

  void draw_label(const Arrow& arrow, const PagePoint& centre) {
    begin("label", arrow);
    canvas_.text(arrow.lines, centre, label_line, width_of(arrow));
    canvas_.end_group();
  }

  void draw_between(const Arrow& arrow, const PlacedEdge& placed) {
    const auto &from = boxes_[index_of(arrow.from)], &to = boxes_[arrow.to];
    const auto rest = after_leaving(placed.curve, from.pill, from.grown);
    begin("arrow", arrow);
    canvas_.arrow(before_entering(rest, to.pill, to.grown + head_length), entry_of(rest, to.pill, to.grown));
    canvas_.end_group();
    labels_.emplace_back(&arrow, placed.label);
  }

  // Where a curve comes to the pill.
  static PagePoint entry_of(const Curve& curve, const Pill& pill, double grown) {
    const auto before = before_entering(curve, pill, grown);
    return before.empty() ? pill.centre : before.back();
  }

  // `up`: -1 above the state, 1 below.
  void draw_loops(const Box& box, const std::vector<const Arrow*>& loops, double up) {
    const double x = box.pill.centre.x, edge = box.pill.centre.y + up * (state_height / 2 + box.grown);
    double inner = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      const double outer = inner + loop_height, half = loop_reach * static_cast<double>(i + 1);
      // A Bézier curve reaches three quarters of the way to its inner points.
      const double bow = edge + up * outer * 4 / 3;
      begin("arrow", *loops[i]);
      canvas_.arrow(
          {{x - half, edge}, {x - 2 * half, bow}, {x + 2 * half, bow}, {x + half + 1, edge + up * head_length}},
          {x + half, edge});
      canvas_.end_group();
      labels_.emplace_back(loops[i], PagePoint{x, edge + up * (outer + height_of(*loops[i]) / 2 + 2)});
      inner = outer + height_of(*loops[i]) + loop_gap;
    }
  }

  void draw_start() {
    const auto& [centre, width, height] = boxes_[graph_.start].pill;
    const PagePoint tip{centre.x - width / 2 - boxes_[graph_.start].grown, centre.y};
    const PagePoint base{tip.x - head_length, tip.y}, from{tip.x - start_length, tip.y};
    canvas_.begin_group("arrow start", "start");
    canvas_.arrow({from, from, base, base}, tip);
    canvas_.end_group();
  }

  void draw_box(std::size_t index) {
    const auto& box = boxes_[index];
    if (index == graph_.states.size()) {
      canvas_.begin_group("state everywhere", "every state");
    } else {
      const auto& state = graph_.states[index];
      canvas_.begin_group(state.visits && index == graph_.start ? "state taken" : kind_of("state", state.visits),
                          description(state));
    }
    if (box.grown > 0) canvas_.pill("ring", box.pill, box.grown);
    canvas_.pill("box", box.pill, 0);
    canvas_.text({box.name}, box.pill.centre, 13, box.pill.width);
    canvas_.end_group();
  }

  const StateGraph& graph_;
  std::vector<Arrow> arrows_;
  std::vector<Box> boxes_;  ///< of the states, then that of every state, if anything comes from there
  std::vector<PlacedEdge> placed_;
  std::vector<std::pair<const Arrow*, PagePoint>> labels_;
  SvgCanvas canvas_;
};

}  // namespace

Result<std::string> svg_of(const StateGraph& graph) {
  Drawing drawing(graph);
  if (auto problem = drawing.place()) return *problem;
  return drawing.text();
}

}  // namespace continua
