#include <sstream>

#include "behaviour/kinematic_body.h"
#include "core/random.h"
#include "support/catch.h"
#include "world/relations.h"

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
  world.objects = {thing("plate", {0.2, 0.2, 0.02}, -0.2, 0), cup("cup", 0.12, 0.03),
                   thing("knife", {0.2, 0.024, 0.01}, 0.12, -0.09), thing("block", cube, 0.3, 0),
                   thing("top", cube, 0.3, 0, 0.06)};
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
  if (!place) return place.error().sentence;
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
      {"put block left cup", ""},
  };
  for (const auto& row : rows) {
    INFO(row.said);
    CHECK(told(row.said) == row.where);
  }
  for (const char* said :
       {"put block right plate", "put block in_front plate", "put block behind plate", "put block on plate",
        "put top on plate", "put knife on plate", "put knife on cup", "put knife in cup", "put block at plate", "put block near plate", "put block beside plate",
        "put block touching plate", "put block between plate cup", "put plate in_front avatar", "put plate in_front human",
        "put plate left avatar", "put knife right human", "put cup near human", "put cup beside avatar", "put cup at avatar", "put cup between avatar plate",
        "slide cup left cup", "slide cup right cup", "slide cup in_front cup", "slide cup behind cup", "put cup to 0 -0.2", "put cup to 0.499 0.1",
        "put cup to 0.12 -0.09", "put cup to -0.2 0",
        // refused
        "put block in cup", "put block in plate", "put cup under plate", "put cup behind avatar", "put cup on human", "put cup in human", "put cup on cup", "put block left top", "put cup to 2 2", "put plate in cup",
        "put cup between plate", "put cup left", "put plate on knife"})
    WARN(said << ": " << told(said));
}

TEST_CASE("what is put somewhere is there, and in nothing else") {
  const char* objects[] = {"plate", "cup", "mug", "knife", "block", "cube"};
  const char* landmarks[] = {"plate", "cup", "mug", "knife", "block", "cube", "avatar", "human"};
  Random random(7);
  const auto any = [&](const auto& of) { return of[static_cast<std::size_t>(random.uniform() * static_cast<double>(std::size(of)))]; };
  int done = 0, blocked = 0;
  for (int round = 0; round < 40; ++round) {
    WorldSnapshot world;
    world.table = {{-0.5, -0.3, 0}, {0.5, 0.3, 0}};
    world.objects = {thing("plate", {0.2, 0.2, 0.02}, -0.38, -0.18), cup("cup", -0.12, -0.2), cup("mug", 0.1, -0.2),
                     thing("knife", {0.2, 0.024, 0.01}, 0.3, -0.2), thing("block", cube, -0.4, 0.2),
                     thing("cube", cube, 0.4, 0.2)};
    for (auto& object : world.objects) object.p_WO += Vec3(0.05 * random.uniform(), 0.05 * random.uniform(), 0);
    for (auto& object : world.objects) object.p_WO = on_grid(object.p_WO);
    KinematicBody body(world);
    for (int n = 0; n < 12; ++n) {
      const auto relation = static_cast<Relation>(static_cast<int>(random.uniform() * 12));
      std::string said = std::string("put ") + any(objects) + " " + std::string(text(relation)) + " " + any(landmarks);
      if (relation == Relation::between) said += std::string(" ") + any(landmarks);
      const auto perspective = random.uniform() < 0.5 ? Perspective::human : Perspective::avatar;
      const AvatarCommand wanted = command(said, perspective);
      const WorldSnapshot before = body.snapshot();
      body.command(wanted);
      const ActReport end = body.advance(before.t + SimTime{1}).acts.back();
      const WorldSnapshot after = body.snapshot();
      INFO(said << ": " << continua::text(end.status) << " " << end.reason);
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
