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

TEST_CASE("an instant is read as it is told") {
  for (const double seconds : {0.0, 4.1, 63.708, 59.999, 726.0}) CHECK(seconds_of(time_text(seconds)) == seconds);
  CHECK(seconds_of("1:5") == 65);
  for (const char* other :
       {"", "5", ":05", "1:", "1:60", "1:-1", "-1:05", "1:02:03", "1:.5", "a:05", "1:1e1", " 1:05"}) {
    CAPTURE(other);
    CHECK_FALSE(seconds_of(other));
  }
}
