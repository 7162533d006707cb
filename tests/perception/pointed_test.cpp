#include "continua/perception/pointed.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("a pointing goes on as long as it may precede its words") {
  const FusionWindow window{2, 1, 0};
  const Pointed pointed{Vec3::Zero(), SimTime::from_seconds(10), "cup"};
  CHECK(goes_on(pointed, SimTime::from_seconds(9), window));
  CHECK(goes_on(pointed, SimTime::from_seconds(12), window));
  CHECK_FALSE(goes_on(pointed, SimTime::from_seconds(12.001), window));
}
