#include "continua/replay/diff/run_diff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <unordered_map>

#include "continua/replay/diff/run_cause.h"
#include "continua/replay/diff/sequence_alignment.h"
#include "continua/replay/log/kinds.h"

namespace continua {
namespace {

using Numbers = std::vector<std::uint32_t>;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// A run as its events, and the records that followed from each. Number 0 stands for the run's beginning, i + 1 for
// event i.
struct Shape {
  Numbers events;               ///< records
  Numbers followed;             ///< records, ordered by the event that they followed from, then as they came
  std::vector<std::size_t> at;  ///< where in `followed` those of a number begin; one more than numbers
};

// The records between which an act goes on are measured, and poses are compared by themselves; of an act only its being
// asked for counts.
Shape shape_of(const RunIndex& run) {
  std::vector<bool> left_out;
  for (const auto& kind : run.kinds())
    left_out.push_back(log::is<log::Pose>(kind) || log::is<log::Act>(kind) || log::is<log::Observed>(kind));
  std::vector<bool> counts(run.size(), false);
  for (const auto& mark : run.act_marks())
    if (mark.asked) counts[mark.n] = true;

  Shape shape;
  Numbers from(run.size(), 0);
  shape.at.assign(2, 0);
  for (std::size_t n = 0; n < run.size(); ++n) {
    const auto& entry = run.entry(n);
    if (entry.event) {
      shape.events.push_back(static_cast<std::uint32_t>(n));
      shape.at.push_back(0);
      from[n] = static_cast<std::uint32_t>(shape.events.size());
      continue;
    }
    from[n] = entry.cause >= 0 ? from[static_cast<std::size_t>(entry.cause)]
                               : static_cast<std::uint32_t>(shape.events.size());
    if (entry.meaning.what != 0 && !left_out[entry.kind]) counts[n] = true;
    if (counts[n]) ++shape.at[from[n] + 1];
  }
  for (std::size_t i = 1; i < shape.at.size(); ++i) shape.at[i] += shape.at[i - 1];
  shape.followed.resize(shape.at.back());
  auto next = shape.at;
  for (std::size_t n = 0; n < run.size(); ++n)
    if (counts[n]) shape.followed[next[from[n]]++] = static_cast<std::uint32_t>(n);
  return shape;
}

std::vector<EventSeen> events_of(const RunIndex& run, const Shape& shape) {
  std::vector<EventSeen> events;
  events.reserve(shape.events.size());
  for (const auto n : shape.events) events.push_back({run.entry(n).meaning.what, run.entry(n).event, run.entry(n).t});
  return events;
}

class Comparison {
 public:
  Comparison(const RunIndex& a, const RunIndex& b) : a_(a), b_(b), shape_a_(shape_of(a)), shape_b_(shape_of(b)) {}

  void run(RunDiff& diff) {
    const auto aligned = align_events(events_of(a_, shape_a_), events_of(b_, shape_b_));
    diff.inputs_a = shape_a_.events.size();
    diff.inputs_b = shape_b_.events.size();
    diff.inputs_common = aligned.same;
    std::vector<std::uint32_t> of_event(shape_a_.events.size(), none);
    for (const auto& [i, j] : aligned.pairs) of_event[i] = static_cast<std::uint32_t>(j);
    events(aligned);
    followed({0, 0});
    for (std::size_t i = 0; i < of_event.size(); ++i)
      if (of_event[i] != none) followed({i + 1, of_event[i] + 1});
    if (!std::is_sorted(pairs_.begin(), pairs_.end())) std::sort(pairs_.begin(), pairs_.end());
    diff.pairs = some_pairs(aligned);
    outcomes();
    std::stable_sort(differences_.begin(), differences_.end(),
                     [](const RunDifference& x, const RunDifference& y) { return key(x) < key(y); });
    diff.count = count_;
    if (differences_.size() > most_differences) differences_.resize(most_differences);
    diff.differences = std::move(differences_);
  }

  /// The first transition in both after these records that leads to the same state with the same stack.
  std::optional<std::pair<std::size_t, std::size_t>> meeting_after(std::size_t a, std::size_t b) const {
    for (const auto& [n, m] : pairs_)
      if (n > a && m > b && log::is<log::Transition>(a_.kind(n)) && stack_at(a_, n) == stack_at(b_, m))
        return std::pair(n, m);
    return std::nullopt;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::pair<std::size_t, std::size_t>> some_pairs(const EventAlignment& aligned) const {
    std::vector<std::pair<std::size_t, std::size_t>> some, growing;
    const auto apart = [](std::size_t count) { return count / most_pairs + 1; };
    for (std::size_t i = 0; i < aligned.pairs.size(); i += apart(aligned.pairs.size()))
      some.emplace_back(shape_a_.events[aligned.pairs[i].first], shape_b_.events[aligned.pairs[i].second]);
    for (std::size_t i = 0; i < pairs_.size(); i += apart(pairs_.size())) some.push_back(pairs_[i]);
    std::sort(some.begin(), some.end());
    for (const auto& pair : some)
      if (growing.empty() || (pair.first > growing.back().first && pair.second > growing.back().second))
        growing.push_back(pair);
    return growing;
  }

  // At one instant inputs come first.
  static std::tuple<SimTime, int, std::size_t> key(const RunDifference& difference) {
    const auto n = !difference.a.empty() ? difference.a.front() : !difference.b.empty() ? difference.b.front() : 0;
    return {difference.t, difference.kind == RunDifference::Kind::input ? 0 : 1, n};
  }

  static std::uint64_t stack_at(const RunIndex& run, std::size_t n) {
    const auto mark = run.mark_at(n);
    const auto* top = mark ? run.symbol(run.stack_marks()[*mark].top) : nullptr;
    return top ? top->stack : 0;
  }

  void note(RunDifference difference) {
    ++count_;
    if (differences_.size() < 20 * most_differences) differences_.push_back(std::move(difference));
  }

  std::span<const std::uint32_t> group(const Shape& shape, std::size_t number) const {
    return std::span(shape.followed).subspan(shape.at[number], shape.at[number + 1] - shape.at[number]);
  }

  // With an event that only one run has goes all that followed from it.
  void add_event(const Shape& shape, std::size_t event, std::vector<std::size_t>& records) const {
    records.push_back(shape.events[event]);
    const auto after = group(shape, event + 1);
    records.insert(records.end(), after.begin(), after.end());
  }

  void events(const EventAlignment& aligned) {
    for (const auto& change : aligned.changes) {
      RunDifference difference;
      difference.kind = RunDifference::Kind::input;
      auto input = change;
      const bool both = change.a && change.b;
      if (change.a) {
        if (both)
          difference.a = {shape_a_.events[*change.a]};
        else
          add_event(shape_a_, *change.a, difference.a);
        input.a = shape_a_.events[*change.a];
        difference.t = a_.entry(*input.a).t;
      }
      if (change.b) {
        if (both)
          difference.b = {shape_b_.events[*change.b]};
        else
          add_event(shape_b_, *change.b, difference.b);
        input.b = shape_b_.events[*change.b];
        difference.t = both ? std::min(difference.t, b_.entry(*input.b).t) : b_.entry(*input.b).t;
      }
      if (change.other) {
        input.other = {shape_a_.events[change.other->first], shape_b_.events[change.other->second]};
        difference.a.push_back(input.other->first);
        difference.b.push_back(input.other->second);
      }
      difference.input = input;
      note(std::move(difference));
    }
    for (const auto& [i, j] : aligned.pairs) {
      const auto n = shape_a_.events[i], m = shape_b_.events[j];
      const bool counted = a_.entry(n).meaning.what != b_.entry(m).meaning.what;
      if (!counted && a_.entry(n).meaning.whole != b_.entry(m).meaning.whole)
        note_pair(RunDifference::Kind::decided, n, m);
    }
  }

  void note_pair(RunDifference::Kind kind, std::size_t n, std::size_t m) {
    RunDifference difference;
    difference.kind = kind;
    difference.a = {n};
    difference.b = {m};
    difference.t = std::min(a_.entry(n).t, b_.entry(m).t);
    note(std::move(difference));
  }

  // The records that followed from one event in a, against those of its counterpart in b.
  void followed(std::pair<std::size_t, std::size_t> numbers) {
    const auto in_a = group(shape_a_, numbers.first), in_b = group(shape_b_, numbers.second);
    shift_ = SimTime{};
    if (numbers.first > 0)
      shift_ = b_.entry(shape_b_.events[numbers.second - 1]).t - a_.entry(shape_a_.events[numbers.first - 1]).t;
    const auto same = [&](std::uint32_t n, std::uint32_t m) {
      return a_.entry(n).meaning.what == b_.entry(m).meaning.what;
    };
    if (std::equal(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(), same)) {
      for (std::size_t i = 0; i < in_a.size(); ++i) pair(in_a[i], in_b[i]);
    } else {
      parts(in_a, in_b);
    }
    tell_shifted();
  }

  void parts(std::span<const std::uint32_t> in_a, std::span<const std::uint32_t> in_b) {
    std::vector<std::uint64_t> what_a, what_b;
    for (const auto n : in_a) what_a.push_back(a_.entry(n).meaning.what);
    for (const auto m : in_b) what_b.push_back(b_.entry(m).meaning.what);
    auto pairs = align(what_a, what_b).pairs;
    pairs.emplace_back(in_a.size(), in_b.size());
    std::size_t i = 0, j = 0;
    for (const auto& [to_i, to_j] : pairs) {
      if (i < to_i || j < to_j) {
        RunDifference difference;
        difference.a.assign(in_a.begin() + static_cast<std::ptrdiff_t>(i),
                            in_a.begin() + static_cast<std::ptrdiff_t>(to_i));
        difference.b.assign(in_b.begin() + static_cast<std::ptrdiff_t>(j),
                            in_b.begin() + static_cast<std::ptrdiff_t>(to_j));
        difference.t = difference.a.empty() ? b_.entry(difference.b.front()).t : a_.entry(difference.a.front()).t;
        note(std::move(difference));
      }
      if (to_i < in_a.size()) pair(in_a[to_i], in_b[to_j]);
      i = to_i + 1;
      j = to_j + 1;
    }
  }

  void pair(std::uint32_t n, std::uint32_t m) {
    pairs_.emplace_back(n, m);
    if (a_.entry(n).meaning.whole != b_.entry(m).meaning.whole) note_pair(RunDifference::Kind::decided, n, m);
    const bool measured = a_.entry(n).measured || b_.entry(m).measured;
    if (!measured && b_.entry(m).t - a_.entry(n).t != shift_) shifted_.emplace_back(n, m);
  }

  void tell_shifted() {
    if (shifted_.empty()) return;
    RunDifference difference;
    difference.kind = RunDifference::Kind::timing;
    difference.t = std::min(a_.entry(shifted_.front().first).t, b_.entry(shifted_.front().second).t);
    for (const auto& [n, m] : shifted_) {
      difference.a.push_back(n);
      difference.b.push_back(m);
    }
    shifted_.clear();
    note(std::move(difference));
  }

  // Of acts that were asked for in both, the last record as a whole.
  void outcomes() {
    std::unordered_map<std::int64_t, std::uint64_t> last_a, last_b;
    std::unordered_map<std::uint64_t, std::int64_t> act_a, act_b;
    const auto collect = [](const RunIndex& run, auto& last, auto& act) {
      for (const auto& mark : run.act_marks()) {
        if (mark.step == 0) last[mark.act] = mark.n;
        if (mark.asked) act[mark.n] = mark.act;
      }
    };
    collect(a_, last_a, act_a);
    collect(b_, last_b, act_b);
    for (const auto& [n, m] : pairs_) {
      if (!log::is<log::Act>(a_.kind(n))) continue;
      const auto one = act_a.find(n), other = act_b.find(m);
      if (one == act_a.end() || other == act_b.end()) continue;
      const auto end_a = last_a[one->second], end_b = last_b[other->second];
      if (a_.entry(end_a).meaning.what != b_.entry(end_b).meaning.what)
        note_pair(RunDifference::Kind::outcome, end_a, end_b);
    }
  }

  const RunIndex &a_, &b_;
  Shape shape_a_, shape_b_;
  Pairs pairs_;    ///< records of both that say the same
  Pairs shifted_;  ///< those of the present event at another time than it
  SimTime shift_;  ///< of the present event
  std::vector<RunDifference> differences_;
  std::size_t count_ = 0;
};

// Bodies that are elsewhere, from the first time on at which one is farther off than the tolerance.
class PoseComparison {
 public:
  PoseComparison(const RunIndex& a, const RunIndex& b, double tolerance_m) : tolerance_m_(tolerance_m) {
    sides_[0].run = &a;
    sides_[1].run = &b;
    for (auto& side : sides_) side.poses = side.run->of_kind(log::Pose::kind.name);
  }

  Outcome compare(RunDiff& diff) {
    for (auto& side : sides_)
      if (auto problem = start(side)) return problem;
    look(diff, SimTime{});
    if (auto problem = skip_common()) return problem;
    while (sides_[0].next < sides_[0].poses.size() || sides_[1].next < sides_[1].poses.size()) {
      const auto t = std::min(time_of(sides_[0]), time_of(sides_[1]));
      for (auto& side : sides_)
        while (time_of(side) == t)
          if (auto problem = take(side)) return problem;
      look(diff, t);
    }
    return std::nullopt;
  }

 private:
  struct Side {
    const RunIndex* run = nullptr;
    std::vector<std::size_t> poses;
    std::size_t next = 0;
    std::optional<std::size_t> last;
    std::map<std::string, std::array<double, 3>> places;
  };

  static SimTime time_of(const Side& side) {
    return side.next < side.poses.size() ? side.run->entry(side.poses[side.next]).t
                                         : SimTime{std::numeric_limits<std::int64_t>::max()};
  }

  // Records that both have alike from the beginning on make no difference; if one run has no others, it need not be
  // read.
  Outcome skip_common() {
    auto& [one, other] = sides_;
    const auto meaning = [](const Side& side, std::size_t i) { return side.run->entry(side.poses[i]).meaning.what; };
    const auto time = [](const Side& side, std::size_t i) { return side.run->entry(side.poses[i]).t; };
    std::size_t common = 0;
    while (common < std::min(one.poses.size(), other.poses.size()) && meaning(one, common) == meaning(other, common) &&
           time(one, common) == time(other, common))
      ++common;
    if (common == one.poses.size() && common == other.poses.size()) {
      one.next = other.next = common;
      return std::nullopt;
    }
    while (one.next < common)
      for (auto& side : sides_)
        if (auto problem = take(side)) return problem;
    return std::nullopt;
  }

  static void place(Side& side, const Json& bodies) {
    if (!bodies.is_object()) return;
    for (const auto& [name, pose] : bodies.items()) {
      const bool numbers =
          pose.is_array() && pose.size() >= 3 && pose[0].is_number() && pose[1].is_number() && pose[2].is_number();
      if (numbers) side.places[name] = {pose[0].get<double>(), pose[1].get<double>(), pose[2].get<double>()};
    }
  }

  static Outcome start(Side& side) {
    const auto& header = side.run->header();
    if (!header) return header.error();
    if (const auto scene = header->find("scene"); scene != header->end() && scene->is_object())
      if (const auto bodies = scene->find("bodies"); bodies != scene->end()) place(side, *bodies);
    return std::nullopt;
  }

  Outcome take(Side& side) {
    side.last = side.poses[side.next++];
    const auto record = side.run->record(*side.last);
    if (!record) return record.error();
    if (const auto bodies = record->find("bodies"); bodies != record->end()) place(side, *bodies);
    return std::nullopt;
  }

  void look(RunDiff& diff, SimTime t) {
    double farthest = 0;
    std::string body;
    for (const auto& [name, place] : sides_[0].places) {
      const auto other = sides_[1].places.find(name);
      if (other == sides_[1].places.end()) continue;
      const auto& there = other->second;
      const double distance = std::hypot(place[0] - there[0], place[1] - there[1], place[2] - there[2]);
      if (distance > farthest) body = name;
      farthest = std::max(farthest, distance);
    }
    if (farthest > diff.largest_distance_m) diff.farthest = body;
    diff.largest_distance_m = std::max(diff.largest_distance_m, farthest);
    if (farthest <= tolerance_m_) return;
    ++diff.count;
    if (told_) return;
    told_ = true;
    RunDifference difference;
    difference.kind = RunDifference::Kind::poses;
    difference.t = t;
    if (sides_[0].last) difference.a = {*sides_[0].last};
    if (sides_[1].last) difference.b = {*sides_[1].last};
    diff.differences.push_back(std::move(difference));
  }

  double tolerance_m_;
  std::array<Side, 2> sides_;
  bool told_ = false;
};

// The chain of causes, the earliest first.
std::vector<std::size_t> led_to(const RunIndex& run, const std::vector<std::size_t>& records) {
  std::vector<std::size_t> chain;
  if (records.empty()) return chain;
  for (std::optional<std::size_t> at = run.cause(records.front()); at; at = run.cause(*at)) chain.push_back(*at);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

// Records that only tell or check bring nothing about: one of them is the first only where nothing else differs.
std::size_t first_that_counts(const RunIndex& a, const RunIndex& b, const std::vector<RunDifference>& differences) {
  const auto counts = [](const RunIndex& run, const std::vector<std::size_t>& records) {
    return !records.empty() && !log::is<log::Expect>(run.kind(records.front())) &&
           !log::is<log::Observed>(run.kind(records.front()));
  };
  const auto found = std::find_if(differences.begin(), differences.end(), [&](const RunDifference& one) {
    return one.kind == RunDifference::Kind::poses || counts(a, one.a) || counts(b, one.b);
  });
  return found == differences.end() ? 0 : static_cast<std::size_t>(found - differences.begin());
}

// So few inputs in common allow no comparison.
bool unrelated(const RunDiff& diff) {
  constexpr std::size_t few = 3, part = 10;
  const auto fewer = std::min(diff.inputs_a, diff.inputs_b);
  return fewer >= few && diff.inputs_common * part < fewer;
}

}  // namespace

const char* name_of(RunDifference::Kind kind) {
  switch (kind) {
    case RunDifference::Kind::input:
      return "input";
    case RunDifference::Kind::happened:
      return "happened";
    case RunDifference::Kind::decided:
      return "decided";
    case RunDifference::Kind::timing:
      return "timing";
    case RunDifference::Kind::outcome:
      return "outcome";
    case RunDifference::Kind::poses:
      return "poses";
  }
  return "";
}

const char* name_of(RunDiff::Sameness sameness) {
  switch (sameness) {
    case RunDiff::Sameness::same:
      return "same";
    case RunDiff::Sameness::without_effect:
      return "without effect";
    case RunDiff::Sameness::different:
      return "different";
    case RunDiff::Sameness::unrelated:
      return "unrelated";
  }
  return "";
}

bool is_same(const RunDiff& diff) {
  return diff.sameness == RunDiff::Sameness::same || diff.sameness == RunDiff::Sameness::without_effect;
}

Result<RunDiff> diff_runs(const RunIndex& a, const RunIndex& b, const DiffOptions& options) {
  const auto &header_a = a.header(), &header_b = b.header();
  if (!header_a) return header_a.error();
  if (!header_b) return header_b.error();
  RunDiff diff;
  diff.givens = given_differences(*header_a, *header_b);
  Comparison comparison(a, b);
  comparison.run(diff);
  const bool same_world = header_a->value("world", Json()) == header_b->value("world", Json());
  if (diff.differences.empty() && same_world)
    if (const auto problem = PoseComparison(a, b, options.tolerance_m).compare(diff)) return *problem;

  if (!diff.differences.empty()) {
    diff.sameness = unrelated(diff) ? RunDiff::Sameness::unrelated : RunDiff::Sameness::different;
    diff.first = first_that_counts(a, b, diff.differences);
    const auto& first = diff.differences[diff.first];
    diff.led_a = led_to(a, first.a);
    diff.led_b = led_to(b, first.b);
    const auto last = [](const std::vector<std::size_t>& records) { return records.empty() ? 0 : records.back(); };
    diff.meet = comparison.meeting_after(last(first.a), last(first.b));
  } else if (!diff.givens.empty()) {
    diff.sameness = RunDiff::Sameness::without_effect;
  }
  if (const auto problem = find_cause(a, b, diff)) return *problem;
  return diff;
}

}  // namespace continua
