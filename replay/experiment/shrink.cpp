#include "continua/replay/experiment/shrink.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/experiment/ddmin.h"
#include "continua/replay/experiment/shrink_against.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

bool is_expectation(const TraceEvent& event) { return std::holds_alternative<Expectation>(event.what); }

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// A run's deeds, for people.
struct Account {
  std::string state;
  std::vector<std::string> said;

  void see(const Situation& situation) {
    state = situation.machine.states[situation.configuration.state].name;
    if (situation.said == latest_) return;
    for (const auto& text : situation.said)
      if (said.empty() || said.back() != text) said.push_back(text);
    latest_ = situation.said;
  }

  std::string sentence() const {
    constexpr std::size_t most = 4;
    const auto first = said.size() > most ? said.end() - most : said.begin();
    std::vector<std::string> last(first, said.end());
    for (auto& text : last) text = "\"" + text + "\"";
    return fmt::format(
        "it ends in the state {}{}", state,
        last.empty() ? std::string(" and says nothing")
                     : fmt::format(", having said{} {}", said.size() > most ? " last" : "", fmt::join(last, ", ")));
  }

 private:
  std::vector<std::string> latest_;
};

class Shrinker {
 public:
  Shrinker(Session& session, const Trace& whole, const ShrinkGoal& goal, const ShrinkProgress& progress,
           const std::string& against)
      : session_(session),
        whole_(whole),
        goal_(goal),
        progress_(progress),
        against_path_(against),
        header_(whole.header) {
    for (const auto& event : whole.events)
      if (is_expectation(event))
        expectations_.push_back(event);
      else
        events_.push_back(event);
  }

  Result<Shrunk> run() {
    if (const auto problem = check_goal()) return *problem;
    Shrunk shrunk;
    shrunk.events_before = events_.size();
    const auto whole = pin();
    if (!whole) return whole.error();
    shrunk.done = *whole;
    if (shrunk.done) {
      // Nothing that comes later made it so.
      if (found_at_) keep_if_still_holds([&](const TraceEvent& event) { return event.t <= *found_at_; });
      // Observed deeds are never inputs, and an unknown kind makes at most a problem.
      keep_if_still_holds([&](const TraceEvent& event) {
        return std::holds_alternative<InputEvent>(event.what) || std::holds_alternative<End>(event.what);
      });
      do take_events_away();
      while (make_events_smaller() || take_objects_away());
      shrunk.trace = result();
      shrunk.events = events_.size();
    } else {
      shrunk.instead = account_.sentence();
    }
    shrunk.probes = probes_;
    return shrunk;
  }

 private:
  Outcome check_goal() const {
    if (goal_.situation && goal_.situation->state) {
      std::vector<std::string> known;
      for (const auto& state : session_.machine().states) known.push_back(state.name);
      if (std::find(known.begin(), known.end(), *goal_.situation->state) == known.end())
        return Error{"--until",
                     fmt::format("the machine {} has no state {}{}", session_.machine().name,
                                 in_quotes(*goal_.situation->state), did_you_mean(*goal_.situation->state, known))};
    }
    if (!goal_.line) return std::nullopt;
    const auto on_line = [&](const TraceEvent& event) { return event.line == *goal_.line; };
    const auto& where_to_look = log::is<log::Expect>(goal_.kind) ? expectations_ : events_;
    if (std::any_of(where_to_look.begin(), where_to_look.end(), on_line)) return std::nullopt;
    return Error{"--until", fmt::format("{}:{} is no {} of the trace", whole_.name, *goal_.line,
                                        log::is<log::Expect>(goal_.kind) ? "expectation" : "event")};
  }

  // Replays the whole trace and notes the target in its run; false if it is not there.
  Result<bool> pin() {
    ++probes_;
    bool met = false;
    std::ostringstream log;
    const auto run = session_.run(
        whole_,
        [&](const Situation& situation) {
          account_.see(situation);
          if (goal_.situation && !met && meets(*goal_.situation, situation)) {
            met = true;
            found_at_ = situation.world.t;
          }
          return false;
        },
        log);
    if (!run) return run.error();
    if (goal_.situation) return met;
    if (goal_.kind == "changed") {
      auto against = ShrinkAgainst::load(against_path_, whole_.name, session_.options(), log.str());
      if (!against) return against.error();
      against_ = std::move(*against);
      const auto cause = against_->cause(whole_, log.str());
      if (cause) pinned_ = *cause;
      return cause.has_value();
    }
    for (const auto& finding : findings(log.view(), goal_.kind)) {
      if (goal_.line && finding.line != goal_.line) continue;
      pinned_ = finding.what;
      found_at_ = finding.t;
      if (!log::is<log::Expect>(goal_.kind)) return true;
      std::erase_if(expectations_, [&](const TraceEvent& event) {
        if (event.line != finding.line) return false;
        unmet_ = event;
        return true;
      });
      return true;
    }
    return false;
  }

  // Whether a run still does it.
  bool holds(const TraceHeader& header, const std::vector<TraceEvent>& events) {
    ++probes_;
    if (progress_) progress_(events_.size(), probes_);
    bool met = false;
    Watch watch;
    if (goal_.situation) watch = [&](const Situation& situation) { return met = meets(*goal_.situation, situation); };
    std::ostringstream log;
    const auto trace = trace_of(header, events);
    const auto run = session_.run(trace, watch, log);
    if (!run || goal_.situation) return run && met;
    if (against_) return against_->cause(trace, log.str()) == pinned_;
    const auto found = findings(log.view(), goal_.kind);
    return std::any_of(found.begin(), found.end(), [&](const Finding& one) { return one.what == pinned_; });
  }

  // A trace of these events, in order, with the expectation that is to stay unmet.
  Trace trace_of(const TraceHeader& header, std::vector<TraceEvent> events) const {
    if (unmet_) insert(events, *unmet_);
    Trace trace{{whole_}, {}};
    trace.header = header;
    std::erase_if(trace.notes, [&](const Note& note) {
      return std::none_of(events.begin(), events.end(),
                          [&](const TraceEvent& event) { return event.line == note.line; });
    });
    trace.events = std::move(events);
    return trace;
  }

  // Where it stood in the trace.
  static void insert(std::vector<TraceEvent>& events, const TraceEvent& event) {
    const auto after =
        std::find_if(events.begin(), events.end(), [&](const TraceEvent& other) { return other.line > event.line; });
    events.insert(after, event);
  }

  template <class Keep>
  void keep_if_still_holds(Keep keep) {
    auto kept = events_;
    std::erase_if(kept, [&](const TraceEvent& event) { return !keep(event); });
    if (kept.size() < events_.size() && holds(header_, kept)) events_ = std::move(kept);
  }

  void take_events_away() {
    const auto all = events_;
    events_ = part_of(all, ddmin(all.size(), [&](const Indices& part) { return holds(header_, part_of(all, part)); }));
  }

  // Whether anything could go.
  bool make_events_smaller() {
    bool smaller = false;
    for (std::size_t i = 0; i < events_.size(); ++i) {
      if (!std::holds_alternative<InputEvent>(events_[i].what)) continue;
      const auto alternatives = std::get<InputEvent>(events_[i].what).alternatives;
      smaller |= reduce(i, alternatives.size(), [&](InputEvent& event, const Indices& part) {
        event.alternatives = part_of(alternatives, part);
        return true;
      });
      const auto words = words_of(std::get<InputEvent>(events_[i].what).text);
      const auto times = std::get<InputEvent>(events_[i].what).words;
      smaller |= reduce(i, words.size(), [&](InputEvent& event, const Indices& part) {
        event.text = fmt::to_string(fmt::join(part_of(words, part), " "));
        if (times.size() == words.size()) event.words = part_of(times, part);
        return !part.empty();
      });
    }
    return smaller;
  }

  // The least of `count` things that an event must have; `keep` leaves it only some of them, or says that it cannot.
  template <class Keep>
  bool reduce(std::size_t index, std::size_t count, Keep keep) {
    if (count == 0) return false;
    const auto with = [&](const Indices& part) -> std::optional<std::vector<TraceEvent>> {
      auto events = events_;
      auto& event = events[index];
      if (!keep(std::get<InputEvent>(event.what), part)) return std::nullopt;
      event.json = json_of(event);
      return events;
    };
    const auto least = ddmin(count, [&](const Indices& part) {
      const auto events = with(part);
      return events && holds(header_, *events);
    });
    if (least.size() == count) return false;
    events_ = *with(least);
    return true;
  }

  bool take_objects_away() {
    const auto all = header_.objects;
    const auto with = [&](const Indices& part) {
      auto header = header_;
      header.objects = part_of(all, part);
      header.json.erase("objects");
      return header;
    };
    const auto least = ddmin(all.size(), [&](const Indices& part) { return holds(with(part), events_); });
    if (least.size() == all.size()) return false;
    header_ = with(least);
    return true;
  }

  // With the expectations that are met among them.
  Trace result() {
    auto trace = trace_of(header_, events_);
    for (const auto& expectation : expectations_) insert(trace.events, expectation);
    std::ostringstream log;
    const auto run = session_.run(trace, {}, log);
    require(run.ok(), "what is left can be replayed");
    const auto unmet = findings(log.view(), "expect");
    std::erase_if(trace.events, [&](const TraceEvent& event) {
      return is_expectation(event) && !(unmet_ && event.line == unmet_->line) &&
             std::any_of(unmet.begin(), unmet.end(), [&](const Finding& one) { return one.line == event.line; });
    });
    return trace;
  }

  Session& session_;
  const Trace& whole_;
  const ShrinkGoal& goal_;
  const ShrinkProgress& progress_;
  const std::string& against_path_;
  std::optional<ShrinkAgainst> against_;  // null without a run to differ from
  TraceHeader header_;
  std::vector<TraceEvent> events_;        // that are left; no expectations
  std::vector<TraceEvent> expectations_;  // but the one that is to stay unmet
  std::optional<TraceEvent> unmet_;
  Json pinned_;                      // Finding::what of the target record, or the cause of the difference
  std::optional<SimTime> found_at_;  // in the run of the whole trace
  Account account_;
  std::size_t probes_ = 0;
};

}  // namespace

Result<Shrunk> shrink(Session& session, const ShrinkGoal& goal, const ShrinkProgress& progress,
                      const std::string& against) {
  auto events = session.trace().events();
  if (!events) return events.error();
  const Trace whole{{session.trace().head()}, *std::move(events)};
  return Shrinker(session, whole, goal, progress, against).run();
}

}  // namespace continua
