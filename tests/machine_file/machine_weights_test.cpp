#include "continua/machine_file/machine_weights.h"

#include <filesystem>
#include <fstream>

#include "support/machines.h"

namespace continua {
namespace {

const std::string text = R"json({"machine":1,"name":"m","start":"A","transitions":[
  {"id":"guess","from":"A","on":"x","to":"A"},{"id":"wait","from":"A","on":"x","to":"A","weight":2}],
  "beliefs":{"concepts":{"point":{}},"evidence":[{"inputs":["p"],"concepts":["point"],"levels":[0.5,1]}]}})json";

std::string written(const std::string& weights) {
  const auto path = (std::filesystem::temp_directory_path() / "continua_weights_test.json").string();
  std::ofstream(path) << weights;
  return path;
}

}  // namespace

TEST_CASE("Weights from a file take the place of a machine's own") {
  Machine machine = *machine_of(text);
  const auto weights = read_weights(written(R"json({"weights":1,"machine":"m","transitions":{"wait":0.25},
    "evidence":[{"row":1,"concepts":["point"],"levels":[0.1,0.9]}],"learned":{"traces":3}})json"),
                                    machine);
  REQUIRE(weights);
  REQUIRE_FALSE(set_weights(machine, *weights));
  CHECK(machine.transitions[0].weight == 1);
  CHECK(machine.transitions[1].weight == 0.25);
  CHECK(machine.beliefs.evidence[0].levels == std::vector<double>{0.1, 0.9});
  // The document in the log has them too.
  const auto again = machine_of(machine.document);
  CHECK(again->transitions[1].weight == 0.25);
  CHECK(again->beliefs.evidence[0].levels == machine.beliefs.evidence[0].levels);
}

TEST_CASE("A file of weights has what differs, and is read back") {
  const auto machine = machine_of(text);
  auto weights = weights_of(*machine);
  CHECK(weights_document(*machine, weights).at("transitions").empty());
  weights.transitions[0] = 0.125;
  weights.levels[0] = {0.25, 0.75};
  const auto document = weights_document(*machine, weights);
  CHECK(document.at("transitions").size() == 1);
  const auto read = read_weights(written(document.dump()), *machine);
  REQUIRE(read);
  CHECK(read->transitions == weights.transitions);
  CHECK(read->levels == weights.levels);
}

TEST_CASE("Faults of a file of weights") {
  const auto machine = machine_of(text);
  const std::pair<const char*, const char*> cases[] = {
      {R"({"weights":1,"machine":"n"})", "found 'n', expected m"},
      {R"({"weights":2,"machine":"m"})", "the version of the format"},
      {R"({"weights":1,"machine":"m","transitions":{"gues":1}})", "did you mean 'guess'?"},
      {R"({"weights":1,"machine":"m","transitions":{"guess":0}})", "greater than 0"},
      {R"({"weights":1,"machine":"m","evidence":[{"row":2,"levels":[0,1]}]})", "the number of a row"},
      {R"({"weights":1,"machine":"m","evidence":[{"row":1,"levels":[1]}]})", "expected 2 levels"},
      {R"({"weights":1,"machine":"m","evidence":[{"row":1,"levels":[1,0]}]})", "ascending"},
      {R"({"weights":1,"machine":"m","evidence":[{"row":1,"concepts":["grab"],"levels":[0,1]}]})", "raises point"},
      {"[]", "a file of weights"}};
  for (const auto& [file, sentence] : cases) {
    const auto weights = read_weights(written(file), *machine);
    CAPTURE(file);
    REQUIRE_FALSE(weights);
    CAPTURE(weights.error().text());
    CHECK(weights.error().sentence.find(sentence) != std::string::npos);
  }
  CHECK_FALSE(read_weights("/no/such/file.json", *machine));
}

}  // namespace continua
