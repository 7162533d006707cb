#include <fmt/format.h>

#include "continua/replay/explain/explain_lines.h"
#include "continua/replay/explain/explain_text.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

std::string node_text(const Json& node) {
  auto text = text_of(node, "term");
  if (const auto type = text_of(node, "type"); !type.empty()) text += " : " + type;
  const auto how = text_of(node, "how");
  if (how == "application") text += fmt::format("  #{}", text_of(node, "n"));
  if (const auto rule = text_of(node, "rule"); !rule.empty()) text += "  raised by " + rule;
  if (how == "abstraction") text += "  left open over";
  if (how == "parts") {
    const auto since = text_of(member_of(node, "origin"), "text");
    text += since.empty() ? "  put together by the machine from" : "  put together by the machine, " + since + ", from";
  }
  if (how == "taught") text += "  one step of";
  if (how == "leaf") text += "  ← " + text_of(member_of(node, "origin"), "text");
  return text;
}

void add_node(const Json& node, const std::string& first, const std::string& rest, std::size_t width,
              std::string& out) {
  const auto& children = member_of(node, "children");
  const bool inner = children.is_array() && !children.empty();
  out += wrapped(node_text(node), first, rest + (inner ? "│   " : "    "), width);
  if (!inner) return;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const bool last = i + 1 == children.size();
    add_node(children[i], rest + (last ? "└─ " : "├─ "), rest + (last ? "   " : "│  "), width, out);
  }
}

}  // namespace

std::string explain_tree(const Json& explained, const ExplainTextOptions& options) {
  std::string out;
  if (const auto& derivation = member_of(explained, "derivation"); derivation.is_object())
    add_node(derivation, "  ", "  ", options.width, out);
  return out;
}

}  // namespace continua
