// The distance of shapes.
#include "continua/core/shape.h"

#include <limits>

#include "support/catch.h"

using namespace continua;

namespace {

double apart(std::vector<double> a, std::vector<double> b) {
  return distance(Shape(std::move(a)), Shape(std::move(b)));
}

}  // namespace

TEST_CASE("the distance of shapes is relative to their size, and the same in both directions") {
  CHECK(apart({1, 2, 3}, {1, 2, 3}) == 0);
  CHECK(apart({1, 0}, {-1, 0}) == 2);
  CHECK(apart({1}, {2}) == 0.5);
  CHECK(apart({2}, {1}) == 0.5);
  CHECK(apart({100}, {200}) == 0.5);
  CHECK(apart({1, 0}, {0, 1}) == Approx(1.414214));
  CHECK(apart({0, 0}, {0, 0}) == 0);
  CHECK(apart({0, 0}, {0, 5}) == 1);
}

TEST_CASE("numbers of any size have a distance") {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  CHECK(apart({most, 0}, {-most, 0}) == 2);
  CHECK(apart({most, most}, {most, most}) == 0);
  CHECK(apart({least}, {0}) == 1);
  CHECK(apart({most}, {least}) == 1);
}

TEST_CASE("shapes are equal if their numbers are") {
  CHECK(Shape() == Shape(std::vector<double>{}));
  CHECK(Shape({1, 2}) == Shape({1, 2}));
  CHECK_FALSE(Shape({1, 2}) == Shape({2, 1}));
  CHECK_FALSE(Shape({1}) == Shape());
}
