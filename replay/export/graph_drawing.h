// One drawing of a state graph: its sizes, its labels, and where all of it is.
#pragma once

#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/export/arrow_labels.h"
#include "continua/replay/export/badge_places.h"
#include "continua/replay/export/graph_layout.h"
#include "continua/replay/export/state_graph.h"
#include "continua/replay/export/svg_canvas.h"

namespace continua {

/// The look of a drawing.
struct GraphLook {
  LabelRoom labels;    ///< of arrows; longer ones become numbers
  bool small = false;  ///< names of states
  LayoutStyle layout;
};

class GraphDrawing {
 public:
  /// REQUIRES that graph and arrows outlive it.
  GraphDrawing(const StateGraph& graph, const std::vector<Arrow>& arrows, const GraphLook& look);

  /// The least area that its states and labels need, in square pixels.
  double least_area() const;

  /// Lays it out and draws it. An error if it cannot be laid out in reasonable time. Not to be called from two threads
  /// at once.
  Outcome draw();

  /// After draw().
  const SvgCanvas& canvas() const { return canvas_; }
  const std::vector<ArrowLabel>& labels() const { return labels_; }
  bool is_apart() const { return apart_; }  ///< no label covers a state or another label

 private:
  // A state, or the box that stands for every state, with its loops nested from the inside out.
  struct Box {
    std::vector<std::string> lines;
    std::string title;
    std::vector<std::size_t> above = {}, below = {};  ///< arrows
    Pill pill{};
    double grown = 0;  ///< how far its outermost line is from the pill's
  };
  struct Size {
    double width = 0, height = 0;
  };

  void add_box(const std::string& name, const std::string& title, double grown);
  std::size_t index_of(std::optional<std::size_t> from) const { return from.value_or(graph_.states.size()); }
  Size size_of_label(std::size_t arrow) const;
  double height_of_loops(const std::vector<std::size_t>& loops) const;
  LayoutNode room_for(std::size_t box) const;
  double thickness_of(const Arrow& arrow) const;
  std::vector<PageBox> taken_boxes() const;
  void begin(const char* what, std::size_t arrow);
  void place_lines(const Layout& layout);
  void place_badges();
  void draw_lines();
  void draw_loops(const Box& box, const std::vector<std::size_t>& loops, double up);
  void draw_start();
  void draw_box(std::size_t index);
  void draw_label(std::size_t arrow);

  const StateGraph& graph_;
  const std::vector<Arrow>& arrows_;
  GraphLook look_;
  std::vector<ArrowLabel> labels_;
  std::vector<Box> boxes_;    ///< of the states, then that of every state, if anything comes from there
  std::vector<Curve> lines_;  ///< of each arrow that is no loop, up to its head
  std::vector<PagePoint> tips_, label_places_;  ///< of each arrow
  std::size_t most_visits_ = 0;
  bool apart_ = true;
  SvgCanvas canvas_;
};

}  // namespace continua
