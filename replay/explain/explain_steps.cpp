#include "continua/replay/explain/explain_steps.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "continua/replay/explain/explain_origin.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_views.h"

namespace continua {
namespace {

Json records_of(ExplainScope& scope, std::size_t input, std::string_view kind) {
  Json records = Json::array();
  for (const auto n : scope.of_turn(input, kind)) records.push_back(scope.record(n));
  return records;
}

// The condition of the machine's edge.
Json condition_of(const Json& graph, const std::string& id, const std::string& from) {
  const auto& edges = member_of(graph, "edges");
  if (!edges.is_array()) return nullptr;
  for (const auto& edge : edges)
    if (text_of(edge, "id") == id && text_of(edge, "from") == from) return member_of(edge, "condition");
  return nullptr;
}

// The number of states that a transition leaves, by its id.
std::map<std::string, std::size_t> states_left(const Json& graph) {
  std::map<std::string, std::size_t> left;
  if (const auto& edges = member_of(graph, "edges"); edges.is_array())
    for (const auto& edge : edges) ++left[text_of(edge, "id")];
  return left;
}

std::string content_text(const Json& value) {
  return value.is_null() ? "null" : value.is_string() ? value.get<std::string>() : compact(value);
}

}  // namespace

Json explained_refusals(const Json& record, const Json& graph) {
  struct Group {
    std::string reason;
    Json ids;
    std::size_t states;
  };
  std::vector<Group> groups;
  auto left = states_left(graph);
  if (const auto& refused = member_of(record, "refused"); refused.is_array())
    for (const auto& one : refused) {
      const auto id = text_of(one, "id");
      auto reason = text_of(one, "reason");
      if (const auto& of = member_of(one, "alternative"); of != member_of(record, "alternative"))
        reason += fmt::format(" (of alternative {})", compact(of));
      auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.reason == reason; });
      if (group == groups.end()) group = groups.insert(groups.end(), {reason, Json::array(), left[id]});
      if (std::find(group->ids.begin(), group->ids.end(), id) == group->ids.end()) group->ids.push_back(id);
      group->states = std::min(group->states, left[id]);
    }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.states < b.states; });
  Json told = Json::array();
  for (auto& group : groups) told.push_back({{"reason", group.reason}, {"ids", std::move(group.ids)}});
  return told;
}

namespace {

// Each thing that was ruled out with its words, `told`, and those of the reason, `why`.
void tell_ruled_out(const RunWords& words, Json& of) {
  const auto list = of.find("ruled_out");
  if (list == of.end() || !list->is_array()) return;
  for (auto& one : *list) {
    if (!one.is_object()) continue;
    one["told"] = words.thing(text_of(one, "object"));
    one["why"] = words.reason(text_of(one, "reason"), text_of(one, "object"));
  }
}

// A list of what a reading or a percept found, each with its meaning or its place in words as `told`.
void tell_found(const RunWords& words, Json& record) {
  if (!record.is_object()) return;
  tell_ruled_out(words, record);
  if (auto found = record.find("resolved"); found != record.end() && found->is_array())
    for (auto& one : *found) {
      if (!one.is_object()) continue;
      tell_ruled_out(words, one);
      if (const auto value = text_of(one, "value"); !value.empty() && value != "null") one["told"] = words.term(value);
      if (member_of(one, "referents").is_array()) one["referents_told"] = words.each(one["referents"]);
    }
  if (auto bound = record.find("bound"); bound != record.end() && bound->is_array())
    for (auto& one : *bound)
      if (one.is_object() && member_of(one, "deixis").is_object())
        one["deixis"]["told"] = words.spot(member_of(one["deixis"], "place"));
}

Json in_words(const RunWords& words, Json records) {
  for (auto& one : records) tell_found(words, one);
  return records;
}

}  // namespace

Json explained_inputs(ExplainScope& scope) {
  Json inputs = Json::array();
  const auto here = scope.input_of(scope.n());
  for (const auto n : scope.inputs()) {
    const Json& record = scope.record(n);
    const auto t = scope.run().entry(n).t.seconds();
    const auto& event = member_of(record, "event");
    const auto kind = text_of(event, "kind");
    if (kind == "pointing" && n != here && !inputs.empty() && inputs.back()["kind"] == kind &&
        inputs.back()["hand"] == text_of(event, "hand") && inputs.back()["here"] == false) {
      inputs.back()["count"] = inputs.back()["count"].get<std::size_t>() + 1;
      inputs.back()["until"] = t;
      continue;
    }
    inputs.push_back({{"n", n},
                      {"t", t},
                      {"kind", kind},
                      {"told", input_text(scope.words(), record)},
                      {"symbol", member_of(record, "symbol")},
                      {"here", n == here},
                      {"percepts", in_words(scope.words(), records_of(scope, n, log::Percept::kind.name))},
                      {"readings", in_words(scope.words(), records_of(scope, n, log::Reading::kind.name))}});
    if (kind == "pointing") {
      inputs.back()["hand"] = text_of(event, "hand");
      inputs.back()["count"] = 1;
      inputs.back()["until"] = t;
    }
  }
  return inputs;
}

Json explained_steps(ExplainScope& scope, const Json& graph) {
  Json steps = Json::array();
  const auto& chain = scope.chain();
  for (auto n = chain.rbegin(); n != chain.rend(); ++n) {
    if (!log::is<log::Transition>(scope.run().kind(*n))) continue;
    const Json& record = scope.record(*n);
    Json step{{"n", *n}, {"t", scope.run().entry(*n).t.seconds()}};
    for (const char* part : {"step", "id", "from", "to", "input"}) step[part] = member_of(record, part);
    step["condition"] = condition_of(graph, text_of(record, "id"), text_of(record, "from"));
    for (const char* part : {"operation", "weight", "probability", "draw", "forced", "candidates", "gates"})
      step[part] = member_of(record, part);
    step["refused"] = explained_refusals(record, graph);
    steps.push_back(std::move(step));
  }
  return steps;
}

Json brought_about(ExplainScope& scope, std::size_t n) {
  const auto& run = scope.run();
  Json records = Json::array();
  for (std::size_t at = n + 1; at < run.size(); ++at)
    if (run.cause(at) == n && !log::is<log::Symbol>(run.kind(at)))
      records.push_back({{"n", at},
                         {"kind", run.kind(at)},
                         {"brief", brief(scope.record(at))},
                         {"told", brief_in_words(scope.words(), scope.record(at))}});
  return records;
}

std::string operation_text(const Json& operation) {
  if (!operation.is_object() || operation.empty()) return operation.is_string() ? operation.get<std::string>() : "";
  const auto name = operation.begin().key();
  const auto& content = operation.begin().value();
  if (name == "none") return "leave the stack";
  if (!content.is_object()) return fmt::format("{} {}", name, content_text(content));
  if (content.empty()) return name;
  std::string text;
  for (const auto& [slot, value] : content.items())
    text += fmt::format("{}{} ← {}", text.empty() ? " " : ", ", slot, content_text(value));
  return name + text;
}

}  // namespace continua
