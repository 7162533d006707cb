#include "continua/perception/input_event.h"

#include "support/catch.h"

using namespace continua;

namespace {

InputEvent speech(std::string text) {
  InputEvent event;
  event.text = std::move(text);
  return event;
}

InputEvent pointing(Vec3 from_W, Vec3 direction_W) {
  InputEvent event;
  event.modality = Modality::pointing;
  event.ray = Ray{from_W, direction_W};
  return event;
}

}  // namespace

TEST_CASE("speech is known by its words alone") {
  CHECK(symbol_of(speech("Put it there.")) == "speech put it there");
  CHECK(symbol_of(speech("  OK,\tgo   on!  ")) == "speech ok go on");
  CHECK(symbol_of(speech("YES")) == "speech yes");
  CHECK(symbol_of(speech("don't")) == "speech dont");
  CHECK(symbol_of(speech("don’t — “stop”…")) == "speech dont stop");
  CHECK(symbol_of(speech("left-most 2")) == "speech left most 2");
  CHECK(symbol_of(speech("Größe")) == "speech größe");
  CHECK(symbol_of(speech("?!")) == "speech");
}

TEST_CASE("a gesture is known by the parts it has") {
  InputEvent event;
  event.modality = Modality::gesture;
  event.name = "point";
  CHECK(symbol_of(event) == "gesture point");
  event.hand = "right";
  event.phase = "start";
  CHECK(symbol_of(event) == "gesture right point start");
  event = {};
  event.modality = Modality::gesture;
  event.name = "grab_move";
  event.direction = "up";
  event.phase = "start";
  CHECK(symbol_of(event) == "gesture grab_move up start");
}

TEST_CASE("pointing is known by its hand") {
  InputEvent event;
  event.modality = Modality::pointing;
  CHECK(symbol_of(event) == "pointing");
  event.hand = "left";
  CHECK(symbol_of(event) == "pointing left");
}

TEST_CASE("the place of an event is its target, else where its ray meets the table") {
  auto event = pointing({0, -0.5, 0.4}, {0.1, 0.5, -0.2});
  CHECK(place_of(event)->isApprox(Vec3(0.2, 0.5, 0)));
  CHECK(place_of(event)->z() == 0);
  event.target_W = Vec3(0.3, 0.1, 0);
  CHECK(*place_of(event) == Vec3(0.3, 0.1, 0));
  CHECK_FALSE(place_of(speech("there")));
}

TEST_CASE("a ray that does not reach the table has no place") {
  CHECK_FALSE(place_of(pointing({0, 0, 0.4}, {1, 0, 0})));                     // level
  CHECK_FALSE(place_of(pointing({0, 0, 0.4}, {0, 0.1, 0.2})));                 // upwards
  CHECK_FALSE(place_of(pointing({0, 0, 0.4}, {1e300, 0, -1e-9})));             // beyond the range of a number
  CHECK(*place_of(pointing({0.1, 0.2, 0}, {0, 1, -1})) == Vec3(0.1, 0.2, 0));  // from the table itself
}

TEST_CASE("an alternative is the event with another reading") {
  auto event = speech("put it");
  event.confidence = 0.6;
  event.until = SimTime::from_seconds(2);
  event.alternatives = {{"but it", 0.3}, {"putt", 0.1}};
  CHECK(alternative(event, 0).text == "put it");
  CHECK(alternative(event, 0).alternatives.size() == 2);
  const auto other = alternative(event, 2);
  CHECK(other.text == "putt");
  CHECK(other.confidence == 0.1);
  CHECK(other.until == event.until);
  CHECK(other.alternatives.empty());
  CHECK(other.alternatives.capacity() == 0);  // a copy that was emptied would keep the memory of all of them
  event.modality = Modality::gesture;
  CHECK(alternative(event, 1).name == "but it");
  CHECK(alternative(event, 1).text == "put it");
}
