#include "continua/replay/experiment/trace_search.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "continua/core/random.h"
#include "continua/knowledge_files/engine_parts.h"
#include "continua/moves/understanding.h"
#include "continua/perception/gesture.h"
#include "continua/replay/experiment/ddmin.h"
#include "continua/replay/experiment/robust.h"
#include "continua/replay/session/expectation.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

// Enough for an act of the kinematic world, and for what a question waits for.
constexpr double seconds_between_turns = 3;
// Inputs after which a state counts as dead if all are refused.
constexpr std::size_t probes = 12;

TraceEvent turn_of(InputEvent input) {
  TraceEvent event;
  event.what = std::move(input);
  return event;
}

void add_gestures(const GestureCatalogue& gestures, std::vector<TraceEvent>& turns) {
  for (const auto& [name, entry] : gestures.entries) {
    std::set<std::string> directions{""};
    for (const auto& [direction, meaning] : entry.meanings) directions.insert(direction);
    for (const auto& direction : directions) {
      InputEvent input;
      input.modality = Modality::gesture;
      input.name = name;
      input.direction = direction;
      input.phase = entry.acts_on.empty() ? "start" : entry.acts_on.front();
      turns.push_back(turn_of(input));
    }
  }
}

// The inputs that arcs name in full.
void add_arcs(const Machine& machine, std::vector<TraceEvent>& turns) {
  std::set<std::string> symbols;
  for (const auto& transition : machine.transitions)
    if (transition.on) symbols.insert(transition.on->names.begin(), transition.on->names.end());
  for (const auto& symbol : symbols)
    if (symbol.starts_with("speech ") || symbol.starts_with("gesture ")) turns.push_back(turn_of(event_of(symbol)));
}

class Search {
 public:
  Search(Session& kinematic, Session* physics, const SearchOptions& options, std::vector<TraceEvent> turns)
      : kinematic_(kinematic), physics_(physics), options_(options), turns_(std::move(turns)), random_(options.seed) {}

  SearchSummary run() {
    while (!options_.enough()) {
      auto talk = next_talk();
      const auto log = log_of(kinematic_, talk);
      ++summary_.runs;
      bool is_new = false;
      for (auto& one : reached_in(log)) is_new |= reached_.insert(std::move(one)).second;
      if (is_new) talks_.push_back(talk);
      for (const auto& fault : faults_of(log)) {
        keep(fault, talk);
        if (fault.kind == "refusals") look_if_dead(fault.place, talk);
      }
      if (is_new && physics_) compare_worlds(talk);
    }
    summary_.kept = talks_.size();
    summary_.reached = reached_.size();
    return std::move(summary_);
  }

 private:
  using Talk = std::vector<TraceEvent>;

  std::size_t draw(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }

  // A talk of any length.
  Talk new_talk() {
    Talk talk(1 + draw(static_cast<std::size_t>(options_.longest)));
    for (auto& turn : talk) turn = turns_[draw(turns_.size())];
    return talk;
  }

  // The turn is drawn before its place: within one call, compilers draw in orders of their own.
  void insert_anywhere(Talk& talk, const TraceEvent& turn) {
    talk.insert(talk.begin() + static_cast<std::ptrdiff_t>(draw(talk.size() + 1)), turn);
  }

  // Another talk, made of one that reached something new, rather lately than long ago, or of none.
  Talk next_talk() {
    if (!options_.guided) return new_talk();
    Talk talk;
    if (!talks_.empty() && random_.uniform() < 0.8)
      talk = talks_[std::max({draw(talks_.size()), draw(talks_.size()), draw(talks_.size())})];
    const auto changes = 1 + draw(3);
    for (std::size_t i = 0; i < changes; ++i) {
      const double which = random_.uniform();
      if (which < 0.2 && !talk.empty())
        talk.erase(talk.begin() + static_cast<std::ptrdiff_t>(draw(talk.size())));
      else if (which < 0.4 && !talk.empty())
        talk[draw(talk.size())] = turns_[draw(turns_.size())];
      else if (which < 0.6)
        insert_anywhere(talk, turns_[draw(turns_.size())]);
      else
        talk.push_back(turns_[draw(turns_.size())]);
    }
    if (talk.empty()) talk.push_back(turns_[draw(turns_.size())]);
    if (talk.size() > static_cast<std::size_t>(options_.longest))
      talk.resize(static_cast<std::size_t>(options_.longest));
    return talk;
  }

  Trace trace_of(const Talk& talk) const {
    Trace trace{{kinematic_.trace().head()}, talk};
    trace.notes.clear();
    for (std::size_t i = 0; i < talk.size(); ++i) {
      auto& event = trace.events[i];
      event.line = i + 2;
      event.t = SimTime::from_seconds(seconds_between_turns * static_cast<double>(i + 1));
      std::get<InputEvent>(event.what).t = event.t;
      event.json = json_of(event);
    }
    TraceEvent end;
    end.line = talk.size() + 2;
    end.t = SimTime::from_seconds(seconds_between_turns * static_cast<double>(talk.size() + 1));
    end.what = End{};
    end.json = json_of(end);
    trace.events.push_back(end);
    return trace;
  }

  std::string log_of(Session& session, const Talk& talk) const {
    std::ostringstream log;
    const auto run = session.run(trace_of(talk), {}, log);
    require(run.ok(), "the scene was set out before");
    return std::move(log).str();
  }

  // A new fault, with the least talk that still has it.
  void keep(const Fault& fault, const Talk& talk) {
    keep_if(fault, talk, [&](const Talk& less) {
      const auto faults = faults_of(log_of(kinematic_, less));
      return std::find(faults.begin(), faults.end(), fault) != faults.end();
    });
  }

  template <class Holds>
  void keep_if(const Fault& fault, const Talk& talk, const Holds& holds) {
    if (!known_.insert(fault).second) return;
    const auto least = ddmin(talk.size(), [&](const Indices& part) { return holds(part_of(talk, part)); });
    summary_.findings.push_back({fault, trace_of(part_of(talk, least))});
    if (options_.tell) options_.tell(summary_.findings.back());
  }

  // After inputs in a row that had no effect: whether no other has one.
  void look_if_dead(const std::string& state, const Talk& talk) {
    const Fault dead{"dead", state};
    if (known_.contains(dead)) return;
    Talk others;
    for (std::size_t i = 0; i < probes; ++i) others.push_back(turns_[draw(turns_.size())]);
    const auto is_dead = [&](const Talk& before) {
      auto more = before;
      more.insert(more.end(), others.begin(), others.end());
      return reached_count(before) == reached_count(more);
    };
    if (is_dead(talk)) keep_if(dead, talk, is_dead);
  }

  // The number of transitions of a run.
  std::size_t reached_count(const Talk& talk) const {
    const auto log = log_of(kinematic_, talk);
    std::size_t count = 0;
    for (auto at = log.find("\n{\"kind\":\"transition\""); at != std::string::npos;
         at = log.find("\n{\"kind\":\"transition\"", at + 1))
      ++count;
    return count;
  }

  void compare_worlds(const Talk& talk) {
    const auto other_act = [&](const Talk& some) -> std::string {
      const auto acts_in = [&](Session& session) {
        std::vector<std::string> acts;
        for (const auto& one : happenings_of(log_of(session, some)))
          if (one.kind == Happened::Kind::act) acts.push_back(one.text.substr(0, one.text.find('(')));
        return acts;
      };
      const auto here = acts_in(kinematic_), there = acts_in(*physics_);
      const auto [a, b] = std::mismatch(here.begin(), here.end(), there.begin(), there.end());
      return a != here.end() ? *a : b != there.end() ? *b : "";
    };
    const auto act = other_act(talk);
    if (!act.empty()) keep_if({"worlds", act}, talk, [&](const Talk& less) { return other_act(less) == act; });
  }

  Session& kinematic_;
  Session* physics_;
  const SearchOptions& options_;
  const std::vector<TraceEvent> turns_;
  Random random_;
  std::vector<Talk> talks_;
  std::set<std::string> reached_;
  std::set<Fault> known_;
  SearchSummary summary_;
};

}  // namespace

Result<std::vector<TraceEvent>> turns_for(Session& session) {
  std::vector<TraceEvent> turns;
  const auto& language = session.parts().language;
  std::set<std::string> said;
  if (language && language->lexicon) {
    const auto examples = load_examples(*language->lexicon);
    if (!examples) return examples.error();
    for (const auto& example : *examples) said.insert(example.say.begin(), example.say.end());
  }
  for (const auto& text : said) {
    InputEvent input;
    input.text = text;
    turns.push_back(turn_of(std::move(input)));
  }
  if (const auto* gestures = session.gestures()) add_gestures(*gestures, turns);
  add_arcs(session.machine(), turns);
  // The scene as the first input meets it.
  Trace hello{{session.trace().head()}, {turn_of(event_of("speech"))}};
  std::ostringstream log;
  const auto run = session.run(
      hello,
      [&](const Situation& situation) {
        for (const auto& object : situation.world.objects) {
          InputEvent input;
          input.modality = Modality::pointing;
          input.target_W = Vec3(object.p_WO.x(), object.p_WO.y(), 0);
          turns.push_back(turn_of(std::move(input)));
        }
        return true;
      },
      log);
  if (!run) return run.error();
  return turns;
}

Result<SearchSummary> search_traces(Session& kinematic, Session* physics, const SearchOptions& options) {
  auto turns = turns_for(kinematic);
  if (!turns) return turns.error();
  if (turns->empty())
    return Error{kinematic.machine().name, "has neither a lexicon nor inputs by name: nothing can be said to it"};
  return Search(kinematic, physics, options, *std::move(turns)).run();
}

}  // namespace continua
