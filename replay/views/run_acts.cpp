#include "replay/views/run_acts.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "replay/views/run_brief.h"

namespace continua {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// The arguments of a term "put(cup, on(plate))" as written; empty where it has none.
std::vector<std::string_view> arguments(std::string_view term) {
  std::vector<std::string_view> found;
  const auto open = term.find('(');
  if (open == std::string_view::npos) return found;
  int depth = 0;
  auto from = open + 1;
  for (auto i = open + 1; i < term.size(); ++i) {
    const char c = term[i];
    const bool ends = depth == 0 && (c == ',' || c == ')');
    if (ends) found.push_back(trimmed(term.substr(from, i - from)));
    if (ends) from = i + 1;
    if (ends && c == ')') break;
    if (c == '(' || c == '<' || c == '[') ++depth;
    if (c == ')' || c == '>' || c == ']') --depth;
  }
  return found;
}

class ActReader {
 public:
  explicit ActReader(const std::set<std::string>& bodies) : bodies_(bodies) {}

  void read(const ActMark& mark, SimTime t, const Json& record) {
    const auto program = text_of(record, "program"), status = text_of(record, "status");
    const auto [place, fresh] = places_.emplace(mark.act, acts_.size());
    if (fresh) {
      acts_.push_back({mark.n, mark.act, "", "", t, {}, false, "", {}, ""});
      named_.push_back(false);
      ended_.push_back(false);
    }
    RunAct& act = acts_[place->second];
    const bool of_step = mark.step > 0;
    const auto body = body_of(program);
    if (act.object.empty()) act.object = body;
    // Steps may also make room by moving other things.
    if (of_step && body == act.object && !named_[place->second])
      if (const auto measured = place_in(program)) act.place = measured;
    if (of_step) return;
    if (act.program.empty()) {
      act.beside = beside_of(program, act.object);
      act.place = place_in(program);
      named_[place->second] = act.place.has_value();
    }
    act.program = program;
    act.status = status;
    const bool begins = status == "asked" || status == "started";
    if (status == "started") act.from = t;
    if (!begins) act.until = t;
    if (!begins) act.done = status == "done";
    ended_[place->second] = !begins;
  }

  std::vector<RunAct> finish(SimTime end) {
    for (std::size_t i = 0; i < acts_.size(); ++i)
      if (!ended_[i]) acts_[i].until = end;
    for (auto& act : acts_) act.until = std::max(act.until, act.from);
    std::stable_sort(acts_.begin(), acts_.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
    return std::move(acts_);
  }

 private:
  std::string body_of(const std::string& program) const {
    for (const auto argument : arguments(program))
      if (const std::string name(argument); bodies_.count(name)) return name;
    return "";
  }
  std::string beside_of(const std::string& program, const std::string& object) const {
    for (const auto argument : arguments(program))
      for (const auto inner : arguments(argument))
        if (const std::string name(inner); bodies_.count(name) && name != object) return name;
    return "";
  }

  const std::set<std::string>& bodies_;
  std::map<std::int64_t, std::size_t> places_;  // act → place in acts_
  std::vector<RunAct> acts_;
  std::vector<bool> named_, ended_;  // of each: its own program names a place; it has come to its end
};

}  // namespace

Result<std::vector<RunAct>> read_acts(const RunIndex& run, const std::set<std::string>& bodies) {
  ActReader reader(bodies);
  for (const auto& mark : run.act_marks()) {
    const auto record = run.record(mark.n);
    if (!record) return record.error();
    reader.read(mark, run.entry(mark.n).t, *record);
  }
  return reader.finish(run.entry(run.size() - 1).t);
}

}  // namespace continua
