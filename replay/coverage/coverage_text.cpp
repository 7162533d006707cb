#include "continua/replay/coverage/coverage_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace continua {
namespace {

constexpr std::size_t bar_width = 20, first_few = 12, digest_shown = 8;

std::string row(const std::string& name, std::size_t reached, std::size_t of) {
  const auto filled = of == 0 ? bar_width : bar_width * reached / of;
  return fmt::format("  {:<16} {:>5} of {:>5}  {:>3} %  [{:<{}}]\n", name, reached, of, percent(reached, of),
                     std::string(filled, '='), bar_width);
}

// "thing known: held; lacks = 'e'"
std::string named(const CoverageItem& item) {
  auto text = item.name;
  if (!item.outcome.empty()) text += ": " + item.outcome;
  if (!item.what.empty()) text += (item.outcome.empty() ? ": " : "; ") + item.what;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string never_reached(const CoverageKind& kind, bool all) {
  std::string text;
  std::size_t told = 0;
  const auto count = kind.items.size() - kind.reached();
  for (const auto& item : kind.items) {
    if (item.count > 0 || (!all && told == first_few)) continue;
    text += "    " + named(item) + "\n";
    ++told;
  }
  if (told < count) text += fmt::format("    and {} more\n", count - told);
  return text.empty() ? text : fmt::format("  {}\n{}", kind.name, text);
}

}  // namespace

std::size_t percent(std::size_t reached, std::size_t of) { return of == 0 ? 100 : 100 * reached / of; }

std::string coverage_text(const std::vector<MachineCoverage>& machines, bool all_never_reached) {
  std::string text;
  for (const auto& machine : machines) {
    if (!text.empty()) text += "\n";
    text += fmt::format("{}  {}  {} {}\n", machine.name, machine.digest.substr(0, digest_shown), machine.runs,
                        machine.runs == 1 ? "run" : "runs");
    std::string of_knowledge, never;
    for (const auto& kind : machine.kinds) {
      if (kind.items.empty()) continue;
      (kind.of_knowledge ? of_knowledge : text) += row(kind.name, kind.reached(), kind.items.size());
      never += never_reached(kind, all_never_reached);
    }
    text += row("in all", machine.reached(), machine.reachable()) + of_knowledge;
    if (!never.empty()) text += "  never reached:\n" + never;
  }
  return text;
}

Json coverage_json(const std::vector<MachineCoverage>& machines) {
  Json all = Json::array();
  for (const auto& machine : machines) {
    Json kinds = Json::array();
    for (const auto& kind : machine.kinds) {
      Json items = Json::array();
      for (const auto& item : kind.items) {
        Json one{{"name", item.name}};
        if (!item.outcome.empty()) one["outcome"] = item.outcome;
        if (!item.what.empty()) one["what"] = item.what;
        one["count"] = item.count;
        items.push_back(std::move(one));
      }
      kinds.push_back(
          {{"kind", kind.name}, {"reached", kind.reached()}, {"of", kind.items.size()}, {"items", std::move(items)}});
    }
    all.push_back(
        {{"name", machine.name},
         {"digest", machine.digest},
         {"lexicon",
          machine.lexicon.empty() ? Json() : Json{{"name", machine.lexicon}, {"digest", machine.lexicon_digest}}},
         {"runs", machine.runs},
         {"reached", machine.reached()},
         {"of", machine.reachable()},
         {"kinds", std::move(kinds)}});
  }
  return {{"machines", std::move(all)}};
}

}  // namespace continua
