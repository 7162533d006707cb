#include "continua/replay/score/score_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/log/time_text.h"
#include "continua/replay/terminal/shell_word.h"
#include "continua/replay/terminal/text_table.h"

namespace continua {
namespace {

constexpr std::size_t first_few = 5;

using Row = TextRow;
using Table = TextTable;

std::string part(int count, int of) {
  return of == 0 ? fmt::format("{}       –", count) : fmt::format("{} {:5.1f} %", count, 100.0 * count / of);
}

Row row_of(const std::string& name, const Score& score) {
  return {name,
          fmt::to_string(score.speaking),
          part(score.exact, score.speaking),
          part(score.lax, score.speaking),
          part(score.same_template, score.speaking),
          score.speaking + score.answered == 0 ? "–" : fmt::format("{:.3f}", score.f1()),
          fmt::to_string(score.spurious),
          part(score.right, score.inputs),
          fmt::format("{} of {}", score.silent_samples, score.samples)};
}

Table table_of_traces(const ScoreReport& report) {
  Table table{
      {"trace", "speaking", "exact", "lax", "template", "F1", "spurious", "inputs right", "silent on pointing"}};
  for (const auto& one : report.traces) table.push_back(row_of(one.name, one.score));
  table.push_back(row_of("total", report.total()));
  return table;
}

// The most frequent first.
std::vector<std::pair<std::string, Score>> in_order(const ScoreOfKinds& kinds) {
  std::vector<std::pair<std::string, Score>> ordered(kinds.begin(), kinds.end());
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.second.speaking > b.second.speaking; });
  return ordered;
}

Table table_of_kinds(const ScoreReport& report) {
  Table table{{"kind of move", "speaking", "lax"}};
  for (const auto& [kind, score] : in_order(report.kinds()))
    table.push_back({kind, fmt::to_string(score.speaking), part(score.lax, score.speaking)});
  return table;
}

std::string markdown(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (const auto& cell : table[i]) {
      text += "| ";
      for (const char c : cell) text += c == '|' ? "\\|" : std::string(1, c);
      text += " ";
    }
    text += "|\n";
    if (i > 0) continue;
    text += "| ---";
    for (std::size_t column = 1; column < table[i].size(); ++column) text += " | ---:";
    text += " |\n";
  }
  return text;
}

std::string told(const std::vector<AvatarMove>& moves) {
  if (moves.empty()) return "silence";
  std::vector<std::string> texts;
  for (const auto& move : moves)
    texts.push_back(move.channel == "speech" ? "“" + move.content + "”" : move.channel + " " + move.content);
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string told(const TraceScore& of, const Episode& miss) {
  const auto look = of.run.empty() ? fmt::format("record {}", miss.n)
                                   : fmt::format("continua explain {} --record {}", shell_word(of.run), miss.n);
  const auto level = miss.level == AgreementLevel::same_template ? " (same template)" : "";
  return fmt::format("{}:{}  {}  {}\n  observed: {}\n  came out: {}{}\n  {}\n", of.trace, miss.line,
                     time_text(miss.t.seconds()), miss.symbol, told(miss.observed), told(miss.produced), level, look);
}

std::string told_misses(const TraceScore& of, bool all) {
  std::string text;
  const auto count = all ? of.misses.size() : std::min(first_few, of.misses.size());
  for (std::size_t i = 0; i < count; ++i) text += told(of, of.misses[i]);
  if (const auto more = of.misses.size() - count)
    text += fmt::format("{}: {} more {}; --misses tells all\n", of.trace, more, more == 1 ? "miss" : "misses");
  return text;
}

Json json_of(const ScoreOfKinds& kinds) {
  Json list = Json::array();
  for (const auto& [kind, score] : in_order(kinds))
    list.push_back({{"kind", kind},
                    {"speaking", score.speaking},
                    {"exact", score.exact},
                    {"lax", score.lax},
                    {"template", score.same_template}});
  return list;
}

Json json_of(const std::vector<AvatarMove>& moves) {
  Json list = Json::array();
  for (const auto& move : moves) list.push_back({{"channel", move.channel}, {"content", move.content}});
  return list;
}

Json json_of(const Episode& miss) {
  return {{"t", miss.t.seconds()},
          {"line", miss.line},
          {"record", miss.n},
          {"input", miss.symbol},
          {"observed", json_of(miss.observed)},
          {"produced", json_of(miss.produced)},
          {"level", name_of(miss.level)}};
}

}  // namespace

Json json_of(const Score& score) {
  return {{"inputs", score.inputs},
          {"speaking", score.speaking},
          {"exact", score.exact},
          {"lax", score.lax},
          {"template", score.same_template},
          {"answered", score.answered},
          {"spurious", score.spurious},
          {"right", score.right},
          {"f1", score.f1()},
          {"samples", score.samples},
          {"silent_samples", score.silent_samples}};
}

Json json_of(const TraceScore& trace) {
  Json json{{"trace", trace.name}, {"run", trace.run.empty() ? Json() : Json(trace.run)}};
  json.update(json_of(trace.score));
  json["kinds"] = json_of(trace.kinds);
  json["misses"] = Json::array();
  for (const auto& miss : trace.misses) json["misses"].push_back(json_of(miss));
  return json;
}

Score ScoreReport::total() const {
  Score total;
  for (const auto& trace : traces) total.add(trace.score);
  return total;
}

ScoreOfKinds ScoreReport::kinds() const {
  ScoreOfKinds all;
  for (const auto& trace : traces)
    for (const auto& [kind, score] : trace.kinds) all[kind].add(score);
  return all;
}

std::string score_text(const ScoreReport& report, bool all_misses) {
  auto text = aligned(table_of_traces(report)) + "\n" + aligned(table_of_kinds(report));
  std::string misses;
  for (const auto& trace : report.traces) misses += told_misses(trace, all_misses);
  return misses.empty() ? text : text + "\nMisses\n" + misses;
}

Json score_json(const ScoreReport& report) {
  Json traces = Json::array();
  for (const auto& trace : report.traces) traces.push_back(json_of(trace));
  return {{"variant", report.variant},
          {"traces", std::move(traces)},
          {"total", json_of(report.total())},
          {"kinds", json_of(report.kinds())}};
}

std::string score_markdown(const ScoreReport& report) {
  return markdown(table_of_traces(report)) + "\n" + markdown(table_of_kinds(report));
}

}  // namespace continua
