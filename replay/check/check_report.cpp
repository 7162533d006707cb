#include "continua/replay/check/check_report.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace continua {
namespace {

// "41 traces: 38 same, 1 changed; " or nothing.
std::string total_of(const CheckReport& report, bool traces, const std::string& noun) {
  std::size_t count = 0;
  std::string text;
  for (const auto& [verdict, number] : verdicts_of(report, traces)) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, verdict);
    count += number;
  }
  return count == 0 ? "" : counted(count, noun) + ": " + text + "; ";
}

// A member of the wanted type, or the replacement for a missing one.
template <class T>
T member(const Json& object, const char* key, T otherwise, bool (Json::*is)() const noexcept) {
  const auto found = object.find(key);
  return found != object.end() && ((*found).*is)() ? found->template get<T>() : otherwise;
}

std::string text_in(const Json& object, const char* key) {
  return member<std::string>(object, key, "", &Json::is_string);
}

constexpr std::array<std::string_view, 4> failures = {"changed", "stale", "broken", "not true"};

// Why a case of a report cannot be believed; empty if it can. One without a status counts as impossible.
std::string fault_of(const Json& json) {
  const auto status = json.find("status");
  if (status == json.end() || !status->is_number_integer()) return "";
  if (*status < exit_done || *status > exit_impossible)
    return fmt::format("'status' is {}; expected {}, {} or {}", compact(*status), static_cast<int>(exit_done),
                       static_cast<int>(exit_no), static_cast<int>(exit_impossible));
  const auto verdict = text_in(json, "verdict");
  if (*status != exit_done || std::find(failures.begin(), failures.end(), verdict) == failures.end()) return "";
  return fmt::format("'verdict' is {} and 'status' {}; expected a status that says so too", in_quotes(verdict),
                     compact(*status));
}

CheckCase case_of(const Json& json) {
  CheckCase one;
  one.path = text_in(json, "path");
  one.is_trace = member(json, "trace", false, &Json::is_boolean);
  one.verdict = text_in(json, "verdict");
  one.sentence = text_in(json, "sentence");
  one.status = member(json, "status", static_cast<int>(exit_impossible), &Json::is_number_integer);
  one.line = member(json, "line", std::size_t{0}, &Json::is_number_unsigned);
  if (const auto problems = json.find("problems"); problems != json.end() && problems->is_array())
    for (const auto& problem : *problems)
      if (problem.is_object()) one.problems.push_back({text_in(problem, "where"), text_in(problem, "sentence")});
  one.details = text_in(json, "details");
  one.page = text_in(json, "page");
  return one;
}

Json json_of(const CheckCase& one) {
  Json json{{"path", one.path}};
  if (one.is_trace) json["trace"] = true;
  json["verdict"] = one.verdict;
  json["sentence"] = one.sentence;
  json["status"] = one.status;
  if (one.line > 0) json["line"] = one.line;
  for (const auto& problem : one.problems)
    json["problems"].push_back({{"where", problem.where}, {"sentence", problem.sentence}});
  if (!one.details.empty()) json["details"] = one.details;
  if (!one.page.empty()) json["page"] = one.page;
  return json;
}

}  // namespace

int CheckReport::status() const {
  int status = exit_done;
  for (const auto& one : cases) status = std::max(status, one.status);
  return status;
}

std::string line_of(const CheckCase& one) {
  return fmt::format("{} {}: {}", one.status == exit_done ? "ok  " : "FAIL", one.path, one.sentence);
}

std::vector<std::pair<std::string, std::size_t>> verdicts_of(const CheckReport& report, bool traces) {
  std::vector<std::pair<std::string, std::size_t>> times;
  for (const char* verdict : {"same", "same decisions", "new", "changed", "stale", "broken", "true", "not true"})
    times.emplace_back(verdict, 0);
  for (const auto& one : report.cases) {
    if (one.is_trace != traces) continue;
    auto found =
        std::find_if(times.begin(), times.end(), [&](const auto& known) { return known.first == one.verdict; });
    if (found == times.end()) found = times.insert(times.end(), {one.verdict, 0});
    ++found->second;
  }
  std::erase_if(times, [](const auto& verdict) { return verdict.second == 0; });
  return times;
}

std::string total_of(const CheckReport& report) {
  const auto traces = total_of(report, true, "trace");
  return fmt::format("{}{}in {:.1f} s", traces, total_of(report, false, traces.empty() ? "file" : "other file"),
                     report.seconds);
}

Json json_of(const CheckReport& report) {
  Json cases = Json::array();
  for (const auto& one : report.cases) cases.push_back(json_of(one));
  return {{"check", 1},
          {"shard", {report.shard.index, report.shard.count}},
          {"files", report.files},
          {"numbers", json_of_item_numbers(report.numbers)},
          {"seconds", report.seconds},
          {"cases", std::move(cases)}};
}

Result<CheckReport> read_report(std::string_view text, const std::string& name) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  if (const auto& doubled = document->duplicates(); !doubled.empty())
    return document->error(doubled.front().place,
                           fmt::format("the key {} a second time in this object", in_quotes(doubled.front().key)));
  const auto& root = document->root();
  if (!root.is_object() || !root.contains("check") || root["check"] != 1)
    return document->error("", "found no report of a check; expected \"check\": 1");
  const auto shard = read_shard(*document);
  if (!shard) return shard.error();
  CheckReport report;
  report.shard = *shard;
  report.files = member(root, "files", std::size_t{0}, &Json::is_number_unsigned);
  report.seconds = member(root, "seconds", 0.0, &Json::is_number);
  if (!root.contains("cases") || !root["cases"].is_array())
    return document->error("/cases", "expected \"cases\": a list of what came out, file by file");
  for (const auto& one : root["cases"]) {
    if (!one.is_object())
      return document->error(fmt::format("/cases/{}", report.cases.size()),
                             fmt::format("found {}; expected an object", compact(one)));
    if (const auto fault = fault_of(one); !fault.empty())
      return document->error(fmt::format("/cases/{}", report.cases.size()), fault);
    report.cases.push_back(case_of(one));
  }
  auto numbers = read_item_numbers(*document, report.shard, report.files, "cases");
  if (!numbers) return numbers.error();
  report.numbers = *std::move(numbers);
  return report;
}

MergedReports merged(const std::vector<std::string>& names, const std::vector<CheckReport>& reports) {
  std::vector<ShardOf> shards;
  for (std::size_t i = 0; i < reports.size(); ++i)
    shards.push_back({names[i], reports[i].shard, reports[i].files, reports[i].numbers});
  auto places = places_of(shards, "file");
  MergedReports all{{{}, reports.front().files, {}, 0, {}}, std::move(places.problems)};
  for (const auto report : places.reports) all.report.seconds += reports[report].seconds;
  for (std::size_t file = 0; file < all.report.files; ++file)
    if (const auto& place = places.items[file]) {
      all.report.numbers.push_back(file);
      all.report.cases.push_back(reports[place->report].cases[place->among_its]);
    }
  return all;
}

}  // namespace continua
