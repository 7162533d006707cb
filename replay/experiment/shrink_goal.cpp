#include "continua/replay/experiment/shrink_goal.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/log/kinds.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

constexpr const char* where = "--until";

// Things to find in a run, by a person's word, and the kind of their records.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> found_kinds = {
    {{"unmet", log::Expect::kind.name},
     {"refusal", log::Refusal::kind.name},
     {"problem", log::Problem::kind.name},
     {"changed", "changed"}}};

std::vector<std::string> expectable() {
  auto fields = fields_of_kind("expect");
  std::erase_if(fields, [](const std::string& name) { return name == "t" || name == "kind" || name == "row"; });
  return fields;
}

Error unknown(const std::string& found) {
  auto known = expectable();
  for (const auto& [name, kind] : found_kinds) known.emplace_back(name);
  return {where, fmt::format("found {}{}; expected FIELD=VALUE with a field of {}, a JSON object of them, or unmet, "
                             "refusal, problem or changed",
                             in_quotes(found), did_you_mean(found, known), fmt::join(expectable(), ", "))};
}

// The value of such a field that a person writes without quotation marks.
Json value_of(const std::string& field, const std::string& text) {
  if (text == "null") return nullptr;
  if (field == "stack_depth") {
    std::uint64_t number = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (problem == std::errc() && end == text.data() + text.size()) return number;
  }
  if (field != "referents") return text;
  if (text.starts_with('[')) {
    auto list = parse_json_line(text, where, 1);
    if (list) return std::move(*list);
  }
  Json names = Json::array();
  for (std::size_t from = 0; from < text.size();) {
    const auto comma = std::min(text.find(',', from), text.size());
    names.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
  return names;
}

// "unmet", "unmet:12", …
Result<std::optional<ShrinkGoal>> found_goal(const std::string& text) {
  const auto colon = std::min(text.find(':'), text.size());
  const auto kind = std::find_if(found_kinds.begin(), found_kinds.end(),
                                 [&](const auto& known) { return known.first == text.substr(0, colon); });
  if (kind == found_kinds.end()) return std::optional<ShrinkGoal>();
  ShrinkGoal goal{{}, std::string(kind->second), {}, text};
  if (colon == text.size()) return std::optional(goal);
  if (kind->first == "changed") return unknown(text);
  std::size_t line = 0;
  const auto* last = text.data() + text.size();
  const auto [end, problem] = std::from_chars(text.data() + colon + 1, last, line);
  if (problem != std::errc() || end != last || line < 2)
    return Error{where, fmt::format("found {}; expected {}:LINE with a line of the trace, from 2", in_quotes(text),
                                    kind->first)};
  goal.line = line;
  return std::optional(goal);
}

// Adds the fields that one text names.
Outcome add_fields(const std::string& text, Json& fields) {
  const auto known = expectable();
  const auto add = [&](const std::string& name, Json value) -> Outcome {
    if (std::find(known.begin(), known.end(), name) == known.end()) return unknown(name);
    if (fields.contains(name)) return Error{where, fmt::format("found {} twice; expected it once", in_quotes(name))};
    fields[name] = std::move(value);
    return std::nullopt;
  };
  if (text.starts_with('{')) {
    const auto object = parse_json_line(text, where, 1);
    if (!object) return object.error();
    for (const auto& [name, value] : object->items())
      if (const auto problem = add(name, value)) return problem;
    return std::nullopt;
  }
  const auto equals = text.find('=');
  if (equals == std::string::npos) return unknown(text);
  const auto name = text.substr(0, equals);
  return add(name, value_of(name, text.substr(equals + 1)));
}

const Json* member(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

// The trace's line that a record tells of, or that it came of.
std::optional<std::size_t> line_of(const Json& record, const std::vector<std::string_view>& records) {
  if (const auto* line = member(record, "line"); line && line->is_number()) return line->get<std::size_t>();
  const auto* cause = member(record, "cause");
  return cause ? line_of(Json::parse(records[cause->get<std::size_t>()]), records) : std::nullopt;
}

}  // namespace

Result<ShrinkGoal> parse_goal(const std::vector<std::string>& texts) {
  require(!texts.empty(), "something is to be looked for");
  for (const auto& text : texts) {
    auto found = found_goal(text);
    if (!found) return found.error();
    if (*found && texts.size() > 1)
      return Error{where, fmt::format("found {} and more; expected it alone", in_quotes(text))};
    if (*found) return std::move(**found);
  }
  Json fields = Json::object();
  for (const auto& text : texts)
    if (const auto problem = add_fields(text, fields)) return *problem;
  if (fields.empty()) return unknown(texts.front());
  fields["t"] = 0;
  fields["kind"] = "expect";
  const auto event = read_event(fields, where, 1);
  if (!event) return Error{where, event.error().sentence};
  return ShrinkGoal{std::get<Expectation>(event->what), "", {}, fmt::format("{}", fmt::join(texts, " "))};
}

bool meets(const Expectation& expectation, const Situation& situation) {
  if (check(expectation, situation).met) return true;
  if (!expectation.says) return false;
  Situation then = situation;
  for (; then.said.size() > 1;) {
    then.said.pop_back();
    if (check(expectation, then).met) return true;
  }
  return false;
}

std::vector<Finding> findings(std::string_view log, const std::string& kind) {
  std::vector<std::string_view> records;
  for (auto end = log.find('\n'); end != std::string_view::npos; end = log.find('\n')) {
    records.push_back(log.substr(0, end));
    log.remove_prefix(end + 1);
  }
  const auto prefix = fmt::format("{{\"kind\":{},", compact(kind));
  std::vector<Finding> found;
  for (const auto text : records) {
    if (!text.starts_with(prefix)) continue;
    const auto record = Json::parse(text);
    if (log::is<log::Expect>(kind) && record["met"] == true) continue;
    Finding one{line_of(record, records), Json::object(), SimTime::from_seconds(record["t"].get<double>())};
    for (const char* field : {"line", "found", "state", "input", "message"})
      if (const auto* value = member(record, field)) one.what[field] = *value;
    found.push_back(std::move(one));
  }
  return found;
}

}  // namespace continua
