// Ids, places, gestures and programs as people say them.
#include "continua/replay/log/run_words.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("programs, places and gestures are told in words, and what is not known as it is") {
  const RunWords words(
      R"(<custom><text name="b1" data="type=block color=red"/><text name="b2" data="type=block color=red"/>
      <text name="b3" data="type=block color=black"/><text data="type=cup" name="mug"/></custom>)");
  struct Case {
    const char* term;
    const char* told;
  };
  const Case cases[] = {
      {"put(b3, on(mug))", "puts the black block on the cup"},
      {"grasp(b1)", "takes the red block (b1)"},
      {"put(b3, <-0.262672, 0.050662, 0.0012>)",
       "puts the black block 26 cm left of and 5 cm beyond the table's middle"},
      {"reach(<0, -0.1, 0>)", "reaches to 10 cm before the table's middle"},
      {"put(b3, <0.001, 0, 0>)", "puts the black block in the table's middle"},
      {"slide(b3, left(b3))", "slides the black block to the left"},
      {"put(b3, left(mug))", "puts the black block left of the cup"},
      {"put(b3, was(b3))", "puts the black block back"},
      {"put(b3, between(b1, mug))", "puts the black block between the red block (b1) and the cup"},
      {"put(b3)", "puts the black block"},
      {"HEAD_NOD", "nods"},
      {"zork(b3)", "zork(b3)"},
      {"\\x. grasp(x)", "\\x. grasp(x)"},
      {"[b3, mug]", "[the black block, the cup]"},
      {"[[b3, mug], [b1]]", "[[the black block, the cup], [the red block (b1)]]"},
      {"[]", "[]"},
      {"put", "put"},
      {"stop", "stops"},
      {"put(b3, <a, b>)", "puts the black block <a, b>"},
      {"", ""},
  };
  for (const auto& [term, told] : cases) {
    CAPTURE(term);
    CHECK(words.term(term) == told);
  }
  CHECK(words.gesture("posack", "") == "yes");
  CHECK(words.gesture("grab_move", "left") == "carry left");
  CHECK(words.gesture("two_fingers", "") == "two fingers");
  CHECK(words.reason("not white(b3)", "b3") == "not white");
  CHECK(words.reason("not white(b3)", "mug") == "not white(b3)");
  CHECK(words.reason("not on(b3, mug)", "mug") == "not on(b3, mug)");
  CHECK(words.missing("loc") == "the place");
  const auto raw = RunWords::raw();
  CHECK(raw.term("put(b3, on(mug))") == "put(b3, on(mug))");
  CHECK(raw.gesture("posack", "") == "posack");
}
