#include "continua/replay/log/run_listing.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/log/act_outcome.h"
#include "continua/replay/log/expectation_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_text.h"

namespace continua {
namespace {

std::string name_of(const Json& header, const char* part) {
  const auto& value = member_of(header, part);
  return value.is_string() ? value.get<std::string>() : text_of(value, "name");
}

// The first record of a kind whose line is so.
template <class Holds>
std::optional<std::size_t> first_line(const RunIndex& run, std::string_view kind, Holds holds) {
  std::optional<std::size_t> found;
  run.read_lines([&](std::size_t n) { return run.kind(n) == kind; },
                 [&](std::size_t n, std::string_view line) {
                   if (holds(line)) found = n;
                   return !found;
                 });
  return found;
}

std::optional<std::size_t> first_of(const RunIndex& run, std::string_view kind) {
  return first_line(run, kind, [](std::string_view) { return true; });
}

bool is_unmet(std::string_view expect) { return member_in(expect, "met") == "false"; }
bool is_failure(std::string_view act) {
  return !member_in(act, "status").empty() && member_in(act, "step").empty() &&
         log::has_failed(text_in(member_in(act, "status")));
}
bool is_question(std::string_view utterance) { return text_in(member_in(utterance, "text")).ends_with('?'); }

// How many expectations were not met; of the first its record, and the difference in words.
struct Unmet {
  std::size_t count = 0;
  Json first;
};

Unmet unmet_of(const RunIndex& run) {
  Unmet unmet;
  std::optional<std::size_t> first;
  run.read_lines([&](std::size_t n) { return log::is<log::Expect>(run.kind(n)); },
                 [&](std::size_t n, std::string_view line) {
                   if (is_unmet(line) && unmet.count++ == 0) first = n;
                   return true;
                 });
  if (const auto record = first ? run.record(*first) : Result<Json>(Json()); first && record)
    unmet.first = {{"n", *first}, {"text", differences_text(RunWords(run), *record)}};
  return unmet;
}

// How the acts ended; of the first that failed its record and the reason.
struct ActTotals {
  std::size_t done = 0, failed = 0;
  Json first_failed;
};

ActTotals act_totals(const RunIndex& run) {
  ActTotals totals;
  run.read_lines([&](std::size_t n) { return log::is<log::Act>(run.kind(n)); },
                 [&](std::size_t n, std::string_view act) {
                   if (!member_in(act, "step").empty()) return true;
                   if (text_in(member_in(act, "status")) == "done") ++totals.done;
                   if (is_failure(act) && totals.failed++ == 0)
                     totals.first_failed = {{"n", n},
                                            {"status", text_in(member_in(act, "status"))},
                                            {"reason", RunWords(run).reason_of_act(act)}};
                   return true;
                 });
  return totals;
}

std::size_t count_refused_samples(const RunIndex& run) {
  std::size_t count = 0;
  for (std::size_t n = 0; n < run.size(); ++n)
    if (const auto cause = run.cause(n); cause && run.entry(*cause).sample && log::is<log::Refusal>(run.kind(n)))
      ++count;
  return count;
}

}  // namespace

std::size_t record_of_interest(const RunIndex& run) {
  if (const auto n = first_line(run, log::Expect::kind.name, is_unmet)) return *n;
  if (const auto n = first_line(run, log::Act::kind.name, is_failure)) return *n;
  if (const auto n = first_of(run, log::Problem::kind.name)) return *n;
  if (const auto n = first_line(run, log::Utterance::kind.name, is_question)) return *n;
  const auto& acts = run.act_marks();
  const auto asked = std::find_if(acts.rbegin(), acts.rend(), [](const ActMark& act) { return act.asked; });
  if (asked != acts.rend()) return asked->n;
  for (const auto kind :
       {log::Utterance::kind.name, log::Act::kind.name, log::Refusal::kind.name, log::Transition::kind.name})
    if (const auto n = first_of(run, kind)) return *n;
  return std::min<std::size_t>(1, run.size() - 1);
}

Result<Json> run_listing(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return header.error();
  std::vector<std::size_t> of_kind(run.kinds().size(), 0);
  for (std::size_t n = 0; n < run.size(); ++n) ++of_kind[run.entry(n).kind];
  Json counts = Json::object();
  for (std::size_t kind = 0; kind < of_kind.size(); ++kind) counts[run.kinds()[kind]] = of_kind[kind];
  const auto count = [&](std::string_view kind) { return counts.value(std::string(kind), std::size_t{0}); };
  std::set<std::int64_t> acts;  // an act has a record for each of its states
  for (const auto& act : run.act_marks()) acts.insert(act.act);
  const auto totals = act_totals(run);
  const auto unmet = unmet_of(run);
  const auto first = record_of_interest(run);
  const auto& scene = member_of(*header, "scene");
  const bool drawable = member_of(scene, "mjcf").is_string() && member_of(scene, "bodies").is_object();
  return Json{{"trace", name_of(*header, "trace")},
              {"duration", run.entry(run.size() - 1).t.seconds()},
              {"records", run.size()},
              {"utterances", count(log::Utterance::kind.name)},
              {"acts", acts.size()},
              {"acts_done", totals.done},
              {"acts_failed", totals.failed},
              {"first_failed", totals.first_failed},
              {"refusals", count(log::Refusal::kind.name)},
              {"refused_samples", count_refused_samples(run)},
              {"problems", count(log::Problem::kind.name)},
              {"expected", count(log::Expect::kind.name)},
              {"met", count(log::Expect::kind.name) - unmet.count},
              {"first_unmet", unmet.first},
              {"counts", counts},
              {"machine", name_of(*header, "machine")},
              {"scene", name_of(*header, "scene")},
              {"bytes", run.bytes()},
              {"complete", run.complete()},
              {"trouble", run.trouble()},
              {"first", first},
              {"first_t", run.entry(first).t.seconds()},
              {"drawable", drawable}};
}

Result<Json> run_summary(const RunIndex& run) {
  auto header = run.record(0);
  if (!header) return header.error();
  auto summary = run_listing(run);
  if (!summary) return summary.error();
  // The texts that the page does not need at once: the scene's XML, the machine's file, and the graph, which has
  // its own address.
  for (const auto& [part, key] : {std::pair{"scene", "mjcf"}, {"machine", "document"}})
    if (header->contains(part) && (*header)[part].is_object()) (*header)[part].erase(key);
  header->erase("graph");
  (*summary)["titles"] = RunWords(run).things();
  (*summary)["header"] = *std::move(header);
  return summary;
}

}  // namespace continua
