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
      {"put(b3, beside(mug))", "puts the black block beside the cup"},
      {"where(b3)", "where the black block is"},
      {"grasp(the(\\x. white(x) and cup(x)))", "takes the white cup"},
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
  CHECK(words.missing("loc") == "the place");
  const auto raw = RunWords::raw();
  CHECK(raw.term("put(b3, on(mug))") == "put(b3, on(mug))");
  CHECK(raw.gesture("posack", "") == "posack");
}

TEST_CASE("reasons are told of the thing that was ruled out, and one without words as it is") {
  const RunWords words(
      R"(<custom><text name="b3" data="type=block color=black"/><text data="type=cup" name="mug"/></custom>)");
  struct Case {
    const char *reason, *thing, *told;
  };
  const Case cases[] = {
      {"not white(b3)", "b3", "not white"},
      {"not white(b3)", "mug", "not white(b3)"},
      {"not on(b3, mug)", "b3", "not on the cup"},
      {"not on(b3, mug)", "mug", "not on(b3, mug)"},
      {"not pointed at", "b3", "not pointed at"},
      {"not leftmost(\\y. block(y), b3)", "b3", "not leftmost block"},
      {"not (b3 = the(\\y. cup(y)) or b3 = the(\\y. plate(y)))", "b3", "not the cup or the plate"},
      {"not (red(b3) and (red(b3) and block(b3)) or green(b3))", "b3", "not red block or green"},
      {"not nearest(\\y. f(y, z), b3)", "b3", "not nearest(\\y. f(y, z), b3)"},
      {"", "b3", ""},
  };
  for (const auto& [reason, thing, told] : cases) {
    CAPTURE(reason);
    CHECK(words.reason(reason, thing) == told);
  }
  CHECK(RunWords::raw().reason("not white(b3)", "b3") == "not white(b3)");
}

TEST_CASE("sentences of the log name things as people do, and open meanings leave gaps") {
  const RunWords words(
      R"(<custom><text name="b3" data="type=block color=black"/><text data="type=cup" name="cup"/></custom>)");
  CHECK(words.named("b3 is held already") == "the black block is held already");
  CHECK(words.named("the cup is there, b33 too") == "the cup is there, b33 too");
  CHECK(words.named("that place is out of my reach") == "that place is out of my reach");
  CHECK(words.meaning("\\x. grasp(x)") == "takes …");
  CHECK(words.meaning("\\x. put(x, in(cup))") == "puts … in the cup");
  CHECK(words.meaning("\\x: e. [lift(x)]") == "[lifts …]");
  CHECK(words.meaning("\\n. zork(n)") == "\\n. zork(n)");
  CHECK(words.meaning("grasp(b3)") == "takes the black block");
  CHECK(words.spot(Json::array({-0.1, 0.05})) == "10 cm left of and 5 cm beyond the table's middle");
  CHECK(words.spot(Json()) == "null");
  CHECK(RunWords::raw().spot(Json::array({-0.1, 0.05})) == "[-0.1,0.05]");
}
