// Any arm that follows mjcf/README.md: ours of seven and of six hinges, and four as others write them, of which three
// are told of by the scene that includes their files.
#include "continua/simulation/arm_check.h"
#include "continua/simulation/physics.h"
#include "simulation/arm_scenes.h"
#include "support/stage.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

/// The blocks' scene with our arm of seven hinges, in which a text is replaced.
Scene scene_of_changed_arm(const std::vector<std::pair<std::string, std::string>>& changes) {
  const TemporaryFolder folder;
  auto text = text_of(arms[0]);
  for (const auto& [what, with] : changes) {
    REQUIRE(text.find(what) != std::string::npos);
    text = replaced(text, what, with);
  }
  return scene_with(folder.file("arm.xml", text), "staircase");
}

std::string notes_on(const Scene& scene) {
  std::string all;
  for (const auto& note : arm_notes(scene)) all += note + "\n";
  return all;
}

const std::vector<std::pair<std::string, std::string>> damped = {{"damping=\"1\"", "damping=\"200\""},
                                                                 {"damping=\"0.2\"", "damping=\"200\""}};

}  // namespace

TEST_CASE("an arm is read from its model: what it measures, and where its tool is") {
  for (const auto& arm : arms) {
    INFO(arm);
    const auto physics = Physics::create(scene_with(arm, "staircase")).value();
    const AvatarForm& avatar = physics->avatar();
    CHECK(avatar.arm.size() == (arm == arms[1] || arm == arms[4] ? 6 : 7));
    const Pose X_WT = tool_pose(avatar.arm, avatar.arm.home);
    CHECK((X_WT.R_WB * Vec3::UnitX()).z() < -0.99);  // fingers down
    const double natural = avatar.natural_yaw(X_WT.p_WB);
    CHECK((X_WT.R_WB * Vec3::UnitY()).dot(Vec3(std::cos(natural), std::sin(natural), 0)) > -0.01);
    CHECK(avatar.hand.widest_opening_m > 0.03);
    const std::map<std::string, double> weaker = {{arms[2], 50}, {arms[3], 50}, {arms[4], 400}, {arms[5], 1000}};
    CHECK(avatar.hand.finger_N_per_m == Approx(weaker.contains(arm) ? weaker.at(arm) : 800));
    CHECK(avatar.hand.finger_tip_m > 0.005);
    CHECK(avatar.hand.palm_back_m > avatar.hand.palm_front_m);
    CHECK(avatar.parts.size() >= 2);
    CHECK(avatar.least_wrist < -1.57);  // a quarter turn is enough: the pads are alike
    CHECK(avatar.most_wrist > 1.57);
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
    if (arm != arms[3]) put("knife", at(-0.02, -0.1));  // flatter than its fingertips grip
    // The fingers of others are too thick for the plate's edge, and open less than the cup is wide.
    if (arm == arms[0] || arm == arms[1]) {
      put("plate", at(-0.15, -0.05));
      put("cup", by(Relation::on, "plate"));
      put("cup_blue", at(0.2, 0.05));
    }
  }
}

TEST_CASE("keyframes of an arm, which are shorter than the scene, are left out") {
  CHECK(text_of(arms[3]).find("<key ") != std::string::npos);
  CHECK(scene_with(arms[3], "staircase").text().find("<key ") == std::string::npos);
}

TEST_CASE("servos are tried for so long, and it is said where that was not enough") {
  const auto notes = arm_notes(scene_with(arms[0], "staircase"), 0.01);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::Matchers::Contains("were not tried: at time steps of 0.002 s"));
}

TEST_CASE("notes on an arm say what keeps it from working, and nothing of arms that work") {
  for (const auto& arm : {arms[0], arms[1], arms[2]}) {
    INFO(arm);
    CHECK(notes_on(scene_with(arm, "staircase")).empty());
  }
  CHECK_THAT(notes_on(scene_with(arms[3], "staircase")),
             Catch::Matchers::Contains("'pad_left' has 4 of its geoms in front of it, by up to 1.5 mm"));
  const auto far = notes_on(scene_of_changed_arm({{"pos=\"0 0.428 0\"", "pos=\"0 3 0\""}}));
  CHECK_THAT(far, Catch::Matchers::Contains("does not get from home to block1"));
  CHECK_THAT(far, Catch::Matchers::Contains("to 0 of 15 places"));
  CHECK_THAT(notes_on(scene_of_changed_arm({{"euler=\"0 0 -90\" childclass", "euler=\"0 0 90\" childclass"}})),
             Catch::Matchers::Contains("does not get from home to block1"));
  CHECK_THAT(notes_on(scene_of_changed_arm(damped)), Catch::Matchers::Contains("'arm_5' is sluggish"));
  CHECK_THAT(notes_on(scene_of_changed_arm({{"forcerange=\"-40 40\"", "forcerange=\"-0.3 0.3\""}})),
             Catch::Matchers::Contains("'arm_2' is sluggish"));
}

TEST_CASE("a grip site that is turned is told with its angle") {
  const std::string site = "<site name=\"grip\"";
  for (const auto& [euler, expected] : {std::pair("0 90 0", "out of the palm: it points 90 degrees off"),
                                        std::pair("0 0 180", "out of the palm: it points 180 degrees off"),
                                        std::pair("0 0 90", "along the y axis of site 'grip': they are 90 degrees"),
                                        std::pair("30 0 0", "along the y axis of site 'grip': they are 30 degrees")}) {
    INFO(euler);
    const auto turned = scene_of_changed_arm({{site, site + " euler=\"" + euler + "\""}});
    const auto physics = Physics::create(turned);
    REQUIRE_FALSE(physics.ok());
    CHECK_THAT(physics.error().text(), Catch::Matchers::Contains(expected));
  }
}

TEST_CASE("an arm whose servos do not follow meets no obstacle: it lags") {
  Stage stage(scene_of_changed_arm(damped));
  const ActReport end = stage.act(Capability::put, "block4", by(Relation::on, "block1"));
  CHECK(end.status == Status::blocked);
  CHECK(name_of(end.reason.code) == "lags");
}
