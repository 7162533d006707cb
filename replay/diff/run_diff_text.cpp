#include "continua/replay/diff/run_diff_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/replay/diff/run_diff_words.h"
#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/time_text.h"

namespace continua {
namespace {

constexpr std::size_t longest_brief = 160;

std::string shortened(std::string text, std::size_t longest) {
  if (text.size() <= longest) return text;
  while (longest > 0 && (text[longest] & 0xC0) == 0x80) --longest;
  return text.substr(0, longest) + "…";
}

// "#16 transition Ask → Compose"
std::string line_of(const RunIndex& run, const RunWords& words, std::size_t n) {
  const auto record = run.record(n);
  const auto told = record ? brief_in_words(words, *record) : record.error().sentence;
  return fmt::format("#{} {} {} {}", n, time_text(run.entry(n).t.seconds()), run.kind(n),
                     shortened(told, longest_brief));
}

class Text {
 public:
  Text(const RunIndex& a, const RunIndex& b, const RunDiff& diff, const DiffTextOptions& options)
      : a_(a), b_(b), words_a_(a), words_b_(b), diff_(diff), options_(options) {}

  std::string written() {
    text_ = coloured("1", diff_.sentence) + "\n";
    side("A", a_);
    side("B", b_);
    if (!diff_.differences.empty()) {
      led();
      heading(fmt::format("First difference ({})", name_of(diff_.differences[diff_.first].kind)));
      difference(diff_.differences[diff_.first]);
      more();
    }
    givens();
    return std::move(text_);
  }

 private:
  std::string coloured(const char* code, const std::string& text) const {
    return options_.colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
  }
  void heading(const std::string& title) { text_ += "\n" + coloured("1", title) + "\n"; }
  void line(const char* mark, const char* code, const std::string& text) {
    text_ += coloured(code, fmt::format("  {} {}", mark, text)) + "\n";
  }

  void side(const char* name, const RunIndex& run) {
    const auto& header = run.header();
    text_ += fmt::format("{}: {}{}\n", name, run.path(), header ? " (" + brief(*header) + ")" : "");
    if (!run.trouble().empty()) text_ += fmt::format("   {}\n", run.trouble());
  }

  void led() {
    if (diff_.led_a.empty() && diff_.led_b.empty()) return;
    heading("What led there");
    for (const auto n : diff_.led_a) line("A", "0", line_of(a_, words_a_, n));
    if (diff_.led_a != diff_.led_b)
      for (const auto n : diff_.led_b) line("B", "0", line_of(b_, words_b_, n));
  }

  void difference(const RunDifference& one) {
    constexpr std::size_t most = 8;
    const auto records = [&](const char* mark, const char* code, const RunIndex& run, const RunWords& words,
                             const std::vector<std::size_t>& all) {
      for (std::size_t i = 0; i < std::min(all.size(), most); ++i) line(mark, code, line_of(run, words, all[i]));
      if (all.size() > most) line(mark, code, fmt::format("and {} more", all.size() - most));
    };
    records("-", "31", a_, words_a_, one.a);
    records("+", "32", b_, words_b_, one.b);
    for (const auto& value : diff_.evidence)
      if (&one == &diff_.differences[diff_.first]) line(" ", "33", value);
  }

  void more() {
    const auto others = std::min(diff_.differences.size() - 1, options_.most);
    if (diff_.count > 1) {
      heading(fmt::format("More differences ({} of {})", others, diff_.count - 1));
      for (std::size_t i = 0, shown = 0; shown < others; ++i) {
        if (i == diff_.first) continue;
        ++shown;
        text_ += fmt::format("  {} at {}\n", name_of(diff_.differences[i].kind),
                             time_text(diff_.differences[i].t.seconds()));
        difference(diff_.differences[i]);
      }
    }
    if (!diff_.meet) return;
    heading("They meet again");
    line("A", "0", line_of(a_, words_a_, diff_.meet->first));
    line("B", "0", line_of(b_, words_b_, diff_.meet->second));
  }

  void givens() {
    if (diff_.givens.empty()) return;
    heading("What the runs do not have in common");
    for (const auto& given : diff_.givens) line("~", "33", fmt::format("{}: {}", given.kind, told(given)));
  }

  const RunIndex &a_, &b_;
  const RunWords words_a_, words_b_;
  const RunDiff& diff_;
  const DiffTextOptions& options_;
  std::string text_;
};

// `raw`: as the log has it, where `brief` has other words.
Json json_of(const RunIndex& run, const RunWords& words, const std::vector<std::size_t>& records) {
  Json all = Json::array();
  for (const auto n : records) {
    const auto record = run.record(n);
    const auto told = record ? brief_in_words(words, *record) : record.error().sentence;
    all.push_back({{"n", n}, {"t", run.entry(n).t.seconds()}, {"kind", run.kind(n)}, {"brief", told}});
    if (const auto raw = record ? brief(*record) : told; raw != told) all.back()["raw"] = raw;
  }
  return all;
}

}  // namespace

std::string diff_text(const RunIndex& a, const RunIndex& b, const RunDiff& diff, const DiffTextOptions& options) {
  return Text(a, b, diff, options).written();
}

std::string diff_markdown(const RunIndex& a, const RunIndex& b, const RunDiff& diff) {
  const auto details = diff_text(a, b, diff);
  const auto body = details.substr(std::min(details.find('\n') + 1, details.size()));
  // Longer than any row of backquotes within.
  std::string fence = "```";
  while (body.find(fence) != std::string::npos) fence += '`';
  return fmt::format(
      "**{}**\n\n<details>\n<summary>{} of {} and {} inputs in common</summary>\n\n{}diff\n{}{}\n</details>\n",
      diff.sentence, diff.inputs_common, diff.inputs_a, diff.inputs_b, fence, body, fence);
}

Json diff_json(const RunIndex& a, const RunIndex& b, const RunDiff& diff) {
  Json differences = Json::array(), givens = Json::array();
  const RunWords words_a(a), words_b(b);
  for (const auto& one : diff.differences)
    differences.push_back({{"kind", name_of(one.kind)},
                           {"t", one.t.seconds()},
                           {"a", json_of(a, words_a, one.a)},
                           {"b", json_of(b, words_b, one.b)},
                           {"change", one.input ? Json(name_of(one.input->kind)) : Json(nullptr)}});
  for (const auto& given : diff.givens)
    givens.push_back(
        {{"kind", given.kind}, {"what", given.what}, {"a", given.a}, {"b", given.b}, {"sentence", told(given)}});
  return {{"same", is_same(diff)},
          {"sameness", name_of(diff.sameness)},
          {"sentence", diff.sentence},
          {"cause",
           {{"kind", diff.cause.kind},
            {"what", diff.cause.what},
            {"a", diff.cause.a},
            {"b", diff.cause.b},
            {"sentence", diff.cause.sentence}}},
          {"evidence", diff.evidence},
          {"first", diff.differences.empty() ? Json(nullptr) : Json(diff.first)},
          {"led", {{"a", json_of(a, words_a, diff.led_a)}, {"b", json_of(b, words_b, diff.led_b)}}},
          {"differences", std::move(differences)},
          {"count", diff.count},
          {"meet", diff.meet ? Json{{"a", diff.meet->first}, {"b", diff.meet->second}} : Json(nullptr)},
          {"givens", std::move(givens)},
          {"inputs", {{"a", diff.inputs_a}, {"b", diff.inputs_b}, {"common", diff.inputs_common}}},
          {"farthest", diff.farthest.empty() ? Json(nullptr) : Json(diff.farthest)},
          {"largest_distance_m", diff.largest_distance_m}};
}

}  // namespace continua
