#include "continua/facts/world_facts.h"

#include <set>
#include <sstream>

#include "continua/core/located_json.h"
#include "continua/core/random.h"
#include "continua/learning/learning.h"
#include "continua/voxml/catalogue.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/markdown_table.h"

namespace continua {
namespace {

std::string facts_page() { return read_file(source_dir() + "/engine/facts/FACTS.md").value(); }

Vec3 read_vector(const std::string& text) {
  std::istringstream stream(text);
  Vec3 vector;
  stream >> vector.x() >> vector.y() >> vector.z();
  return vector;
}

// The world that FACTS.md describes.
WorldSnapshot documented_world() {
  WorldSnapshot world;
  world.table = {{-0.6, -0.4, 0}, {0.6, 0.4, 0}};
  world.held = "block2";
  for (const auto& row : table_rows(facts_page(), 4)) {
    ObjectState object;
    object.name = row[0];
    std::istringstream attributes(row[1]);
    for (std::string each; attributes >> each;)
      object.attributes[each.substr(0, each.find('='))] = each.substr(each.find('=') + 1);
    object.half_extents_m = read_vector(row[2]) / 2;
    object.p_WO = read_vector(row[3]);
    world.objects.push_back(object);
  }
  return world;
}

const Catalogue& voxemes() {
  static const Catalogue catalogue = read_catalogue(source_dir() + "/engine/knowledge/voxemes").catalogue;
  return catalogue;
}

ObjectState cube(const char* name, double side, double x, double y, double z, double yaw = 0) {
  ObjectState object;
  object.name = name;
  object.half_extents_m = Vec3::Constant(side / 2);
  object.p_WO = {x, y, z};
  object.yaw = yaw;
  return object;
}

WorldSnapshot world_of(std::vector<ObjectState> objects) {
  WorldSnapshot world;
  world.table = {{-0.6, -0.4, 0}, {0.6, 0.4, 0}};
  world.objects = std::move(objects);
  return world;
}

// Evaluates texts in a world.
class Seen {
 public:
  explicit Seen(WorldSnapshot world, std::uint64_t seed = 1, Perspective perspective = Perspective::human)
      : world_(std::move(world)), random_(seed), facts_(perspective, &voxemes()) {
    const auto program = parse_term("\\x. [grasp(x), lift(x)]", names_of({{"grasp", "e -> t"}, {"lift", "e -> t"}}));
    learned_.gestures.emplace("claw",
                              parse_term("lift(block2)", names_of({{"lift", "e -> t"}, {"block2", "e"}})).value());
    learned_.programs.emplace("hoist", Program{program.value()});
    names_.insert(WorldFacts::signature().begin(), WorldFacts::signature().end());
    for (const auto& object : world_.objects) names_.emplace(object.name, Type::entity());
    for (const auto* each : {"ghost", "avatar", "human"}) names_.emplace(each, Type::entity());
    for (const auto* each : {"left", "right", "in_front", "behind", "on", "over"})
      names_.emplace(each, Type::parse("e -> loc").value());
    for (const auto* each : {"in", "near"}) names_.emplace(each, Type::parse("term -> loc").value());
    for (const auto* each : {"put", "slide"}) names_.emplace(each, Type::parse("e -> loc -> t").value());
    names_.emplace("between", Type::parse("e -> term -> loc").value());
  }

  Term term(std::string_view text) {
    INFO(text);
    auto read = parse_term(text, names_);
    if (!read) FAIL(read.error().text());
    const RuleTable rules({&term_rules(), &facts_.rules()});
    Evaluation evaluation(rules, nullptr, {.world = &world_, .random = &random_, .learned = &learned_});
    Term value = evaluation.value(*read);
    margin = evaluation.margin;
    return value;
  }
  std::string value(std::string_view text) { return print(term(text)); }
  bool is(std::string_view text) { return term(text).is_true(); }

  double margin = 0;

 private:
  static Signature names_of(const std::map<std::string, std::string>& types) {
    Signature names;
    for (const auto& [name, type] : types) names.emplace(name, Type::parse(type).value());
    return names;
  }

  WorldSnapshot world_;
  Random random_;
  Learned learned_;
  WorldFacts facts_;
  Signature names_ = term_signature();
};

}  // namespace

TEST_CASE("every example of FACTS.md is true, and every fact has one") {
  Seen seen(documented_world());
  std::set<std::string> documented;
  for (const auto& row : table_rows(facts_page(), 5)) {
    const auto &name = row[0], &type = row[1], &example = row[3], &value = row[4];
    INFO(name << ": " << example);
    CHECK(documented.insert(name).second);
    REQUIRE(WorldFacts::signature().contains(name));
    CHECK(WorldFacts::signature().at(name).text() == type);
    CHECK(seen.value(example) == value);
    CHECK(example.find(name) != std::string::npos);
  }
  std::set<std::string> names;
  for (const auto& [name, type] : WorldFacts::signature()) names.insert(name);
  CHECK(documented == names);
}

TEST_CASE("a place that two relations share is on the table, free, and in as exact a sense as there is") {
  Seen seen(world_of({cube("a", 0.1, 0, 0, 0.05), cube("b", 0.1, 0.3, 0.3, 0.05), cube("c", 0.06, -0.5, -0.3, 0.03)}));
  CHECK(seen.value("common_place(c, right(a), in_front(b))") == "<0.23, 0.07, 0>");  // the nearest exact one
  CHECK(seen.value("common_place(c, left(a), right(b))") == "null");
  CHECK(seen.value("common_place(c, behind(b), right(b))") == "<0.38, 0.35, 0>");  // loosely: nothing is both exactly
  CHECK(seen.value("common_place(a, near(b), <0.1, 0.1, 0>)") == "<0.1, 0.1, 0>");
  CHECK(seen.value("common_place(a, left(c), behind(b))") == "null");  // it would reach over the edge
  CHECK(seen.value("common_place(ghost, right(a), left(b))") == "null");
}

TEST_CASE("who sits on the other side calls sides of things the other way round, but not their own") {
  Seen seen(world_of({cube("a", 0.1, 0, 0, 0.05)}));
  CHECK(seen.value("as_seen_by(avatar, left(a))") == "right(a)");
  CHECK(seen.value("as_seen_by(avatar, behind(a))") == "in_front(a)");
  CHECK(seen.value("as_seen_by(human, left(a))") == "left(a)");
  CHECK(seen.value("as_seen_by(avatar, near(a))") == "near(a)");
  CHECK(seen.value("as_seen_by(avatar, left(avatar))") == "left(avatar)");
  CHECK(seen.value("as_seen_by(avatar, <0.1, 0.2, 0>)") == "<0.1, 0.2, 0>");
  CHECK(seen.value("as_seen_by(a, left(a))") == "null");
  CHECK(seen.value("as_seen_by(avatar, left(ghost))") == "null");
}

TEST_CASE("what is not in the world gives null, and so does no world") {
  Seen seen(documented_world());
  for (const auto* text : {"position(ghost)", "bounds(ghost)", "attribute(ghost, 'type')", "attribute(plate, 'color')",
                           "volume(ghost)", "closest(ghost, table)", "clear(ghost, 0)", "fits(ghost, table, [])",
                           "free_place(ghost, table)", "position(null)"})
    CHECK(seen.value(text) == "null");
  CHECK(Seen(world_of({})).value("[held, head(scene)]") == "[null, null]");

  const WorldFacts blind(Perspective::human);
  for (const auto& [name, rule] : blind.rules()) {
    INFO(name);
    const std::vector<Term> arguments(rule.arity, Term::entity("plate"));
    const RuleTable rules({});
    Evaluation evaluation(rules, nullptr);
    CHECK(rule.compute(arguments, evaluation).is_null());
  }
}

TEST_CASE("the closest point of a box is on it, or the place itself when that is within") {
  Seen seen(world_of({cube("block1", 0.1, 0, 0, 0.05)}));
  CHECK(seen.value("closest(block1, <0.2, 0.3, 0.4>)") == "<0.05, 0.05, 0.1>");
  CHECK(seen.value("closest(block1, <0.01, -0.02, 0.03>)") == "<0.01, -0.02, 0.03>");
  CHECK(seen.value("closest(block1, box(<1, 0, 0>, <2, 0, 0>))") == "<0.05, 0, 0>");
}

TEST_CASE("a top is clear by what share of it is covered, and by what touches it") {
  const auto covered = [](double x, double bottom) {
    return Seen(world_of({cube("base", 0.1, 0, 0, 0.05), cube("top", 0.1, x, 0, bottom + 0.05)}));
  };
  CHECK_FALSE(covered(0, 0.1).is("clear(base, 0)"));
  CHECK(covered(0, 0.1).is("clear(top, 0)"));
  CHECK_FALSE(covered(0.06, 0.1).is("clear(base, 1 / 3)"));  // covers 0.4
  CHECK(covered(0.07, 0.1).is("clear(base, 1 / 3)"));        // covers 0.3
  CHECK_FALSE(covered(0.07, 0.1).is("clear(base, 0)"));
  CHECK(covered(0.1, 0.1).is("clear(base, 0)"));         // side by side
  CHECK(covered(0, 0.1).is("clear(base, 1)"));           // covers all of it, but not more
  CHECK_FALSE(covered(0, 0.1011).is("clear(base, 0)"));  // a gap below 1.2 mm
  CHECK(covered(0, 0.1013).is("clear(base, 0)"));
  CHECK_FALSE(covered(0, 0.0989).is("clear(base, 0)"));  // sunk in by less than 1.2 mm
  CHECK(covered(0, 0.05).is("clear(base, 0)"));          // not on top, but through it

  Seen near(covered(0.07, 0.1));
  near.is("clear(base, 0)");
  CHECK(near.margin == Approx(0.0012));
  CHECK(Seen(world_of({cube("base", 0.1, 0, 0, 0.05)})).is("clear(base, 0)"));
}

TEST_CASE("a box fits where it meets nothing, touching is not meeting") {
  Seen seen(world_of({cube("block1", 0.1, 0, 0, 0.05), cube("block2", 0.1, 0.3, 0, 0.05),
                      cube("high", 0.1, -0.3, 0, 0.15), cube("turned", 0.1, 0, 0.3, 0.05, 0.785398163)}));
  CHECK(seen.is("fits(block1, <0, 0, 0>, [])"));
  CHECK_FALSE(seen.is("fits(block1, <0.3, 0, 0>, [])"));
  CHECK(seen.is("fits(block1, <0.3, 0, 0>, [block2])"));
  CHECK(seen.is("fits(block1, <0.3, 0, 0>, [ghost, block2])"));
  CHECK(seen.is("fits(block1, <0.2, 0, 0>, [])"));
  CHECK(seen.is("fits(block1, <0.2011, 0, 0>, [])"));
  CHECK_FALSE(seen.is("fits(block1, <0.2013, 0, 0>, [])"));
  CHECK(seen.is("fits(block1, <-0.3, 0, 9>, [])"));  // below a thing that is high up
  CHECK(seen.is("fits(block1, <0, 0.17, 0>, [])"));
  CHECK_FALSE(seen.is("fits(turned, <0.118, 0, 0>, [])"));  // its corners reach further than its sides
  CHECK(seen.is("fits(turned, <0.12, 0, 0>, [])"));
}

TEST_CASE("a free place is where the object fits, within the region, the same for the same seed") {
  const auto world = world_of({cube("block1", 0.1, 0, 0, 0.05), cube("block2", 0.1, 0.3, 0, 0.05)});
  Seen seen(world), again(world), other(world, 2);
  for (int i = 0; i < 50; ++i) {
    const std::string place = seen.value("free_place(block1, box(<0.1, -0.2, 0.01>, <0.5, 0.2, 0.01>))");
    CHECK(place == again.value("free_place(block1, box(<0.1, -0.2, 0.01>, <0.5, 0.2, 0.01>))"));
    CHECK(place != other.value("free_place(block1, box(<0.1, -0.2, 0.01>, <0.5, 0.2, 0.01>))"));
    CHECK(seen.is("fits(block1, " + place + ", []) and z(" + place + ") = 0.01 and inside(" + place +
                  ", box(<0.1, -0.2, 0>, <0.5, 0.2, 0>))"));
  }
  CHECK(seen.value("free_place(block1, box(<0.29, -0.01, 0>, <0.31, 0.01, 0>))") == "null");
}

TEST_CASE("a thing is located where a place term says, as the perspective sees it") {
  const auto world = world_of({cube("block1", 0.1, 0, 0, 0.05), cube("block2", 0.1, 0.3, 0.02, 0.05),
                               cube("block3", 0.1, -0.3, 0, 0.05), cube("block4", 0.1, 0.3, 0.02, 0.15)});
  Seen human(world), avatar(world, 1, Perspective::avatar);
  CHECK(human.is("located(block2, right(block1))"));
  CHECK(human.margin == Approx(0.08));
  CHECK(human.value("located(block2, left(block1))") == "false");
  CHECK(avatar.value("located(block2, left(block1))") == "true");
  CHECK(avatar.value("located(block2, right(block1))") == "false");
  for (const auto* term :
       {"located(block1, between(block2, block3))", "located(block4, on(block2))", "located(block2, left(avatar))",
        "located(block2, <0.305, 0.015, 0>)", "located(block2, near(<0.4, 0.02, 0>))",
        "located(block2, box(<0.2, 0, 0>, <0.4, 0.1, 0>))", "located(block2, in(box(<0.2, 0, 0>, <0.4, 0.1, 0>)))",
        "located(block1, between(block3, <0.3, 0, 0>))"}) {
    INFO(term);
    CHECK(human.is(term));
    CHECK(avatar.is(term));
  }
  for (const auto* term : {"located(ghost, on(block1))", "located(block1, on(ghost))", "located(block1, over(block2))",
                           "located(block1, null)", "located(block1, on(null))", "offset(block2, 'over')",
                           "offset(block2, 'on')", "offset(ghost, 'left')"}) {
    INFO(term);
    CHECK(human.value(term) == "null");
  }
  CHECK(human.value("map([left, right], \\side. located(block2, side(block1)))") == "[false, true]");
  CHECK(human.value("\\v. located(block2, left(v))") == "\\v. located(block2, left(v))");
  CHECK(human.value("map(['left', 'right', 'in_front', 'behind'], offset(block2))") == "[-0.3, 0.3, -0.02, 0.02]");
  CHECK(avatar.value("map(['left', 'right', 'in_front', 'behind'], offset(block2))") == "[0.3, -0.3, 0.02, -0.02]");
}

TEST_CASE("candidates of a region are found with facts and functions together") {
  Seen seen(documented_world());
  CHECK(seen.value("filter(scene, \\o. attribute(o, 'type') = 'block' and o != held and clear(o, 1 / 3) and "
                   "inside(closest(o, <0.1, 0, 0>), square(<0.1, 0, 0>, 0.2)))") == "[block3]");
  CHECK(seen.value("sort_by(scene, \\o. negate(z(position(o))))") == "[block2, block3, block1, plate]");
}

}  // namespace continua
