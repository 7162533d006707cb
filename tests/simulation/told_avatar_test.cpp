// Arms as others write them, included as they are: what a scene tells of them, what is guessed, and what they do.
#include "continua/simulation/told_avatar.h"

#include "continua/simulation/scene_compile.h"
#include "simulation/arm_scenes.h"
#include "support/stage.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

const std::string panda = others + "panda.xml", ur5e = others + "ur5e.xml", sawyer = others + "sawyer.xml";

/// A table and an arm of others, of which the scene tells `words`.
std::string scene_text(const std::string& arm, const std::string& words) {
  return "<mujoco><compiler autolimits='true'/>\n<include file='" + arm + "'/>\n<custom>\n<text name='avatar' data='" +
         words +
         "'/>\n</custom>\n<worldbody><geom name='table_top' type='box' size='1 1 0.1' pos='0 0 "
         "-0.1'/></worldbody></mujoco>";
}

Result<CompiledScene> compiled(const std::string& arm, const std::string& words) {
  static const TemporaryFolder folder;
  return compile_scene(folder.file("told.xml", scene_text(arm, words)));
}

}  // namespace

TEST_CASE("arms that are told of put, stack and push") {
  struct Task {
    Capability what;
    std::string object;
    Goal goal;
    double within_m;
  };
  struct Place {
    std::string scene;
    std::vector<std::string> without;  // hands of others are broad
    std::vector<Task> tasks;
  };
  constexpr auto put = Capability::put, push = Capability::push;
  const std::vector<Place> places = {
      {"staircase",
       {},
       {{put, "block1", at(0.1, -0.05), 0.005},
        {put, "block4", by(Relation::on, "block1"), 0.005},
        {put, "block7", at(-0.05, -0.05), 0.005},
        {put, "block6", by(Relation::on, "block7"), 0.005},
        {put, "block5", by(Relation::on, "block6"), 0.005}}},
      {"staircase",
       {"block3", "block4", "block5", "block6", "block7"},
       {{push, "block1", at(0.1, 0.0), 0.02},
        {push, "block1", at(0.2, 0.0), 0.02},
        {push, "block1", at(0, -0.05), 0.02}}},
      {"workbench",
       {"cup", "plate", "knife"},
       {{put, "block_yellow", at(-0.1, -0.1), 0.006},
        {put, "block_green", by(Relation::on, "block_yellow"), 0.005},
        {put, "block_green", at(0.1, 0.0), 0.005},
        {push, "block_green", at(0.2, 0.0), 0.02},
        {put, "block_red", by(Relation::left, "block_yellow"), 0.005}}},
  };
  for (const auto& arm : arms) {
    if (told_of(arm).empty()) continue;
    for (const auto& place : places) {
      std::vector<ObjectOverride> removed;
      for (const auto& object : place.without) removed.push_back({object, {}, {}, {}, {}, true});
      Stage stage(scene_with(arm, place.scene, removed));
      for (const auto& task : place.tasks) {
        const ActReport end = stage.act(task.what, task.object, task.goal);
        INFO(arm << " in " << place.scene << ": " << name_of(task.what) << " " << task.object << ": "
                 << words_of(end.reason));
        CHECK(end.status == Status::done);
        CHECK(end.position_error_m < task.within_m);
      }
    }
  }
}

TEST_CASE("elements that are not told are guessed, each with its file and line") {
  const auto found = compiled(panda, "base=0,0.6,0,-90");
  REQUIRE(found.ok());
  std::string all;
  for (const auto& guess : found->guesses) all += guess + "\n";
  const auto line = [&](const std::string& file, const std::string& text) {
    const auto whole = text_of(file);
    const auto at = whole.find(text);
    REQUIRE(at != std::string::npos);
    return file + ":" + std::to_string(1 + std::count(whole.begin(), whole.begin() + static_cast<long>(at), '\n'));
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(all, Contains(line(panda, "<body name=\"hand\"") + ": guessed: body 'hand' is the hand"));
  CHECK_THAT(all, Contains(line(panda, "<body name=\"left_finger\"") + ": guessed: body 'left_finger' is a finger"));
  CHECK_THAT(all, Contains(": guessed: geom 3 of body 'right_finger' is the pad"));
  CHECK_THAT(all, Contains("the grip is between the pads, at (0.0000, 0.0000, 0.1029)"));
  CHECK_THAT(all, Contains(line(panda, "<key name=\"home\"") + ": guessed: keyframe 'home'"));

  const auto both = compiled(panda, "hand=hand pads=left_finger,right_finger grip=0,0,0.1 home=home");
  REQUIRE(both.ok());
  for (const auto& guess : both->guesses) CHECK_THAT(guess, Contains("is the pad that presses"));
}

TEST_CASE("a scene that tells of its avatar becomes one that has all elements, which loads again") {
  const auto once = compiled(sawyer, told_of(sawyer));
  REQUIRE(once.ok());
  const TemporaryFolder folder;
  const auto again = compile_scene(folder.file("again.xml", once->source.text()));
  REQUIRE(again.ok());
  CHECK(again->guesses.empty());
  CHECK(again->source.text() == once->source.text());
}

TEST_CASE("words about an avatar that are wrong are told with file and line") {
  for (const auto& [arm, words, expected] : std::vector<std::array<std::string, 3>>{
           {panda, "hands=hand", "told.xml:4: 'hands' is no word about an avatar (did you mean 'hand'?)"},
           {panda, "hand", "told.xml:4: 'hand' has no value"},
           {panda, "hand=hnad", "told.xml:4: hand: the scene has no body 'hnad' (did you mean 'hand'?)"},
           {panda, "hand=left_finger pads=left_finger,right_finger", "body 'left_finger' does not carry both pads"},
           {panda, "pads=left_finger", "told.xml:4: pads: expected the names of two"},
           {panda, "pads=left_finger,thumb", "pads: the scene has no geom or body 'thumb'"},
           {panda, "pads=left_finger,left_finger", "pads: both are of one body"},
           {panda, "grip=1,2", "grip: expected a site, or its place"},
           {panda, "grip=here", "grip: the scene has no site 'here'"},
           {panda, "home=1,2,3", "home: 3 angles; the arm has 7 hinges"},
           {panda, "home=rest", "home: no keyframe 'rest'"},
           {panda, "base=1,2", "base: expected a place"},
           {panda, "base=a,b,c", "base: expected a place"},
           {others + "seven_axis.xml", "home=0,0,0,0,0,0,0",
            "told.xml:4: home: the scene has numbers 'arm_home' already"},
           {others + "seven_axis.xml", "grip=0,0,0", "told.xml:4: grip: the scene has a site 'grip' already"},
       }) {
    INFO(words);
    const auto found = compiled(arm, words);
    REQUIRE_FALSE(found.ok());
    CHECK_THAT(found.error().text(), Catch::Matchers::Contains(expected));
  }
}
