#include "continua/replay/experiment/robust_text.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace continua {
namespace {

constexpr double plot_width = 200, plot_height = 140, gap = 46, legend_height = 30;
constexpr std::array<const char*, run_ends> colours{"#2b7bba", "#e08e0b", "#8a8a8a", "#c8102e"};

std::vector<std::string> kinds_in(const Robustness& robustness) {
  std::vector<std::string> kinds;
  for (const auto& point : robustness.points)
    if (std::find(kinds.begin(), kinds.end(), point.kind) == kinds.end()) kinds.push_back(point.kind);
  return kinds;
}

// The plot of one kind, with its upper left corner at `left`, `top`.
std::string plot(const Robustness& robustness, const std::string& kind, double left, double top) {
  double strongest = 0;
  for (const auto& point : robustness.points) strongest = std::max(strongest, point.strength);
  const auto x = [&](double strength) { return left + strength / strongest * plot_width; };
  const auto y = [&](double share) { return top + (1 - share) * plot_height; };
  auto svg = fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>\n"
      "<path d=\"M{:.1f} {:.1f}v{:.1f}h{:.1f}\" fill=\"none\" stroke=\"#888\"/>\n",
      left, top - 8, kind, left, top, plot_height, plot_width);
  for (const double share : {0.0, 0.5, 1.0})
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.0f} %</text>\n", left - 5, y(share) + 4,
                       100 * share);
  for (std::size_t end = 0; end < run_ends; ++end) {
    // Without noise a run is the same.
    auto line = fmt::format("{:.1f},{:.1f}", x(0), y(end == 0 ? 1 : 0));
    for (const auto& point : robustness.points) {
      if (point.kind != kind) continue;
      line += fmt::format(" {:.1f},{:.1f}", x(point.strength), y(point.share(static_cast<RunEnd>(end))));
      if (end == 0)
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:g}</text>\n", x(point.strength),
                           top + plot_height + 14, point.strength);
    }
    svg +=
        fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", line, colours[end]);
  }
  return svg;
}

}  // namespace

std::string robust_text(const Robustness& robustness) {
  std::string text = fmt::format("{:<10}{:>9}{:>7}{:>9}{:>9}{:>9}{:>12}\n", "noise", "strength", "runs", "same", "asks",
                                 "less", "otherwise");
  for (const auto& point : robustness.points) {
    text += fmt::format("{:<10}{:>9g}{:>7}", point.kind, point.strength, point.runs());
    for (std::size_t end = 0; end < run_ends; ++end)
      text += fmt::format("{:>{}.1f} %", 100 * point.share(static_cast<RunEnd>(end)), end + 1 == run_ends ? 10 : 7);
    text += "\n";
  }
  for (const auto& one : robustness.breaks)
    text += fmt::format("{}, {} {:g}: {}: {}\n", one.trace, one.kind, one.strength, fmt::join(one.sentences, "; "),
                        fmt::join(one.acts, ", "));
  return text;
}

std::string robust_svg(const Robustness& robustness) {
  const auto kinds = kinds_in(robustness);
  const double width = gap + static_cast<double>(kinds.size()) * (plot_width + gap);
  const double height = plot_height + legend_height + 2 * gap;
  auto svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
      "role=\"img\" font-family=\"sans-serif\" font-size=\"11\">\n<title>Ends of runs against the strength of "
      "noise</title>\n<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"#fff\"/>\n",
      width, height);
  for (std::size_t i = 0; i < kinds.size(); ++i)
    svg += plot(robustness, kinds[i], gap + static_cast<double>(i) * (plot_width + gap), gap);
  for (std::size_t end = 0; end < run_ends; ++end)
    svg +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\" font-weight=\"bold\">{}</text>\n",
                    gap + static_cast<double>(end) * 80, height - legend_height / 2, colours[end], run_end_names[end]);
  return svg + "</svg>\n";
}

Json robust_json(const Robustness& robustness) {
  Json json{{"points", Json::array()}, {"breaks", Json::array()}};
  for (const auto& point : robustness.points) {
    Json one{{"kind", point.kind}, {"strength", point.strength}, {"runs", point.runs()}};
    for (std::size_t end = 0; end < run_ends; ++end) one[run_end_names[end]] = point.ends[end];
    json["points"].push_back(std::move(one));
  }
  for (const auto& one : robustness.breaks)
    json["breaks"].push_back({{"trace", one.trace},
                              {"kind", one.kind},
                              {"strength", one.strength},
                              {"changes", one.sentences},
                              {"acts", one.acts}});
  return json;
}

}  // namespace continua
