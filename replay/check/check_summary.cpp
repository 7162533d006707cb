#include "continua/replay/check/check_summary.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "continua/core/markup.h"

namespace continua {
namespace {

// A line of text in HTML.
std::string line_of(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return in_markup(text);
}

// A line of text that Markdown shows as it is.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : line_of(text)) {
    if (std::string_view("\\`*_[]|~#").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

// Text between lines of backticks, of which there are more than anywhere in it.
std::string fenced(const std::string& text) {
  std::string fence = "```";
  while (text.find(fence) != std::string::npos) fence += '`';
  return fmt::format("{}\n{}{}{}\n", fence, text, text.ends_with('\n') ? "" : "\n", fence);
}

std::string failure(const CheckCase& one) {
  std::string text =
      fmt::format("<details><summary><b>{}</b>: {}</summary>\n\n", line_of(one.path), line_of(one.sentence));
  std::string problems;
  for (const auto& problem : one.problems) problems += problem.text() + "\n";
  if (!problems.empty()) text += fenced(problems) + "\n";
  if (!one.details.empty()) text += one.details + (one.details.ends_with('\n') ? "\n" : "\n\n");
  if (!one.page.empty()) text += fmt::format("Report: {}\n\n", plain(one.page));
  return text + "</details>\n\n";
}

}  // namespace

std::string markdown_of(const CheckReport& report) {
  std::string text = fmt::format("## continua check: {}\n\n{}\n\n",
                                 report.status() == exit_done ? "all holds" : "failed", plain(total_of(report)));
  text += "| verdict | traces | other files |\n| --- | ---: | ---: |\n";
  for (const auto& [verdict, count] : verdicts_of(report, true))
    text += fmt::format("| {} | {} | |\n", plain(verdict), count);
  for (const auto& [verdict, count] : verdicts_of(report, false))
    text += fmt::format("| {} | | {} |\n", plain(verdict), count);
  text += "\n";
  for (const auto& one : report.cases)
    if (one.status != exit_done) text += failure(one);
  return text;
}

}  // namespace continua
