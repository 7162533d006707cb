#include "continua/replay/export/chrome.h"

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
    write({{"ph", "i"},
           {"s", "t"},
           {"name", name},
           {"ts", now_us_},
           {"pid", process},
           {"tid", int(lane)},
           {"args", shown(record)}});
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
      if (!under_way_.emplace(which, text_of(record, "program")).second) return;
      span("b", which, under_way_[which], shown(record));
    } else {
      finish(which, shown(record));
    }
  }

  // The steps of an act end with it.
  void finish(const ActStep& which, const Json& args) {
    for (auto step = under_way_.upper_bound(which);
         which.second == 0 && step != under_way_.end() && step->first.first == which.first;) {
      span("e", step->first, step->second, Json::object());
      step = under_way_.erase(step);
    }
    const auto found = under_way_.find(which);
    if (found == under_way_.end()) return;
    span("e", which, found->second, args);
    under_way_.erase(found);
  }

  void span(const char* phase, const ActStep& which, const std::string& program, const Json& args) {
    write({{"ph", phase},
           {"cat", "act"},
           {"id", which.first},
           {"name", program},
           {"ts", now_us_},
           {"pid", process},
           {"tid", int(acts)},
           {"args", args}});
  }

  const RunIndex& run_;
  std::ostream& out_;
  bool first_ = true;
  std::int64_t now_us_ = 0, since_us_ = 0;
  std::string state_;
  std::map<ActStep, std::string> under_way_;
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
