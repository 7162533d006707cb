#include "continua/core/result.h"

#include <memory>

#include "continua/core/sim_time.h"
#include "support/catch.h"

using namespace continua;

TEST_CASE("a result holds a value or an error") {
  Result<int> seven = 7;
  CHECK(seven.ok());
  CHECK(*seven == 7);
  *seven = 8;
  CHECK(seven.value() == 8);
  const Result<int> none = Error{"f:3", "found x; expected y"};
  CHECK_FALSE(none);
  CHECK(none.error().text() == "f:3: found x; expected y");
  CHECK(Error{"", "no place"}.text() == "no place");
}

TEST_CASE("a value can be moved out of a result") {
  Result<std::unique_ptr<int>> held = std::make_unique<int>(3);
  CHECK(*std::move(held).value() == 3);
  Result<std::unique_ptr<int>> other = std::make_unique<int>(4);
  const auto moved = *std::move(other);
  CHECK(*moved == 4);
}

TEST_CASE("seconds become the nearest microsecond and back") {
  CHECK(SimTime::from_seconds(5.45347).us == 5'453'470);
  CHECK(SimTime::from_seconds(0.0000005).us == 1);
  CHECK(SimTime{1'130'000}.seconds() == 1.13);
  CHECK(SimTime{5} + SimTime{7} - SimTime{2} == SimTime{10});
}
