#include "continua/perception/fusion.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "continua/perception/shown_with.h"

namespace continua {
namespace {

constexpr struct {
  SimTime from{std::numeric_limits<std::int64_t>::min()}, until{std::numeric_limits<std::int64_t>::max()};
} ever;

// The order of percepts of one time.
int rank(const Percept& percept) {
  if (percept.deixis) return 1;
  return percept.event.modality == Modality::speech ? 2 : 3;
}

auto order(const Percept& percept) { return std::tuple(percept.event.t, rank(percept), percept.serial); }

bool is_sample(const Percept& percept) { return percept.event.modality == Modality::pointing; }

// The told end of the event; its beginning where none is told.
SimTime told_end(const Percept& percept) {
  return std::max(percept.event.t, percept.event.until.value_or(percept.event.t));
}

// Whether a gesture is made without words, as its end tells.
bool is_by_itself(const Percept& gesture) { return gesture.event.until == gesture.event.t; }

// The time until which words begin that a gesture is shown with. Pointings find their words in another way.
SimTime words_come_until(const Percept& gesture, const FusionWindow& window) {
  if (gesture.deixis || window.together_s == 0 || is_by_itself(gesture)) return gesture.event.t;
  return std::max(told_end(gesture), gesture.event.t + SimTime::from_seconds(window.together_s));
}

// Whether the percept is a gesture, other than a pointing, that begins during the words.
bool is_shown_during(const Percept& percept, const Percept& speech) {
  return percept.event.modality == Modality::gesture && !percept.deixis && speech.event.modality == Modality::speech &&
         speech.event.t <= percept.event.t && percept.event.t <= std::max(told_end(speech), speech.spoken);
}

// The end of the last taker that needs a pointing.
std::optional<SimTime> last_need(const std::vector<Taker>& takers) {
  std::optional<SimTime> last;
  for (const auto& taker : takers)
    if (taker.needs) last = std::max(last.value_or(taker.until), taker.until);
  return last;
}

// Whether the pointing of a taker was made with other words that have none: "put the cup" [pointing] "here".
bool is_of_others(std::size_t taker, const Percept& speech, const std::vector<std::optional<Deixis>>& bound) {
  const Deixis& pointing = *bound[taker];
  if (gap_us(speech.takers[taker], pointing) == 0) return false;
  for (std::size_t i = 0; i < bound.size(); ++i)
    if (!bound[i] && gap_us(speech.takers[i], pointing) == 0) return true;
  return false;
}

// The time until which an unfinished sentence waits for its next piece. A pointing with its last words is a part of it.
SimTime last_piece(const Percept& speech, const std::vector<std::optional<Deixis>>& bound, const FusionWindow& window) {
  const bool is_shown = !bound.empty() && bound.back() && speech.takers.back().until >= speech.spoken;
  return std::max(speech.spoken, is_shown ? settled_at(*bound.back()) : speech.spoken) +
         SimTime::from_seconds(window.pause_s);
}

bool waits_for_words(const Percept& speech, const FusionWindow& window) {
  return speech.unfinished && window.pause_s > 0;
}

// The time at which the pointings of speech are complete.
SimTime all_pointed_at(const Percept& speech, const std::vector<std::optional<Deixis>>& bound,
                       const FusionWindow& window) {
  const auto last = last_need(speech.takers);
  const SimTime heard = told_end(speech);
  if (!last) return heard;
  const SimTime latest = std::max(heard, *last + SimTime::from_seconds(window.after_s));
  SimTime at = std::max(heard, *last);
  for (std::size_t i = 0; i < bound.size(); ++i) {
    if (!speech.takers[i].needs) continue;
    if (!bound[i] || is_of_others(i, speech, bound)) return latest;
    at = std::max(at, settled_at(*bound[i]));
  }
  return std::min(at, latest);
}

// The time at which speech is complete with its present bindings.
SimTime complete_at(const Percept& speech, const std::vector<std::optional<Deixis>>& bound,
                    const FusionWindow& window) {
  const SimTime at = all_pointed_at(speech, bound, window);
  return waits_for_words(speech, window) ? std::max(at, last_piece(speech, bound, window)) : at;
}

// The time at which a gesture, other than a pointing, is complete: the words that it goes with are spoken first.
SimTime shown_at(const Percept& gesture, const std::vector<Percept>& waiting, const FusionWindow& window) {
  std::optional<SimTime> said;
  for (const auto& speech : waiting)
    if (is_shown_during(gesture, speech) || is_shown_with(gesture, speech, window))
      said = std::max(said.value_or(gesture.event.t), told_end(speech));
  if (said) return *said;
  return gesture.event.modality == Modality::gesture ? words_come_until(gesture, window) : gesture.event.t;
}

// The time at which a pointing that no words take is complete: with words that it was made with and that ask for none,
// such as a yes, else when none can take it any more.
SimTime pointed_at(const Percept& pointing, const std::vector<Percept>& waiting, const FusionWindow& window) {
  SimTime at = pointing.deixis->until + SimTime::from_seconds(window.after_s);
  for (const auto& speech : waiting)
    if (is_shown_with(pointing, speech, window) && speech.takers.empty() && !waits_for_words(speech, window))
      at = std::min(at, std::max(settled_at(*pointing.deixis), told_end(speech)));
  return at;
}

bool lacks_pointing(const Ensemble& ensemble) {
  const auto& takers = ensemble.percept.takers;
  for (std::size_t i = 0; i < takers.size(); ++i)
    if (takers[i].needs && !ensemble.bound[i]) return true;
  return false;
}

// A gesture that was shown just before whole words comes after them, as one shown just after them does: "take the
// knife", and a hand that grabs.
void put_whole_words_first(std::vector<Ensemble>::iterator begin, std::vector<Ensemble>::iterator end,
                           const FusionWindow& window) {
  for (auto speech = begin; speech != end; ++speech) {
    if (speech->percept.event.modality != Modality::speech || lacks_pointing(*speech)) continue;
    const auto first = std::stable_partition(begin, speech, [&](const Ensemble& each) {
      const auto& gesture = each.percept;
      return gesture.deixis || gesture.before_words || !is_shown_with(gesture, speech->percept, window);
    });
    std::rotate(first, speech, std::next(speech));
  }
}

// Words that still lack something come after the gestures that were made with them: "take this", and a hand like a cup.
// So do all words after gestures that say how they are meant: "the blocks", and two fingers.
void put_shown_first(std::vector<Ensemble>::iterator begin, std::vector<Ensemble>::iterator end) {
  for (auto speech = begin; speech != end; ++speech) {
    const bool lacks = lacks_pointing(*speech);
    const auto rest = std::stable_partition(std::next(speech), end, [&](const Ensemble& each) {
      return (lacks || each.percept.before_words) && is_shown_during(each.percept, speech->percept);
    });
    std::rotate(speech, std::next(speech), rest);
    speech = std::prev(rest);
  }
}

}  // namespace

bool is_shown_with(const Percept& percept, const Percept& speech, const FusionWindow& window) {
  const bool is_pair = percept.event.modality == Modality::gesture && speech.event.modality == Modality::speech;
  if (!is_pair || window.pause_s == 0 || is_by_itself(percept)) return false;
  return speech.event.t <= words_come_until(percept, window) && percept.event.t <= told_end(speech);
}

bool Fusion::is_too_late(SimTime t, SimTime now) const { return t + SimTime::from_seconds(latest_s()) < now; }

bool Fusion::receive(Percept percept, SimTime now) {
  if (is_too_late(percept.event.t, now)) return false;
  arrive(std::move(percept));
  return true;
}

bool Fusion::sample(const InputEvent& event, int serial, SimTime now) {
  if (is_too_late(event.t, now)) return false;
  arrive(Sample{event, serial});
  return true;
}

void Fusion::arrive(Arrival arrival) {
  const auto key = [](const Arrival& each) {
    if (const auto* percept = std::get_if<Percept>(&each)) return order(*percept);
    return std::tuple(std::get<Sample>(each).event.t, 0, 0);
  };
  const auto after = std::upper_bound(arrived_.begin(), arrived_.end(), arrival,
                                      [&](const Arrival& a, const Arrival& b) { return key(a) < key(b); });
  arrived_.insert(after, std::move(arrival));
}

std::vector<Ensemble> Fusion::release(SimTime now, const Joining& joining) {
  std::vector<Ensemble> released;
  const SimTime until = now - lateness();
  for (;;) {
    const auto complete = next_complete();
    const auto next = next_arrival();
    if (next && *next <= until && (!complete || *next <= *complete))
      process_next(joining);
    else if (complete && *complete <= until)
      now_ = std::max(now_, *complete);
    else
      break;
    const auto earlier = static_cast<std::ptrdiff_t>(released.size());
    while (release_first(released)) {
    }
    put_whole_words_first(std::next(released.begin(), earlier), released.end(), window_);
    put_shown_first(std::next(released.begin(), earlier), released.end());
  }
  now_ = std::max(now_, until);
  return released;
}

// Processes all arrivals of the earliest time.
void Fusion::process_next(const Joining& joining) {
  const SimTime t = *next_arrival();
  now_ = std::max(now_, t);
  while (next_arrival() == t) {
    Arrival arrival = std::move(arrived_.front());
    arrived_.erase(arrived_.begin());
    if (const auto* sample = std::get_if<Sample>(&arrival)) {
      track_.add(sample->event, sample->serial);
      continue;
    }
    auto& percept = std::get<Percept>(arrival);
    if (percept.deixis) gestures_.push_back(*percept.deixis);
    if (joining && percept.event.modality == Modality::speech) percept = joined(std::move(percept), joining);
    const auto after = std::upper_bound(waiting_.begin(), waiting_.end(), percept,
                                        [](const Percept& a, const Percept& b) { return order(a) < order(b); });
    waiting_.insert(after, std::move(percept));
  }
  forget();
}

// Joins speech with the unfinished sentence that waits for it, if there is one.
Percept Fusion::joined(Percept speech, const Joining& joining) {
  const auto parts = plan().parts;
  std::size_t i = waiting_.size();
  const auto goes_on = [&](const Percept& first, const Plan::Part& part) {
    return first.event.modality == Modality::speech && waits_for_words(first, window_) &&
           speech.event.t <= last_piece(first, part.bound, window_);
  };
  while (i > 0 && !goes_on(waiting_[i - 1], parts[i - 1])) --i;
  if (i == 0) return speech;
  auto whole = joining(waiting_[i - 1], speech);
  if (!whole) return speech;
  waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i - 1));
  return *std::move(whole);
}

std::optional<SimTime> Fusion::next_arrival() const {
  if (arrived_.empty()) return std::nullopt;
  if (const auto* percept = std::get_if<Percept>(&arrived_.front())) return percept->event.t;
  return std::get<Sample>(arrived_.front()).event.t;
}

// Binds pointings to the takers of waiting speech. Pointings come from waiting_, released_ and the track, in this
// order.
Fusion::Plan Fusion::plan() const {
  // Collects takers, and the waiting pointings with their index in `waiting_` (`from`).
  Plan plan;
  plan.parts.resize(waiting_.size());
  std::vector<std::tuple<Taker, std::size_t, std::size_t>> takers;  // each with its percept and its place in it
  std::vector<Deixis> pointings;
  std::vector<std::size_t> from;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    plan.parts[i].bound.resize(waiting_[i].takers.size());
    for (std::size_t k = 0; k < waiting_[i].takers.size(); ++k) takers.emplace_back(waiting_[i].takers[k], i, k);
    if (!waiting_[i].deixis) continue;
    from.push_back(i);
  }
  // Assigns the pointings of all sources; a waiting pointing with a taker is taken.
  if (!takers.empty()) {
    std::stable_sort(takers.begin(), takers.end(), [](const auto& a, const auto& b) {
      return std::tie(std::get<0>(a).from, std::get<0>(a).until) < std::tie(std::get<0>(b).from, std::get<0>(b).until);
    });
    const auto all = track_.fixations(ever.from, ever.until);
    for (const auto i : from) pointings.push_back(dwelling(*waiting_[i].deixis, all));
    for (const auto& each : released_) pointings.push_back(dwelling(each, all));
    for (const auto& each : all)
      if (!is_of_gesture(each)) pointings.push_back(each);
    std::vector<Taker> bare;
    for (const auto& each : takers) bare.push_back(std::get<0>(each));
    const auto assigned = assign(bare, pointings, window_);
    for (std::size_t t = 0; t < assigned.size(); ++t) {
      if (!assigned[t]) continue;
      const auto& [taker, i, k] = takers[t];
      plan.parts[i].bound[k] = pointings[*assigned[t]];
      if (*assigned[t] < from.size()) plan.parts[from[*assigned[t]]].taken = true;
    }
  }
  // With these bindings each percept, except taken pointings, has a time at which it is complete.
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const auto& percept = waiting_[i];
    auto& part = plan.parts[i];
    if (percept.deixis) {
      if (!part.taken) part.complete = pointed_at(percept, waiting_, window_);
    } else {
      part.complete = percept.event.modality == Modality::speech ? complete_at(percept, part.bound, window_)
                                                                 : shown_at(percept, waiting_, window_);
    }
  }
  return plan;
}

// The gesture, with what the samples of its hand have told of it so far.
Deixis Fusion::dwelling(const Deixis& gesture, const std::vector<Deixis>& fixations) const {
  Deixis deixis = with_dwell(gesture, fixations);
  deixis.followed = gesture.begun && track_.follows(gesture);
  return deixis;
}

bool Fusion::is_of_gesture(const Deixis& fixation) const {
  return std::any_of(gestures_.begin(), gestures_.end(),
                     [&](const Deixis& gesture) { return is_part_of(fixation, gesture); });
}

std::optional<SimTime> Fusion::next_complete() const {
  std::optional<SimTime> next;
  for (const auto& part : plan().parts)
    if (part.complete && (!next || *part.complete < *next)) next = part.complete;
  return next;
}

// Releases the first complete percept, and the percepts that it releases.
bool Fusion::release_first(std::vector<Ensemble>& released) {
  const auto parts = plan().parts;
  const auto is_complete = [&](const Plan::Part& part) { return part.complete && *part.complete <= now_; };
  const auto first = std::find_if(parts.begin(), parts.end(), is_complete);
  if (first == parts.end()) return false;
  const auto words = static_cast<std::size_t>(first - parts.begin());
  // Gestures that were shown with the words, and that are complete with them, follow at once.
  std::vector<int> shown;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (is_complete(parts[i]) && is_shown_with(waiting_[i], waiting_[words], window_))
      shown.push_back(waiting_[i].serial);
  release_up_to(words, parts, released);
  for (const int serial : shown) {
    const auto gesture =
        std::find_if(waiting_.begin(), waiting_.end(), [&](const Percept& each) { return each.serial == serial; });
    if (gesture != waiting_.end())
      release_up_to(static_cast<std::size_t>(gesture - waiting_.begin()), plan().parts, released);
  }
  return true;
}

void Fusion::release_up_to(std::size_t last, const std::vector<Plan::Part>& parts, std::vector<Ensemble>& released) {
  const bool by_pointing = waiting_[last].deixis.has_value(), by_sample = is_sample(waiting_[last]);
  std::vector<Deixis> taken;
  std::vector<Percept> still;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    auto& percept = waiting_[i];
    const bool is_being_said = percept.event.modality == Modality::speech && now_ < told_end(percept);
    const bool kept = by_sample || is_being_said || (percept.deixis ? parts[i].taken : by_pointing);
    const bool stays = i > last || (i < last && kept);
    if (stays) {
      still.push_back(std::move(percept));
      continue;
    }
    for (const auto& pointing : parts[i].bound)
      if (pointing) taken.push_back(*pointing);
    if (percept.deixis) {
      percept.deixis = with_dwell(*percept.deixis, track_.fixations(ever.from, ever.until));
      percept.event.target_W = percept.deixis->place_W;
      released_.push_back(*percept.deixis);
    }
    released.push_back({std::move(percept), parts[i].bound, now_});
  }
  waiting_ = std::move(still);
  for (const auto& pointing : taken) take(pointing);
}

void Fusion::take(const Deixis& pointing) {
  if (!pointing.gesture || pointing.samples > 1) track_.forget(pointing);
  if (!pointing.gesture) return;
  const auto is_it = [&](const Deixis& each) { return each.serials.front() == pointing.serials.front(); };
  std::erase_if(released_, is_it);
  std::erase_if(waiting_, [&](const Percept& each) { return each.deixis && is_it(*each.deixis); });
}

// Forgets pointings and samples that no word can go with any more.
void Fusion::forget() {
  SimTime first = now_;
  for (const auto& percept : waiting_) {
    if (percept.event.modality == Modality::speech) first = std::min(first, percept.event.t);
    for (const auto& taker : percept.takers) first = std::min(first, taker.from);
  }
  const SimTime before = first - SimTime::from_seconds(window_.before_s);
  const auto is_over = [&](const Deixis& each) { return each.until < before; };
  std::erase_if(released_, is_over);
  std::erase_if(gestures_, is_over);
  track_.forget_before(before - SimTime::from_seconds(longest_dropout_s));
}

std::vector<Ensemble> Fusion::release_all(const Joining& joining) {
  std::vector<Ensemble> released;
  while (next_arrival()) process_next(joining);
  while (!waiting_.empty()) {
    const auto parts = plan().parts;
    const auto first = std::find_if(parts.begin(), parts.end(), [](const Plan::Part& part) { return !part.taken; });
    release_up_to(static_cast<std::size_t>(first - parts.begin()), parts, released);
  }
  put_whole_words_first(released.begin(), released.end(), window_);
  put_shown_first(released.begin(), released.end());
  return released;
}

bool Fusion::waits(int serial) const {
  const auto is_up_to = [&](const Percept& percept) {
    return std::min(percept.serial, percept.pieces.empty() ? percept.serial : percept.pieces.front()) <= serial;
  };
  return std::any_of(waiting_.begin(), waiting_.end(), is_up_to) ||
         std::any_of(arrived_.begin(), arrived_.end(), [&](const Arrival& arrival) {
           const auto* percept = std::get_if<Percept>(&arrival);
           return percept && is_up_to(*percept);
         });
}

std::optional<SimTime> Fusion::due() const {
  std::optional<SimTime> due = next_complete();
  for (const auto& arrival : arrived_)
    if (const auto* percept = std::get_if<Percept>(&arrival)) {
      due = std::min(due.value_or(percept->event.t), percept->event.t);
      break;
    }
  if (due) due = *due + lateness();
  return due;
}

}  // namespace continua
