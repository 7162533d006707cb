#include "continua/replay/scene/run_acts.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "continua/replay/log/run_brief.h"
#include "continua/term/written_term.h"

namespace continua {
namespace {

class ActReader {
 public:
  explicit ActReader(const std::set<std::string>& bodies) : bodies_(bodies) {}

  void read(const ActMark& mark, SimTime t, const Json& record) {
    const auto program = text_of(record, "program"), status = text_of(record, "status");
    const auto read = read_written_term(program);
    const auto term = read ? *read : WrittenTerm();
    const auto [place, fresh] = places_.emplace(mark.act, acts_.size());
    if (fresh) {
      acts_.push_back({mark.n, mark.act, "", "", t, {}, false, "", {}, ""});
      named_.push_back(false);
      ended_.push_back(false);
    }
    RunAct& act = acts_[place->second];
    const bool of_step = mark.step > 0;
    const auto body = body_among(term.parts);
    if (act.object.empty()) act.object = body;
    // Steps may also make room by moving other things.
    if (of_step && body == act.object && !named_[place->second])
      if (const auto* measured = last_place(term)) act.place = measured->min;
    if (of_step) return;
    if (act.program.empty()) {
      act.beside = beside_of(term, act.object);
      if (const auto* named = last_place(term)) act.place = named->min;
      named_[place->second] = last_place(term) != nullptr;
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
  // The first of the terms that names a body other than `but`; empty if none does.
  std::string body_among(const std::vector<WrittenTerm>& terms, const std::string& but = {}) const {
    for (const auto& term : terms)
      if (term.kind == WrittenTerm::Kind::name && term.name != but && bodies_.count(term.name)) return term.name;
    return "";
  }
  // `plate` of put(cup, on(plate)).
  std::string beside_of(const WrittenTerm& program, const std::string& object) const {
    for (const auto& argument : program.parts)
      if (auto body = body_among(argument.parts, object); !body.empty()) return body;
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
