#include "continua/core/digest.h"

#include "continua/core/random.h"
#include "support/catch.h"

using namespace continua;

TEST_CASE("a digest is that of XXH3-128, on every machine") {
  // The reference vectors of the algorithm for the empty text.
  CHECK(digest("") == "99aa06d3014798d86001c324468d497f");
  CHECK(digest("a").size() == 32);
  CHECK(digest("a") != digest("b"));
}

TEST_CASE("a running digest is that of the whole, wherever the pieces end") {
  const std::string text(1000, 'x');
  RunningDigest running;
  running.add(text.substr(0, 1));
  running.add("");
  running.add(text.substr(1, 700));
  CHECK(running.text() == digest(text.substr(0, 701)));  // asking does not end it
  running.add(text.substr(701));
  CHECK(running.text() == digest(text));
}

TEST_CASE("the generator is SplitMix64") {
  // The first values for seed 1234567, as published with the algorithm.
  Random random(1234567);
  CHECK(random.next() == 6457827717110365317ULL);
  CHECK(random.next() == 3203168211198807973ULL);
  Random copy = random;
  CHECK(copy.next() == random.next());
  for (int i = 0; i < 1000; ++i) {
    const double draw = random.uniform();
    CHECK((draw >= 0 && draw < 1));
  }
}
