#include "continua/replay/commands/graph_options.h"

#include <CLI/CLI.hpp>

#include "continua/replay/export/graph_svg.h"

namespace continua {

void add_graph_options(CLI::App& command, GraphOptions& options) {
  command.add_option("--states", options.states, "A,B,…: a picture has these states alone, and the arrows among them")
      ->delimiter(',');
  command.add_option("--width", options.width,
                     "that a picture is made for, in mm, or with its unit (8.5cm, 320px); otherwise 170");
}

Result<std::string> picture_of(const StateGraph& graph, const GraphOptions& options) {
  const auto width = options.width.empty() ? page_width_mm : picture_width(options.width, "--width");
  if (!width) return width.error();
  return svg_of(graph, *width);
}

}  // namespace continua
