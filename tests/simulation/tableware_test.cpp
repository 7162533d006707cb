// The scenes with tableware, and how objects of every kind are placed in them.
#include "continua/simulation/physics_body.h"
#include "continua/simulation/scene.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

const std::string scenes = source_dir() + "/mjcf/scenes/";

Scene loaded(const std::string& name, const std::vector<ObjectOverride>& overrides = {}) {
  auto scene = load_scene(scenes + name + ".xml", overrides);
  INFO((scene ? "" : scene.error().text()));
  REQUIRE(scene);
  return std::move(scene).value();
}

}  // namespace

TEST_CASE("plates and cups and knives have their sizes, and cups are hollow") {
  for (const char* name : {"emre_table", "place_setting"}) {
    const WorldSnapshot world = loaded(name).initial_snapshot();
    for (const auto& object : world.objects) {
      INFO(name << " " << object.name);
      const std::map<std::string, Vec3> large = {
          {"plate", {0.2, 0.2, 0.02}}, {"cup", {0.08, 0.08, 0.1}}, {"knife", {0.18, 0.024, 0.01}}};
      const std::map<std::string, Vec3> small = {{"block", {0.06, 0.06, 0.06}},
                                                 {"plate", {0.108, 0.108, 0.02}},
                                                 {"cup", {0.046, 0.046, 0.1}},
                                                 {"knife", {0.128, 0.0216, 0.01}}};
      const std::string& type = object.attributes.at("type");
      const auto& sizes = name == std::string("emre_table") ? small : large;
      CHECK((object.half_extents_m - sizes.at(type) / 2).norm() < 2e-4);
      CHECK(object.bounds_W().min.z() == 0);
      CHECK(object.interior.has_value() == (type == "cup"));
      if (!object.interior) continue;
      CHECK((object.interior->min.array() > -object.half_extents_m.array()).all());
      CHECK(object.interior->max.z() == Approx(object.half_extents_m.z()));
    }
  }
  CHECK(loaded("emre_table").objects().size() == 9);
}

TEST_CASE("the scenes stand still") {
  for (const char* name : {"emre_table", "place_setting"}) {
    const Scene scene = loaded(name);
    const WorldSnapshot before = scene.initial_snapshot();
    auto physics = Physics::create(scene).value();
    const AvatarTarget home{{physics->arm().home, ArmVector::Zero(physics->arm().size())}, 0.02};
    for (int i = 0; i < 1000; ++i) REQUIRE(physics->step(home));
    for (std::size_t i = 0; i < before.objects.size(); ++i) {
      INFO(name << " " << before.objects[i].name);
      const Pose pose = physics->object_pose(static_cast<int>(i));
      CHECK((pose.p_WB - before.objects[i].p_WO).norm() < 1e-3);
      const Eigen::Quaterniond R_WB(Eigen::AngleAxisd(before.objects[i].yaw, Vec3::UnitZ()));
      CHECK(pose.R_WB.angularDistance(R_WB) < 0.01);
    }
  }
}

TEST_CASE("objects that a trace places stand on the table, or on what is under them") {
  const auto height = [](double x, double y, double z) {
    const ObjectOverride plate{"plate", -0.2, 0.0, 0.01, {}, false};
    return loaded("place_setting", {{"cup", x, y, z, 0.0, false}, plate}).initial_snapshot().find("cup")->p_WO.z();
  };
  struct Row {
    double x, y, z, stands;
  };
  const Row rows[] = {
      {0.2, 0.2, 0.05, 0.05},    {0.2, 0.2, 0.033, 0.05},      {0.2, 0.2, 0.068, 0.05},  {0.2, 0.2, -0.3, 0.05},
      {0.2, 0.2, 0.2, 0.2},      {0.2, 1.2, -0.3, -0.3},       {-0.2, 0.0, 0.072, 0.07}, {-0.2, 0.0, 0.055, 0.07},
      {-0.25, 0.0, 0.069, 0.07}, {0.2, 0.2, 0.05005, 0.05005},
  };
  for (const auto& row : rows) {
    INFO(row.x << " " << row.y << " " << row.z);
    CHECK(height(row.x, row.y, row.z) == Approx(row.stands).margin(1e-4));
  }
}

TEST_CASE("the description for viewers has every part of a cup, and a removed cup is gone") {
  const auto parts = [](const Scene& scene, const char* body) {
    std::map<std::string, int> found;
    const Json description = scene.description();
    for (const auto& geom : description["geoms"]) found[geom["type"]] += geom["body"] == body;
    return found;
  };
  CHECK(parts(loaded("place_setting"), "cup_blue") ==
        std::map<std::string, int>{
            {"box", 15}, {"capsule", 0}, {"cylinder", 1}, {"ellipsoid", 0}, {"plane", 0}, {"sphere", 0}});
  const Scene rest = loaded("place_setting", {{"cup", {}, {}, {}, {}, true}});
  CHECK(parts(rest, "cup")["box"] == 0);
  CHECK(parts(rest, "cup_blue")["box"] == 15);
  CHECK(rest.objects().size() == 3);
}

TEST_CASE("a hollow that is no box of its body is an error") {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& in_cup, const std::string& in_world) {
    const auto scene = load_scene(folder.file(
        "s.xml", "<mujoco><worldbody><geom name='table_top' type='box' size='1 1 .1' pos='0 0 -.1'/>" + in_world +
                     "<body name='cup'><freejoint/><geom size='.1'/>" + in_cup + "</body></worldbody></mujoco>"));
    return scene ? "" : scene.error().sentence;
  };
  CHECK(error("<site name='cup_interior' type='box' size='.1 .1 .1'/>", "").empty());
  const std::string wrong = "site 'cup_interior': expected a box of that body, along its axes";
  CHECK(error("<site name='cup_interior' size='.1'/>", "") == wrong);
  CHECK(error("<site name='cup_interior' type='box' size='.1 .1 .1' euler='0 0 30'/>", "") == wrong);
  CHECK(error("", "<site name='cup_interior' type='box' size='.1 .1 .1'/>") == wrong);
}

TEST_CASE("whatever is asked of the arm ends with how it went, and things of every kind survive it") {
  struct Row {
    const char* object;
    std::optional<Relation> relation;
    std::vector<std::string> landmarks;
  };
  const Row rows[] = {
      {"cup", {}, {}},
      {"cup", Relation::in_front, {"human"}},
      {"cup_blue", Relation::on, {"plate"}},
      {"knife", Relation::in, {"cup"}},
      {"knife", Relation::left, {"knife"}},
      {"plate", Relation::in_front, {"avatar"}},
      {"knife", Relation::between, {"plate", "cup"}},
      {"cup", Relation::behind, {"avatar"}},
  };
  auto body = PhysicsBody::create(loaded("place_setting")).value();
  SimTime now;
  for (const auto& row : rows) {
    INFO(row.object << " " << (row.relation ? name_of(*row.relation) : "at a point"));
    AvatarCommand put;
    put.what = Capability::put;
    put.object = row.object;
    put.goal.relation = row.relation;
    put.goal.landmarks = row.landmarks;
    body->command(put);
    std::optional<ActReport> end;
    for (int i = 0; i < 400 && !(end && body->at_rest()); ++i) {
      const WorldReport report = body->advance(now + SimTime::from_seconds(0.1));
      now = report.until;
      for (const auto& act : report.acts)
        if (act.status != Status::started) end = act;
    }
    REQUIRE(end);
    CHECK(body->at_rest());
    CHECK((end->status == Status::done || !end->reason.empty()));
  }
}
