#include "continua/replay/log/time_text.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("instants and lengths of time have one form") {
  CHECK(time_text(0) == "0:00");
  CHECK(time_text(4.1) == "0:04.1");
  CHECK(time_text(63.708) == "1:03.708");
  CHECK(time_text(32.99969) == "0:33");
  CHECK(time_text(59.9996) == "1:00");
  CHECK(time_text(726) == "12:06");
  CHECK(seconds_text(0.8) == "0.8 s");
  CHECK(seconds_text(2) == "2 s");
}
