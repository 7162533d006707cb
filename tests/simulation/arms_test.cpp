// Any arm that follows mjcf/README.md: ours of seven and of six hinges, and one as others write them.
#include <fstream>
#include <sstream>

#include "continua/simulation/physics.h"
#include "support/stage.h"
#include "support/temporary_folder.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

const std::string root = CONTINUA_SOURCE_DIR;
const std::array arms = {root + "/mjcf/avatar/arm7.xml", root + "/mjcf/avatar/arm6.xml",
                         root + "/tests/simulation/arms/seven_axis.xml"};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

/// A shipped scene with another arm in it.
Scene scene_with(const std::string& arm, const std::string& scene) {
  std::ifstream file(root + "/mjcf/scenes/" + scene + ".xml");
  std::stringstream text;
  text << file.rdbuf();
  const TemporaryFolder folder;
  const auto with_arm = replaced(text.str(), "../avatar/arm7.xml", arm);
  return load_scene(folder.file("scene.xml", replaced(with_arm, "../objects", root + "/mjcf/objects"))).value();
}

}  // namespace

TEST_CASE("an arm is read from its model: what it measures, and where its tool is") {
  for (const auto& arm : arms) {
    INFO(arm);
    const auto physics = Physics::create(scene_with(arm, "staircase")).value();
    const AvatarForm& avatar = physics->avatar();
    CHECK(avatar.arm.size() == (arm == arms[1] ? 6 : 7));
    const Pose X_WT = tool_pose(avatar.arm, avatar.arm.home);
    CHECK((X_WT.R_WB * Vec3::UnitX()).z() < -0.99);  // fingers down
    const double natural = avatar.natural_yaw(X_WT.p_WB);
    CHECK((X_WT.R_WB * Vec3::UnitY()).dot(Vec3(std::cos(natural), std::sin(natural), 0)) > -0.01);
    CHECK(avatar.hand.widest_opening_m > 0.03);
    CHECK(avatar.hand.finger_N_per_m == Approx(arm == arms[2] ? 50 : 800));
    CHECK(avatar.hand.finger_tip_m > 0.005);
    CHECK(avatar.hand.palm_back_m > avatar.hand.palm_front_m);
    CHECK(avatar.parts.size() >= 2);
    CHECK(avatar.least_wrist < -1.6);
    CHECK(avatar.most_wrist > 1.6);
  }
}

TEST_CASE("every arm reaches the blocks' table, grasps, lifts, points and puts") {
  for (const auto& arm : arms) {
    INFO(arm);
    Stage stage(scene_with(arm, "staircase"));
    for (const char* block : {"block1", "block4", "block7"}) {
      INFO(block);
      CHECK(stage.act(Capability::reach, block).status == Status::done);
      CHECK(stage.act(Capability::point, block).status == Status::done);
      const ActReport lift = stage.act(Capability::lift, block);
      CHECK(lift.status == Status::done);
      INFO(words_of(lift.reason));
      CHECK(stage.body->snapshot().find(block)->p_WO.z() > 0.12);
      CHECK(stage.act(Capability::ungrasp, block).status == Status::done);
      CHECK(stage.body->snapshot().held.empty());
    }
    const auto put = [&](const std::string& object, const Goal& goal) {
      const ActReport end = stage.act(Capability::put, object, goal);
      INFO(object << ": " << words_of(end.reason));
      CHECK(end.status == Status::done);
      CHECK(end.position_error_m < 0.005);
    };
    put("block1", at(0.1, -0.05));
    put("block4", by(Relation::on, "block1"));
    put("block7", at(-0.03, -0.05));
    put("block6", by(Relation::on, "block7"));
    put("block5", by(Relation::on, "block6"));
  }
}

TEST_CASE("every arm handles plate, cup and knife") {
  for (const auto& arm : arms) {
    INFO(arm);
    Stage stage(scene_with(arm, "place_setting"));
    const auto put = [&](const std::string& object, const Goal& goal) {
      const ActReport end = stage.act(Capability::put, object, goal);
      INFO(object << ": " << name_of(end.status) << ", " << words_of(end.reason));
      CHECK(end.status == Status::done);
    };
    put("knife", at(-0.02, -0.1));
    if (arm != arms[2]) {  // its fingers are too thick for the plate's edge, and open less than the cup is wide
      put("plate", at(-0.15, -0.05));
      put("cup", by(Relation::on, "plate"));
      put("cup_blue", at(0.2, 0.05));
    }
  }
}
