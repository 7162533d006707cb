// Short notation for events and the ensembles made of them, for tests of fusion; times in seconds.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "continua/perception/fusion.h"

namespace continua {

inline SimTime at(double t_s) { return SimTime::from_seconds(t_s); }

/// A word; this, that, here and there need a pointing, "cup" takes one where there is one.
struct Said {
  std::string text;
  double from_s, until_s;
};

inline Percept speech(int serial, double t_s, const std::vector<Said>& said, bool timed = true) {
  Percept percept;
  percept.serial = serial;
  percept.event.t = at(t_s);
  for (const auto& [text, from_s, until_s] : said) {
    percept.event.text += (percept.event.text.empty() ? "" : " ") + text;
    if (timed) percept.event.until = at(until_s);
    const bool needs = text == "that" || text == "there" || text == "here" || text == "this";
    if (needs || text == "cup") percept.takers.push_back({at(from_s), at(until_s), needs});
  }
  return percept;
}

inline Percept gesture(int serial, double t_s, const std::string& name, double until_s = -1,
                       const std::string& hand = "right") {
  Percept percept;
  percept.serial = serial;
  percept.event.t = at(t_s);
  percept.event.modality = Modality::gesture;
  percept.event.name = name;
  percept.event.hand = hand;
  if (until_s >= 0) percept.event.until = at(until_s);
  if (name == "point") percept.event.target_W = Vec3(0.01 * serial, 0, 0);
  percept.deixis = deixis_of(percept.event, serial);
  return percept;
}

/// "1.80 put it there [4]": time, words, and the serials of each taker's pointings; of fixations their times.
inline std::string brief(const Ensemble& ensemble) {
  const auto& event = ensemble.percept.event;
  std::string text = fmt::format("{:.2f} {}", ensemble.at.seconds(), event.text.empty() ? event.name : event.text);
  for (const auto& bound : ensemble.bound) {
    if (!bound)
      text += " [-]";
    else if (bound->gesture)
      text += fmt::format(" [{}]", bound->serials.front());
    else
      text += fmt::format(" [{:.2f}-{:.2f} {}]", bound->from.seconds(), bound->until.seconds(), bound->hand);
  }
  return text;
}

inline std::string brief(const std::vector<Ensemble>& ensembles) {
  std::string text;
  for (const auto& each : ensembles) text += (text.empty() ? "" : "; ") + brief(each);
  return text;
}

}  // namespace continua
