#include <sstream>

#include "continua/body/kinematic_body.h"
#include "continua/core/random.h"
#include "continua/world/relations.h"
#include "support/catch.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

ObjectState thing(const std::string& name, const Vec3& size_m, double x, double y, double z = 0) {
  return {name, {}, size_m / 2, Vec3(x, y, z + size_m.z() / 2), 0};
}

ObjectState cup(const std::string& name, double x, double y) {
  ObjectState cup = thing(name, {0.08, 0.08, 0.1}, x, y);
  cup.interior = Box{{-0.025, -0.025, -0.042}, {0.025, 0.025, 0.05}};
  return cup;
}

const Vec3 cube = Vec3::Constant(0.06);

WorldSnapshot laid_table() {
  WorldSnapshot world;
  world.table = {{-0.5, -0.3, 0}, {0.5, 0.3, 0}};
  world.objects = {thing("plate", {0.2, 0.2, 0.02}, -0.2, 0),
                   cup("cup", 0.12, 0.03),
                   thing("knife", {0.2, 0.024, 0.01}, 0.12, -0.09),
                   thing("block", cube, 0.3, 0),
                   thing("top", cube, 0.3, 0, 0.06),
                   thing("pin", {0.03, 0.01, 0.01}, 0.45, 0.2)};
  return world;
}

/// "put knife in cup", "slide block left block", "put block at 0.1 0.2", "put block between plate cup".
AvatarCommand command(const std::string& said, Perspective perspective = Perspective::human) {
  std::istringstream words(said);
  std::string program, relation, landmark;
  AvatarCommand command;
  words >> program >> command.object >> relation;
  command.what = program == "slide" ? Capability::slide : Capability::put;
  command.goal.perspective = perspective;
  if (relation == "to") {
    words >> command.goal.p_WG.x() >> command.goal.p_WG.y();
    return command;
  }
  command.goal.relation = relation_named(relation);
  REQUIRE(command.goal.relation);
  while (words >> landmark) command.goal.landmarks.push_back(landmark);
  return command;
}

/// Where it is put, or why it is not.
std::string told(const std::string& said, const WorldSnapshot& world = laid_table(),
                 Occupied occupied = Occupied::avoided) {
  const auto place = placement(command(said), world, occupied);
  if (!place) return words_of(place.reason());
  std::ostringstream out;
  out << place->p_WO.x() << " " << place->p_WO.y() << " " << place->p_WO.z() << (place->upright ? " upright" : "");
  return out.str();
}

/// Apart, or one in the other's hollow: told independently of the engine, from corners.
bool apart(const ObjectState& a, const ObjectState& b) {
  const Box x = a.bounds_W(), y = b.bounds_W();
  for (int i = 0; i < 3; ++i)
    if (x.max[i] <= y.min[i] + 3e-4 || y.max[i] <= x.min[i] + 3e-4) return true;
  const auto in = [](const Box& inner, const ObjectState& outer) {
    if (!outer.interior) return false;
    const Vec3 low = inner.min - outer.p_WO, high = inner.max - outer.p_WO;
    return low.x() > outer.interior->min.x() - 3e-4 && high.x() < outer.interior->max.x() + 3e-4 &&
           low.y() > outer.interior->min.y() - 3e-4 && high.y() < outer.interior->max.y() + 3e-4 &&
           low.z() > outer.interior->min.z() - 3e-4;
  };
  return in(x, b) || in(y, a);
}

}  // namespace

TEST_CASE("where things are put") {
  struct Row {
    const char *said, *where;
  };
  const Row rows[] = {
      // sides touch
      {"put block left cup", "0.05 0.03 0.03"},
      {"put block right plate", "-0.07 0 0.03"},
      {"put block in_front plate", "-0.2 -0.13 0.03"},
      {"put block behind plate", "-0.2 0.13 0.03"},
      {"put block touching plate", "-0.07 0 0.03"},
      // others leave room for a hand
      {"put block at plate", "-0.065 0 0.03"},
      {"put block beside plate", "-0.05 0 0.03"},
      {"put block near plate", "-0.02 0 0.03"},
      {"put block between plate cup", "-0.04 0.015 0.03"},
      {"put block on plate", "-0.2 0 0.05"},
      {"put top on plate", "-0.2 0 0.05"},
      {"put knife on cup", "0.12 0.03 0.105"},
      {"put knife in cup", "0.12 0.03 0.108 upright"},
      {"put pin in cup", "0.12 0.03 0.013"},
      // participants have a side of the table
      {"put plate in_front avatar", "0 0.17 0.01"},
      {"put plate in_front human", "-0.08 -0.17 0.01"},
      {"put plate left avatar", "0.25 0.17 0.01"},
      {"put knife right human", "0.25 -0.258 0.005"},
      {"put cup near human", "0 -0.23 0.05"},
      {"put cup beside avatar", "0 0.23 0.05"},
      {"put cup at avatar", "0 0.23 0.05"},
      {"put cup between avatar plate", "-0.1 0.15 0.05"},
      // a step to a side, as far as there is room
      {"slide cup left cup", "0.02 0.03 0.05"},
      {"slide cup right cup", "0.22 0.03 0.05"},
      {"slide cup in_front cup", "0.12 -0.035 0.05"},
      {"slide cup behind cup", "0.12 0.13 0.05"},
      // points, occupied or not
      {"put cup to 0 -0.2", "0 -0.2 0.05"},
      {"put cup to 0.49 0.1", "0.49 0.1 0.05"},
      {"put cup to -0.2 0", "-0.2 0 0.05"},
      // refused
      {"put block in cup", "block does not fit into cup"},
      {"put plate in cup", "plate does not fit into cup"},
      {"put block in plate", "plate has no hollow that anything could be put in"},
      {"put pin on cup", "pin would fall into cup"},
      {"put plate on knife", "knife is too narrow to bear plate"},
      {"put block on pin", "pin is too narrow to bear block"},
      {"put cup under plate", "nothing can be put under plate"},
      {"put cup behind avatar", "nothing can be put behind avatar"},
      {"put cup on human", "nothing can be put on human"},
      {"put cup in human", "nothing can be put in human"},
      {"put cup on cup", "cup cannot be put on itself"},
      {"put block left top", "top stands on or in block, and would move along"},
      {"put cup between plate", "it is not said between what"},
      {"put cup left", "it is not said left what"},
  };
  for (const auto& row : rows) {
    INFO(row.said);
    CHECK(told(row.said) == row.where);
  }
}

TEST_CASE("a container is full when what would fit finds no room for what is in it, and both bodies are told so") {
  WorldSnapshot world = laid_table();
  ObjectState& cup = world.objects[1];
  world.objects[5].p_WO = cup.p_WO;
  world.objects[5].half_extents_m = {0.02, 0.02, 0.03};
  for (const Occupied occupied : {Occupied::avoided, Occupied::cleared}) {
    CHECK(told("put knife in cup", world, occupied) == "cup is full of pin");
    CHECK(told("put block in cup", world, occupied) == "block does not fit into cup");
    CHECK(told("put plate on knife", world, occupied) == "knife is too narrow to bear plate");
    CHECK(told("put knife in cup", laid_table(), occupied) == "0.12 0.03 0.108 upright");
  }
}

TEST_CASE("where a body that finds room itself puts things") {
  struct Row {
    const char *said, *where;
  };
  // The plate is in the way of the first, the block of the second and third.
  const Row rows[] = {
      {"put cup to -0.15 0.05", "-0.15 0.05 0.05"}, {"put cup on block", "0.3 0 0.11"},
      {"put plate left block", "0.17 0 0.01"},      {"put block left top", "0.24 0 0.03"},
      {"put cup beside block", "0.21 0 0.05"},      {"put cup on cup", "cup cannot be put on itself"},
  };
  for (const auto& row : rows) {
    INFO(row.said);
    CHECK(told(row.said, laid_table(), Occupied::cleared) == row.where);
  }
}

TEST_CASE("what is turned takes the room of its box along the axes") {
  WorldSnapshot world = laid_table();
  world.objects[2].yaw = 1.5707963267948966;
  CHECK(told("put knife right plate", world) == "-0.088 0 0.005");
}

TEST_CASE("what is missing has a name") {
  const WorldSnapshot world = laid_table();
  CHECK(missing_thing(command("put cup left avatar"), world) == std::nullopt);
  CHECK(missing_thing(command("put mug left avatar"), world) == "mug");
  CHECK(missing_thing(command("put cup between plate spoon"), world) == "spoon");
}

TEST_CASE("what is put somewhere is there, and in nothing else") {
  const char* objects[] = {"plate", "cup", "mug", "knife", "block", "cube"};
  const char* landmarks[] = {"plate", "cup", "mug", "knife", "block", "cube", "avatar", "human"};
  Random random(7);
  const auto any = [&](const auto& of) {
    return of[static_cast<std::size_t>(random.uniform() * static_cast<double>(std::size(of)))];
  };
  int done = 0, blocked = 0;
  for (int round = 0; round < 40; ++round) {
    WorldSnapshot world;
    world.table = {{-0.5, -0.3, 0}, {0.5, 0.3, 0}};
    world.objects = {
        thing("plate", {0.2, 0.2, 0.02}, -0.38, -0.18), cup("cup", -0.12, -0.2),         cup("mug", 0.1, -0.2),
        thing("knife", {0.2, 0.024, 0.01}, 0.3, -0.2),  thing("block", cube, -0.4, 0.2), thing("cube", cube, 0.4, 0.2)};
    for (auto& object : world.objects) object.p_WO += Vec3(0.05 * random.uniform(), 0.05 * random.uniform(), 0);
    for (auto& object : world.objects) object.p_WO = on_grid(object.p_WO);
    KinematicBody body(world);
    for (int n = 0; n < 12; ++n) {
      const auto relation = static_cast<Relation>(static_cast<int>(random.uniform() * 12));
      std::string said =
          std::string("put ") + any(objects) + " " + std::string(name_of(relation)) + " " + any(landmarks);
      if (relation == Relation::between) said += std::string(" ") + any(landmarks);
      const auto perspective = random.uniform() < 0.5 ? Perspective::human : Perspective::avatar;
      const AvatarCommand wanted = command(said, perspective);
      const WorldSnapshot before = body.snapshot();
      body.command(wanted);
      ActReport end = body.advance(before.t + SimTime{1}).acts.back();
      if (!body.at_rest()) end = body.advance(before.t + SimTime{1}).acts.back();
      const WorldSnapshot after = body.snapshot();
      INFO(said << ": " << name_of(end.status) << " " << words_of(end.reason));
      for (std::size_t i = 0; i < after.objects.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          INFO(after.objects[i].name << " and " << after.objects[j].name);
          CHECK(apart(after.objects[i], after.objects[j]));
        }
      }
      if (end.status == Status::blocked) {
        ++blocked;
        CHECK_FALSE(end.reason.empty());
        for (std::size_t i = 0; i < after.objects.size(); ++i) CHECK(after.objects[i].p_WO == before.objects[i].p_WO);
        continue;
      }
      ++done;
      const ObjectState& object = *after.find(wanted.object);
      std::vector<Landmark> beside;
      bool step = false;
      for (const auto& name : wanted.goal.landmarks) step = step || name == object.name;
      if (step) {
        CHECK((object.p_WO - before.find(object.name)->p_WO).dot(side_W(relation, perspective)) > 0.02);
        continue;
      }
      for (const auto& name : wanted.goal.landmarks) beside.push_back(*Landmark::named(name, after));
      CHECK(holds_by(relation, object, beside, after.table, perspective) > 0);
    }
  }
  CHECK(done > 100);
  CHECK(blocked > 50);
}
