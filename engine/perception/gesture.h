// The gestures that the engine knows: data (engine/knowledge/gestures, GESTURES.md beside this file).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/perception/input_event.h"

namespace continua {

/// One gesture, by either hand.
struct GestureEntry {
  std::string name;   ///< as recognisers tell it: point, posack, grab
  std::string about;  ///< for people: its look and meaning
  std::string kind;   ///< the kind of move: δ ω α y n, or another that machines know (engage, stop)
  /// Its meaning, in the project's notation, by direction; "" is the key of the meaning without one. Iconic gestures
  /// have one: grab → \x: e. grasp(x), push left → \x: e. slide(x, left(x)), a cupped hand → \x: e. cup(x).
  std::map<std::string, std::string, std::less<>> meanings;
  std::vector<std::string> acts_on;  ///< phases that make it a move: start and stroke, unless the file says otherwise
  std::string where;                 ///< of the file, "path:line:column"

  /// The meaning in this direction, else the one without direction; null if there is neither.
  const std::string* meaning(std::string_view direction) const;
  /// Whether this phase of it is a move; a gesture without phases was seen as a whole.
  bool acts(std::string_view phase) const;
};

struct GestureCatalogue {
  std::string name, path, digest;
  std::string lexicon;  ///< whose words the meanings are made of, for who checks the file alone; may be empty
  std::size_t examples = 0;
  std::map<std::string, GestureEntry, std::less<>> entries;

  const GestureEntry* find(std::string_view gesture) const;
};

/// The symbol of the event for machines that know gestures by their meanings: "gesture δ", "gesture α", "gesture
/// unknown" where there is no entry; of a phase that is no move, with the phase: "gesture δ stop".
std::string gesture_symbol(const InputEvent& event, const GestureEntry* entry);

/// The error is the first of check_gestures.
Result<GestureCatalogue> read_gestures(std::string_view text, const std::string& path);

/// All problems of a file, each with line, found, expected and the nearest name; false examples are among them. The
/// caller checks meanings as terms, since it knows the words that they are made of
/// (knowledge_files/language_loading.h).
std::vector<Error> check_gestures(std::string_view text, const std::string& path);

}  // namespace continua
