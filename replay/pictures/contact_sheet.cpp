#include "continua/replay/pictures/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "continua/replay/pictures/run_pictures.h"

namespace continua {
namespace {

constexpr Colour paper{1, 1, 1}, ink{0.12, 0.13, 0.15}, grey{0.42, 0.45, 0.5};
constexpr std::size_t most_lines = 4;

std::vector<std::vector<TextRun>> caption(const Canvas& canvas, const KeyMoment& moment, double letters, double width) {
  std::vector<std::vector<TextRun>> lines;
  for (const auto& one : moment.happenings) {
    std::vector<TextRun> runs;
    if (lines.empty()) runs.push_back({clock_text(moment.t) + "  ", grey, false});
    runs.push_back({one.who + ": ", ink, true});
    runs.push_back({one.text, ink, false});
    for (auto& line : canvas.wrapped(letters, runs, width, 2)) lines.push_back(std::move(line));
  }
  if (lines.empty()) lines.push_back({{clock_text(moment.t), grey, false}});
  if (lines.size() > most_lines) lines.resize(most_lines);
  return lines;
}

}  // namespace

int sheet_columns(std::size_t pictures) {
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(pictures))));
}

Canvas contact_sheet(const std::vector<KeyMoment>& moments, const std::vector<Image>& pictures) {
  require(!pictures.empty() && moments.size() == pictures.size(), "a contact sheet of moments without pictures");
  const ImageSize picture = pictures.front().size;
  const auto columns = static_cast<std::size_t>(sheet_columns(pictures.size()));
  const std::size_t rows = (pictures.size() + columns - 1) / columns;
  const int gap = std::max(picture.width / 40, 4);
  const double letters = std::max(picture.width / 30.0, 9.0), line_height = 1.4 * letters;

  const Canvas measure({1, 1}, paper);
  std::vector<std::vector<std::vector<TextRun>>> captions;
  std::vector<std::size_t> row_lines(rows, 1);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    captions.push_back(caption(measure, moments[i], letters, picture.width));
    row_lines[i / columns] = std::max(row_lines[i / columns], captions.back().size());
  }

  std::vector<int> tops{gap};
  for (const auto lines : row_lines)
    tops.push_back(tops.back() + picture.height + static_cast<int>(line_height * static_cast<double>(lines)) + 2 * gap);
  Canvas sheet({static_cast<int>(columns) * (picture.width + gap) + gap, tops.back() - gap}, paper);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int x = gap + static_cast<int>(i % columns) * (picture.width + gap), y = tops[i / columns];
    sheet.put(pictures[i], x, y);
    double line_y = y + picture.height + gap / 2.0 + line_height / 2;
    for (const auto& line : captions[i]) {
      sheet.text(x, line_y, letters, line);
      line_y += line_height;
    }
  }
  return sheet;
}

}  // namespace continua
