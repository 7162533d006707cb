#include "continua/replay/coverage/coverage.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "continua/replay/coverage/coverage_phrases.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

using Key = std::tuple<std::string, std::string, std::string>;
Key key_of(const CoverageItem& item) { return {item.name, item.outcome, item.what}; }

// The elements of a list; none of any other value.
const Json& list(const Json& object, const char* key) {
  static const Json none = Json::array();
  const auto& found = member_of(object, key);
  return found.is_array() ? found : none;
}

using Counts = std::map<std::string, std::size_t>;

std::size_t count_of(const Counts& counts, const std::string& name) {
  const auto found = counts.find(name);
  return found == counts.end() ? 0 : found->second;
}

// Reads the records of a run and counts by names; then lists the parts of the header's graph, with the counts.
class Counting {
 public:
  explicit Counting(const Json& header)
      : header_(header), phrases_(member_of(header, "machine"), member_of(header, "phrases")) {}

  Outcome read(const RunIndex& run) {
    for (std::size_t n = 1; n < run.size(); ++n) {
      const auto count = counter_of(run.kind(n));
      if (!count) continue;
      const auto record = run.record(n);
      if (!record) return record.error();
      (this->*count)(run, n, *record);
    }
    return std::nullopt;
  }

  MachineCoverage result() const {
    const auto &machine = member_of(header_, "machine"), &lexicon = member_of(header_, "lexicon");
    MachineCoverage coverage{text_of(machine, "name"),
                             text_of(machine, "digest"),
                             text_of(lexicon, "name"),
                             text_of(lexicon, "digest"),
                             1,
                             {}};
    coverage.kinds = {states(), transitions(), conditions(), gates(), operations(), phrases_.reached()};
    const auto named = [](const char* kind, const Counts& counts) {
      CoverageKind used{kind, {}, true};
      for (const auto& [name, count] : counts) used.items.push_back({name, "", "", count});
      return used;
    };
    coverage.kinds.push_back(named(raising_rules, rules_));
    coverage.kinds.push_back(named(lexicon_rules, lexicon_rules_));
    coverage.kinds.push_back({lexicon_entries, {}, true});
    auto& entries = coverage.kinds.back().items;
    for (const auto& [key, count] : entries_) entries.push_back({std::get<0>(key), "", std::get<2>(key), count});
    return coverage;
  }

 private:
  using Count = void (Counting::*)(const RunIndex&, std::size_t, const Json&);

  static Count counter_of(const std::string& kind) {
    if (log::is<log::Transition>(kind)) return &Counting::transition;
    if (log::is<log::Refusal>(kind)) return &Counting::refusal;
    if (log::is<log::Branches>(kind)) return &Counting::branches;
    if (log::is<log::Application>(kind)) return &Counting::application;
    if (log::is<log::Reading>(kind)) return &Counting::reading;
    if (log::is<log::Utterance>(kind)) return &Counting::utterance;
    return nullptr;
  }

  void transition(const RunIndex&, std::size_t, const Json& record) {
    const auto id = text_of(record, "id");
    ++fired_[id];
    ++entered_[text_of(record, "to")];
    if (const auto& operation = member_of(record, "operation"); operation.is_object() && !operation.empty())
      ++operations_[operation.begin().key()];
    // With several inputs a transition may be a candidate with each: its condition held once.
    std::set<std::string> held = {id}, not_held;
    for (const auto& candidate : list(record, "candidates")) held.insert(text_of(candidate, "id"));
    for (const auto& one : held) ++held_[one];
    count_refused(record);
    for (const auto& gate : list(record, "gates"))
      ++(member_of(gate, "passed") == true ? passed_ : turned_away_)[text_of(gate, "state")];
  }

  void refusal(const RunIndex&, std::size_t, const Json& record) { count_refused(record); }

  void count_refused(const Json& record) {
    std::set<std::string> refused;
    for (const auto& one : list(record, "refused")) refused.insert(text_of(one, "id"));
    for (const auto& one : refused) ++not_held_[one];
  }

  // The first of them is the one whose records are in the log.
  void branches(const RunIndex&, std::size_t, const Json& record) {
    const auto& all = list(record, "branches");
    for (std::size_t i = 1; i < all.size(); ++i) {
      const auto& by = list(all[i], "by");
      if (!by.empty()) ++entered_[text_of(all[i], "state")];
      for (const auto& id : by)
        if (id.is_string()) ++fired_[id.get<std::string>()], ++held_[id.get<std::string>()];
    }
  }

  void application(const RunIndex&, std::size_t, const Json& record) {
    if (const auto rule = text_of(record, "rule"); !rule.empty()) ++rules_[rule];
  }

  // Of an n-best list there is a reading for each alternative: the one that was gone on with counts.
  void reading(const RunIndex&, std::size_t, const Json& record) {
    if (member_of(record, "taken") == false) return;
    const auto& rank = member_of(record, "rank");
    for (const auto& entry : list(record, "entries")) {
      const auto& parses = member_of(entry, "parses");  // those that it is in, where not all are meant
      if (parses.is_array() && std::find(parses.begin(), parses.end(), rank) == parses.end()) continue;
      ++entries_[key_of(lexicon_entry(text_of(entry, "words"), text_of(entry, "category"), text_of(entry, "term")))];
    }
    for (const auto& rule : list(record, "rules"))
      if (rule.is_string()) ++lexicon_rules_[rule.get<std::string>()];
  }

  // An utterance belongs to the transition that brought it about and to the state that this led to.
  void utterance(const RunIndex& run, std::size_t n, const Json& record) {
    const auto cause = run.cause(n);
    if (!cause || !log::is<log::Transition>(run.kind(*cause))) return;
    const auto transition = run.record(*cause);
    if (transition) phrases_.said(text_of(record, "text"), text_of(*transition, "id"), text_of(*transition, "to"));
  }

  CoverageKind states() const {
    const auto start = text_of(member_of(header_, "graph"), "start");
    CoverageKind kind{"states"};
    for (const auto& state : graph("states")) {
      const auto name = text_of(state, "id");
      kind.items.push_back({name, "", "", count_of(entered_, name) + (name == start ? 1 : 0)});
    }
    return kind;
  }

  // A transition from several states is several edges.
  CoverageKind transitions() const {
    CoverageKind kind{"transitions"};
    for_each_transition([&](const std::string& id, const Json&) {
      kind.items.push_back({id, "", "", count_of(fired_, id)});
    });
    return kind;
  }

  CoverageKind conditions() const {
    CoverageKind kind{"conditions"};
    for_each_transition([&](const std::string& id, const Json& edge) {
      const auto condition = text_of(edge, "condition");
      if (condition.empty()) return;
      kind.items.push_back({id, "held", condition, count_of(held_, id)});
      kind.items.push_back({id, "did not hold", condition, count_of(not_held_, id)});
    });
    return kind;
  }

  CoverageKind gates() const {
    CoverageKind kind{"gates"};
    for (const auto& state : graph("states")) {
      const auto& gate = member_of(state, "gate");
      if (!gate.is_object()) continue;
      const auto name = text_of(state, "id"), condition = text_of(gate, "condition");
      kind.items.push_back({name, "passed", condition, count_of(passed_, name)});
      kind.items.push_back({name, "turned away", condition, count_of(turned_away_, name)});
    }
    return kind;
  }

  CoverageKind operations() const {
    std::vector<std::string> names;
    const auto note = [&](const std::string& name) {
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const auto& edge : graph("edges")) note(text_of(edge, "operation"));
    for (const auto& state : graph("states")) note(text_of(member_of(state, "gate"), "operation"));
    CoverageKind kind{"operations"};
    for (const auto& name : names) kind.items.push_back({name, "", "", count_of(operations_, name)});
    return kind;
  }

  const Json& graph(const char* key) const { return list(member_of(header_, "graph"), key); }

  void for_each_transition(auto what) const {
    std::set<std::string> met;
    for (const auto& edge : graph("edges"))
      if (const auto id = text_of(edge, "id"); met.insert(id).second) what(id, edge);
  }

  const Json& header_;
  PhraseCounts phrases_;
  Counts entered_, fired_, held_, not_held_, passed_, turned_away_, operations_, rules_, lexicon_rules_;
  std::map<Key, std::size_t> entries_;
};

}  // namespace

std::size_t CoverageKind::reached() const {
  return static_cast<std::size_t>(
      std::count_if(items.begin(), items.end(), [](const CoverageItem& item) { return item.count > 0; }));
}

CoverageKind& MachineCoverage::kind(const std::string& wanted) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const CoverageKind& kind) { return kind.name == wanted; });
  if (found != kinds.end()) return *found;
  return kinds.emplace_back(CoverageKind{wanted});
}

std::size_t MachineCoverage::reached() const {
  std::size_t sum = 0;
  for (const auto& kind : kinds)
    if (!kind.of_knowledge) sum += kind.reached();
  return sum;
}

std::size_t MachineCoverage::reachable() const {
  std::size_t sum = 0;
  for (const auto& kind : kinds)
    if (!kind.of_knowledge) sum += kind.items.size();
  return sum;
}

CoverageItem lexicon_entry(const std::string& words, const std::string& category, const std::string& term) {
  return {words, "", category.empty() ? "passed over" : category + ", " + term, 0};
}

Result<MachineCoverage> coverage_of(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return header.error();
  if (list(member_of(*header, "graph"), "states").empty())
    return Error{run.where(0), "found a header without the machine's states; expected \"graph\""};
  Counting counting(*header);
  if (const auto problem = counting.read(run)) return *problem;
  return counting.result();
}

void add(MachineCoverage& sum, const MachineCoverage& more) {
  sum.runs += more.runs;
  for (const auto& kind : more.kinds) {
    auto& items = sum.kind(kind.name).items;
    std::map<Key, std::size_t> places;
    for (std::size_t i = 0; i < items.size(); ++i) places.emplace(key_of(items[i]), i);
    for (const auto& item : kind.items) {
      const auto [place, is_new] = places.emplace(key_of(item), items.size());
      if (is_new)
        items.push_back(item);
      else
        items[place->second].count += item.count;
    }
  }
}

std::vector<MachineCoverage> by_machine(const std::vector<MachineCoverage>& runs) {
  std::vector<MachineCoverage> machines;
  const auto names = [](const MachineCoverage& one) {
    return std::tie(one.name, one.digest, one.lexicon, one.lexicon_digest);
  };
  for (const auto& run : runs) {
    const auto found = std::find_if(machines.begin(), machines.end(),
                                    [&](const MachineCoverage& machine) { return names(machine) == names(run); });
    if (found == machines.end())
      machines.push_back(run);
    else
      add(*found, run);
  }
  return machines;
}

void add_reachable(CoverageKind& kind, const std::vector<CoverageItem>& all) {
  MachineCoverage sum, used;
  sum.kinds = {{kind.name, all, kind.of_knowledge}};
  for (auto& item : sum.kinds.front().items) item.count = 0;
  used.kinds = {std::move(kind)};
  add(sum, used);
  kind = std::move(sum.kinds.front());
}

}  // namespace continua
