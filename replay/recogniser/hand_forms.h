// The forms of a hand that are gestures, by data: knowledge/hand_forms.json (RECOGNISERS.md, Hands).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/world/geometry.h"

namespace continua {

/// The points of a hand as MediaPipe numbers them, in metres: x to the right of the picture, y down, z away from the
/// camera, from any origin. A hand has 21.
using HandPoints = std::vector<Vec3>;
inline constexpr std::size_t points_of_hand = 21;

/// A stretched finger points from its knuckle to its tip.
struct Finger {
  const char* name;
  std::size_t knuckle, joint, tip;  ///< numbers of points
  std::size_t from;  ///< the finger is the more stretched the further its tip is from here than its joint
};

struct HandForm {
  struct Bound {
    std::size_t measure;
    double least, most;
  };
  std::string name;  ///< of the gesture
  std::vector<Bound> bounds;
  const Finger* pointer = nullptr;  ///< the finger that points; null: the form points at nothing
};

class HandForms {
 public:
  explicit HandForms(std::vector<HandForm> forms) : forms_(std::move(forms)) {}
  /// The first form whose measures are all within their bounds; null: none, or the points are no hand's.
  const HandForm* find(const HandPoints& points) const;
  std::size_t size() const { return forms_.size(); }

 private:
  std::vector<HandForm> forms_;
};

/// Errors: of the file, with the place; an example that has another form than it says.
Result<HandForms> read_hand_forms(std::string_view text, const std::string& path);
/// All that is wrong with the text.
std::vector<Error> hand_form_problems(std::string_view text, const std::string& path);

}  // namespace continua
