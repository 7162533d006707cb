#include "continua/knowledge_files/based_machine.h"

#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/knowledge_files/language_loading.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string door = R"({ "machine": 1, "name": "door", "start": "Shut", "accept": ["Shut"],
  "define": { "one": "1", "two": "2" },
  "transitions": [
    { "id": "open", "from": "Shut", "on": "push", "to": "Open", "none": true },
    { "id": "shut", "from": "Open", "on": "pull", "to": "Shut", "none": true } ] }
)";

// A knowledge folder with the machine `door`, and a machine of its own beside it.
struct Based {
  TemporaryFolder folder;
  DataPaths data{folder.path() / "knowledge", folder.path() / "mjcf"};
  Based() { folder.file("knowledge/machines/door.json", door); }
  Result<Machine> load(const std::string& text) { return load_machine(folder.file("own.json", text), data); }
  std::string error(const std::string& text) {
    const auto sentence = load(text).error().text();
    return sentence.substr(folder.path().string().size() + 1);
  }
};

}  // namespace

TEST_CASE("a machine may be another one with changes") {
  Based based;
  const auto machine = based
                           .load(R"({ "machine": 1, "name": "lift", "based_on": "door", "accept": ["Open"],
  "define": { "two": null, "three": "3" },
  "transitions": [ { "id": "shut", "from": "Open", "on": "time", "to": "Shut", "none": true },
                   { "id": "stay", "from": "Open", "on": "hold", "to": "Open", "none": true } ] })")
                           .value();
  CHECK(machine.name == "lift");
  std::vector<std::string> ids;
  for (const auto& transition : machine.transitions) ids.push_back(transition.id);
  CHECK(ids == std::vector<std::string>{"open", "shut", "stay"});
  CHECK(machine.knows_input("time"));
  CHECK_FALSE(machine.knows_input("pull"));
  const auto document = Json::parse(machine.document);
  CHECK(document["accept"] == Json({"Open"}));
  CHECK(document["define"] == Json({{"one", "1"}, {"three", "3"}}));
  CHECK_FALSE(document.contains("based_on"));
}

TEST_CASE("a base may be based on another") {
  Based based;
  based.folder.file("middle.json", R"({ "name": "middle", "based_on": "door", "define": { "two": "22" } })");
  const auto machine = based.load(R"({ "machine": 1, "name": "top", "based_on": "middle.json" })").value();
  CHECK(Json::parse(machine.document)["define"] == Json({{"one", "1"}, {"two", "22"}}));
}

TEST_CASE("an error of a machine that is based on another has its place in either file") {
  Based based;
  CHECK(based
            .error("{ \"machine\": 1, \"name\": \"x\", \"based_on\": \"door\",\n  \"transitions\": [\n"
                   "    { \"id\": \"new\", \"from\": \"Shut\", \"on\": \"a\", \"to\": \"Open\",\n      \"when\": \"1 "
                   "+\" } ] }")
            .starts_with("own.json:4:15: "));
  CHECK(based.error("{ \"machine\": 1, \"name\": \"x\", \"based_on\": \"door\",\n  \"start\": 3 }")
            .starts_with("own.json:2:12: "));
  based.folder.file("knowledge/machines/door.json", [] {
    auto text = door;
    return text.replace(text.find("\"1\""), 3, "\"1 +\"");
  }());
  CHECK(based.error(R"({ "machine": 1, "name": "x", "based_on": "door" })")
            .starts_with("knowledge/machines/door.json:2:"));

  CHECK(based.error(R"({ "machine": 1, "name": "x", "based_on": "dor" })")
            .find("there is no machine 'dor' (did you mean 'door'?)") != std::string::npos);
  CHECK(based.error(R"({ "machine": 1, "name": "x", "based_on": 7 })") ==
        "own.json:1:42: expected the name or the path of a machine");
  CHECK(based.error(R"({ "machine": 1, "name": "x", "based_on": "own.json" })").find("is based on itself") !=
        std::string::npos);
}
