#include "continua/replay/export/run_report.h"

#include <algorithm>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "continua/core/markup.h"
#include "continua/replay/diff/sequence_alignment.h"
#include "continua/replay/export/expectation_table.h"
#include "continua/replay/export/graph_svg.h"
#include "continua/replay/export/run_dialogue.h"
#include "continua/replay/export/run_html.h"
#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/time_text.h"

namespace continua {
namespace {

// Longest list of records that differ, and longest record, in bytes; all are in the diff in the same folder.
constexpr std::size_t most_rows = 400, longest_record = 4000;

std::string seconds(SimTime t) { return time_text(t.seconds()); }
// Both times where they differ as told.
std::string seconds(SimTime a, SimTime b) {
  const auto in_a = seconds(a), in_b = seconds(b);
  return in_a == in_b ? in_a : fmt::format("A {}<br/>B {}", in_a, in_b);
}

const char* described(RunDifference::Kind kind) {
  switch (kind) {
    case RunDifference::Kind::input:
      return "another input";
    case RunDifference::Kind::happened:
      return "something else happened";
    case RunDifference::Kind::decided:
      return "the same happened, decided by something else";
    case RunDifference::Kind::timing:
      return "the same at another time";
    case RunDifference::Kind::outcome:
      return "an act came to something else";
    case RunDifference::Kind::poses:
      return "bodies are elsewhere";
  }
  return "";
}

std::string of_line(const DialogueLine& line) {
  return fmt::format("<span class=\"who\">{}</span> {} {}", line.who, in_markup(line.how), in_markup(line.what));
}

std::string same_row(const std::string& time, const std::string& html) {
  return fmt::format("<tr><td>{0}</td><td class=\"both\">{1}</td><td class=\"both again\">{1}</td></tr>\n", time, html);
}

// A row with the cells of the approved run and of this one; empty text: an empty cell.
std::string differing_row(const std::string& time, const std::string& approved, const std::string& now) {
  const auto cell = [](const char* kind, const char* of, const char* mark, const std::string& html) {
    return html.empty() ? std::string("<td></td>")
                        : fmt::format("<td class=\"{}\" data-of=\"{}\">{} {}</td>", kind, of, mark, html);
  };
  return fmt::format("<tr><td>{}</td>{}{}</tr>\n", time, cell("gone", "A, approved", "−", approved),
                     cell("come", "B, now", "+", now));
}

constexpr const char* two_columns =
    "<table>\n<thead><tr><th class=\"time\" scope=\"col\">time</th><th scope=\"col\">A: approved</th>"
    "<th scope=\"col\">B: now</th></tr></thead>\n<tbody>\n";
constexpr const char* end_of_table = "</tbody></table>\n";

std::string one_dialogue(const RunIndex& run) {
  std::string html =
      "<table>\n<thead><tr><th class=\"time\" scope=\"col\">time</th><th scope=\"col\">what was said and done</th>"
      "</tr></thead>\n<tbody>\n";
  for (const auto& line : dialogue_of(run))
    html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", seconds(line.t), of_line(line));
  return html + end_of_table;
}

// Equal lines, whatever their times, side by side; between them the differing ones, side by side where they happened at
// the same time.
std::string both_dialogues(const RunIndex& approved, const RunIndex& now) {
  const auto a = dialogue_of(approved), b = dialogue_of(now);
  std::map<std::string, std::uint64_t> numbers;
  const auto numbered = [&](const std::vector<DialogueLine>& lines) {
    std::vector<std::uint64_t> content;
    for (const auto& line : lines) content.push_back(numbers.emplace(of_line(line), numbers.size()).first->second);
    return content;
  };
  const auto in_a = numbered(a), in_b = numbered(b);
  std::string html = two_columns;
  std::size_t i = 0, j = 0;
  const auto tell_until = [&](std::size_t end_a, std::size_t end_b) {
    while (i < end_a || j < end_b) {
      const auto* line_a = i < end_a && (j == end_b || a[i].t <= b[j].t) ? &a[i] : nullptr;
      const auto* line_b = j < end_b && (i == end_a || b[j].t <= a[i].t) ? &b[j] : nullptr;
      if (line_a) ++i;
      if (line_b) ++j;
      html += differing_row(seconds((line_b ? line_b : line_a)->t), line_a ? of_line(*line_a) : "",
                            line_b ? of_line(*line_b) : "");
    }
  };
  for (const auto& [same_a, same_b] : align(in_a, in_b).pairs) {
    tell_until(same_a, same_b);
    html += same_row(seconds(a[i].t, b[j].t), of_line(b[j]));
    i = same_a + 1;
    j = same_b + 1;
  }
  tell_until(a.size(), b.size());
  return html + end_of_table;
}

std::string of_record(const RunIndex& run, const RunWords& words, std::size_t n) {
  const auto record = run.record(n);
  if (!record) return in_markup(record.error().text());
  auto text = compact(*record);
  if (text.size() > longest_record) {
    auto end = longest_record;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    text = text.substr(0, end) + "…";
  }
  return fmt::format("<b>{}</b> {}<details><summary>record {}</summary><span class=\"record\">{}</span></details>",
                     in_markup(run.kind(n)), in_markup(brief_in_words(words, *record)), n, in_markup(text));
}

// Each difference under its kind; its records side by side, first against first.
std::string differing_records(const RunIndex& approved, const RunIndex& now, const RunDiff& diff) {
  if (diff.differences.empty()) return "<p>None.</p>\n";
  std::string html = two_columns;
  const RunWords words_a(approved), words_b(now);
  std::size_t rows = 0, shown = 0;
  for (const auto& one : diff.differences) {
    if (rows >= most_rows) break;
    html += fmt::format("<tr class=\"part\"><td colspan=\"3\">{}. {}</td></tr>\n", ++shown, described(one.kind));
    const auto size = std::max(one.a.size(), one.b.size());
    for (std::size_t i = 0; i < size && rows < most_rows; ++i, ++rows) {
      const auto* in_a = i < one.a.size() ? &approved.entry(one.a[i]) : nullptr;
      const auto* in_b = i < one.b.size() ? &now.entry(one.b[i]) : nullptr;
      html += differing_row(seconds((in_a ? in_a : in_b)->t, (in_b ? in_b : in_a)->t),
                            in_a ? of_record(approved, words_a, one.a[i]) : "",
                            in_b ? of_record(now, words_b, one.b[i]) : "");
    }
  }
  html += end_of_table;
  if (shown < diff.count)
    html += fmt::format("<p class=\"quiet\">These are the first {} of {} differences.</p>\n", shown, diff.count);
  return html;
}

std::string graph_of(const RunIndex& run, const std::string& what) {
  static std::mutex one_at_a_time;  // as svg_of asks for
  const std::lock_guard lock(one_at_a_time);
  const auto graph = state_graph_of(run);
  if (!graph) return {};
  const auto picture = svg_of(*graph);
  if (!picture) return {};
  return fmt::format("<details><summary>{}</summary><div class=\"picture\">{}</div></details>\n", what, *picture);
}

// "interaction 163a8db98e7e…, physics, seed 0"
std::string made_with(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return in_markup(header.error().text());
  const auto part = [&](const char* key) { return header->value(key, Json()); };
  return in_markup(fmt::format("machine {} {}, {} world, seed {}, continua {}", text_of(part("machine"), "name"),
                               text_of(part("machine"), "digest").substr(0, 12), text_of(*header, "world"),
                               text_of(*header, "seed"), text_of(*header, "continua")));
}

std::string of_worlds(const std::vector<WorldPictures>& worlds) {
  std::string html;
  for (const auto& [title, sides] : worlds) {
    html += fmt::format("<h3>{}</h3>\n<div class=\"worlds\">\n", in_markup(title));
    for (const auto& side : sides) {
      const auto picture = side.png.empty()
                               ? fmt::format("<p class=\"no_picture\">No picture: {}</p>", in_markup(side.trouble))
                               : fmt::format("<img alt=\"the scene, {0}\" src=\"data:image/png;base64,{1}\"/>",
                                             in_markup(side.title), side.png);
      html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture, in_markup(side.title));
    }
    html += "</div>\n";
  }
  return html.empty() ? html : "<h2>The scene</h2>\n" + html;
}

// The sentence, unless the table of unmet expectations tells the same.
std::string cause_of(const RunReport& report, const std::string& unmet) {
  std::string html;
  const auto add = [&](const std::string& text) {
    html += fmt::format("<p class=\"cause\">{}</p>\n", in_markup(text));
  };
  if (unmet.empty())
    add(report.sentence);
  else
    add("The run does not do what its trace expects.");
  if (report.diff && report.diff->sentence != report.sentence) add(report.diff->sentence);
  return html + unmet;
}

}  // namespace

std::string report_page(const RunReport& report) {
  const bool good = report.verdict == "same" || report.verdict == "same decisions" || report.verdict == "new";
  auto body = fmt::format("<h1>{} <span class=\"verdict {}\">{}</span></h1>\n", in_markup(report.trace),
                          good ? "good" : "bad", in_markup(report.verdict));
  body += cause_of(report, unmet_table(*report.run));
  body += fmt::format("<p class=\"quiet\">now: {}", made_with(*report.run));
  if (report.approved) body += fmt::format("<br/>approved: {}", made_with(*report.approved));
  body += "</p>\n" + of_worlds(report.worlds) + "<h2>The dialogue</h2>\n";
  if (report.approved && report.diff) {
    body += both_dialogues(*report.approved, *report.run);
    body += "<h2>Records that differ</h2>\n" + differing_records(*report.approved, *report.run, *report.diff);
  } else {
    body += one_dialogue(*report.run);
  }
  body += "<h2>The machine</h2>\n" + graph_of(*report.run, "what this run visited");
  if (report.approved) body += graph_of(*report.approved, "what the approved run visited");
  body += "<h2>How to reproduce</h2>\n<pre>";
  for (const auto& command : report.commands) body += in_markup(command) + "\n";
  return html_page(report.verdict + ": " + report.trace, body + "</pre>\n");
}

}  // namespace continua
