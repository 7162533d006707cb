#include "continua/replay/pictures/canvas.h"

#include <cairo.h>

#include <algorithm>
#include <numbers>

#include "continua/core/characters.h"

namespace continua {

struct Canvas::Handles {
  cairo_surface_t* surface;
  cairo_t* cairo;
  explicit Handles(ImageSize size)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height)),
        cairo(cairo_create(surface)) {}
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
};

namespace {

void use_font(cairo_t* cairo, double size, bool bold) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
}

// Cairo draws nothing more after text that it cannot read.
std::string as_utf8(std::string_view text) {
  std::string readable;
  while (!text.empty()) {
    const auto length = character_length(text);
    const bool control = length == 1 && static_cast<unsigned char>(text.front()) < ' ';
    readable += length == 0 ? "\uFFFD" : control ? " " : std::string(text.substr(0, length));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return readable;
}

void use(cairo_t* cairo, const Colour& colour) {
  cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, colour.alpha);
}

}  // namespace

Canvas::Canvas(ImageSize size, Colour background) : handles_(std::make_unique<Handles>(size)), size_(size) {
  use(handles_->cairo, background);
  cairo_paint(handles_->cairo);
}
Canvas::Canvas(const Image& image) : handles_(std::make_unique<Handles>(image.size)), size_(image.size) {
  put(image, 0, 0);
}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

void Canvas::put(const Image& image, int x, int y) {
  require(x >= 0 && y >= 0 && x + image.size.width <= size_.width && y + image.size.height <= size_.height,
          "an image that does not fit into its canvas");
  cairo_surface_flush(handles_->surface);
  unsigned char* const pixels = cairo_image_surface_get_data(handles_->surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(handles_->surface));
  const unsigned char* from = image.rgb.data();
  for (int row = 0; row < image.size.height; ++row) {
    auto* to = reinterpret_cast<std::uint32_t*>(pixels + static_cast<std::size_t>(y + row) * stride) + x;
    for (int column = 0; column < image.size.width; ++column, from += 3)
      *to++ = static_cast<std::uint32_t>(from[0]) << 16 | static_cast<std::uint32_t>(from[1]) << 8 | from[2];
  }
  cairo_surface_mark_dirty(handles_->surface);
}

void Canvas::box(double x, double y, double width, double height, double radius, Colour colour) {
  cairo_t* const cairo = handles_->cairo;
  constexpr double quarter = std::numbers::pi / 2;
  const double r = std::min({radius, width / 2, height / 2});
  cairo_new_sub_path(cairo);
  cairo_arc(cairo, x + width - r, y + r, r, -quarter, 0);
  cairo_arc(cairo, x + width - r, y + height - r, r, 0, quarter);
  cairo_arc(cairo, x + r, y + height - r, r, quarter, 2 * quarter);
  cairo_arc(cairo, x + r, y + r, r, 2 * quarter, 3 * quarter);
  cairo_close_path(cairo);
  use(cairo, colour);
  cairo_fill(cairo);
}

void Canvas::text(double x, double y, double size, const std::vector<TextRun>& runs) {
  cairo_t* const cairo = handles_->cairo;
  double at = x;
  for (const auto& run : runs) {
    use_font(cairo, size, run.bold);
    use(cairo, run.colour);
    const auto text = as_utf8(run.text);
    cairo_move_to(cairo, at, y + 0.36 * size);  // half the height of a capital below the middle
    cairo_show_text(cairo, text.c_str());
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, text.c_str(), &extents);
    at += extents.x_advance;
  }
}

double Canvas::width_of(double size, const std::vector<TextRun>& runs) const {
  double width = 0;
  for (const auto& run : runs) {
    use_font(handles_->cairo, size, run.bold);
    cairo_text_extents_t extents;
    cairo_text_extents(handles_->cairo, as_utf8(run.text).c_str(), &extents);
    width += extents.x_advance;
  }
  return width;
}

std::vector<std::vector<TextRun>> Canvas::wrapped(double size, const std::vector<TextRun>& runs, double width,
                                                  std::size_t most) const {
  std::vector<std::vector<TextRun>> lines(1);
  for (const auto& run : runs) {
    for (std::size_t from = 0; from < run.text.size();) {
      const auto end = std::min(run.text.find(' ', from), run.text.size() - 1) + 1;
      TextRun word{run.text.substr(from, end - from), run.colour, run.bold};
      from = end;
      if (width_of(size, {word}) > width) {  // even alone: as much of it as fits
        std::string part;
        for (const auto& character : characters(word.text)) {
          if (!part.empty() && width_of(size, {{part + character, run.colour, run.bold}}) > width) break;
          part += character;
        }
        from -= word.text.size() - part.size();
        word.text = part;
      }
      auto longer = lines.back();
      if (!longer.empty() && longer.back().bold == word.bold)
        longer.back().text += word.text;
      else
        longer.push_back(word);
      if (lines.back().empty() || width_of(size, longer) <= width)
        lines.back() = std::move(longer);
      else
        lines.push_back({word});
    }
  }
  if (lines.size() > most) {
    lines.resize(most);
    lines.back().push_back({"…", lines.back().back().colour, false});
  }
  return lines;
}

std::string Canvas::png() const {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  const auto status = cairo_surface_write_to_png_stream(handles_->surface, append, &bytes);
  require(status == CAIRO_STATUS_SUCCESS, "a picture could not be written as PNG");
  return bytes;
}

std::string_view Canvas::bgrx() const {
  cairo_surface_flush(handles_->surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(handles_->surface));
  return {reinterpret_cast<const char*>(cairo_image_surface_get_data(handles_->surface)),
          stride * static_cast<std::size_t>(size_.height)};
}

}  // namespace continua
