#include "continua/core/local_time.h"

#include <string>

#include "support/catch.h"

using namespace continua;

TEST_CASE("times are told from other texts") {
  for (const std::string text : {"2018-02-05", "2018-02-05T13:53", "2018-02-05T13:53:17", "1999-12-31T23:59:60"}) {
    INFO(text);
    CHECK(is_local_time(text));
  }
  for (const std::string text :
       {"", "2018", "2018-2-5", "2018-02-05T", "2018-02-05 13:53", "2018-02-05T13", "2018-13-05", "2018-00-05",
        "2018-02-32", "2018-02-00", "2018-02-05T24:00", "2018-02-05T13:60", "2018-02-05T13:53:61", "2018-02-05T13:53:1",
        "2018-02-05T13:53:17Z", "-018-02-05", "2O18-02-05"}) {
    INFO(text);
    CHECK_FALSE(is_local_time(text));
  }
}
