#include "continua/language/misspelling.h"

#include <support/catch.h>

using namespace continua;

TEST_CASE("the one mistake that leads from one word to another") {
  CHECK(slip("teh", "the") == Slip::exchanged);
  CHECK(slip("lfet", "left") == Slip::exchanged);
  CHECK(slip("blok", "block") == Slip::missing);
  CHECK(slip("yelow", "yellow") == Slip::missing);
  CHECK(slip("kni", "knife") == Slip::none);
  CHECK(slip("putt", "put") == Slip::added);
  CHECK(slip("read", "red") == Slip::added);
  CHECK(slip("nife", "knife") == Slip::first);
  CHECK(slip("tthe", "the") == Slip::added);
  CHECK(slip("xthe", "the") == Slip::first);
  CHECK(slip("clock", "block") == Slip::replaced);
  CHECK(slip("cup", "cup") == Slip::none);
  CHECK(slip("", "") == Slip::none);
  CHECK(slip("a", "") == Slip::first);
  CHECK(slip("plait", "plate") == Slip::none);
}
