// The gestures that the engine knows: data (engine/knowledge/gestures, described in perception/GESTURES.md).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/perception/input_event.h"

namespace continua {

/// A gesture of either hand.
struct GestureEntry {
  std::string name;   ///< the recognisers' name: point, posack, grab
  std::string about;  ///< for people: its look and meaning
  std::string kind;   ///< its kind of move: δ ω α y n, or another that machines know (engage, stop)
  /// Its meanings by direction, in the project's notation; the key "" has the meaning without a direction. Iconic
  /// gestures have meanings: grab → \x: e. grasp(x), push left → \x: e. slide(x, left(x)), a cupped hand → \x: e.
  /// cup(x).
  std::map<std::string, std::string, std::less<>> meanings;
  std::vector<std::string> acts_on;  ///< phases that make it a move: start and stroke, unless the file says otherwise
  bool before_words = false;         ///< shown during words, it is understood before them
  std::string where;                 ///< place in the file, "path:line:column"

  /// The meaning in this direction, else the meaning without a direction; nullptr if there is none.
  const std::string* meaning(std::string_view direction) const;
  /// Whether this phase of the gesture is a move. A gesture without a phase was seen as a whole and is one.
  bool acts(std::string_view phase) const;
};

struct GestureCatalogue {
  std::string name, path, digest;
  std::string lexicon;  ///< the lexicon for the words in meanings when the file is checked alone; may be empty
  std::size_t examples = 0;
  ShapeLimits shapes;  ///< for taught gestures that are known by their shape
  std::map<std::string, GestureEntry, std::less<>> entries;

  const GestureEntry* find(std::string_view gesture) const;
};

/// The symbol of the event for machines with a catalogue: "gesture δ", "gesture α", "gesture unknown" without an entry;
/// for a phase that is not a move, with the phase: "gesture δ stop".
std::string gesture_symbol(const InputEvent& event, const GestureEntry* entry);

/// Reads a file of gestures. The error is the first of check_gestures().
Result<GestureCatalogue> read_gestures(std::string_view text, const std::string& path);

/// All problems of a file, with place, found and expected text and the nearest name; examples that do not hold are
/// problems too. Meanings are checked elsewhere, with the words of a lexicon (knowledge_files/language_loading.h).
std::vector<Error> check_gestures(std::string_view text, const std::string& path);

}  // namespace continua
