#include "continua/core/counted.h"

#include "support/catch.h"

namespace continua {

TEST_CASE("one thing is counted without an s") {
  CHECK(counted(0, "row") == "0 rows");
  CHECK(counted(1, "row") == "1 row");
  CHECK(counted(2, "row") == "2 rows");
}

}  // namespace continua
