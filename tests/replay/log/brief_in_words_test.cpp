#include "continua/replay/log/brief_in_words.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("a record in brief names things, places and gestures as people do, and keeps its terms") {
  const RunWords words(std::string_view(R"(<text name="block6" data="type=block color=red"/>
                                            <text name="cup" data="type=cup color=white"/>)"));
  const auto told = [&](const char* record) { return brief_in_words(words, Json::parse(record)); };
  CHECK(told(R"json({"kind":"act","act":1,"program":"put(cup, <-0.26, 0, 0>)","status":"asked"})json") ==
        "asked “puts the white cup 26 cm left of the table's middle”");
  CHECK(told(R"json({"kind":"gesture","gesture":"point(block6)"})json") == "“points at the red block”");
  CHECK(told(R"json({"kind":"input","event":{"kind":"gesture","name":"posack","phase":"stroke"}})json") ==
        "gesture “yes”");
  CHECK(told(R"json({"kind":"input","event":{"kind":"act","act":1,"program":"grasp(block6)","status":"done"}})json") ==
        "act 1, “takes the red block”, done");
  CHECK(told(R"json({"kind":"expect","met":true,"expected":{"act":"grasp(block6)"}})json") ==
        "met: the avatar does “takes the red block”");
  CHECK(told(R"json({"kind":"expect","met":false,"expected":{"state":"Ask","act":"grasp(block6)","says":"Okay."},
                     "found":{"state":"Ask","act":"grasp(cup)","says":"null"}})json") ==
        "not met: the avatar does “takes the red block”, found “takes the white cup”; the avatar says “Okay.”, found "
        "nothing");
  CHECK(
      told(R"json({"kind":"expect","met":false,"expected":{"referents":["cup","block6"],"holding":"cup","stack_depth":2,
                     "indicated":"<0.1, 0, 0>"},"found":{"referents":[],"holding":"null","stack_depth":1,
                     "indicated":"null"}})json") ==
      "not met: meant may be the white cup or the red block, found nothing; the avatar holds the white cup, found "
      "nothing; symbols on the stack 2, found 1; indicated is 10 cm right of the table's middle, found nothing");
  CHECK(told(R"json({"kind":"observed","channel":"action","content":"grasp(block6)"})json") ==
        "action “takes the red block”");
  CHECK(told(R"json({"kind":"observed","channel":"speech","content":"Okay."})json") == "speech Okay.");
  CHECK(told(R"json({"kind":"application","function":"grasp","argument":"block6","result":"grasp(block6)"})json") ==
        "grasp @ block6 = grasp(block6)");
  CHECK(told(R"json({"kind":"symbol","id":1,"slots":{"theme":"point(block6)","sure":"1"}})json") ==
        "#1 theme “points at the red block”, sure 1");
  CHECK(told(R"json({"kind":"utterance","text":"Okay."})json") == "“Okay.”");
  CHECK(told(R"json({"kind":"act","act":1,"program":"\\x. grasp(x)","status":"asked"})json") == "asked \\x. grasp(x)");
}
