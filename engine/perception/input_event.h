// An event of the human's as a recogniser reported it, and its input symbol for machines.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/shape.h"
#include "continua/core/sim_time.h"
#include "continua/world/geometry.h"

namespace continua {

enum class Modality { speech, gesture, pointing, gaze };

/// A ray of a pointing or of a gaze in W: from a point along a direction (not necessarily of unit length).
struct Ray {
  Vec3 from_W = Vec3::Zero();
  Vec3 direction_W = Vec3::UnitX();
};

/// Another reading of the same signal, from an n-best list.
struct Alternative {
  std::string text;  ///< the words, or the gesture's name
  double confidence = 1;
};

/// The longest n-best list of an event; each entry is read as the whole event is.
inline constexpr std::size_t most_alternatives = 100;

struct Word {
  std::string text;
  SimTime t;
};

/// Fields that a modality does not have keep their defaults. traces/FORMAT.md describes each.
struct InputEvent {
  SimTime t;
  Modality modality = Modality::speech;
  std::string text;              ///< speech: the words
  std::string name;              ///< gesture: "point", "grab", "posack", …
  std::string hand;              ///< gesture, pointing: "left", "right" or empty
  std::string direction;         ///< gesture: "left", "up", … or empty
  std::string phase;             ///< gesture: "start", "stop", "stroke"
  Shape features;                ///< gesture: its form, by any embedding of the recogniser's; may be empty
  std::optional<Vec3> target_W;  ///< gesture, pointing, gaze: the intended point of the table
  std::optional<Ray> ray;        ///< pointing, gaze
  std::optional<SimTime> until;
  double confidence = 1;  ///< 0 … 1
  bool final = true;      ///< speech: false for words that the recogniser may still revise
  std::vector<Word> words;
  std::vector<Alternative> alternatives;
};

/// The symbol of the event for machines:
///   speech    "speech " + the words in lower case, without punctuation, with single spaces ("speech put it there")
///   gesture   "gesture" + hand + name + direction + phase, those that are present ("gesture right point start")
///   pointing  "pointing" + hand ("pointing right")
///   gaze      "gaze"
/// Speech that is not final is "interim", whatever its words.
std::string symbol_of(const InputEvent& event);

/// Symbol of speech that is not final.
inline constexpr const char* interim_symbol = "interim";

/// An event without a place that has this symbol.
InputEvent event_of(std::string_view symbol);

/// The place where the event points on the plane of the table (z = 0): its target, else the point where its ray meets
/// that plane.
std::optional<Vec3> place_of(const InputEvent& event);

/// The distance in metres from the hand or the eyes to that place; nothing without a ray or a place.
std::optional<double> distance_of(const InputEvent& event);

/// The event with the text or name and the confidence of its k-th alternative, and without further alternatives; 0 is
/// the event itself. REQUIRES k <= alternatives.size().
InputEvent alternative(const InputEvent& event, std::size_t k);

std::string name_of(Modality modality);

}  // namespace continua
