#include "continua/knowledge_files/data_paths.h"

#include <cstdlib>
#include <filesystem>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

// A source tree with two machines and a scene, which CONTINUA_HOME names while this lives.
class Tree {
 public:
  Tree() {
    fs::create_directories(root() / "traces");
    for (const char* name : {"engine/knowledge/machines/diana.json", "engine/knowledge/machines/paper.json",
                             "mjcf/scenes/table.xml", "traces/own.json", "traces/diana.json"})
      folder_.file(name, "x");
    setenv("CONTINUA_HOME", root().c_str(), 1);
  }
  ~Tree() { unsetenv("CONTINUA_HOME"); }
  const fs::path& root() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("the data is found without being told") {
  unsetenv("CONTINUA_HOME");
  const auto data = find_data_paths();
  REQUIRE(data);
  CHECK(fs::is_directory(data->knowledge));
  CHECK(fs::is_directory(data->mjcf));
}

TEST_CASE("CONTINUA_HOME and the knowledge option say where the data is") {
  const Tree tree;
  CHECK(find_data_paths()->knowledge == tree.root() / "engine/knowledge");
  CHECK(find_data_paths((tree.root() / "traces").string())->knowledge == tree.root() / "traces");
  CHECK(find_data_paths((tree.root() / "none").string()).error().sentence ==
        "is no folder; expected one with machines, lexicon and voxemes");
  setenv("CONTINUA_HOME", (tree.root() / "engine").c_str(), 1);
  CHECK(find_data_paths().error().text() ==
        (tree.root() / "engine").string() +
            ": CONTINUA_HOME has no engine/knowledge and mjcf; expected the project's folder");
}

TEST_CASE("machines and scenes are found by name and by path") {
  const Tree tree;
  const auto data = find_data_paths().value();
  const auto traces = tree.root() / "traces";
  const auto machine = [&](const std::string& name) { return resolve_machine(name, data, traces, "t.jsonl:1"); };
  CHECK(machine("diana").value() == (tree.root() / "engine/knowledge/machines/diana.json").string());
  CHECK(machine("own").value() == (traces / "own.json").string());
  CHECK(machine("own.json").value() == (traces / "own.json").string());
  CHECK(machine("./diana.json").value() == (traces / "diana.json").string());
  CHECK(machine("../mjcf/scenes/table.xml").value() == (tree.root() / "mjcf/scenes/table.xml").string());
  CHECK(machine((traces / "own.json").string()).value() == (traces / "own.json").string());
  CHECK(resolve_scene("table", data, traces, "").value() == (tree.root() / "mjcf/scenes/table.xml").string());
}

TEST_CASE("a machine or scene that is missing is an error with the nearest name") {
  const Tree tree;
  const auto data = find_data_paths().value();
  CHECK(resolve_machine("dianna", data, ".", "t.jsonl:1").error().text() ==
        "t.jsonl:1: there is no machine 'dianna' (did you mean 'diana'?); expected a file or one of diana, paper");
  CHECK(resolve_scene("tabel", data, ".", "").error().text() ==
        "there is no scene 'tabel' (did you mean 'table'?); expected a file or one of table");
  CHECK(resolve_machine("", data, ".", "t.jsonl:1").error().text() ==
        "t.jsonl:1: no machine is named; expected a name or a path");
  CHECK_FALSE(resolve_machine("machines", data, data.knowledge, ""));  // a folder is no machine
}
