// Laws of fusion, for any events in any order of arrival.
#include <algorithm>
#include <map>
#include <set>

#include "perception/pointing_samples.h"
#include "perception/talk.h"
#include "support/catch.h"
#include "term/law.h"

using namespace continua;

namespace {

// Times in tenths of a second; many things happen at one time.
struct Happening {
  std::vector<Percept> percepts;
  std::vector<InputEvent> samples;
};

int tenths(int from, int until) { return *rc::gen::inRange(from, until + 1); }

Percept any_percept(int serial) {
  const double t = tenths(0, 60) / 10.0;
  const std::string hand = *rc::gen::element(std::string("left"), std::string("right"));
  const int what = tenths(0, 4);
  if (what == 0) return gesture(serial, t, "posack", -1, hand);
  if (what <= 2) return gesture(serial, t, "point", tenths(0, 1) == 0 ? -1 : t + tenths(0, 15) / 10.0, hand);
  std::vector<Said> said;
  double from = t;
  for (int words = tenths(1, 4); words > 0; --words) {
    const double until = from + tenths(1, 4) / 10.0;
    said.push_back({*rc::gen::element(std::string("that"), std::string("there"), std::string("cup"), std::string("go")),
                    from, until});
    from = until;
  }
  return speech(serial, t, said, tenths(0, 1) == 0);
}

Happening any_happening() {
  Happening happening;
  for (int n = tenths(1, 8), serial = 1; serial <= n; ++serial) happening.percepts.push_back(any_percept(serial));
  for (int n = tenths(0, 2); n > 0; --n) {
    const double from = tenths(0, 60) / 10.0, x = tenths(-5, 5) / 10.0;
    const std::string hand = n == 1 ? "left" : "right";
    for (int i = tenths(0, 20); i >= 0; --i) happening.samples.push_back(sample_at(from + 0.05 * i, x, 0, hand));
  }
  return happening;
}

// All events, each arriving after its own delay; a release at each arrival, and every `every_s` in between.
std::vector<Ensemble> told(const Happening& happening, const std::vector<int>& delays_ms, const FusionWindow& window,
                           double every_s) {
  std::map<SimTime, std::vector<std::size_t>> arrivals;
  const auto& [percepts, samples] = happening;
  for (std::size_t i = 0; i < percepts.size() + samples.size(); ++i) {
    const SimTime t = i < percepts.size() ? percepts[i].event.t : samples[i - percepts.size()].t;
    arrivals[t + SimTime{delays_ms[i] * 1000}].push_back(i);
  }
  for (double t = 0; every_s > 0 && t < 20; t += every_s) arrivals[at(t)];
  Fusion fusion(window, around_table);
  std::vector<Ensemble> all;
  const auto release = [&](SimTime now) {
    for (auto& each : fusion.release(now)) all.push_back(std::move(each));
  };
  for (const auto& [now, indices] : arrivals) {
    for (const auto i : indices) {
      if (i < percepts.size())
        RC_ASSERT(fusion.receive(percepts[i], now));
      else
        RC_ASSERT(fusion.sample(samples[i - percepts.size()], static_cast<int>(1000 + i), now));
    }
    release(now);
  }
  while (const auto due = fusion.due()) release(*due);
  return all;
}

std::vector<int> delays(const Happening& happening, int most_ms) {
  std::vector<int> all;
  for (std::size_t i = 0; i < happening.percepts.size() + happening.samples.size(); ++i)
    all.push_back(most_ms == 0 ? 0 : *rc::gen::inRange(0, most_ms + 1));
  return all;
}

// The end of the words; the beginning of anything else.
SimTime said_by(const Percept& percept) {
  const auto& event = percept.event;
  return event.modality == Modality::speech ? std::max(event.t, event.until.value_or(event.t)) : event.t;
}

const FusionWindow in_order = {2, 1, 0}, late = {2, 1, 0.5}, expectant = {2, 1, 0, 1, 0.4},
                   late_expectant = {2, 1, 0.5, 1, 0.4};

}  // namespace

TEST_CASE("what comes out depends on when things happened alone", "[law]") {
  law("delays within the lateness change nothing", [] {
    const auto happening = any_happening();
    const auto prompt = brief(told(happening, delays(happening, 0), late, 0));
    RC_ASSERT(brief(told(happening, delays(happening, 500), late, 0)) == prompt);
    RC_ASSERT(brief(told(happening, delays(happening, 500), late, 0.3)) == prompt);
  });
  law("without lateness it is the same", [] {
    const auto happening = any_happening();
    const auto prompt = brief(told(happening, delays(happening, 0), in_order, 0));
    RC_ASSERT(brief(told(happening, delays(happening, 0), in_order, 0.07)) == prompt);
    RC_ASSERT(brief(told(happening, delays(happening, 500), late, 0)) == prompt);
  });
  law("neither where gestures wait for words", [] {
    const auto happening = any_happening();
    const auto prompt = brief(told(happening, delays(happening, 0), expectant, 0));
    RC_ASSERT(brief(told(happening, delays(happening, 0), expectant, 0.07)) == prompt);
    RC_ASSERT(brief(told(happening, delays(happening, 500), late_expectant, 0.3)) == prompt);
  });
}

TEST_CASE("nothing is lost, doubled or bound twice", "[law]") {
  law("percepts", [] {
    const auto happening = any_happening();
    const auto all = told(happening, delays(happening, 0), in_order, 0);
    std::multiset<int> released, taken;
    std::set<int> either;
    for (const auto& each : all) {
      released.insert(each.percept.serial);
      either.insert(each.percept.serial);
      RC_ASSERT(each.bound.size() == each.percept.takers.size());
      for (const auto& bound : each.bound) {
        if (!bound) continue;
        for (const auto serial : bound->serials) taken.insert(serial);
        if (bound->gesture) either.insert(bound->serials.front());
      }
    }
    for (const auto serial : released) RC_ASSERT(released.count(serial) == 1U);
    for (const auto serial : taken) RC_ASSERT(taken.count(serial) == 1U);
    RC_ASSERT(either.size() == happening.percepts.size());
  });
}

TEST_CASE("what is bound lies in the window, in the order of the words", "[law]") {
  law("window", [] {
    const auto happening = any_happening();
    for (const auto& each : told(happening, delays(happening, 0), in_order, 0)) {
      std::optional<Deixis> before;
      for (std::size_t i = 0; i < each.bound.size(); ++i) {
        if (!each.bound[i]) continue;
        RC_ASSERT(each.bound[i]->until + at(in_order.before_s) >= each.percept.takers[i].from);
        RC_ASSERT(each.bound[i]->from <= each.percept.takers[i].until + at(in_order.after_s));
        RC_ASSERT(!before || before->from <= each.bound[i]->from);
        before = each.bound[i];
      }
    }
  });
}

TEST_CASE("release does not go back in time, nor keep what has no counterpart", "[law]") {
  law("times", [] {
    const auto happening = any_happening();
    SimTime latest{0};
    const auto all = told(happening, delays(happening, 0), in_order, 0);
    // Pointing that some word might take may be kept for it until another is better.
    const auto is_wanted = [&](const Deixis& pointing) {
      return std::any_of(all.begin(), all.end(), [&](const Ensemble& other) {
        const auto& takers = other.percept.takers;
        return std::any_of(takers.begin(), takers.end(), [&](const Taker& taker) {
          return pointing.until + at(in_order.before_s) >= taker.from &&
                 pointing.from <= taker.until + at(in_order.after_s);
        });
      });
    };
    // A gesture that begins during words may wait for their end.
    const auto is_end_of_words_around = [&](const Ensemble& gesture) {
      const auto& event = gesture.percept.event;
      return event.modality == Modality::gesture && std::any_of(all.begin(), all.end(), [&](const Ensemble& other) {
               const auto& words = other.percept.event;
               return words.modality == Modality::speech && words.t <= event.t && event.t <= said_by(other.percept) &&
                      gesture.at == said_by(other.percept);
             });
    };
    for (const auto& each : all) {
      RC_ASSERT(each.at >= latest);
      latest = each.at;
      RC_ASSERT(each.at >= each.percept.event.t);
      SimTime end = each.percept.deixis ? each.percept.deixis->until : each.percept.event.t;
      bool alone = !each.percept.deixis || !is_wanted(*each.percept.deixis);
      bool needs = each.percept.deixis.has_value();
      for (std::size_t i = 0; i < each.bound.size(); ++i) {
        if (each.percept.takers[i].needs) needs = true, end = std::max(end, each.percept.takers[i].until);
        if (each.bound[i]) alone = false;
      }
      if (needs) RC_ASSERT(each.at <= end + at(in_order.after_s) || !alone);
      if (!needs) RC_ASSERT(each.at == said_by(each.percept) || is_end_of_words_around(each));
    }
  });
}

TEST_CASE("the assignment is the best there is", "[law]") {
  // Every monotone assignment is tried.
  struct Best {
    const std::vector<Taker>& takers;
    const std::vector<Deixis>& pointings;
    std::tuple<int, int, std::int64_t> least{99, 99, 0};
    void go(std::size_t i, std::size_t j, std::tuple<int, int, std::int64_t> cost) {
      if (i == takers.size()) {
        least = std::min(least, cost);
        return;
      }
      auto without = cost;
      ++(takers[i].needs ? std::get<0>(without) : std::get<1>(without));
      go(i + 1, j, without);
      for (auto k = j; k < pointings.size(); ++k) {
        const auto &t = takers[i], p = Taker{pointings[k].from, pointings[k].until, false};
        if (p.until + at(2) < t.from || p.from > t.until + at(1)) continue;
        auto with = cost;
        std::get<2>(with) += std::max({(t.from - p.until).us, (p.from - t.until).us, std::int64_t{0}});
        go(i + 1, k + 1, with);
      }
    }
  };
  law("of all", [] {
    std::vector<Taker> takers;
    std::vector<Deixis> pointings;
    double t = 0;
    for (int n = tenths(0, 4); n > 0; --n) {
      t += tenths(0, 10) / 10.0;
      const double until = t + tenths(1, 4) / 10.0;
      takers.push_back({at(t), at(until), tenths(0, 1) == 0});
      t = until;
    }
    for (int n = tenths(0, 5); n > 0; --n) {
      Deixis pointing;
      pointing.from = at(tenths(-20, 60) / 10.0);
      pointing.until = pointing.from + at(tenths(0, 8) / 10.0);
      pointing.gesture = tenths(0, 1) == 0;
      pointing.serials = {n};
      pointings.push_back(pointing);
    }
    std::stable_sort(pointings.begin(), pointings.end(), [](const auto& a, const auto& b) {
      return std::tie(a.from, a.until, b.gesture) < std::tie(b.from, b.until, a.gesture);
    });
    Best best{takers, pointings};
    best.go(0, 0, {0, 0, 0});
    std::tuple<int, int, std::int64_t> cost{0, 0, 0};
    const auto assigned = assign(takers, pointings, in_order);
    for (std::size_t i = 0; i < takers.size(); ++i) {
      if (!assigned[i]) {
        ++(takers[i].needs ? std::get<0>(cost) : std::get<1>(cost));
        continue;
      }
      const auto& p = pointings[*assigned[i]];
      std::get<2>(cost) += std::max({(takers[i].from - p.until).us, (p.from - takers[i].until).us, std::int64_t{0}});
    }
    RC_ASSERT(cost == best.least);
    // The pointings may be given in any order.
    auto shuffled = pointings;
    std::reverse(shuffled.begin(), shuffled.end());
    const auto again = assign(takers, shuffled, in_order);
    for (std::size_t i = 0; i < takers.size(); ++i) {
      RC_ASSERT(assigned[i].has_value() == again[i].has_value());
      if (again[i]) RC_ASSERT(pointings[*assigned[i]].serials == shuffled[*again[i]].serials);
    }
  });
}
