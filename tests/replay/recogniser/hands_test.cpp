// Hands before a camera, as pointing rays.
#include <cmath>

#include "continua/core/replaced_file.h"
#include "continua/replay/recogniser/camera.h"
#include "continua/replay/recogniser/hand_forms.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

// A hand with its index finger stretched and the others bent, in metres from its middle, along the axes of C.
std::vector<Vec3> pointing_hand() {
  std::vector<Vec3> points(21, Vec3(0, 0.02, 0));
  points[0] = {0, 0.06, 0.01};       // wrist
  points[5] = {0.01, 0, 0.02};       // the index finger's knuckle
  points[6] = {0.015, -0.03, 0.03};  // its joint
  points[8] = {0.02, -0.06, 0.05};   // its tip
  for (const std::size_t joint : {10, 14, 18}) points[joint] = {-0.01, -0.02, 0.01};
  return points;
}

// The frame that MediaPipe would give of the hand with its middle at `p_C`, by a camera 90° wide and 2:1.
std::string frame(const std::vector<Vec3>& hand, const Vec3& p_C, bool mirrored) {
  Json picture = Json::array(), world = Json::array();
  for (const auto& point : hand) {
    const Vec3 seen = p_C + point;
    const double across = (seen.x() / seen.z() + 1) / 2, down = (seen.y() / seen.z() / 0.5 + 1) / 2;
    picture.push_back({{"x", mirrored ? 1 - across : across}, {"y", down}, {"z", 0}});
    world.push_back({{"x", mirrored ? -point.x() : point.x()}, {"y", point.y()}, {"z", point.z()}});
  }
  return fmt::format(R"({{"timestamp_ms": 500, "gestures": [[{{"category_name": "None", "score": 0.9}}]],
    "handedness": [[{{"category_name": "Right", "score": 0.9}}]],
    "hand_landmarks": [{}], "hand_world_landmarks": [{}]}})",
                     compact(picture), compact(world));
}

std::shared_ptr<const Camera> camera(const std::string& more) {
  const auto file = binary_dir() + "/hands_test.camera.json";
  REQUIRE_FALSE(
      replace_file(file, R"({"position": [0, 1, 0.5], "looks_at": [0, 0, 0.5], "size": [800, 400], )" + more));
  const auto read = named_camera(file);
  INFO((read ? std::string() : read.error().text()));
  REQUIRE(read);
  return *read;
}

const std::string knowledge = source_dir() + "/engine/knowledge";

Json ray(const char* format, const std::string& output, std::shared_ptr<const Camera> seen_by) {
  const auto events = read_output(*recogniser_format(format), output, {"hands", false, std::move(seen_by), knowledge});
  REQUIRE(events);
  return events->empty() ? Json() : (*events)[0]["ray"];
}

TEST_CASE("A pointing hand is a ray in the world, mirrored or not") {
  // The camera is across the table and looks toward the human: its right is -x, its depth -y, its down -z.
  for (const bool mirrored : {false, true}) {
    const auto seen_by = camera(fmt::format(R"("field_of_view": 1.5707963268, "mirrored": {}}})", mirrored));
    const auto found = ray("mediapipe", frame(pointing_hand(), {0.1, 0.2, 0.6}, mirrored), seen_by);
    const Vec3 direction_C = Vec3(0.01, -0.06, 0.03).normalized();
    REQUIRE(found.is_object());
    const Vec3 expected[] = {{-0.12, 0.35, 0.36}, {-direction_C.x(), -direction_C.z(), -direction_C.y()}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(std::abs(found["from"][axis].get<double>() - expected[0][static_cast<int>(axis)]) < 2e-4);
      CHECK(std::abs(found["direction"][axis].get<double>() - expected[1][static_cast<int>(axis)]) < 2e-4);
    }
  }
}

TEST_CASE("A hand that does not point, or that no camera is told of, is no ray") {
  const auto seen_by = camera(R"("field_of_view": 1.5707963268})");
  auto open = pointing_hand();
  for (const std::size_t tip : {12, 16, 20}) open[tip] = {-0.01, -0.06, 0.03};
  CHECK(ray("mediapipe", frame(open, {0, 0, 0.6}, false), seen_by).is_null());
  CHECK(ray("mediapipe", frame(pointing_hand(), {0, 0, 0.6}, false), nullptr).is_null());
}

TEST_CASE("A finger's tip is on the table where the picture shows it, if the table's corners are known") {
  const auto file = binary_dir() + "/hands_test.camera.json";
  const auto seen = [&](const std::string& text, double across, double down) {
    REQUIRE_FALSE(replace_file(file, text));
    const auto read = read_camera(file);
    INFO((read ? std::string() : read.error().text()));
    REQUIRE(read);
    const auto target = target_of(across, down, *read);
    return target ? compact(*target) : "none";
  };
  // The table's far edge, y = 0.3, is seen half as long as the near one.
  const std::string table =
      R"({"corners": [{"seen": [0.3, 0.2], "is": [-0.5, 0.3]}, {"seen": [0.7, 0.2], "is": [0.5, 0.3]},
                                            {"seen": [0.9, 0.8], "is": [0.5, -0.3]}, {"seen": [0.1, 0.8], "is": [-0.5, -0.3]}]})";
  CHECK(seen(table, 0.3, 0.2) == "[-0.5,0.3]");
  CHECK(seen(table, 0.9, 0.8) == "[0.5,-0.3]");
  CHECK(seen(table, 0.5, 0.4) == "[0.0,0.0]");  // where the diagonals meet
  CHECK(seen(table, 0.5, -0.5) == "none");      // above the horizon
  // As of a recogniser: the tip of the pointing hand's finger.
  const auto seen_by = named_camera(file);
  REQUIRE(seen_by);
  const auto events = read_output(*recogniser_format("mediapipe"), frame(pointing_hand(), {0, 0.2, 1}, false),
                                  {"hands", false, *seen_by, knowledge});
  REQUIRE(events);
  REQUIRE(events->size() == 1);
  CHECK_FALSE((*events)[0].contains("ray"));
  CHECK((*events)[0]["target"] == *target_of(0.5 + 0.01 / 1.05, 0.5 + 0.14 / 1.05, **seen_by));
}

// A frame of a HandLandmarker, which tells no gestures: one hand in the form of an example, or no hand.
std::string landmarks(int ms, const Json& hand) {
  Json world = Json::array();
  for (const auto& point : hand) world.push_back({{"x", point[0]}, {"y", point[1]}, {"z", point[2]}});
  Json frame = {{"timestamp_ms", ms}, {"handedness", Json::array()}, {"worldLandmarks", Json::array()}};
  if (!hand.empty()) {
    frame["handedness"].push_back(Json::array({{{"categoryName", "Left"}, {"score", 0.75}}}));
    frame["worldLandmarks"].push_back(world);
  }
  return compact(frame);
}

std::string told_of(const std::string& frames) {
  const auto events = read_output(*recogniser_format("mediapipe"), frames, {"hands", false, nullptr, knowledge});
  if (!events) return events.error().text();
  std::string told;
  for (const auto& event : *events)
    told += fmt::format("{} {} {} {}; ", compact(event["t"]), event["name"].get<std::string>(),
                        event["phase"].get<std::string>(), compact(event["confidence"]));
  return told;
}

TEST_CASE("A hand whose gesture nobody tells has that of its form, once for as long as it is held") {
  const auto path = knowledge + "/hand_forms.json";
  const auto examples = LocatedJson::read(path)->root()["examples"];
  REQUIRE(examples.size() > 3);
  for (const auto& example : examples) {
    std::string frames;
    for (int ms = 0; ms <= 1000; ms += 50)
      frames += landmarks(ms, ms < 200 || ms > 800 ? Json::array() : example["hand"]);
    const auto name = example["form"].is_null() ? "" : example["form"].get<std::string>();
    CHECK(told_of(frames) == (name.empty() ? "" : fmt::format("0.2 {0} start 0.75; 0.8 {0} stop 0.75; ", name)));
  }
}

TEST_CASE("Slow frames show a gesture that two in a row have") {
  const auto hand = LocatedJson::read(knowledge + "/hand_forms.json")->root()["examples"][2]["hand"];
  const auto none = Json::array();
  CHECK(told_of(landmarks(0, hand) + landmarks(1500, none) + landmarks(3000, hand) + landmarks(4500, hand) +
                landmarks(6000, hand) + landmarks(7500, none)) == "4.25 stop start 0.75; 7.25 stop stop 0.75; ");
  // The recogniser stood still between two.
  CHECK(told_of(landmarks(0, hand) + landmarks(1000, hand) + landmarks(9000, hand)) ==
        "0.75 stop start 0.75; 1.0 stop stop 0.75; ");
}

TEST_CASE("Forms of a hand are checked") {
  const std::pair<const char*, const char*> faults[] = {
      {R"({"hand_forms": 1, "forms": {"fist": {"measures": {"index.strech": [0, 1]}}}})", "did you mean"},
      {R"({"hand_forms": 1, "forms": {"fist": {"measures": {"index.up": [1, 0]}}}})", "not less"},
      {R"({"hand_forms": 1, "forms": {"fist": {"points_with": "toe", "measures": {}}}})", "toe"},
      {R"({"hand_forms": 1, "forms": {}, "examples": [{"form": "fist", "hand": [[0, 0, 0]]}]})", "found 1 points"}};
  for (const auto& [text, sentence] : faults) {
    const auto problems = hand_form_problems(text, "forms.json");
    REQUIRE(problems.size() == 1);
    INFO(problems[0].text());
    CHECK(problems[0].text().find(sentence) != std::string::npos);
  }
}

TEST_CASE("A forearm of ROS4HRI is a ray, through all frames up to the camera's") {
  const auto seen_by = camera(R"("field_of_view": 1, "frame": "optical"})");
  const std::string frames = R"({"transforms":[
{"header":{"frame_id":"/optical"},"child_frame_id":"body_a1","transform":{"translation":{"x":0,"y":0,"z":1},"rotation":{"x":0,"y":0,"z":0,"w":1}}},
{"header":{"frame_id":"r_elbow_a1"},"child_frame_id":"r_wrist_a1","transform":{"translation":{"x":0,"y":0,"z":-0.25}}}]}
{"transforms":[{"header":{"stamp":{"sec":3,"nanosec":0},"frame_id":"body_a1"},"child_frame_id":"r_elbow_a1",
 "transform":{"translation":{"x":0.2,"y":0,"z":0},"rotation":{"x":0.7071067812,"y":0,"z":0,"w":0.7071067812}}}]})";
  const auto events = read_output(*recogniser_format("ros4hri"), frames, {"hands", false, seen_by});
  REQUIRE(events);
  REQUIRE(events->size() == 1);
  // The elbow is turned by 90° about x: its -z is +y of the camera, which is down.
  CHECK(compact((*events)[0]) ==
        R"({"t":3.0,"kind":"pointing","hand":"right","ray":{"from":[-0.2,0.0,0.25],"direction":[0.0,0.0,-1.0]}})");
}

TEST_CASE("A camera's file is checked") {
  const auto file = binary_dir() + "/hands_test.camera.json";
  const std::pair<const char*, const char*> faults[] = {
      {R"({"position": [0, 1], "looks_at": [0, 0, 0], "field_of_view": 1})", "expected a point [x, y, z]"},
      {R"({"position": [0, 1, 0], "looks_at": [0, 1, 0], "field_of_view": 1})", "another point than"},
      {R"({"position": [0, 1, 0], "looks_at": [0, 0, 0]})", "there is no \"field_of_view\""},
      {R"({"position": [0, 1, 0], "looks_at": [0, 0, 0], "field_of_view": 60})", "found 60"},
      {R"({"corners": [{"seen": [0, 0], "is": [0, 0]}]})", "found 1 corners"},
      {R"({"corners": [{"seen": [0, 0], "is": [0, 0]}, {"seen": [1, 1], "is": [1, 0]}, {"seen": [0.5, 0.5], "is": [1, 1]},
                       {"seen": [0, 1], "is": [0, 1]}]})",
       "in a line"}};
  for (const auto& [text, sentence] : faults) {
    REQUIRE_FALSE(replace_file(file, text));
    const auto read = read_camera(file);
    REQUIRE_FALSE(read);
    CHECK(read.error().text().find(sentence) != std::string::npos);
    CHECK(read.error().where.find("hands_test.camera.json:1:") != std::string::npos);
  }
}

}  // namespace
}  // namespace continua
