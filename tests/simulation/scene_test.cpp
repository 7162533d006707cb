#include "continua/simulation/scene.h"

#include <algorithm>

#include "continua/simulation/world_pace.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string staircase = source_dir() + "/mjcf/scenes/staircase.xml";

/// A scene file with that text, in a folder of the test program's own.
std::string written(const std::string& name, const std::string& text) {
  static const TemporaryFolder folder;
  return folder.file(name, text);
}

std::string error_of(const std::string& name, const std::string& text) {
  const auto scene = load_scene(written(name, text));
  REQUIRE_FALSE(scene.ok());
  return scene.error().text();
}

const std::string a_table = "<geom name='table_top' type='box' size='1 1 0.1' pos='0 0 -0.1'/>\n";

}  // namespace

TEST_CASE("the staircase has its blocks in order, at rest on the table") {
  const auto scene = load_scene(staircase);
  REQUIRE(scene.ok());
  const WorldSnapshot world = scene->initial_snapshot();
  std::vector<std::string> colors;
  for (const auto& object : world.objects) {
    colors.push_back(object.attributes.at("color"));
    CHECK(object.attributes.at("type") == "block");
    CHECK(object.half_extents_m.isApprox(Vec3::Constant(0.03), 1e-9));
    CHECK(object.p_WO.z() == Approx(0.03));
  }
  CHECK(colors == std::vector<std::string>{"yellow", "black", "green", "orange", "red", "purple"});
  CHECK(world.find("block3")->p_WO.isApprox(Vec3(0.3132, 0.0796, 0.03), 1e-9));
  CHECK(world.table.min.x() == Approx(-0.4952));
  CHECK(world.table.max.x() == Approx(0.4964));
  CHECK(world.table.min.y() == Approx(-0.1168));
  CHECK(world.table.max.y() == Approx(0.1168));
  CHECK(world.table.max.z() == 0);
}

TEST_CASE("overrides place and remove objects") {
  ObjectOverride moved{"block4", 0.1, -0.05, {}, 0.5, false};
  ObjectOverride high{"block5", {}, {}, 0.2, {}, false};
  ObjectOverride gone{"block1", {}, {}, {}, {}, true};
  const auto scene = load_scene(staircase, {moved, high, gone});
  REQUIRE(scene.ok());
  const WorldSnapshot world = scene->initial_snapshot();
  CHECK(world.objects.size() == 5);
  CHECK(world.find("block1") == nullptr);
  CHECK(world.find("block4")->p_WO.isApprox(Vec3(0.1, -0.05, 0.03), 1e-9));
  CHECK(world.find("block4")->yaw == Approx(0.5));
  CHECK(world.find("block5")->p_WO.z() == Approx(0.2));
  CHECK(scene->description()["bodies"].contains("block1") == false);
  CHECK(scene->text().find("name=\"block1\" pos") == std::string::npos);
}

TEST_CASE("an override of an unknown object names the nearest") {
  const auto scene = load_scene(staircase, {ObjectOverride{"blok4", {}, {}, {}, {}, true}});
  REQUIRE_FALSE(scene.ok());
  CHECK(scene.error().text().find("'blok4'") != std::string::npos);
  CHECK(scene.error().text().find("did you mean 'block") != std::string::npos);
}

TEST_CASE("the description has every geom and body of the scene") {
  const auto scene = load_scene(staircase);
  REQUIRE(scene.ok());
  const Json description = scene->description();
  int blocks = 0;
  for (const auto& geom : description["geoms"]) {
    CHECK(description["bodies"].contains(geom["body"].get<std::string>()));
    blocks += geom["body"].get<std::string>().starts_with("block");
  }
  CHECK(blocks == 6);
  const auto& geoms = description["geoms"];
  const auto is_floor = [](const Json& geom) { return geom["type"] == "plane" && geom["body"] == "world"; };
  CHECK(std::count_if(geoms.begin(), geoms.end(), is_floor) == 1);
  CHECK(geoms.size() > 25);
  CHECK(description["bodies"]["block6"] == Json::array({-0.144, 0.0656, 0.03, 1, 0, 0, 0}));
}

TEST_CASE("the description has what meshes consist of, where that is not too much") {
  const std::string wedge =
      "<mujoco><asset><mesh name='wedge' vertex='-.1 -.1 -.1  .1 -.1 -.1  -.1 .1 -.1  .1 .1 -.1  -.1 -.1 .1  .1 -.1 "
      ".1'/>"
      "</asset><worldbody><body name='table'>" +
      a_table + "</body><body name='ramp' pos='0 0 .1'><geom type='mesh' mesh='wedge'/></body></worldbody></mujoco>";
  const auto scene = load_scene(written("wedge.xml", wedge));
  if (!scene) FAIL(scene.error().text());
  const auto geoms = scene->description()["geoms"];
  REQUIRE(geoms.size() == 2);
  CHECK_FALSE(geoms[0].contains("mesh"));
  const auto& geom = geoms[1];
  CHECK(geom["type"] == "mesh");
  REQUIRE(geom.contains("mesh"));
  const auto &vertices = geom["mesh"]["vertices"], &faces = geom["mesh"]["faces"];
  CHECK(vertices.size() == 18);
  CHECK(faces.size() == 24);
  for (const auto& face : faces) CHECK((face >= 0 && face < 6));
  // Put by the geom's pose, the corners are where the file has them.
  const auto& q = geom["quat"];
  const Eigen::Quaterniond R_BG(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(), q[3].get<double>());
  double highest = -1;
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    const Vec3 corner(vertices[i].get<double>(), vertices[i + 1].get<double>(), vertices[i + 2].get<double>());
    const Vec3 p_B = R_BG * corner + Vec3(geom["pos"][0], geom["pos"][1], geom["pos"][2]);
    CHECK(p_B.cwiseAbs().isApprox(Vec3::Constant(0.1), 1e-3));
    highest = std::max(highest, p_B.z());
  }
  CHECK(highest == Approx(0.1).margin(1e-4));
}

TEST_CASE("the text of a scene has its inclusions in place, and loads again to the same") {
  const auto scene = load_scene(staircase);
  REQUIRE(scene.ok());
  CHECK(scene->text().find("<include") == std::string::npos);
  const auto again = load_scene(written("again.xml", scene->text()));
  REQUIRE(again.ok());
  CHECK(again->description() == scene->description());
  CHECK(again->text() == scene->text());
}

TEST_CASE("bad scenes are errors with a place and a sentence") {
  CHECK(load_scene("/nowhere/scene.xml").error().text().find("/nowhere/scene.xml") != std::string::npos);
  CHECK(error_of("empty.xml", "").find("empty.xml") != std::string::npos);
  CHECK(error_of("garbage.xml", "\x01\x02 not xml <<<").find("garbage.xml") != std::string::npos);
  CHECK(error_of("other.xml", "<html/>").find("expected an MJCF file") != std::string::npos);
  CHECK(error_of("unclosed.xml", "<mujoco>\n<worldbody>\n").find("unclosed.xml") != std::string::npos);
  CHECK(error_of("no_table.xml", "<mujoco><worldbody/></mujoco>").find("table_top") != std::string::npos);
  CHECK(error_of("unknown.xml", "<mujoco>\n<worldbody>\n<geom sise='1'/>\n</worldbody>\n</mujoco>")
            .find("unknown.xml:3: ") != std::string::npos);
  CHECK(error_of("mass.xml", "<mujoco>\n<worldbody>\n" + a_table +
                                 "<body name='x'>\n<freejoint/>\n</body>\n</worldbody>\n</mujoco>")
            .find("mass.xml") != std::string::npos);
  CHECK(error_of("loop.xml", "<mujoco>\n<include file='loop.xml'/>\n</mujoco>")
            .find("loop.xml:2: 'loop.xml' includes itself") != std::string::npos);
  CHECK(error_of("lost.xml", "<mujoco>\n\n<include file='lost_part.xml'/>\n</mujoco>")
            .find("lost.xml:3: cannot include") != std::string::npos);
  CHECK(error_of("off.xml",
                 "<mujoco><worldbody>" + a_table +
                     "<body name='cup'><freejoint/><geom size='0.1' pos='0 0 0.1'/></body></worldbody></mujoco>")
            .find("object 'cup'") != std::string::npos);
}

TEST_CASE("a time step that cannot be simulated is refused with its place") {
  const auto with_step = [](const std::string& step) {
    return written("step.xml",
                   "<mujoco>\n<option timestep='" + step + "'/>\n<worldbody>\n" + a_table + "</worldbody>\n</mujoco>");
  };
  for (const char* step : {"0", "-1", "1e-6", "1e-12", "0.2", "nan", "inf"}) {
    INFO(step);
    const auto scene = load_scene(with_step(step));
    REQUIRE_FALSE(scene.ok());
    CHECK(scene.error().text().find("step.xml:2: ") != std::string::npos);
  }
  for (const char* step : {"1e-5", "0.002", "0.1"}) CHECK(load_scene(with_step(step)).ok());
}

TEST_CASE("inclusions and sizes beyond all use are refused with their place") {
  written("i0.xml", "<mujoco>\n</mujoco>");
  for (int depth = 1; depth <= 30; ++depth) {
    const auto below = "<include file='i" + std::to_string(depth - 1) + ".xml'/>\n";
    written("i" + std::to_string(depth) + ".xml", "<mujoco>\n" + below + below + "</mujoco>");
  }
  CHECK(error_of("bomb.xml", "<mujoco>\n<include file='i30.xml'/>\n</mujoco>").find("expected at most 1000") !=
        std::string::npos);
  for (const char* size : {"nkey='1000000'", "nuser_body='100000000'", "njmax='1e9'"}) {
    const auto said = error_of("size.xml", "<mujoco>\n<size " + std::string(size) + "/>\n</mujoco>");
    CHECK(said.find("size.xml:2: ") != std::string::npos);
    CHECK(said.find("expected at most") != std::string::npos);
  }
}

TEST_CASE("an error in an included file names that file and its line") {
  written("part.xml", "<mujoco>\n<worldbody>\n\n<geom kolor='1'/>\n</worldbody>\n</mujoco>");
  const std::string text = error_of("whole.xml",
                                    "<mujoco>\n<!-- <include file='nothing.xml'/> -->\n<include file='part.xml'/>\n"
                                    "</mujoco>");
  CHECK(text.find("part.xml:4: ") != std::string::npos);
  CHECK(text.find("line") == std::string::npos);  // MuJoCo's, which counts in the text with all inclusions
  const auto world = [](const std::string& inside) {
    return "<mujoco>\n<worldbody>\n" + inside + "</worldbody>\n</mujoco>";
  };
  for (const std::string& part : {world("<geom size='-1'/>\n"), world("<geom size='1' material='none'/>\n"),
                                  world("<geom type='mesh' mesh='none'/>\n"), world("<geom class='none'/>\n")}) {
    written("part.xml", part);
    const auto said = error_of("whole.xml", "<mujoco>\n<include file='part.xml'/>\n</mujoco>");
    INFO(said);
    CHECK(said.find("part.xml:3: ") != std::string::npos);
    CHECK(said.find("line") == std::string::npos);
  }
}

TEST_CASE("a world that takes many times its time to work out is refused before it runs") {
  const auto with_balls = [](const std::string& step, int balls) {
    std::string inside = a_table;
    for (int i = 0; i < balls; ++i)
      inside += "<body name='b" + std::to_string(i) + "' pos='0 0 0.1'><freejoint/><geom size='0.1'/></body>\n";
    return written("balls.xml", "<mujoco>\n<option timestep='" + step +
                                    "'/>\n<size nconmax='2000' njmax='5000'/>\n"
                                    "<worldbody>\n" +
                                    inside + "</worldbody>\n</mujoco>");
  };
  CHECK_FALSE(check_pace(load_scene(staircase).value()));
  CHECK_FALSE(check_pace(load_scene(with_balls("0.002", 3)).value()));
  const auto slow = check_pace(load_scene(with_balls("0.00001", 40)).value());
  REQUIRE(slow);
  CHECK(slow->text().find("balls.xml: physics takes over 20 times") != std::string::npos);
}

TEST_CASE("a tipped object is seen as it lies") {
  SceneObject knife{"knife", 1, {}, Vec3(0.1, 0.02, 0.01)};
  for (const double x : {-0.1, 0.1})
    for (const double y : {-0.02, 0.02})
      for (const double z : {-0.01, 0.01}) knife.corners_B.push_back({x, y, z});
  const auto turn = [](double angle, const Vec3& axis) { return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)); };
  CHECK(observed(knife, {Vec3(0.12344, 0, 0), turn(0.3, Vec3::UnitZ())}).yaw == Approx(0.3));
  CHECK(observed(knife, {Vec3(0.12344, 0, 0), turn(0.3, Vec3::UnitZ())}).p_WO.x() == 0.1234);
  const ObjectState standing = observed(knife, {Vec3::Zero(), turn(1.5707963267948966, Vec3::UnitY())});
  CHECK(standing.half_extents_m.isApprox(Vec3(0.01, 0.02, 0.1), 1e-3));
  const ObjectState on_its_side = observed(knife, {Vec3::Zero(), turn(1.5707963267948966, Vec3::UnitX())});
  CHECK(on_its_side.half_extents_m.isApprox(Vec3(0.1, 0.01, 0.02), 1e-3));
}
