// The gestures that the engine knows: data (engine/knowledge/gestures, GESTURES.md beside this file).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "perception/input_event.h"

namespace continua {

/// One gesture, whatever hand makes it.
struct GestureEntry {
  std::string name;   ///< as recognisers tell it: point, posack, grab
  std::string about;  ///< for people: what it looks like and says
  std::string kind;   ///< what kind of move it is: δ ω α y n, or another that machines know (engage, disengage)
  /// What it says, in the project's notation, by direction; "" is the key of the meaning without one. Iconic gestures
  /// have one: grab → \x: e. grasp(x), push left → \x: e. slide(x, left(x)), a cupped hand → \x: e. cup(x).
  std::map<std::string, std::string, std::less<>> meanings;
  std::vector<std::string> acts_on;  ///< phases that make it a move: start and stroke, unless the file says otherwise
};

struct GestureCatalogue {
  std::string name, path, digest;
  std::map<std::string, GestureEntry, std::less<>> entries;

  const GestureEntry* find(std::string_view gesture) const;
};

/// The error is the first of check_gestures.
Result<GestureCatalogue> read_gestures(std::string_view text, const std::string& path);

/// All that is wrong with a file: line, what was found, what was expected, the nearest name.
std::vector<Error> check_gestures(std::string_view text, const std::string& path);

}  // namespace continua
