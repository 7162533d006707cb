// The form of something seen as a vector of numbers, such as a recogniser's embedding of a gesture, and the distance of
// two such vectors.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace continua {

/// An immutable value; copies share the numbers. Empty: nothing is known of the form.
class Shape {
 public:
  Shape() = default;
  /// REQUIRES finite numbers.
  explicit Shape(std::vector<double> numbers)
      : numbers_(numbers.empty() ? nullptr : std::make_shared<const std::vector<double>>(std::move(numbers))) {}

  bool empty() const { return !numbers_; }
  std::size_t size() const { return numbers_ ? numbers_->size() : 0; }
  /// REQUIRES !empty().
  const std::vector<double>& numbers() const { return *numbers_; }
  bool operator==(const Shape& other) const;

 private:
  std::shared_ptr<const std::vector<double>> numbers_;
};

/// The relative distance |a - b| / max(|a|, |b|): 0 for equal vectors, at most 2. Rounded to a millionth, so that the
/// last bits of floating point decide nothing. REQUIRES two shapes of one size.
///
/// Embeddings come in any scale, so the distance has none: one limit serves all recognisers. Vectors of one length are
/// ordered as by their cosine. Unlike the cosine it tells vectors of one direction apart, and vectors of one number.
double distance(const Shape& a, const Shape& b);

/// Limits for the recognition of a shape by its distance to known ones.
struct ShapeLimits {
  double farthest = 0.4;  ///< a shape farther than this from every known one is unknown; 0 … 2
  /// The share by which the nearest known shape must be nearer than the nearest one with another meaning; 0 … 1.
  double margin = 0.25;
};

}  // namespace continua
