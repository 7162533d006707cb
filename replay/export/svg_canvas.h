// The canvas of a picture: SVG text that grows, and its extent. Colours are those of the style's classes, for light and
// dark pages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/export/curve.h"

namespace continua {

class SvgCanvas {
 public:
  /// `kind`: its classes, separated by blanks. `title` is its tooltip.
  void begin_group(std::string_view kind, std::string_view title);
  void end_group();

  /// A line with an arrow's head from its end to `tip`.
  void arrow(const Curve& line, const PagePoint& tip);
  void pill(std::string_view kind, const Pill& pill, double grown);
  /// Lines below each other, centred about `centre`; `width` is how wide they may come out.
  void text(const std::vector<std::string>& lines, const PagePoint& centre, double line_height, double width);

  /// The whole document.
  std::string document(std::string_view title) const;

 private:
  void reach(const PagePoint& p);

  std::string body_;
  PagePoint low_{1e9, 1e9}, high_{-1e9, -1e9};  ///< of all that is drawn
};

}  // namespace continua
