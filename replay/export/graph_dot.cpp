#include "continua/replay/export/graph_dot.h"

#include <fmt/format.h>

namespace continua {
namespace {

constexpr const char* never_colour = "gray60";

// In a label a backslash begins an escape and an ampersand an entity.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
    if (c == '&') out += "amp;";
  }
  return out;
}

std::string quoted(const std::string& text) { return '"' + escaped(text) + '"'; }

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += (text.empty() ? "" : "\\n") + escaped(line);
  return '"' + text + '"';
}

std::string colours(std::optional<std::size_t> visits) {
  if (!visits) return "";
  if (*visits > 0) return " penwidth=2";
  return fmt::format(" color={0} fontcolor={0}", never_colour);
}

std::string state_line(const StateGraph& graph, std::size_t index) {
  const auto& state = graph.states[index];
  const auto visits = index == graph.start && state.visits == 0 ? std::nullopt : state.visits;
  return fmt::format("  s{} [label={}{} tooltip={}{}]\n", index, quoted(state.name),
                     state.accepting ? " peripheries=2" : "", quoted(description(state)), colours(visits));
}

std::string arrow_line(const Arrow& arrow) {
  // Loops that consume an input above their state, the others below.
  const char* side = !arrow.loops()                    ? ""
                     : arrow.epsilon || arrow.rejected ? " tailport=s headport=s"
                                                       : " tailport=n headport=n";
  return fmt::format("  {} -> s{} [label={} tooltip={}{}{}{}]\n",
                     arrow.from ? fmt::format("s{}", *arrow.from) : "everywhere", arrow.to, joined(arrow.lines),
                     joined(arrow.full), side, arrow.rejected ? " style=dashed" : "", colours(arrow.visits));
}

}  // namespace

std::string dot_of(const StateGraph& graph) {
  std::string text = fmt::format(
      "digraph {} {{\n"
      "  rankdir=LR\n"
      "  node [shape=box style=rounded fontname=\"Helvetica\" fontsize=13]\n"
      "  edge [fontname=\"Courier\" fontsize=10 arrowsize=0.7]\n"
      "  nowhere [shape=none label=\"\" width=0 height=0]\n",
      quoted(graph.name));
  const auto arrows = arrows_of(graph);
  for (const auto& arrow : arrows)
    if (!arrow.from) {
      text += "  everywhere [label=\"any state\" style=\"rounded,dashed\"]\n";
      break;
    }
  for (std::size_t i = 0; i < graph.states.size(); ++i) text += state_line(graph, i);
  if (graph.start) text += fmt::format("  nowhere -> s{}\n", *graph.start);
  for (const auto& arrow : arrows) text += arrow_line(arrow);
  return text + "}\n";
}

}  // namespace continua
