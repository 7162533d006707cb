// The canvas of a picture: SVG text that grows, and its extent. Colours are those of the style's classes, for light and
// dark pages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/export/curve.h"

namespace continua {

inline constexpr double pixels_per_mm = 96 / 25.4;
inline constexpr double picture_margin = 10;  ///< pixels, around a picture and between its parts

class SvgCanvas {
 public:
  /// `kind`: its classes, separated by blanks. `title` is its tooltip.
  void begin_group(std::string_view kind, std::string_view title);
  void end_group();

  /// A line with an arrow's head from its end to `tip`; `thickness` 0: that of the style.
  void arrow(const Curve& line, const PagePoint& tip, double thickness = 0);
  void pill(std::string_view kind, const Pill& pill, double grown);
  /// Lines below each other, centred about `centre`; `width` is how wide they may come out.
  void text(const std::vector<std::string>& lines, const PagePoint& centre, double line_height, double width);
  /// One line that begins at `from`, the left end of its base line.
  void line_of_text(std::string_view kind, std::string_view text, const PagePoint& from, double width);

  bool is_empty() const { return body_.empty(); }
  double width() const { return high_.x - low_.x; }
  double height() const { return high_.y - low_.y; }

  /// The document of canvases below each other, each in the size that `scales` gives it, as wide as the widest.
  struct Layer {
    const SvgCanvas& canvas;
    double scale = 1;
  };
  static std::string document(std::string_view title, const std::vector<Layer>& layers);

 private:
  void reach(const PagePoint& p);

  std::string body_;
  PagePoint low_{1e9, 1e9}, high_{-1e9, -1e9};  ///< of all that is drawn
};

}  // namespace continua
