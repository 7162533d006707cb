#include "continua/world/relations.h"

#include <rapidcheck.h>

#include <cstdlib>
#include <vector>

#include "support/catch.h"

namespace continua {
namespace {

const Box table{{-0.6, -0.4, 0}, {0.6, 0.4, 0}};
const double never = -std::numeric_limits<double>::infinity();

ObjectState box(const std::string& name, const Vec3& size_m, const Vec3& p_W) {
  ObjectState object;
  object.name = name;
  object.half_extents_m = size_m / 2;
  object.p_WO = p_W;
  return object;
}

ObjectState cube(const std::string& name, double x, double y, double z = 0.03) {
  return box(name, Vec3::Constant(0.06), {x, y, z});
}

double by(const char* relation, const ObjectState& object, const std::vector<Landmark>& landmarks,
          Perspective perspective = Perspective::human) {
  return holds_by(relation_named(relation).value(), object, landmarks, table, perspective);
}

double by_one(const char* relation, const ObjectState& object, const ObjectState& landmark) {
  return by(relation, object, {Landmark::object(landmark)});
}

void law(const std::string& what, const auto& property) {
  setenv("RC_PARAMS", "seed=1 max_success=500", 0);
  INFO(what);
  CHECK(rc::check(what, property));
}

int pick(int from, int to) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, to + 1)); }

// Near the middle, so that boxes often meet; in whole millimetres.
ObjectState any_box(const std::string& name) {
  const Vec3 size(pick(10, 200) / 1e3, pick(10, 200) / 1e3, pick(10, 100) / 1e3);
  return box(name, size, on_grid({pick(-200, 200) / 1e3, pick(-200, 200) / 1e3, size.z() / 2 + 0.05 * pick(0, 2)}));
}

const char* any_relation() {
  static const std::vector<const char*> relations = {"left", "right", "in_front", "behind", "on",      "in",
                                                     "at",   "near",  "beside",   "under",  "touching"};
  return relations[pick(0, 10)];
}

}  // namespace

TEST_CASE("relations have names") {
  for (const char* name :
       {"left", "right", "in_front", "behind", "on", "in", "at", "near", "beside", "touching", "under", "between"})
    CHECK(name_of(relation_named(name).value()) == name);
  CHECK_FALSE(relation_named("over"));
  CHECK(participant_named("human") == Perspective::human);
  CHECK_FALSE(participant_named("left"));
}

TEST_CASE("sides, near and beside have a rough and a loose sense") {
  const ObjectState base = cube("base", 0, 0);
  const std::vector<Landmark> landmark = {Landmark::object(base)};
  const auto holds = [&](const char* relation, const ObjectState& object) {
    std::string senses;
    for (const auto sides : {Sides::exact, Sides::rough, Sides::loose})
      senses += holds_by(relation_named(relation).value(), object, landmark, table, Perspective::human, sides) > 0
                    ? '+'
                    : '-';
    return senses;
  };
  CHECK(holds("left", cube("a", -0.2, 0.01)) == "+++");
  CHECK(holds("left", cube("a", -0.2, 0.19)) == "-++");
  CHECK(holds("left", cube("a", -0.2, 0.2)) == "-++");  // as far to the left as behind
  CHECK(holds("behind", cube("a", -0.2, 0.2)) == "-++");
  CHECK(holds("left", cube("a", -0.2, 0.21)) == "--+");
  CHECK(holds("left", cube("a", 0.2, 0)) == "---");
  CHECK(holds("left", cube("a", -0.04, 0, 0.09)) == "---");  // rests on it
  CHECK(holds("near", cube("a", 0.24, 0)) == "-++");
  CHECK(holds("near", cube("a", 0.34, 0)) == "--+");
  CHECK(holds("beside", cube("a", 0.15, 0)) == "-++");
  CHECK(holds("touching", cube("a", 0.09, 0)) == "---");
}

TEST_CASE("relations hold by the lengths that the header tells") {
  struct Row {
    const char* relation;
    ObjectState object, landmark;
    double by;
  };
  const ObjectState base = cube("base", 0, 0);
  const ObjectState plate = box("plate", {0.2, 0.2, 0.02}, {0, 0, 0.01});
  ObjectState cup = box("cup", {0.08, 0.08, 0.1}, {0, 0, 0.05});
  cup.interior = Box{{-0.03, -0.03, -0.04}, {0.03, 0.03, 0.05}};
  const Vec3 stick(0.01, 0.02, 0.2);
  const Row rows[] = {
      {"left", cube("a", -0.1, 0.02), base, 0.04},   // across they overlap by that
      {"left", cube("a", -0.04, 0.02), base, 0.01},  // beyond half of 6 cm
      {"left", cube("a", -0.1, 0.07), base, -0.01},  // passes by
      {"left", cube("a", 0.1, 0), base, -0.13},
      {"left", cube("a", -0.04, 0, 0.09), base, -0.0012},  // rests on it
      {"in_front", cube("a", 0.01, -0.2), base, 0.05},
      {"behind", cube("a", 0.01, 0.2), base, 0.05},
      {"on", cube("a", 0.02, 0.01, 0.09), base, 0.0012},
      {"on", cube("a", 0.02, 0.01, 0.092), base, -0.0008},
      {"on", cube("a", 0.07, 0, 0.09), base, -0.01},
      {"under", base, cube("a", 0.02, 0, 0.2), 0.04},
      {"under", base, cube("a", 0.02, 0, 0.05), -0.0388},
      {"in", box("stick", stick, {0.01, 0, 0.11}), cup, 0.0012},
      {"in", box("stick", stick, {0.04, 0, 0.15}), cup, -0.01},
      {"in", box("stick", stick, {0, 0, 0.22}), cup, -0.02},
      {"touching", cube("a", 0.065, 0), base, 0.005},
      {"touching", cube("a", 0.065, 0.075), base, -0.005},
      {"at", cube("a", 0.02, 0, 0.09), base, 0.01},
      {"at", cube("a", 0.2, 0), base, -0.13},
      {"near", cube("a", 0.09, 0.1), base, 0.05},
      {"near", cube("a", 0.18, 0), base, -0.02},
      {"near", cube("a", 0, 0, 0.09), base, 0.1},
      {"beside", cube("a", 0.09, 0), base, 0.02},
      {"beside", cube("a", 0.12, 0), base, -0.01},
      {"beside", cube("a", 0.05, 0), plate, -0.0588},
  };
  for (const auto& [relation, object, landmark, expected] : rows) {
    INFO(relation << " at " << object.p_WO.transpose());
    CHECK(by_one(relation, object, landmark) == Approx(expected).margin(1e-9));
  }
  CHECK(by_one("in", cube("a", 0, 0), plate) == never);  // it has no hollow
  CHECK(by("left", cube("a", -0.1, 0), {}) == never);
}

TEST_CASE("between is on the way from one to the other") {
  const auto first_cube = cube("first", -0.2, -0.1), second_cube = cube("second", 0.2, 0.1);
  const auto first = Landmark::object(first_cube), second = Landmark::object(second_cube);
  CHECK(by("between", cube("a", 0, 0), {first, second}) > 0.05);
  CHECK(by("between", cube("a", 0, 0), {second, first}) > 0.05);
  CHECK(by("between", cube("a", -0.2, 0.1), {first, second}) < -0.05);
  CHECK(by("between", cube("a", 0.4, 0.2), {first, second}) < -0.1);
  const Landmark both[] = {first, second};
  CHECK(holds_by(Relation::between, cube("a", -0.1, 0.1), both, table, Perspective::human, Sides::loose) > 0);
  CHECK(holds_by(Relation::between, cube("a", -0.2, 0.4), both, table, Perspective::human, Sides::loose) < -0.05);
  CHECK(by("between", cube("a", 0, 0), {first, first}) == never);
  CHECK(by("between", cube("a", 0, 0), {first}) == never);
}

TEST_CASE("participants have sides of their own, whatever the perspective") {
  const auto avatar = Landmark::participant(Perspective::avatar, table);
  const auto human = Landmark::participant(Perspective::human, table);
  const auto object = cube("a", 0.1, 0.3);
  for (const auto perspective : {Perspective::human, Perspective::avatar}) {
    CHECK(by("in_front", object, {avatar}, perspective) == Approx(0.3));
    CHECK(by("in_front", object, {human}, perspective) == Approx(-0.3));
    CHECK(by("left", object, {avatar}, perspective) == Approx(0.1));
    CHECK(by("right", object, {human}, perspective) == Approx(0.1));
    CHECK(by("near", object, {avatar}, perspective) == Approx(0.18));
    CHECK(by("near", object, {human}, perspective) == Approx(-0.42));
    CHECK(by("behind", object, {avatar}, perspective) == never);
    CHECK(by("on", object, {avatar}, perspective) == never);
  }
}

TEST_CASE("at a place is where the centre is") {
  const auto region = Landmark::place({{0, 0, 0}, {0.2, 0.1, 0}});
  for (const char* relation : {"at", "in", "on"}) {
    CHECK(by(relation, cube("a", 0.1, 0.08), {region}) == Approx(0.03));
    CHECK(by(relation, cube("a", -0.005, 0.08), {region}) == Approx(0.005));
    CHECK(by(relation, cube("a", -0.02, 0.08), {region}) == Approx(-0.01));
  }
}

TEST_CASE("laws of relations") {
  law("the sides of one perspective are the opposite ones of the other", [] {
    using enum Perspective;
    const auto a = any_box("a"), b = any_box("b");
    const std::vector<Landmark> of_a = {Landmark::object(a)}, of_b = {Landmark::object(b)};
    RC_ASSERT(by("left", a, of_b, human) == by("right", a, of_b, avatar));
    RC_ASSERT(by("in_front", a, of_b, human) == by("behind", a, of_b, avatar));
    RC_ASSERT(by("left", a, of_b, human) == by("right", b, of_a, human));
    RC_ASSERT(by("behind", a, of_b, human) == by("in_front", b, of_a, human));
    RC_ASSERT(by("left", a, of_b, human) <= 0 || by("right", a, of_b, human) < 0);
    RC_CLASSIFY(by("left", a, of_b, human) > 0, "left");
  });

  law("nothing stands in a relation to itself", [] {
    const auto a = any_box("a"), b = any_box("b");
    RC_ASSERT(by_one(any_relation(), a, a) == never);
    RC_ASSERT(by("between", a, {Landmark::object(a), Landmark::object(b)}) == never);
  });

  law("moving one thing by less than the margin changes no relation", [] {
    const auto a = any_box("a"), b = any_box("b");
    const char* relation = any_relation();
    const double before = by_one(relation, a, b), reach = std::min(std::abs(before), 0.3) - 2 * position_grid_m;
    RC_PRE(reach > 0);
    const double angle = pick(0, 63) / 10.0;
    auto moved = a;
    moved.p_WO = on_grid(Vec3(a.p_WO + reach * Vec3(std::cos(angle), std::sin(angle), 0)));
    RC_ASSERT((by_one(relation, moved, b) > 0) == (before > 0));
    RC_CLASSIFY(before > 0, "it holds");
  });
}

}  // namespace continua
