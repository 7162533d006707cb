#include "continua/replay/inspector/run_labels.h"

#include <algorithm>

#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_text.h"

namespace continua {
namespace {

std::string event_text(std::string_view event) {
  const auto kind = text_in(member_in(event, "kind"));
  if (kind == "speech") return text_in(member_in(event, "text"));
  if (kind != "gesture") return {};
  const auto name = text_in(member_in(event, "name")), direction = text_in(member_in(event, "direction"));
  return direction.empty() ? name : name + " " + direction;
}

std::string shown_text(const std::string& kind, std::string_view line) {
  if (kind == "input") return event_text(member_in(line, "event"));
  const char* member = kind == "utterance"  ? "text"
                       : kind == "gesture"  ? "gesture"
                       : kind == "act"      ? "program"
                       : kind == "observed" ? "content"
                                            : nullptr;
  return member ? text_in(member_in(line, member)) : std::string();
}

}  // namespace

std::string label_of(const std::string& kind, std::string_view line) {
  if (kind == "pose") return {};
  const auto parts = brief_parts(kind);
  Json record;
  if (parts) {
    // Only what is read is made a tree.
    thread_local std::string part;
    part = "{\"kind\":" + compact(kind);
    scan_members(line, [&](std::string_view key, std::string_view value) {
      if (std::find(parts->members.begin(), parts->members.end(), key) != parts->members.end())
        part.append(",\"").append(key).append("\":").append(value);
    });
    record = Json::parse(part += '}', nullptr, false);
  } else {
    record = Json::parse(line, nullptr, false);
  }
  return record.is_object() ? brief(record) : std::string();
}

Result<Json> run_labels(const RunIndex& run, const std::vector<std::size_t>& numbers) {
  Json labels = Json::object();
  auto next = numbers.begin();
  const auto problem = run.read_lines(
      [&](std::size_t n) {
        next = std::lower_bound(next, numbers.end(), n);
        return next != numbers.end() && *next == n;
      },
      [&](std::size_t n, std::string_view line) {
        labels[std::to_string(n)] = Json{label_of(run.kind(n), line), shown_text(run.kind(n), line)};
        return true;
      });
  if (problem) return *problem;
  return Json{{"labels", std::move(labels)}};
}

}  // namespace continua
