// Collective programs: goals of voxemes, and the rings of places that they are made of.
#include "continua/facts/formations.h"

#include <cmath>

#include "continua/facts/world_facts.h"
#include "continua/term/term_text.h"
#include "continua/world/world_snapshot.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

// A table of 1.2 m x 0.8 m with cubes of 6 cm in a row, 20 cm apart.
WorldSnapshot cubes(std::size_t count, double depth_m = 0.8) {
  WorldSnapshot world;
  world.table = {{-0.6, -depth_m / 2, 0}, {0.6, depth_m / 2, 0}};
  for (std::size_t i = 0; i < count; ++i) {
    ObjectState cube;
    cube.name = "b" + std::to_string(i + 1);
    cube.half_extents_m = Vec3::Constant(0.03);
    cube.p_WO = {-0.5 + 0.2 * static_cast<double>(i), 0, 0.03};
    world.objects.push_back(cube);
  }
  return world;
}

const Catalogue& shipped() {
  static const Catalogue catalogue = read_catalogue(source_dir() + "/engine/knowledge/voxemes").catalogue;
  return catalogue;
}

Term value(const std::string& text, const WorldSnapshot& world, const Catalogue& voxemes = shipped()) {
  Signature names = term_signature();
  names.insert(WorldFacts::signature().begin(), WorldFacts::signature().end());
  for (const auto& object : world.objects) names.emplace(object.name, Type::entity());
  const WorldFacts facts(Perspective::human, &voxemes);
  const RuleTable rules({&term_rules(), &facts.rules()});
  Evaluation evaluation(rules, nullptr, {.world = &world});
  return evaluation.value(parse_term(text, names).value());
}

std::vector<Vec3> points(const Term& list) {
  std::vector<Vec3> points;
  for (const auto& each : list.elements()) {
    const auto& p = each.place_value().min;
    points.push_back({p[0], p[1], p[2]});
  }
  return points;
}

}  // namespace

TEST_CASE("the goal of a collective program is reached by a put for each thing") {
  const auto six = cubes(6);
  CHECK(print(value("formed('tower', [b2, b1, b3])", six)) == "[put(b1, on(b2)), put(b3, on(b1))]");
  CHECK(print(value("formed('row', [b3, b1, b2])", six)) == "[put(b2, right(b1)), put(b3, right(b2))]");
  CHECK(print(value("formed('staircase', [b1, b2, b3, b4, b5, b6])", six)) ==
        "[put(b2, right(b1)), put(b3, on(b2)), put(b4, right(b2)), put(b5, on(b4)), put(b6, on(b5))]");
  CHECK(print(value("formed('staircase', [b1, b2, b3, b4])", six)) ==
        "[put(b4, right(b1)), put(b2, right(b4)), put(b3, on(b2))]");
  CHECK(value("formed('circle', [b1, b2, b3])", six).elements().size() == 3);
  CHECK(value("formed_at('surround', [b1, b2], bounds(b3))", six).elements().size() == 2);
  CHECK(value("formed('house', [b1])", six).is_null());
  CHECK(value("formed('surround', [b1])", six).is_null());
}

TEST_CASE("the places of a ring are evenly spaced, clear of each other and of what they surround") {
  const auto six = cubes(6);
  const auto around = points(value("ring_around(bounds(b3), [b1, b2, b4, b5])", six));
  REQUIRE(around.size() == 4);
  const Vec3 middle = six.find("b3")->p_WO;
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(std::hypot(around[i].x() - middle.x(), around[i].y() - middle.y()) == Approx(0.1024).margin(1e-3));
    CHECK((around[i] - around[(i + 1) % 4]).norm() > 0.0849 + 0.03);
    CHECK(around[i].z() == 0);
  }
  const auto within = points(value("ring_within(table, [b1, b2, b3, b4, b5, b6])", six));
  REQUIRE(within.size() == 6);
  for (const auto& point : within)
    for (const auto& object : six.objects) CHECK((point - object.p_WO).head<2>().norm() > 0.06);
}

TEST_CASE("a ring turns so that its places are on the table") {
  const auto narrow = cubes(4, 0.26);
  for (const auto& point : points(value("ring_around(bounds(b3), [b1, b2])", narrow)))
    CHECK(std::abs(point.y()) < 0.13 - 0.042);
}

TEST_CASE("a goal that cannot be read is told at its document") {
  Catalogue catalogue;
  Voxeme voxeme;
  voxeme.entity = Voxeme::Entity::program;
  voxeme.predicate = "heap";
  voxeme.path = "heap.xml";
  voxeme.goal = "\\y. map(y, \\o. at(o, onn(o)))";
  catalogue.add(voxeme);
  const Formations formations(catalogue, WorldFacts::signature());
  REQUIRE(formations.problems().size() == 1);
  CHECK(formations.problems()[0].where == "heap.xml");
  CHECK_THAT(formations.problems()[0].sentence, Catch::Contains("onn"));
}
