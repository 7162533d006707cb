#include "continua/replay/export/graph_svg.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "continua/replay/export/graph_drawing.h"
#include "continua/replay/export/graph_legend.h"

namespace continua {
namespace {

// The looks of a drawing, from the most legible to the one that needs the least room; each from left to right, then
// downward. A line with a number on it needs room for that between the ranks.
constexpr std::array looks = {
    GraphLook{{4, 30}, false, {false, 16, 14}}, GraphLook{{4, 30}, false, {true, 18, 14}},
    GraphLook{{3, 18}, false, {false, 46, 14}}, GraphLook{{3, 18}, false, {true, 44, 14}},
    GraphLook{{2, 9}, false, {false, 46, 14}},  GraphLook{{2, 9}, false, {true, 44, 14}},
    GraphLook{{0, 0}, false, {false, 46, 16}},  GraphLook{{0, 0}, false, {true, 44, 16}},
    GraphLook{{0, 0}, false, {false, 30, 12}},  GraphLook{{0, 0}, false, {true, 28, 12}},
    GraphLook{{0, 0}, true, {false, 26, 9}},    GraphLook{{0, 0}, true, {true, 24, 9}},
};
constexpr double highest_share = 1.35;    ///< of a drawing's height in its width: that of a page
constexpr std::size_t many_arrows = 200;  ///< from which on a layout takes seconds: only the densest look is tried
constexpr std::size_t most_arrows = 600;  ///< of which places for numbers are found in some seconds
constexpr double densest = 0.5;           ///< share of a page that states and labels may cover

// How much too large a drawing is for its page; at most 1 if it fits.
double excess_of(const GraphDrawing& drawing, double width) {
  return std::max(drawing.canvas().width() / width, drawing.canvas().height() / (highest_share * width));
}

class BestDrawing {
 public:
  BestDrawing(const StateGraph& graph, const std::vector<Arrow>& arrows, double width)
      : graph_(graph), arrows_(arrows), width_(width) {}

  Result<std::unique_ptr<GraphDrawing>> find() {
    for (std::size_t i = arrows_.size() > many_arrows ? looks.size() - 2 : 0; i < looks.size(); i += 2) {
      if (looks[i].labels.lines > 0 && !has_room(looks[i])) continue;
      for (const auto& look : {looks[i], looks[i + 1]})
        if (!best_ || excess_ > 1) consider(look);
    }
    if (!best_) return *problem_;
    return std::move(best_);
  }

 private:
  bool has_room(const GraphLook& look) const {
    return GraphDrawing(graph_, arrows_, look).least_area() <= densest * highest_share * width_ * width_;
  }

  void consider(const GraphLook& look) {
    auto drawing = std::make_unique<GraphDrawing>(graph_, arrows_, look);
    if (auto problem = drawing->draw()) {
      problem_ = std::move(problem);
      return;
    }
    // A label on top of a state is worse than small letters.
    const double excess = excess_of(*drawing, width_) + (drawing->is_apart() ? 0 : 10);
    if (best_ && excess >= excess_) return;
    best_ = std::move(drawing);
    excess_ = excess;
  }

  const StateGraph& graph_;
  const std::vector<Arrow>& arrows_;
  double width_;
  std::unique_ptr<GraphDrawing> best_;
  double excess_ = 0;
  Outcome problem_;
};

}  // namespace

Result<std::string> svg_of(const StateGraph& graph, double width_mm) {
  const double width = width_mm * pixels_per_mm - 2 * picture_margin;
  const auto arrows = arrows_of(graph);
  if (arrows.size() > most_arrows)
    return Error{graph.name,
                 fmt::format("has {} arrows; expected at most {} in a picture; --states and --visited cut it "
                             "down, and --dot gives it to other programs",
                             arrows.size(), most_arrows)};
  const auto found = BestDrawing(graph, arrows, width).find();
  if (!found) return found.error();
  const auto& drawing = **found;
  const auto legend = legend_of(graph, arrows, drawing.labels(), width);
  return SvgCanvas::document(graph.name,
                             {{drawing.canvas(), std::min(1.0, width / drawing.canvas().width())}, {legend}});
}

}  // namespace continua
