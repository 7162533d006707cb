#include "continua/replay/export/chrome.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <utility>

#include "continua/replay/export/each_record.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

enum Lane { human = 1, states, transitions, avatar, acts };

constexpr int process = 1;

// The time for which something without length is shown, microseconds.
constexpr std::int64_t longest_shown_us = 1'000'000, transition_us = 40'000;

struct Slice {
  std::size_t n = 0;
  Lane lane = human;
  std::int64_t from_us = 0, until_us = 0;
  std::string name;
  Json args;
  bool within = false;  // a step of the act before it
};

// Slices of a lane nest or follow one another, as viewers want them: one ends where the next begins, and those that
// begin together lie one in the other.
void nest(std::vector<Slice*>& slices) {
  std::vector<Slice*> open;
  for (auto* slice : slices) {
    while (!open.empty() &&
           (open.back()->until_us <= slice->from_us || (!slice->within && open.back()->from_us < slice->from_us))) {
      open.back()->until_us = std::min(open.back()->until_us, slice->from_us);
      open.pop_back();
    }
    if (!open.empty()) slice->until_us = std::min(slice->until_us, open.back()->until_us);
    open.push_back(slice);
  }
}

class TraceEvents {
 public:
  TraceEvents(const RunIndex& run, std::ostream& out) : run_(run), out_(out) {}

  void begin() {
    out_ << "{\"traceEvents\":[";
    write({{"ph", "M"},
           {"name", "process_name"},
           {"pid", process},
           {"args", {{"name", std::filesystem::path(run_.path()).filename().string()}}}});
    for (const auto& [lane, name] :
         {std::pair(human, "human"), std::pair(states, "state"), std::pair(transitions, "transitions"),
          std::pair(avatar, "avatar"), std::pair(acts, "acts")}) {
      write({{"ph", "M"}, {"name", "thread_name"}, {"pid", process}, {"tid", int(lane)}, {"args", {{"name", name}}}});
      write({{"ph", "M"},
             {"name", "thread_sort_index"},
             {"pid", process},
             {"tid", int(lane)},
             {"args", {{"sort_index", int(lane)}}}});
    }
  }

  void add(const Json& record) {
    const auto kind = text_of(record, "kind");
    const auto& entry = run_.entry(static_cast<std::size_t>(integer_of(record, "n")));
    now_us_ = entry.t.us;
    if (log::is<log::Input>(kind) && !entry.sample)
      at_once(human, brief(record), record);
    else if (log::is<log::Utterance>(kind) || log::is<log::AvatarGesture>(kind))
      at_once(avatar, brief(record), record);
    else if (log::is<log::Transition>(kind))
      add_transition(record);
    else if (log::is<log::Act>(kind))
      add_act(record);
    if (const auto& depth = member_of(record, "depth"); depth.is_number_integer())
      write({{"ph", "C"}, {"name", "stack"}, {"ts", now_us_}, {"pid", process}, {"args", {{"symbols", depth}}}});
  }

  void end() {
    leave_state();
    while (!under_way_.empty()) finish(under_way_.begin()->first, Json::object());
    std::map<int, std::vector<Slice*>> lanes;
    for (auto& slice : slices_) lanes[slice.lane].push_back(&slice);
    for (auto& [lane, slices] : lanes) {
      std::stable_sort(slices.begin(), slices.end(),
                       [](const auto* a, const auto* b) { return a->from_us < b->from_us; });
      nest(slices);
      for (const auto* slice : slices) write_slice(*slice);
    }
    write_arrows();
    out_ << "\n]}\n";
  }

 private:
  using ActStep = std::pair<std::int64_t, std::int64_t>;  // step 0: the act as a whole

  static std::int64_t integer_of(const Json& record, const char* key) {
    const auto& value = member_of(record, key);
    return value.is_number_integer() ? value.get<std::int64_t>() : 0;
  }

  // The members that a viewer shows next to an event.
  static Json shown(const Json& record) {
    Json args = record;
    for (const char* known : {"kind", "t"}) args.erase(known);
    return args;
  }

  void write(const Json& event) {
    out_ << (first_ ? "\n" : ",\n") << event.dump(-1, ' ', false, Json::error_handler_t::replace);
    first_ = false;
  }

  void at_once(Lane lane, const std::string& name, const Json& record) {
    const auto shown_us = lane == transitions ? transition_us : longest_shown_us;
    slices_.push_back({number_of(record), lane, now_us_, now_us_ + shown_us, name, shown(record)});
  }

  static std::size_t number_of(const Json& record) { return static_cast<std::size_t>(integer_of(record, "n")); }

  void write_slice(const Slice& slice) {
    write({{"ph", "X"},
           {"name", slice.name},
           {"ts", slice.from_us},
           {"dur", slice.until_us - slice.from_us},
           {"pid", process},
           {"tid", int(slice.lane)},
           {"args", slice.args}});
  }

  // From the slice of the nearest cause that has one to its consequence.
  void write_arrows() {
    std::map<std::size_t, const Slice*> of_record;
    for (const auto& slice : slices_) of_record.emplace(slice.n, &slice);
    for (const auto& slice : slices_) {
      auto cause = run_.cause(slice.n);
      while (cause && !of_record.contains(*cause)) cause = run_.cause(*cause);
      if (!cause) continue;
      write_arrow("s", slice.n, *of_record.at(*cause));
      write_arrow("f", slice.n, slice);
    }
  }

  void write_arrow(const char* phase, std::size_t id, const Slice& at) {
    Json arrow{{"ph", phase},      {"cat", "cause"}, {"name", "cause"},    {"id", id},
               {"ts", at.from_us}, {"pid", process}, {"tid", int(at.lane)}};
    if (*phase == 'f') arrow["bp"] = "e";
    write(arrow);
  }

  void add_transition(const Json& record) {
    at_once(transitions, text_of(record, "id"), record);
    const auto to = text_of(record, "to");
    if (state_.empty()) state_ = text_of(record, "from");
    if (to == state_) return;
    leave_state();
    state_ = to;
  }

  void leave_state() {
    if (!state_.empty() && now_us_ > since_us_)
      write({{"ph", "X"},
             {"name", state_},
             {"ts", since_us_},
             {"dur", now_us_ - since_us_},
             {"pid", process},
             {"tid", int(states)}});
    since_us_ = now_us_;
  }

  void add_act(const Json& record) {
    const ActStep which{integer_of(record, "act"), integer_of(record, "step")};
    const auto status = text_of(record, "status");
    if (status == "asked") return;
    if (status == "started") {
      if (!under_way_.emplace(which, slices_.size()).second) return;
      slices_.push_back(
          {number_of(record), acts, now_us_, now_us_, text_of(record, "program"), shown(record), which.second > 0});
    } else {
      finish(which, shown(record));
    }
  }

  // The steps of an act end with it.
  void finish(const ActStep& which, const Json& args) {
    for (auto step = under_way_.upper_bound(which);
         which.second == 0 && step != under_way_.end() && step->first.first == which.first;) {
      slices_[step->second].until_us = now_us_;
      step = under_way_.erase(step);
    }
    const auto found = under_way_.find(which);
    if (found == under_way_.end()) return;
    slices_[found->second].until_us = now_us_;
    if (!args.empty()) slices_[found->second].args = args;
    under_way_.erase(found);
  }

  const RunIndex& run_;
  std::ostream& out_;
  bool first_ = true;
  std::int64_t now_us_ = 0, since_us_ = 0;
  std::string state_;
  std::vector<Slice> slices_;
  std::map<ActStep, std::size_t> under_way_;  // places in slices_
};

}  // namespace

Outcome export_chrome(const RunIndex& run, std::ostream& out) {
  TraceEvents events(run, out);
  events.begin();
  if (auto problem = each_record(run, [&](const Json& record) { events.add(record); })) return problem;
  events.end();
  if (!out) return Error{run.path(), "the export could not be written"};
  return std::nullopt;
}

}  // namespace continua
