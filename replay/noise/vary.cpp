#include "continua/replay/noise/vary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/random.h"
#include "continua/replay/noise/heard.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

// Samples of a hand that are further apart belong to two pointings.
constexpr double stretch_gap_s = 0.6;
constexpr double doubled_after_s = 0.2;

// Draws of one event for one kind of noise.
Random draws(std::uint64_t seed, std::size_t event, std::uint64_t kind) {
  return Random(Random(seed).next() ^ Random(8 * event + kind).next());
}

// Normal, of standard deviation 1, by the sum of twelve draws: the same on every machine, as a logarithm need not be.
double normal(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

const InputEvent* input_of(const TraceEvent& event) { return std::get_if<InputEvent>(&event.what); }

bool points(const InputEvent& input) {
  return input.modality == Modality::pointing || (input.modality == Modality::gesture && input.target_W);
}

// The first and the last event of the pointing that each event belongs to.
std::map<std::size_t, std::pair<std::size_t, std::size_t>> stretches_of(const Trace& trace) {
  std::map<std::string, std::vector<std::size_t>> latest;  // by hand
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> stretches;
  const auto close = [&](std::vector<std::size_t>& stretch) {
    for (const auto event : stretch) stretches[event] = {stretch.front(), stretch.back()};
    stretch.clear();
  };
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    const auto* input = input_of(trace.events[i]);
    if (!input || !points(*input)) continue;
    auto& stretch = latest[input->hand];
    if (!stretch.empty() && (input->t - input_of(trace.events[stretch.back()])->t).seconds() > stretch_gap_s)
      close(stretch);
    stretch.push_back(i);
  }
  for (auto& [hand, stretch] : latest) close(stretch);
  return stretches;
}

// One event on its way through the recognisers.
class Way {
 public:
  Way(const Trace& trace, std::size_t event, const Noise& noise, std::uint64_t seed)
      : trace_(trace), event_(event), noise_(noise), seed_(seed), now_{trace.events[event]} {}

  void words() {
    auto& input = std::get<InputEvent>(now_[0].what);
    if (input.modality != Modality::speech || input.text.empty()) return;
    auto list_draws = draws(seed_, event_, 1), word_draws = draws(seed_, event_, 0);
    const auto before = input.text;
    if (list_draws.uniform() < noise_.n_best.share) {
      hear_as_list(input, noise_, list_draws);
      tell("\"{}\" is heard as a list of {}, \"{}\" first", before, input.alternatives.size() + 1, input.text);
    } else if (!hear_words(input, noise_, word_draws)) {
      now_.clear();
      tell("\"{}\" is not heard", before);
    } else if (input.text != before) {
      tell("\"{}\" is heard for \"{}\", {:.2f} sure", input.text, before, input.confidence);
    } else if (input.confidence != input_of(trace_.events[event_])->confidence) {
      tell("\"{}\" is heard, {:.2f} sure", before, input.confidence);
    }
  }

  void gesture() {
    if (now_.empty()) return;
    const auto& input = std::get<InputEvent>(now_[0].what);
    if (input.modality != Modality::gesture) return;
    auto random = draws(seed_, event_, 3);
    const auto& [missed, doubled] = noise_.gestures;
    const double chance = random.uniform(), which = random.uniform() * (missed + doubled);
    if (chance >= missed + doubled) return;
    if (which < missed) {
      now_.clear();
      return tell("the gesture {} is missed", input.name);
    }
    tell("the gesture {} is seen twice", input.name);
    now_.push_back(shifted(now_[0], SimTime::from_seconds(doubled_after_s)));
  }

  // `stretch`: its pointing's first and last event.
  void pointing(std::pair<std::size_t, std::size_t> stretch) {
    if (now_.empty()) return;
    const auto time_of = [&](std::size_t event) { return input_of(trace_.events[event])->t; };
    auto of_stretch = draws(seed_, stretch.first, 4), own = draws(seed_, event_, 5);
    const double late_s = of_stretch.uniform() * noise_.pointing.late_s;
    const double left = 1 - of_stretch.uniform() * noise_.pointing.cut;
    const double off[2] = {normal(own) * noise_.pointing.sd_m, normal(own) * noise_.pointing.sd_m};
    const double length_s = (time_of(stretch.second) - time_of(stretch.first)).seconds();
    if (event_ != stretch.first && (time_of(event_) - time_of(stretch.first)).seconds() > left * length_s) {
      now_.clear();
      return tell("the pointing at {} s is cut", seconds(time_of(event_)));
    }
    for (auto& event : now_) {
      auto& input = std::get<InputEvent>(event.what);
      move(input, off);
      if (input.until && left < 1)
        input.until = input.t + SimTime::from_seconds((*input.until - input.t).seconds() * left);
      event.t = event.t + SimTime::from_seconds(late_s);
    }
    if (noise_.pointing.sd_m > 0)
      tell("the pointing at {} s is {:.3f}, {:.3f} m off", seconds(time_of(event_)), off[0], off[1]);
    if (late_s > 0) tell("the pointing at {} s is known {:.2f} s later", seconds(time_of(event_)), late_s);
  }

  void time() {
    auto random = draws(seed_, event_, 2);
    const double by_s = normal(random) * noise_.times.sd_s;
    if (now_.empty() || noise_.times.sd_s == 0) return;
    const auto& original = trace_.events[event_];
    // Not before the beginning.
    const auto by = std::max(SimTime::from_seconds(by_s), SimTime{} - input_of(original)->t);
    for (auto& event : now_) event = shifted(event, by);
    tell("an event at {} s comes {:+.3f} s", seconds(original.t), by.seconds());
  }

  // Nothing if all is as it was.
  std::optional<Edit> edit() {
    if (sentence_.empty()) return std::nullopt;
    for (auto& event : now_) event.json = json_of(event);
    return Edit{event_, std::move(now_), std::move(sentence_)};
  }

 private:
  template <class... Parts>
  void tell(fmt::format_string<Parts...> sentence, Parts&&... parts) {
    if (!sentence_.empty()) sentence_ += "; ";
    sentence_ += fmt::format(sentence, std::forward<Parts>(parts)...);
  }

  static double seconds(SimTime t) { return t.seconds(); }

  // Other coordinates have no rest of a division by a micrometre, as in all traces.
  static void move(InputEvent& input, const double (&off)[2]) {
    for (int axis = 0; axis < 2; ++axis) {
      const double by = std::round(off[axis] * 1e6) / 1e6;
      if (input.target_W) (*input.target_W)[axis] += by;
      // The point on the table moves with the hand.
      if (input.ray) input.ray->from_W[axis] += by;
    }
  }

  static TraceEvent shifted(const TraceEvent& event, SimTime by) {
    auto later = event;
    auto& input = std::get<InputEvent>(later.what);
    later.t = later.t + by;
    input.t = input.t + by;
    if (input.until) input.until = *input.until + by;
    for (auto& word : input.words) word.t = word.t + by;
    return later;
  }

  const Trace& trace_;
  const std::size_t event_;
  const Noise& noise_;
  const std::uint64_t seed_;
  std::vector<TraceEvent> now_;
  std::string sentence_;
};

}  // namespace

std::vector<Edit> edits_of(const Trace& trace, const Noise& noise, std::uint64_t seed) {
  std::vector<Edit> edits;
  const auto stretches = stretches_of(trace);
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    if (!input_of(trace.events[i])) continue;
    Way way(trace, i, noise, seed);
    way.words();
    way.gesture();
    if (const auto stretch = stretches.find(i); stretch != stretches.end()) way.pointing(stretch->second);
    way.time();
    if (auto edit = way.edit()) edits.push_back(*std::move(edit));
  }
  return edits;
}

Trace edited_trace(const Trace& trace, const std::vector<Edit>& edits) {
  Trace edited;
  static_cast<TraceHead&>(edited) = trace;
  edited.notes.clear();
  auto edit = edits.begin();
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    if (std::holds_alternative<Expectation>(trace.events[i].what)) continue;
    const bool is_edited = edit != edits.end() && edit->event == i;
    if (is_edited)
      edited.events.insert(edited.events.end(), edit->becomes.begin(), edit->becomes.end());
    else
      edited.events.push_back(trace.events[i]);
    if (is_edited) ++edit;
  }
  const auto ends = [](const TraceEvent& event) { return std::holds_alternative<End>(event.what); };
  std::stable_sort(edited.events.begin(), edited.events.end(),
                   [&](const TraceEvent& a, const TraceEvent& b) { return ends(a) != ends(b) ? ends(b) : a.t < b.t; });
  if (!edited.events.empty() && ends(edited.events.back())) {
    auto& end = edited.events.back();
    for (const auto& event : edited.events) end.t = std::max(end.t, event.t);
    end.json = json_of(end);
  }
  for (std::size_t i = 0; i < edited.events.size(); ++i) edited.events[i].line = i + 2;
  edited.digest = digest(write_trace(edited));
  return edited;
}

}  // namespace continua
