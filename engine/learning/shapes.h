// Taught gestures recognised by their shape (paper §4, one-shot learning): the nearest exemplar decides, if it is near
// enough and no exemplar with another meaning is about as near.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "continua/core/shape.h"
#include "continua/learning/learning.h"

namespace continua {

/// A taught gesture and the distance of its nearest exemplar.
struct Likeness {
  std::string gesture;
  double distance = 0;
};

struct Recognition {
  enum class Verdict { named, recognised, too_far, contested, nothing_known };
  Verdict verdict = Verdict::nothing_known;
  std::optional<Likeness> nearest;
  std::optional<Likeness> rival;    ///< the nearest gesture with another meaning
  std::size_t of_other_length = 0;  ///< exemplars of another length: another space, so there is no distance
  std::string reason;               ///< a sentence for people: by which exemplar, or why by none
};

/// The account of a gesture that goes by its name: the distance of its own nearest exemplar, if it has any.
Recognition by_name(const std::string& gesture, const Shape& shape, const Learned& learned);

/// Compares the shape with the exemplars of all taught gestures. Equal distances: the first name counts.
/// REQUIRES !shape.empty().
Recognition recognise(const Shape& shape, const Learned& learned, const ShapeLimits& limits);

/// The gestures that a lesson about this one is about too: those of the same meaning with an exemplar that is
/// recognised by one of its exemplars. The gesture itself comes first.
std::vector<std::string> of_one_shape(const std::string& gesture, const Learned& learned, const ShapeLimits& limits);

/// The latest gestures that were shown with a shape. A lesson may follow, and makes an exemplar of the shape.
class ShownShapes {
 public:
  /// The older ones are no longer spoken of.
  static constexpr std::size_t most = 32;

  /// A name for a gesture that the recogniser gives none: the name of the exemplar or the shown gesture with exactly
  /// this shape, else one that no lesson has and that `is_taken` does not know.
  std::string name_for(const Shape& shape, const Learned& learned,
                       const std::function<bool(std::string_view)>& is_taken);
  void add(const std::string& name, const Shape& shape);
  /// The latest shape of this name; empty if there is none.
  Shape find(std::string_view name) const;

 private:
  std::vector<std::pair<std::string, Shape>> shown_;
  int named_ = 0;  ///< number of names given
};

}  // namespace continua
