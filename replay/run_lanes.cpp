#include "replay/run_lanes.h"

#include <map>
#include <set>

#include "replay/run_brief.h"

namespace continua {
namespace {

constexpr double pointing_gap_s = 0.5;  // samples come at 20 to 30 a second; a longer pause ends the burst

Json list() { return Json::array(); }

double number_of(const Json& object, const char* key, double otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

// Fills the lanes record by record, in order.
class LaneBuilder {
 public:
  explicit LaneBuilder(const RunIndex& run) : run_(run), pointing_(run.size(), false) {}

  // REQUIRES every record before n added.
  Outcome add(std::size_t n) {
    const auto& kind = run_.kind(n);
    const auto& entry = run_.entry(n);
    t_.push_back(entry.t.seconds());
    kind_.push_back(entry.kind);
    cause_.push_back(entry.cause);
    // What a pointing sample brings about is marked with it, however long the chain.
    if (entry.cause >= 0) pointing_[n] = pointing_[static_cast<std::size_t>(entry.cause)];
    if (kind == "pose") {
      label_.push_back("");
      return std::nullopt;
    }
    const auto record = run_.record(n);
    if (!record) return record.error();
    if (kind == "input")
      add_input(n, *record);
    else if (kind == "transition" || kind == "rewrite")
      add_step(n, kind, *record);
    else if (kind == "utterance" || kind == "gesture")
      lanes_[kind == "gesture" ? "move" : kind].push_back(
          {seconds(n), n, text_of(*record, kind == "gesture" ? "gesture" : "text")});
    else if (kind == "act")
      add_act(n, *record);
    else if (kind == "observed")
      lanes_["observed"].push_back({seconds(n), n, text_of(*record, "content")});
    else if (kind == "rest")
      lanes_["rest"].push_back({number_of(*record, "from", seconds(n)), number_of(*record, "to", seconds(n)), n});
    else if ((kind == "refusal" && !pointing_[n]) || kind == "problem" ||
             (kind == "expect" && record->value("met", Json()) == false))
      lanes_["flags"].push_back({seconds(n), n, kind});
    label_.push_back(pointing_[n] && kind == "input" ? "" : brief(*record));
    if (worth_stopping_at(n, kind)) interest_.push_back(n);
    return std::nullopt;
  }

  Json finish() {
    for (const auto& [name, open] : open_gestures_) lanes_["gesture"][open][1] = seconds(run_.size() - 1);
    for (const auto& [act, open] : open_acts_) lanes_["act"][open][1] = seconds(run_.size() - 1);
    Json lanes{{"kinds", run_.kinds()},
               {"t", std::move(t_)},
               {"kind", std::move(kind_)},
               {"cause", std::move(cause_)},
               {"label", std::move(label_)},
               {"interest", std::move(interest_)},
               {"transitions", std::move(steps_)},
               {"depth", std::move(depth_)}};
    for (auto& [name, lane] : lanes_.items()) lanes[name] = std::move(lane);
    return lanes;
  }

 private:
  double seconds(std::size_t n) const { return run_.entry(n).t.seconds(); }

  void add_input(std::size_t n, const Json& record) {
    const auto event = record.value("event", Json::object());
    const auto kind = text_of(event, "kind");
    const auto t = seconds(n);
    if (kind == "pointing") {
      pointing_[n] = true;
      auto& bursts = lanes_["pointing"];
      if (!bursts.empty() && t - bursts.back()[1].get<double>() < pointing_gap_s) {
        bursts.back()[1] = t;
        bursts.back()[3] = bursts.back()[3].get<int>() + 1;
      } else {
        bursts.push_back({t, t, n, 1});
      }
    } else if (kind == "speech") {
      lanes_["speech"].push_back({t, number_of(event, "until", t), n, text_of(event, "text")});
    } else if (kind == "gesture") {
      add_gesture(n, event);
    }
  }

  // A gesture lasts from its start to the stop of the same name and hand.
  void add_gesture(std::size_t n, const Json& event) {
    const auto t = seconds(n);
    const auto name = text_of(event, "hand") + " " + text_of(event, "name");
    const auto phase = text_of(event, "phase");
    auto& lane = lanes_["gesture"];
    const auto open = open_gestures_.find(name);
    if (open != open_gestures_.end()) {
      lane[open->second][1] = t;
      open_gestures_.erase(open);
    }
    if (phase == "stop") return;
    auto label = text_of(event, "name");
    if (const auto direction = text_of(event, "direction"); !direction.empty()) label += " " + direction;
    if (phase == "start") open_gestures_[name] = lane.size();
    lane.push_back({t, number_of(event, "until", t), n, label});
  }

  void add_step(std::size_t n, const std::string& kind, const Json& record) {
    const auto stack =
        record.contains("stack") && record["stack"].is_number_integer() ? record["stack"].get<std::int64_t>() : -1;
    changed_stack_ = stack != stack_;
    stack_ = stack;
    const auto depth = static_cast<int>(number_of(record, "depth", static_cast<double>(run_.stack_ids(stack).size())));
    if (depth_.empty() || depth_.back()[2] != depth) depth_.push_back({seconds(n), n, depth});
    if (kind != "transition") return;
    steps_["n"].push_back(n);
    for (const char* part : {"id", "from", "to", "input"}) steps_[part].push_back(text_of(record, part));
    steps_["depth"].push_back(depth);
  }

  // Steps are within their act's time.
  void add_act(std::size_t n, const Json& record) {
    if (record.contains("step")) return;
    const auto act = text_of(record, "act"), status = text_of(record, "status");
    auto& lane = lanes_["act"];
    const auto known = known_acts_.find(act);
    if (known == known_acts_.end()) {
      known_acts_[act] = lane.size();
      lane.push_back({seconds(n), seconds(n), n, text_of(record, "program"), status});
    } else {
      lane[known->second][1] = seconds(n);
      lane[known->second][4] = status;
    }
    if (status == "asked" || status == "started")
      open_acts_[act] = known_acts_[act];
    else
      open_acts_.erase(act);
  }

  // Neither the stream of samples nor its refusals nor what it moves without changing the stack.
  bool worth_stopping_at(std::size_t n, const std::string& kind) const {
    static const std::set<std::string> never{"run", "symbol", "rest", "end", "memory", "belief", "observed"};
    if (never.count(kind)) return false;
    if (!pointing_[n]) return true;
    if (kind == "input" || kind == "refusal") return false;
    return (kind != "transition" && kind != "rewrite") || changed_stack_;
  }

  const RunIndex& run_;
  std::vector<bool> pointing_;  // the record is a pointing sample or was brought about by one
  Json t_ = list(), kind_ = list(), cause_ = list(), label_ = list(), interest_ = list(), depth_ = list();
  Json steps_{{"n", list()}, {"id", list()}, {"from", list()}, {"to", list()}, {"input", list()}, {"depth", list()}};
  Json lanes_{{"speech", list()}, {"gesture", list()},  {"pointing", list()}, {"utterance", list()}, {"move", list()},
              {"act", list()},    {"observed", list()}, {"rest", list()},     {"flags", list()}};
  std::map<std::string, std::size_t> open_gestures_, open_acts_, known_acts_;  // places in their lanes
  std::int64_t stack_ = -1;
  bool changed_stack_ = false;
};

}  // namespace

Result<Json> run_lanes(const RunIndex& run) {
  LaneBuilder lanes(run);
  for (std::size_t n = 0; n < run.size(); ++n)
    if (auto problem = lanes.add(n)) return *problem;
  return lanes.finish();
}

}  // namespace continua
