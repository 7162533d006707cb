#include "continua/replay/session/shelf.h"

#include "support/catch.h"
#include "support/stage.h"

using namespace continua;

TEST_CASE("a scene is loaded once for all who share it") {
  Shelf shelf;
  int loaded = 0;
  const auto load = [&] {
    ++loaded;
    return Result<Scene>(shipped_scene("staircase"));
  };
  const auto first = shelf.scene("a", load), again = shelf.scene("a", load);
  REQUIRE((first.ok() && again.ok()));
  CHECK(loaded == 1);
  CHECK(&first->model() == &again->model());
  CHECK(shelf.scene("b", load).ok());
  CHECK(loaded == 2);
}

TEST_CASE("a scene that cannot be loaded is tried anew") {
  Shelf shelf;
  int tried = 0;
  const auto fail = [&] {
    ++tried;
    return Result<Scene>(Error{"a", "is no scene"});
  };
  CHECK(shelf.scene("a", fail).error().sentence == "is no scene");
  CHECK_FALSE(shelf.scene("a", fail).ok());
  CHECK(tried == 2);
}

TEST_CASE("scenes beyond those that are held are loaded again") {
  Shelf shelf;
  const auto scene = shipped_scene("staircase");
  int loaded = 0;
  const auto load = [&] {
    ++loaded;
    return Result<Scene>(scene);
  };
  for (int i = 0; i < 100; ++i) REQUIRE(shelf.scene(std::to_string(i), load).ok());
  REQUIRE(shelf.scene("0", load).ok());
  CHECK(loaded == 101);
}
