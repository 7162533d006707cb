#include "continua/replay/log/run_views.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_sources.h"
#include "continua/replay/log/run_words.h"

namespace continua {
namespace {

Json brief_json(const RunIndex& run, std::size_t n, const Json& record) {
  return Json{{"n", n}, {"t", run.entry(n).t.seconds()}, {"kind", run.kind(n)}, {"brief", brief(record)}};
}

}  // namespace

Result<std::string> run_records(const RunIndex& run, const RecordFilter& filter) {
  std::string text = "{\"records\":[";
  std::size_t count = 0;
  std::optional<std::size_t> next;
  for (std::size_t n = filter.after; n < run.size(); ++n) {
    const auto t = run.entry(n).t.seconds();
    if (filter.from_s && t < *filter.from_s) continue;
    if (filter.to_s && t > *filter.to_s) continue;
    if (!filter.kinds.empty() && std::find(filter.kinds.begin(), filter.kinds.end(), run.kind(n)) == filter.kinds.end())
      continue;
    if (count == filter.limit) {
      next = n;
      break;
    }
    const auto record = run.record_text(n);
    if (!record) return record.error();
    if (count++ > 0) text += ',';
    text += *record;
  }
  return text += fmt::format("],\"next\":{}}}", next ? std::to_string(*next) : "null");
}

Result<Json> run_graph(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return header.error();
  Json graph = header->value("graph", Json::object());
  if (!graph.is_object()) graph = Json::object();
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::size_t> steps;
  for (const auto& step : run.step_marks()) ++steps[{step.id, step.from, step.to}];
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> taken;
  std::map<std::string, std::size_t> entered;
  for (const auto& [step, visits] : steps) {
    const auto& [id, from, to] = step;
    taken[{run.names()[id], run.names()[from], run.names()[to]}] += visits;
    entered[run.names()[to]] += visits;
  }
  for (const char* part : {"states", "edges"})
    if (!graph.contains(part) || !graph[part].is_array()) graph[part] = Json::array();
  for (auto& state : graph["states"])
    if (state.is_object()) state["visits"] = entered[text_of(state, "id")];
  for (auto& edge : graph["edges"]) {
    if (!edge.is_object()) continue;
    auto found = taken.extract({text_of(edge, "id"), text_of(edge, "from"), text_of(edge, "to")});
    edge["visits"] = found ? found.mapped() : std::size_t{0};
  }
  // The remaining edges ended elsewhere than their transitions lead: a gate turned them away.
  for (const auto& [key, visits] : taken) {
    const auto& [id, from, to] = key;
    Json diverted{{"id", id},         {"from", from},         {"to", to},
                  {"input", nullptr}, {"condition", nullptr}, {"operation", ""}};
    for (const auto& edge : graph["edges"])
      if (edge.is_object() && text_of(edge, "id") == id && text_of(edge, "from") == from)
        for (const char* part : {"input", "condition", "operation"}) diverted[part] = edge.value(part, Json());
    diverted["diverted"] = true;
    diverted["visits"] = visits;
    graph["edges"].push_back(std::move(diverted));
  }
  return graph;
}

namespace {

// {slot: {was, now}} of the slots in which two symbols differ; null where one has none. Slots that are no object count
// as none.
Json slots_changed(const Json& was, const Json& now) {
  if (!was.is_object()) return slots_changed(Json::object(), now);
  if (!now.is_object()) return slots_changed(was, Json::object());
  Json changed = Json::object();
  const auto note = [&](const std::string& slot) {
    const auto before = was.value(slot, Json()), after = now.value(slot, Json());
    if (before != after) changed[slot] = Json{{"was", before}, {"now", after}};
  };
  for (const auto& [slot, value] : now.items()) note(slot);
  for (const auto& [slot, value] : was.items())
    if (!now.contains(slot)) note(slot);
  return changed;
}

// `told`: the values of slots, also of those before a change, for which there are words.
void tell_slots(const RunWords& words, Json& symbol) {
  Json told = Json::object();
  const auto tell = [&](const Json& value) {
    if (!value.is_string()) return;
    const auto term = value.get<std::string>();
    if (auto text = words.term(term); text != term) told[term] = std::move(text);
  };
  if (const auto& slots = member_of(symbol, "slots"); slots.is_object())
    for (const auto& value : slots) tell(value);
  if (const auto& changed = member_of(symbol, "slots_changed"); changed.is_object())
    for (const auto& change : changed) tell(member_of(change, "was"));
  if (!told.empty()) symbol["told"] = std::move(told);
}

constexpr std::int64_t no_symbol = -1;

// From the stack with the top `was` to that with the top `top`.
Result<Json> stack_change(const RunIndex& run, std::int64_t was, std::int64_t top) {
  auto now = run.snapshot(top);
  if (!now) return now.error();
  auto before = run.snapshot(was);
  if (!before) return before.error();

  // Stacks share their tails, so they are equal from the bottom up.
  std::size_t same = 0;
  while (same < now->size() && same < before->size() &&
         (*now)[now->size() - 1 - same]["id"] == (*before)[before->size() - 1 - same]["id"])
    ++same;
  const auto added = now->size() - same, removed = before->size() - same;
  for (std::size_t i = 0; i < now->size(); ++i) {
    auto& symbol = (*now)[i];
    const auto height = added - 1 - i;  // above the shared tail, for the symbols that are new
    if (i >= added) {
      symbol["change"] = "same";
    } else if (height < removed) {
      symbol["change"] = "changed";
      symbol["slots_changed"] = slots_changed((*before)[removed - 1 - height]["slots"], symbol["slots"]);
    } else {
      // A pushed symbol inherits from the one below: the push set the slots that differ.
      symbol["change"] = "added";
      symbol["slots_changed"] =
          slots_changed(i + 1 < now->size() ? (*now)[i + 1]["slots"] : Json::object(), symbol["slots"]);
    }
  }
  Json gone = Json::array();
  for (std::size_t i = 0; i + added < removed; ++i) gone.push_back((*before)[i]);
  const RunWords words(run);
  for (auto* symbols : {&*now, &gone})
    for (auto& symbol : *symbols) tell_slots(words, symbol);
  return Json{{"depth", now->size()},
              {"depth_before", before->size()},
              {"symbols", *std::move(now)},
              {"removed", std::move(gone)}};
}

// The top that is known at record n: before the first step, the symbol that the log begins with.
std::int64_t top_at(const RunIndex& run, std::size_t n) {
  if (const auto mark = run.mark_at(n)) return run.stack_marks()[*mark].top;
  if (n < 1 || run.kind(1) != "symbol") return no_symbol;
  const auto symbol = run.record(1);
  if (!symbol) return no_symbol;
  const auto& id = member_of(*symbol, "id");
  return id.is_number_integer() ? id.get<std::int64_t>() : no_symbol;
}

}  // namespace

Result<Json> run_stack(const RunIndex& run, std::size_t n) {
  const auto mark = run.mark_at(n);
  const auto& marks = run.stack_marks();
  auto change =
      stack_change(run, mark && *mark > 0 ? marks[*mark - 1].top : no_symbol, mark ? marks[*mark].top : no_symbol);
  if (!change) return change;
  Json told{{"n", n}, {"at", mark ? Json(marks[*mark].n) : Json()}};
  told.update(*change);
  return told;
}

namespace {

// A branch of this id in a `branches` record, or null.
Json branch_in(const Json& record, std::int64_t id) {
  const auto& branches = member_of(record, "branches");
  if (branches.is_array())
    for (const auto& one : branches)
      if (const auto& number = member_of(one, "id"); number.is_number_integer() && number.get<std::int64_t>() == id)
        return one;
  return nullptr;
}

std::int64_t integer_of(const Json& object, const char* key, std::int64_t otherwise) {
  const auto& value = member_of(object, key);
  return value.is_number_integer() ? value.get<std::int64_t>() : otherwise;
}

// The top of the branch's stack in the last of these records that has it, or no symbol.
Result<std::int64_t> last_top(const RunIndex& run, const std::vector<std::size_t>& records, std::size_t count,
                              std::int64_t branch) {
  for (auto i = count; i > 0; --i) {
    const auto record = run.record(records[i - 1]);
    if (!record) return record.error();
    if (const auto found = branch_in(*record, branch); !found.is_null()) return integer_of(found, "stack", no_symbol);
  }
  return no_symbol;
}

}  // namespace

Result<Json> run_branch_stack(const RunIndex& run, std::size_t n, std::int64_t branch) {
  const auto records = run.of_kind(log::Branches::kind.name);
  const auto count = static_cast<std::size_t>(std::upper_bound(records.begin(), records.end(), n) - records.begin());
  if (count == 0) return Error{run.where(n), "here the automaton is in one configuration: there are no branches"};
  const auto record = run.record(records[count - 1]);
  if (!record) return record.error();
  const auto found = branch_in(*record, branch);
  if (found.is_null()) {
    std::string known;
    const auto& branches = member_of(*record, "branches");
    if (branches.is_array())
      for (const auto& one : branches) known += (known.empty() ? "" : ", ") + text_of(one, "id");
    return Error{run.where(n), "there is no branch " + std::to_string(branch) + "; there are " + known};
  }
  const auto before = last_top(run, records, count - 1, integer_of(found, "parent", branch));
  if (!before) return before.error();
  auto change = stack_change(run, *before, integer_of(found, "stack", no_symbol));
  if (!change) return change;
  Json told{{"n", n}, {"at", records[count - 1]}, {"branch", found}};
  told.update(*change);
  return told;
}

Result<Json> run_stack_since(const RunIndex& run, std::size_t before, std::size_t n) {
  return stack_change(run, top_at(run, before), top_at(run, n));
}

Result<Json> run_derivation(const RunIndex& run, std::size_t n) {
  // Upwards through `cause` and `because`; and across to the applications that the
  // records met on the way brought about, and to those whose result became part of one already met.
  std::map<std::size_t, Json> applications, inputs;
  std::set<std::size_t> met;
  RunSources sources(run);
  std::vector<std::size_t> open{n};
  Json chain = Json::array();
  for (std::optional<std::size_t> at = n; at; at = run.cause(*at)) {
    const auto record = run.record(*at);
    if (!record) return record.error();
    chain.push_back(brief_json(run, *at, *record));
  }
  const auto all = run.of_kind(log::Application::kind.name);
  std::multimap<std::size_t, std::size_t> brought_about;  // cause -> application
  for (const auto application : all)
    if (const auto cause = run.cause(application); cause && application <= n)
      brought_about.emplace(*cause, application);
  std::map<std::string, std::vector<std::size_t>> made;  // result -> applications
  const auto last = std::upper_bound(all.begin(), all.end(), n);
  for (auto at = all.begin(); at != last; ++at)
    if (const auto record = run.record(*at)) made[text_of(*record, "result")].push_back(*at);

  while (!open.empty()) {
    const auto at = open.back();
    open.pop_back();
    if (!met.insert(at).second) continue;
    if (const auto cause = run.cause(at)) open.push_back(*cause);
    const auto [from, to] = brought_about.equal_range(at);
    for (auto found = from; found != to; ++found) open.push_back(found->second);
    auto record = run.record(at);
    if (!record) return record.error();
    if (auto problem = sources.add(at, *record)) return *problem;
    if (log::is<log::Input>(run.kind(at))) inputs[at] = *std::move(record);
    if (!log::is<log::Application>(run.kind(at))) continue;
    for (const char* part : {"function", "argument"})
      if (const auto found = made.find(text_of(*record, part)); found != made.end()) {
        const auto older = std::lower_bound(found->second.begin(), found->second.end(), at);
        if (older != found->second.begin()) open.push_back(*std::prev(older));
      }
    applications.emplace(at, *std::move(record));
  }
  for (const auto input : sources.inputs()) inputs.emplace(input, Json());
  Json told_applications = Json::array(), told_inputs = Json::array();
  for (auto& [number, record] : applications) told_applications.push_back(std::move(record));
  for (auto& [number, record] : inputs) {
    if (record.is_null()) {
      auto read = run.record(number);
      if (!read) return read.error();
      record = *std::move(read);
    }
    told_inputs.push_back(brief_json(run, number, record));
  }
  return Json{{"n", n},
              {"chain", std::move(chain)},
              {"applications", std::move(told_applications)},
              {"inputs", std::move(told_inputs)}};
}

}  // namespace continua
