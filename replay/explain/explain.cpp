#include "continua/replay/explain/explain.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include <fmt/format.h>

#include "continua/replay/explain/explain_cells.h"
#include "continua/replay/explain/explain_derivation.h"
#include "continua/replay/explain/explain_headline.h"
#include "continua/replay/explain/explain_scope.h"
#include "continua/replay/explain/explain_stack.h"
#include "continua/replay/explain/explain_steps.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_listing.h"

namespace continua {
namespace {

// A number that a record of a line has, without making a tree of it.
std::optional<std::int64_t> number_of(const RunIndex& run, std::size_t n, std::string_view key) {
  std::optional<std::int64_t> number;
  if (const auto line = run.line(n))
    scan_members(*line, [&](std::string_view name, std::string_view value) {
      if (name.size() == key.size() && name == key) number = number_in<std::int64_t>(value);
    });
  return number;
}

// The numbers there are, for those who ask for another.
struct Numbers {
  std::optional<std::int64_t> least, most;

  void add(std::int64_t number) {
    least = std::min(least.value_or(number), number);
    most = std::max(most.value_or(number), number);
  }
  Error missing(const RunIndex& run, const std::string& noun, std::int64_t wanted) const {
    if (!least) return {run.path(), fmt::format("found no {}s; expected {} {}", noun, noun, wanted)};
    return {run.path(), fmt::format("there is no {} {}; the log has {}", noun, wanted,
                                    least == most ? fmt::format("{} {} alone", noun, *most)
                                                  : fmt::format("{}s {} to {}", noun, *least, *most))};
  }
};

Result<std::size_t> transition_of_step(const RunIndex& run, std::int64_t wanted) {
  Numbers numbers;
  const auto all = run.of_kind(log::Transition::kind.name);
  // Where nothing is missing it is the one at its place.
  if (wanted >= 1 && static_cast<std::size_t>(wanted) <= all.size())
    if (const auto n = all[static_cast<std::size_t>(wanted) - 1]; number_of(run, n, "step") == wanted) return n;
  for (const auto n : all) {
    const auto number = number_of(run, n, "step");
    if (number == wanted) return n;
    if (number) numbers.add(*number);
  }
  return numbers.missing(run, "step", wanted);
}

Result<std::size_t> first_of_act(const RunIndex& run, std::int64_t wanted) {
  Numbers numbers;
  for (const auto& mark : run.act_marks()) {
    if (mark.act == wanted) return static_cast<std::size_t>(mark.n);
    numbers.add(mark.act);
  }
  return numbers.missing(run, "act", wanted);
}

// The consequences of a cause that a reader asks for.
constexpr std::array deeds = {log::Act::kind.name, log::Utterance::kind.name, log::AvatarGesture::kind.name,
                              log::Refusal::kind.name};

std::size_t rank(const RunIndex& run, std::size_t n) {
  return static_cast<std::size_t>(std::find(deeds.begin(), deeds.end(), run.kind(n)) - deeds.begin());
}

bool is_deed(const RunIndex& run, std::size_t n) {
  const auto place = rank(run, n);
  if (place == deeds.size()) return false;
  const auto cause = run.cause(n);
  if (log::is<log::Act>(run.kind(n)))
    return !cause || !log::is<log::Act>(run.kind(*cause));  // asked for, and not how it goes on
  return !log::is<log::Refusal>(run.kind(n)) || !cause || !run.entry(*cause).sample;
}

Result<std::size_t> last_deed(const RunIndex& run, double until_s) {
  std::optional<std::size_t> last, first;
  for (std::size_t n = 0; n < run.size(); ++n) {
    if (!is_deed(run, n)) continue;
    if (!first) first = n;
    if (run.entry(n).t.seconds() > until_s) continue;
    const bool together = last && run.cause(n) == run.cause(*last) && run.entry(n).t == run.entry(*last).t;
    if (!together || rank(run, n) < rank(run, *last)) last = n;
  }
  if (last) return *last;
  if (!first) return Error{run.path(), "the avatar did and refused nothing in this log"};
  return Error{run.path(), fmt::format("the avatar did and refused nothing until {}; the first is at {}",
                                       time_text(until_s), time_text(run.entry(*first).t.seconds()))};
}

// The record that an expectation was last held against: the deed that it speaks of, else the decision before it.
std::size_t held_against(const RunIndex& run, std::size_t expect) {
  const auto record = run.record(expect);
  const auto expected = record ? member_of(*record, "expected") : Json();
  const auto found = record ? member_of(*record, "found") : Json();
  const auto differs = [&](const char* key) {
    return expected.is_object() && expected.contains(key) && member_of(expected, key) != member_of(found, key);
  };
  const std::string_view wanted = differs("says") ? "utterance" : differs("act") ? "act" : "transition";
  std::size_t decision = expect;
  for (auto n = expect; n-- > 0;) {
    if (run.kind(n) == wanted && (wanted != "act" || is_deed(run, n))) return n;
    if (decision == expect && (log::is<log::Transition>(run.kind(n)) || is_deed(run, n))) decision = n;
  }
  return decision;
}

// The decisions behind the record of which the log's end says that next to nothing could have changed them.
Json fragile_among(const RunIndex& run, ExplainScope& scope) {
  Json fragile = Json::array();
  if (!run.complete()) return fragile;
  const auto& all = member_of(scope.record(run.size() - 1), "fragile");
  if (!all.is_array()) return fragile;
  std::set<std::size_t> behind(scope.chain().begin(), scope.chain().end());
  for (const auto input : scope.inputs())
    for (const auto reading : scope.of_turn(input, log::Reading::kind.name)) behind.insert(reading);
  for (const auto& one : all)
    if (const auto& n = member_of(one, "n"); n.is_number_unsigned() && behind.count(n.get<std::size_t>()) != 0)
      fragile.push_back(one);
  return fragile;
}

Json brief_json(ExplainScope& scope, std::size_t n) {
  return {{"n", n},
          {"t", scope.run().entry(n).t.seconds()},
          {"kind", scope.run().kind(n)},
          {"brief", brief(scope.record(n))},
          {"told", brief_in_words(scope.words(), scope.record(n))}};
}

// The headline; that of an expectation goes on with the one of the record it was held against.
std::string sentence_about(ExplainScope& own, ExplainScope& about, const Json& act) {
  auto text = headline(own, act);
  return own.n() != about.n() && log::is<log::Expect>(own.run().kind(own.n())) ? text + " " + headline(about, act)
                                                                               : text;
}

}  // namespace

Result<std::size_t> asked_record(const RunIndex& run, const ExplainQuestion& question) {
  if (question.step) return transition_of_step(run, *question.step);
  if (question.act) return first_of_act(run, *question.act);
  if (question.at_s) return last_deed(run, *question.at_s);
  if (!question.record) return record_of_interest(run);
  if (*question.record < run.size()) return *question.record;
  return Error{run.path(),
               fmt::format("there is no record {}; the log has records 0 to {}", *question.record, run.size() - 1)};
}

Result<Json> explain(const RunIndex& run, std::size_t n) {
  const auto record = run.record(n);
  if (!record) return record.error();
  auto about = n;
  if (log::is<log::Expect>(run.kind(n))) about = held_against(run, n);
  if (log::is<log::Act>(run.kind(n)))
    if (const auto cause = run.cause(n); cause && log::is<log::Act>(run.kind(*cause))) about = *cause;
  ExplainScope scope(run, about);
  ExplainScope own(run, n);
  auto act = explained_act(scope, about);
  Json told{{"run", run.path()},
            {"n", n},
            {"t", run.entry(n).t.seconds()},
            {"kind", run.kind(n)},
            {"brief", brief(*record)},
            {"headline", sentence_about(own, scope, act)},
            {"about", about}};
  auto& chain = told["chain"] = Json::array();
  for (const auto at : own.chain()) chain.push_back(brief_json(own, at));
  told["inputs"] = explained_inputs(scope);
  const auto graph = header_member(run, "graph");
  told["steps"] = explained_steps(scope, graph);
  told["choice"] = header_member(run, "choice");
  told["refused"] = log::is<log::Refusal>(run.kind(about)) ? explained_refusals(scope.record(about), graph) : Json();
  auto stack = explained_stack(scope);
  if (!stack) return stack.error();
  told["stack"] = *std::move(stack);
  told["cells"] = explained_cells(own);
  told["derivation"] = derivation_of(scope);
  told["act"] = std::move(act);
  told["brought_about"] = brought_about(scope, about);
  const auto cause = run.cause(about);
  told["along"] = cause ? brought_about(scope, *cause) : Json::array();
  std::erase_if(told["along"].get_ref<Json::array_t&>(), [&](const Json& one) { return one["n"] == about; });
  told["fragile"] = fragile_among(run, scope);
  told["trouble"] = run.trouble();
  for (auto* each : {&own, &scope}) each->tell_raw();
  told["raw"] = sentence_about(own, scope, explained_act(scope, about));
  return told;
}

Result<Json> explain_cell(const RunIndex& run, std::size_t n, const std::string& cell) {
  const auto value = cell_value(run, cell);
  if (value.empty()) return Error{run.path(), fmt::format("found no cell '{}'; expected SYMBOL.SLOT", cell)};
  ExplainScope scope(run, n);
  return Json{{"n", n}, {"cell", cell}, {"value", value}, {"derivation", derivation_of(scope, value)}};
}

}  // namespace continua
