#include "continua/behaviour/reenactment.h"

#include "continua/facts/world_facts.h"
#include "support/catch.h"

using namespace continua;

namespace {

WorldSnapshot two_blocks() {
  WorldSnapshot world;
  world.table = {{-0.5, -0.12, 0}, {0.5, 0.12, 0}};
  for (const auto& [name, x] : {std::pair("a", 0.0), std::pair("b", 0.2)})
    world.objects.push_back({name, {}, Vec3::Constant(0.03), {x, 0, 0.03}, 0});
  return world;
}

Term term(const std::string& text) {
  Signature names = {{"put", *Type::parse("e -> loc -> t")},
                     {"on", *Type::parse("e -> loc")},
                     {"right", *Type::parse("e -> loc")},
                     {"grasp", *Type::parse("e -> t")},
                     {"a", Type::entity()},
                     {"b", Type::entity()},
                     {"c", Type::entity()}};
  const auto parsed = parse_term(text, names);
  if (!parsed) FAIL(parsed.error().text());
  return *parsed;
}

}  // namespace

TEST_CASE("observed acts are done one after the other, each to its end") {
  Reenactment world(two_blocks(), nullptr, Perspective::avatar);
  CHECK(world.act(term("put(a, on(b))"), SimTime{1}).status == ActReport::Status::done);
  CHECK(world.body().snapshot().find("a")->p_WO.isApprox(Vec3(0.2, 0, 0.09)));
  CHECK(world.act(term("grasp(b)"), SimTime{2}).status == ActReport::Status::done);
  CHECK(world.body().snapshot().held == "b");
  CHECK(world.act(term("put(b, <-0.1, 0.02, 0>)"), SimTime{3}).status == ActReport::Status::done);
  CHECK(world.body().snapshot().find("b")->p_WO.isApprox(Vec3(-0.1, 0.02, 0.03)));
  CHECK(world.body().snapshot().held.empty());
}

TEST_CASE("what was observed is done also where there is no room, by pushing") {
  auto world = two_blocks();
  world.objects.push_back({"c", {}, Vec3::Constant(0.03), {0.2, 0.02, 0.09}, 0});   // on b
  world.objects.push_back({"d", {}, Vec3::Constant(0.03), {0.13, 0.02, 0.03}, 0});  // at b's side, the avatar's right
  Reenactment on(world, nullptr, Perspective::avatar);
  CHECK(on.act(term("put(a, on(b))"), SimTime{1}).status == ActReport::Status::done);
  const auto stacked = on.body().snapshot();
  CHECK(stacked.find("a")->p_WO.z() == Approx(0.09));
  CHECK(stacked.find("a")->p_WO.y() < 0);
  CHECK(stacked.find("c")->p_WO.y() > 0.02);
  Reenactment beside(world, nullptr, Perspective::avatar);
  CHECK(beside.act(term("put(a, right(b))"), SimTime{1}).status == ActReport::Status::done);
  CHECK(beside.body().snapshot().find("a")->p_WO.isApprox(Vec3(0.14, -0.02, 0.03)));
  CHECK(beside.body().snapshot().find("d")->p_WO.isApprox(Vec3(0.13, 0.04, 0.03)));
}

TEST_CASE("what cannot be done leaves the world as it was") {
  Reenactment world(two_blocks(), nullptr, Perspective::avatar);
  for (const auto& act : {term("put(a, on(a))"), term("grasp(c)"), Term::text("G push right high")}) {
    INFO(print(act));
    CHECK(world.act(act, SimTime{1}).status != ActReport::Status::done);
    CHECK(world.body().snapshot().find("a")->p_WO == Vec3(0, 0, 0.03));
    CHECK(world.body().snapshot().held.empty());
  }
}
