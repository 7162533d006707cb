// The symbol under which a machine knows an event, and the kind of move that the event is.
#pragma once

#include <optional>
#include <string>

#include "continua/automaton/machine.h"
#include "continua/learning/learning.h"
#include "continua/learning/shapes.h"
#include "continua/perception/gesture.h"
#include "continua/perception/input_event.h"

namespace continua {

/// Where the meaning of a gesture comes from. A gesture goes by its name if a lesson or the catalogue has it, else by
/// its shape. The end of a gesture has no taught meaning.
struct KnownGesture {
  const Term* taught = nullptr;         ///< the meaning that the human taught
  std::string lesson;                   ///< the name under which it was taught
  const GestureEntry* entry = nullptr;  ///< of the catalogue, if it was not taught
  std::optional<Recognition> shape;     ///< if it was looked for by its shape

  /// Whether it is understood before the words during which it is shown.
  bool comes_before_words() const { return !taught && entry && entry->before_words; }
};

/// Both must outlive the result. `gestures`: nullptr: gestures are known by their names, and nothing is found.
KnownGesture known_gesture(const InputEvent& event, const GestureCatalogue* gestures, const Learned& learned);

/// A taught gesture is a move that shows an action, or an object if it means one. `gestures`: nullptr: gestures are
/// known by their names.
std::string symbol_of(const InputEvent& event, const GestureCatalogue* gestures, const Learned& learned);

/// By the machine's table of moves, else by lessons and catalogue; empty if the event alone is not a move.
std::string kind_of(const InputEvent& event, const Machine& machine, const GestureCatalogue* gestures,
                    const Learned& learned);

}  // namespace continua
