#include "continua/replay/inspector/run_labels.h"

#include <algorithm>

#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_text.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

std::string event_text(const RunWords& words, std::string_view event) {
  const auto kind = text_in(member_in(event, "kind"));
  if (kind == "speech") return text_in(member_in(event, "text"));
  if (kind != "gesture") return {};
  return words.gesture(text_in(member_in(event, "name")), text_in(member_in(event, "direction")));
}

// Something said, shown, done or observed, as people say it.
std::string shown_text(const RunWords& words, const std::string& kind, std::string_view line) {
  if (log::is<log::Input>(kind)) return event_text(words, member_in(line, log::name_of(&log::Input::event)));
  const auto text_of_member = [&](auto member) { return text_in(member_in(line, log::name_of(member))); };
  if (log::is<log::Utterance>(kind)) return text_of_member(&log::Utterance::text);
  if (log::is<log::AvatarGesture>(kind)) return words.term(text_of_member(&log::AvatarGesture::gesture));
  if (log::is<log::Act>(kind)) return words.term(text_of_member(&log::Act::program));
  if (log::is<log::Observed>(kind)) {
    const auto content = text_of_member(&log::Observed::content);
    return text_of_member(&log::Observed::channel) == "speech" ? "“" + content + "”" : words.term(content);
  }
  return {};
}

// The members of the record that brief() reads; null for poses and for a line that is no JSON.
Json told_part(const std::string& kind, std::string_view line) {
  if (log::is<log::Pose>(kind)) return nullptr;
  const auto* schema = log::schema_of(kind);
  if (!schema) return Json::parse(line, nullptr, false);
  // Only the members that are read become a tree.
  thread_local std::string part;
  part = "{\"kind\":" + compact(kind);
  scan_members(line, [&](std::string_view key, std::string_view value) {
    const auto shown = [&](const log::MemberSchema& one) { return one.in_brief && one.name == key; };
    if (std::any_of(schema->members.begin(), schema->members.end(), shown))
      part.append(",\"").append(key).append("\":").append(value);
  });
  return Json::parse(part += '}', nullptr, false);
}

std::string label_of(const Json& told) { return told.is_object() ? brief(told) : std::string(); }

std::string label_in_words(const RunWords& words, const Json& told) {
  return told.is_object() ? brief_in_words(words, told) : std::string();
}

}  // namespace

std::string label_of(const std::string& kind, std::string_view line) { return label_of(told_part(kind, line)); }

std::string label_in_words(const RunWords& words, const std::string& kind, std::string_view line) {
  return label_in_words(words, told_part(kind, line));
}

Result<Json> run_labels(const RunIndex& run, const std::vector<std::size_t>& numbers) {
  const RunWords words(run);
  Json labels = Json::object();
  auto next = numbers.begin();
  const auto problem = run.read_lines(
      [&](std::size_t n) {
        next = std::lower_bound(next, numbers.end(), n);
        return next != numbers.end() && *next == n;
      },
      [&](std::size_t n, std::string_view line) {
        const auto record = told_part(run.kind(n), line);
        auto& told = labels[std::to_string(n)] = {label_of(record), shown_text(words, run.kind(n), line)};
        auto in_words = label_in_words(words, record);
        auto reason = log::is<log::Act>(run.kind(n)) ? words.reason_of_act(line) : std::string();
        const bool same = in_words == told[0];
        if (!same || !reason.empty()) told.push_back(same ? Json() : Json(std::move(in_words)));
        if (!reason.empty()) told.push_back(std::move(reason));
        return true;
      });
  if (problem) return *problem;
  return Json{{"labels", std::move(labels)}};
}

}  // namespace continua
