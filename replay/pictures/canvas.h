// Pictures with text, by cairo, in memory; the only files that know it are this one's.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/simulation/renderer.h"

namespace continua {

struct Colour {
  double red = 0, green = 0, blue = 0, alpha = 1;
};

/// A piece of a line of text.
struct TextRun {
  std::string text;  ///< UTF-8; other bytes become U+FFFD
  Colour colour = {};
  bool bold = false;
};

/// Lengths in pixels, from the top left corner.
class Canvas {
 public:
  Canvas(ImageSize size, Colour background);
  explicit Canvas(const Image& image);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  void put(const Image& image, int x, int y);
  void box(double x, double y, double width, double height, double radius, Colour colour);
  /// One line; `y` is the line's middle.
  void text(double x, double y, double size, const std::vector<TextRun>& runs);
  double width_of(double size, const std::vector<TextRun>& runs) const;

  /// `runs` broken at spaces into lines of at most `width`; of more than `most` lines the rest is "…".
  std::vector<std::vector<TextRun>> wrapped(double size, const std::vector<TextRun>& runs, double width,
                                            std::size_t most) const;

  ImageSize size() const { return size_; }
  std::string png() const;
  /// Row by row from the top: blue, green, red and a byte without meaning.
  std::string_view bgrx() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  ImageSize size_;
};

}  // namespace continua
