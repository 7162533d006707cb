// Scenes outside the project: the example of mjcf/README.md, and scenes with objects that have no voxeme.
#include <algorithm>
#include <fstream>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/check/check.h"
#include "continua/replay/check/file_kinds.h"
#include "continua/replay/session/session.h"
#include "continua/simulation/scene.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const fs::path source = source_dir();

std::string content(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The scene that the page shows, and its NAME.
std::pair<std::string, std::string> scene_of_readme() {
  const std::string page = content(source / "mjcf/README.md");
  const auto from = page.find("<mujoco model=\""), until = page.find("</mujoco>", from);
  REQUIRE(until != std::string::npos);
  const auto name = page.substr(from + 15, page.find('"', from + 15) - from - 15);
  return {name, page.substr(from, until + 9 - from)};
}

struct Replayed {
  ReplaySummary summary;
  std::vector<Json> records;
  std::string warning;
};

Replayed replay(const std::string& trace, bool physics) {
  ReplayOptions options;
  options.physics = physics;
  auto session = Session::load(trace, options);
  if (!session) FAIL(session.error().text());
  std::stringstream log;
  Replayed run{session->run(log), {}, session->warning() ? session->warning()->text() : ""};
  for (std::string line; std::getline(log, line);) run.records.push_back(Json::parse(line));
  return run;
}

}  // namespace

TEST_CASE("the scene that the page on scenes shows loads without a word, and a put in it is done") {
  const TemporaryFolder folder;
  const auto [name, mjcf] = scene_of_readme();
  CHECK(std::count(mjcf.begin(), mjcf.end(), '\n') <= 15);
  for (const char* part : {"avatar", "objects"})
    fs::copy(source / "mjcf" / part, folder.path() / part, fs::copy_options::recursive);
  const std::string path = folder.file("scenes/" + name + ".xml", mjcf);
  const auto scene = load_scene(path);
  if (!scene) FAIL(scene.error().text());
  REQUIRE_FALSE(scene->objects().empty());
  const FileCheck check = check_file(mjcf, path);
  CHECK(check.problems.empty());
  CHECK(check.notes.empty());

  const SceneObject& object = scene->objects().front();
  const std::string trace = folder.file(
      "put.trace.jsonl", R"({"kind":"trace","version":1,"machine":"interaction","scene":"scenes/)" + name + R"(.xml"}
{"t":1,"kind":"speech","text":"Put the )" +
                             object.attributes.at("color") + " " + object.attributes.at("type") + R"( there.","until":2}
{"t":1.5,"kind":"gesture","name":"point","hand":"right","phase":"stroke","target":[-0.1,-0.05],"until":2}
)");
  const Replayed run = replay(trace, true);
  CHECK(run.warning.empty());
  CHECK(run.summary.acts == 1);
  CHECK(run.summary.acts_done == 1);
}

TEST_CASE("objects without a voxeme are named once, with what is not known, and can be talked about and moved") {
  const std::string trace = (source / "traces/corner/objects_without_voxeme.trace.jsonl").string();
  for (const bool physics : {false, true}) {
    const Replayed run = replay(trace, physics);
    CHECK(run.summary.expectations_met == run.summary.expectations);
    CHECK(run.summary.acts_done == run.summary.acts);
    CHECK(run.summary.problems == 0);
    CHECK(run.records.front()["scene"]["without_voxeme"] == Json{"gadget", "blok"});
    CHECK(run.warning.find("objects_without_voxeme.xml: no voxeme of 'gadget' of type 'gadget', 'blok' of type 'blok' "
                           "(did you mean 'block'?): what can be done with them is not known, and nothing is refused "
                           "for it; expected one of the object's name or type in ") != std::string::npos);
    CHECK(run.warning.ends_with("/voxemes/objects"));
  }
  ReplayOptions kinematic;
  kinematic.physics = false;
  CHECK(check_trace(trace, kinematic).warning.has_value());
}

TEST_CASE("a scene whose objects all have voxemes has no warning, nor one whose other objects are off the table") {
  const TemporaryFolder folder;
  const std::string scene = (source / "traces/corner/objects_without_voxeme.xml").string();
  const std::string trace =
      folder.file("t.trace.jsonl", R"({"kind":"trace","version":1,"machine":"interaction","scene":")" + scene +
                                       R"(","objects":{"gadget":null,"blok":null}})" + "\n");
  const Replayed run = replay(trace, false);
  CHECK(run.warning.empty());
  CHECK_FALSE(run.records.front()["scene"].contains("without_voxeme"));
}

TEST_CASE("validate tells what is in a scene: objects, table and arm, and what is not known of it") {
  const fs::path corner = source / "traces/corner/objects_without_voxeme.xml";
  FileCheck check = check_file(content(corner), corner.string());
  CHECK(check.problems.empty());
  CHECK(check.summary == "scene, 3 objects: red_block, gadget, blok, a table of 1.00 m x 0.50 m, an arm of 7 hinges");
  REQUIRE(check.notes.size() == 1);
  CHECK(check.notes[0].find("no voxeme of 'gadget'") != std::string::npos);

  const TemporaryFolder folder;
  const std::string bare = R"(<mujoco><worldbody><body name="table"><geom name="table_top" type="box" pos="0 0 -0.01"
size="0.5 0.25 0.01"/></body></worldbody></mujoco>)";
  check = check_file(bare, folder.file("bare.xml", bare));
  CHECK(check.problems.empty());
  CHECK(check.summary == "scene, 0 objects, a table of 1.00 m x 0.50 m, no arm");
  REQUIRE(check.notes.size() == 1);
  CHECK(check.notes[0].ends_with("; only the kinematic world can be used"));
}
