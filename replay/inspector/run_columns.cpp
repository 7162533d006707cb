#include "continua/replay/inspector/run_columns.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "continua/core/located_json.h"
#include "continua/replay/log/act_outcome.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_stops.h"
#include "continua/replay/log/run_text.h"

namespace continua {
namespace {

static_assert(std::endian::native == std::endian::little, "columns are given out as they lie in memory");

constexpr double pointing_gap_s = 0.5;  // samples come at 20 to 30 a second; a longer pause ends the burst
constexpr std::size_t aligned_to = 8;

std::size_t aligned(std::size_t bytes) { return (bytes + aligned_to - 1) / aligned_to * aligned_to; }

template <class T>
constexpr const char* type_name = nullptr;
template <>
constexpr const char* type_name<double> = "f64";
template <>
constexpr const char* type_name<float> = "f32";
template <>
constexpr const char* type_name<std::int32_t> = "i32";
template <>
constexpr const char* type_name<std::uint32_t> = "u32";
template <>
constexpr const char* type_name<std::uint16_t> = "u16";

// Columns one after another.
class ColumnBytes {
 public:
  template <class T>
  void add(const std::string& name, const std::vector<T>& values) {
    bytes_.resize(aligned(bytes_.size()));
    columns_[name] = Json{{"type", type_name<T>}, {"offset", bytes_.size()}, {"length", values.size()}};
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  std::string behind(Json header) {
    header["columns"] = std::move(columns_);
    const auto text = compact(header);
    const auto size = static_cast<std::uint32_t>(text.size());
    std::string all(reinterpret_cast<const char*>(&size), sizeof size);
    all.reserve(aligned(sizeof size + text.size()) + bytes_.size());
    all += text;
    all.resize(aligned(all.size()));
    return all += bytes_;
  }

 private:
  Json columns_ = Json::object();
  std::string bytes_;
};

struct Lane {
  std::vector<std::uint32_t> n;
  std::vector<double> from, to;

  void add(std::size_t number, double begin, double end) {
    n.push_back(static_cast<std::uint32_t>(number));
    from.push_back(begin);
    to.push_back(std::max(begin, end));
  }
};

double seconds_in(std::string_view value, double otherwise) { return number_in<double>(value).value_or(otherwise); }

// The content of the lines, line by line, then the columns that follow from the index alone.
class ColumnBuilder {
 public:
  explicit ColumnBuilder(const RunIndex& run) : run_(run), names_(run.names()) {
    for (const auto& kind : run.kinds()) {
      const auto read = std::find_if(readers.begin(), readers.end(), [&](const auto& one) { return one.kind == kind; });
      read_.push_back(read == readers.end() ? nullptr : read->read);
    }
    for (std::uint32_t number = 0; number < names_.size(); ++number) name_numbers_.emplace(names_[number], number);
  }

  Result<std::string> build() {
    const auto problem = run_.read_lines([this](std::size_t n) { return read_[run_.entry(n).kind] != nullptr; },
                                         [this](std::size_t n, std::string_view line) {
                                           (this->*read_[run_.entry(n).kind])(n, line);
                                           return true;
                                         });
    if (problem) return *problem;
    const auto end = seconds(run_.size() - 1);
    for (const auto& [name, open] : open_gestures_) lanes_["gesture"].to[open] = end;
    for (const auto open : open_acts_) lanes_["act"].to[open] = std::max(end, lanes_["act"].from[open]);
    if (many_branches_) lanes_["branches"].to.back() = end;
    add_records();
    add_steps();
    return bytes(end);
  }

 private:
  using Reader = void (ColumnBuilder::*)(std::size_t n, std::string_view line);
  struct KindReader {
    std::string_view kind;
    Reader read;
  };
  static const std::vector<KindReader> readers;

  double seconds(std::size_t n) const { return run_.entry(n).t.seconds(); }

  void read_input(std::size_t n, std::string_view line) {
    if (run_.entry(n).sample) {
      add_sample(n);
      if (line.find("\"confidence\"") == std::string_view::npos) return;
    }
    std::string_view kind, until, confidence, name, hand, phase;
    scan_members(member_in(line, "event"), [&](std::string_view key, std::string_view value) {
      for (const auto& [of, into] : {std::pair{"kind", &kind},
                                     {"until", &until},
                                     {"confidence", &confidence},
                                     {"name", &name},
                                     {"hand", &hand},
                                     {"phase", &phase}})
        if (key == of) *into = value;
    });
    const auto t = seconds(n), to = seconds_in(until, t);
    if (const auto value = number_in<double>(confidence)) {
      lanes_["confidence"].add(n, t, to);
      confidences_.push_back(static_cast<float>(*value));
    }
    const auto of = text_in(kind);
    if (of == "speech")
      lanes_["speech"].add(n, t, to);
    else if (of == "gaze")
      add_look(t, to, n);
    else if (of == "gesture")
      read_gesture(n, text_in(hand) + " " + text_in(name), text_in(phase), to);
  }

  void add_sample(std::size_t n) {
    auto& bursts = lanes_["pointing"];
    const auto t = seconds(n);
    if (!bursts.n.empty() && t - bursts.to.back() < pointing_gap_s) {
      bursts.to.back() = std::max(t, bursts.to.back());
      ++samples_.back();
    } else {
      bursts.add(n, t, t);
      samples_.push_back(1);
    }
  }

  // Samples of the eyes that follow one another are one bar.
  void add_look(double t, double to, std::size_t n) {
    auto& lane = lanes_["gaze"];
    if (!lane.n.empty() && t - lane.to.back() < pointing_gap_s)
      lane.to.back() = std::max(to, lane.to.back());
    else
      lane.add(n, t, to);
  }

  void read_gesture(std::size_t n, const std::string& of, const std::string& phase, double to) {
    auto& lane = lanes_["gesture"];
    const auto t = seconds(n);
    const auto open = open_gestures_.find(of);
    if (open != open_gestures_.end()) {
      lane.to[open->second] = std::max(t, lane.from[open->second]);
      open_gestures_.erase(open);
    }
    if (phase == "stop") {
      ends_of_gestures_.insert(n);
      return;
    }
    if (phase == "start") open_gestures_[of] = lane.n.size();
    lane.add(n, t, to);
  }

  // Steps are within their act's time.
  void read_act(std::size_t n, std::string_view line) {
    std::string_view act, status, step;
    scan_members(line, [&](std::string_view key, std::string_view value) {
      for (const auto& [of, into] : {std::pair{"act", &act}, {"status", &status}, {"step", &step}})
        if (key == of) *into = value;
    });
    if (!step.empty()) return;
    auto& lane = lanes_["act"];
    const auto t = seconds(n);
    const auto [known, is_new] = known_acts_.try_emplace(std::string(act), lane.n.size());
    const auto place = known->second;
    if (is_new) {
      lane.add(n, t, t);
      statuses_.push_back(0);
    }
    lane.to[place] = std::max(t, lane.from[place]);
    const auto is = text_in(status);
    statuses_[place] = name_number(is);
    if (log::has_failed(is)) gone_wrong_.insert(n);
    if (is == "asked" || is == "started")
      open_acts_.insert(place);
    else
      open_acts_.erase(place);
  }

  void read_rest(std::size_t n, std::string_view line) {
    const auto t = seconds(n);
    lanes_["rest"].add(n, seconds_in(member_in(line, "from"), t), seconds_in(member_in(line, "to"), t));
  }

  void read_expect(std::size_t n, std::string_view line) {
    if (member_in(line, "met") == "false") gone_wrong_.insert(n);
  }

  void read_branches(std::size_t n, std::string_view line) {
    std::uint32_t count = 0;
    scan_elements(member_in(line, "branches"), [&](std::string_view) { ++count; });
    auto& lane = lanes_["branches"];
    if (many_branches_) lane.to.back() = std::max(seconds(n), lane.from.back());
    many_branches_ = count > 1;
    if (!many_branches_) return;
    lane.add(n, seconds(n), seconds(n));
    branch_counts_.push_back(count);
  }

  void add_records() {
    const std::map<std::string_view, const char*> instants{{log::Utterance::kind.name, "utterance"},
                                                           {log::AvatarGesture::kind.name, "move"},
                                                           {log::Observed::kind.name, "observed"},
                                                           {log::Problem::kind.name, "flag"},
                                                           {log::Expect::kind.name, "flag"},
                                                           {log::Refusal::kind.name, "flag"},
                                                           {log::Act::kind.name, "flag"}};
    std::vector<Lane*> lane_of;
    for (const auto& kind : run_.kinds()) {
      const auto lane = instants.find(kind);
      lane_of.push_back(lane == instants.end() ? nullptr : &lanes_[lane->second]);
    }
    t_.reserve(run_.size());
    kind_.reserve(run_.size());
    cause_.reserve(run_.size());
    for (std::size_t n = 0; n < run_.size(); ++n) {
      const auto& entry = run_.entry(n);
      const auto t = entry.t.seconds();
      t_.push_back(t);
      kind_.push_back(entry.kind);
      cause_.push_back(static_cast<std::int32_t>(entry.cause));
      auto* lane = lane_of[entry.kind];
      if (!lane) continue;
      const auto& kind = run_.kind(n);
      if (log::is<log::Refusal>(kind) && ends_of_gestures_.count(static_cast<std::size_t>(cause_.back()))) continue;
      const bool told_by_content = log::is<log::Expect>(kind) || log::is<log::Act>(kind);
      if ((log::is<log::Refusal>(kind) && entry.by_sample) || (told_by_content && !gone_wrong_.count(n))) continue;
      lane->add(n, t, t);
    }
  }

  void add_steps() {
    auto& lane = lanes_["depth"];
    auto step = run_.step_marks().begin();
    const auto steps_up_to = [&](std::size_t n) {
      for (; step != run_.step_marks().end() && step->n < n; ++step)
        step_depths_.push_back(depths_.empty() ? 0 : depths_.back());
    };
    for (const auto& mark : run_.stack_marks()) {
      steps_up_to(mark.n);
      if (!depths_.empty() && depths_.back() == mark.depth) continue;
      const auto t = seconds(mark.n);
      if (!lane.n.empty()) lane.to.back() = std::max(t, lane.from.back());
      lane.add(mark.n, t, seconds(run_.size() - 1));
      depths_.push_back(mark.depth);
    }
    steps_up_to(run_.size());
  }

  std::uint32_t name_number(const std::string& name) {
    const auto [known, is_new] = name_numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) names_.push_back(name);
    return known->second;
  }

  std::string bytes(double duration) {
    ColumnBytes all;
    all.add("t", t_);
    all.add("kind", kind_);
    all.add("cause", cause_);
    all.add("stop", records_worth_stopping_at(run_));
    for (const char* name : {"speech", "gesture", "pointing", "gaze", "utterance", "move", "observed", "act", "rest",
                             "flag", "branches", "confidence", "depth"}) {
      const auto& lane = lanes_[name];
      all.add(std::string(name) + ".n", lane.n);
      all.add(std::string(name) + ".from", lane.from);
      all.add(std::string(name) + ".to", lane.to);
    }
    all.add("pointing.count", samples_);
    all.add("act.status", statuses_);
    all.add("branches.count", branch_counts_);
    all.add("confidence.value", confidences_);
    all.add("depth.value", depths_);
    for (const auto& [name, part] : {std::pair{"step.n", &StepMark::n},
                                     {"step.id", &StepMark::id},
                                     {"step.from", &StepMark::from},
                                     {"step.to", &StepMark::to}}) {
      std::vector<std::uint32_t> values;
      values.reserve(run_.step_marks().size());
      for (const auto& step : run_.step_marks()) values.push_back(step.*part);
      all.add(name, values);
    }
    all.add("step.depth", step_depths_);
    return all.behind(Json{{"records", run_.size()},
                           {"duration", duration},
                           {"kinds", run_.kinds()},
                           {"names", names_},
                           {"complete", run_.complete()}});
  }

  const RunIndex& run_;
  std::vector<Reader> read_;  // by kind
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> name_numbers_;
  std::vector<double> t_;
  std::vector<std::uint16_t> kind_;
  std::vector<std::int32_t> cause_;
  std::vector<std::uint32_t> samples_, statuses_, branch_counts_, depths_, step_depths_;
  std::vector<float> confidences_;
  std::map<std::string, Lane, std::less<>> lanes_;
  std::map<std::string, std::size_t> open_gestures_;         // places in their lane
  std::unordered_map<std::string, std::size_t> known_acts_;  // by number as written: places in their lane
  std::set<std::size_t> open_acts_;                          // places in their lane
  std::unordered_set<std::size_t> ends_of_gestures_;
  std::unordered_set<std::size_t> gone_wrong_;  // unmet expectations, failed acts
  bool many_branches_ = false;
};

const std::vector<ColumnBuilder::KindReader> ColumnBuilder::readers{
    {log::Input::kind.name, &ColumnBuilder::read_input},
    {log::Act::kind.name, &ColumnBuilder::read_act},
    {log::Rest::kind.name, &ColumnBuilder::read_rest},
    {log::Expect::kind.name, &ColumnBuilder::read_expect},
    {log::Branches::kind.name, &ColumnBuilder::read_branches}};

}  // namespace

Result<std::string> run_columns(const RunIndex& run) { return ColumnBuilder(run).build(); }

}  // namespace continua
