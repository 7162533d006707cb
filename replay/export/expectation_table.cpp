#include "continua/replay/export/expectation_table.h"

#include <fmt/format.h>

#include "continua/core/markup.h"
#include "continua/replay/log/expectation_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/time_text.h"

namespace continua {
namespace {

// Longest table, in expectations: a run that goes another way meets few of the rest.
constexpr std::size_t most_told = 50;

std::string cell(const char* kind, const char* of, const std::string& text, const std::string& raw) {
  return fmt::format("<td class=\"{}\" data-of=\"{}\" title=\"{}\">{}</td>", kind, of, in_markup(raw), in_markup(text));
}

std::string rows_of(const RunIndex& run, const RunWords& words, std::size_t n, const Json& expect) {
  auto html = fmt::format("<tr class=\"part\"><td colspan=\"3\">line {} of the trace, at {}</td></tr>\n",
                          text_of(expect, "line"), time_text(run.entry(n).t.seconds()));
  for (const auto& field : told_fields(words, expect))
    html +=
        fmt::format("<tr><td>{}</td>{}{}</tr>\n", in_markup(field.name),
                    cell(field.met ? "both" : "gone", "expected", field.expected, field.raw_expected),
                    cell(field.met ? "both" : "come", "found", field.met ? "the same" : field.found, field.raw_found));
  return html;
}

}  // namespace

std::string unmet_table(const RunIndex& run) {
  const RunWords words(run);
  std::string rows;
  std::size_t count = 0;
  for (const auto n : run.of_kind(log::Expect::kind.name)) {
    const auto record = run.record(n);
    if (!record || member_of(*record, "met") != false) continue;
    if (++count <= most_told) rows += rows_of(run, words, n, *record);
  }
  if (count == 0) return "";
  auto html =
      "<table class=\"unmet\">\n<thead><tr><th class=\"field\" scope=\"col\">field</th><th scope=\"col\">expected"
      "</th><th scope=\"col\">found</th></tr></thead>\n<tbody>\n" +
      rows + "</tbody></table>\n";
  if (count > most_told)
    html += fmt::format("<p class=\"quiet\">These are the first {} of {}.</p>\n", most_told, count);
  return html;
}

}  // namespace continua
