#include "continua/replay/commands/moved_paths.h"

#include "support/catch.h"

namespace continua {

TEST_CASE("A trace that is written to another folder keeps the way to its recordings") {
  Json header = Json::parse(R"({"media":[{"file":"a.webm","offset":1},{"file":"../b.wav"},{"file":"/c.mp4"}]})");
  move_media(header, "corpus/traces", "build");
  CHECK(compact(header["media"]) ==
        R"([{"file":"../corpus/traces/a.webm","offset":1},{"file":"../corpus/b.wav"},{"file":"/c.mp4"}])");
  move_media(header, "build", "corpus/traces");
  CHECK(header["media"][0]["file"] == "a.webm");
  Json none = Json::object();
  move_media(none, "a", "b");
  CHECK(none.empty());
}

}  // namespace continua
