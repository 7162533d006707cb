// All files of the knowledge folder load, and their examples are true.
#include <filesystem>

#include "continua/core/located_json.h"
#include "continua/facts/world_facts.h"
#include "continua/knowledge_files/language_loading.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/replay/check/examples.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

TEST_CASE("every machine of the knowledge folder is sound, and its examples are true of it") {
  const auto data = find_data_paths();
  REQUIRE(data.ok());
  int machines = 0;
  for (const auto& file : fs::directory_iterator(data->knowledge / "machines")) {
    if (file.path().extension() != ".json") continue;
    ++machines;
    CAPTURE(file.path());
    auto loaded = load_machine(file.path().string(), *data);
    if (!loaded) FAIL(loaded.error().text());
    const auto machine = std::make_shared<const Machine>(std::move(*loaded));
    auto language = load_language(*data, *machine);
    if (!language) FAIL(language.error().text());
    CHECK_FALSE(machine->examples.empty());
    CHECK(broken_examples(machine, std::make_shared<const Language>(std::move(*language))) ==
          std::vector<std::string>{});
  }
  CHECK(machines > 0);
}

TEST_CASE("every lexicon of the knowledge folder is sound, and its examples are true of it") {
  const auto data = find_data_paths();
  REQUIRE(data.ok());
  int lexicons = 0;
  for (const auto& folder : fs::directory_iterator(data->knowledge / "lexicon")) {
    ++lexicons;
    const auto lexicon = load_named_lexicon(*data, folder.path().string(), "");
    if (!lexicon) FAIL(lexicon.error().text());
    const auto examples = load_examples(**lexicon);
    if (!examples) FAIL(examples.error().text());
    std::vector<std::string> problems;
    for (const auto& problem : check_examples(*examples, **lexicon)) problems.push_back(problem.text());
    CHECK(problems == std::vector<std::string>{});
    CHECK(examples->size() >= 40);
  }
  CHECK(lexicons > 0);
}

TEST_CASE("every gesture of the knowledge folder means a term of its lexicon's words") {
  const auto data = find_data_paths();
  REQUIRE(data.ok());
  const auto lexicon = load_named_lexicon(*data, "english", "");
  REQUIRE(lexicon.ok());
  const auto gestures = load_gestures(*data, "tabletop", *lexicon, "");
  if (!gestures) FAIL(gestures.error().text());
  CHECK((*gestures)->lexicon == "english");
  CHECK((*gestures)->examples >= (*gestures)->entries.size());
  const auto none = load_gestures(*data, "tabeltop", *lexicon, "\"gestures\" of a machine");
  REQUIRE_FALSE(none.ok());
  CHECK(
      none.error().text() ==
      "\"gestures\" of a machine: there is no gesture catalogue 'tabeltop' (did you mean 'tabletop'?); expected a file "
      "or one of tabletop");
  auto wrong = **gestures;
  wrong.entries.at("grab").meanings[""] = "\\x: e. graps(x)";
  const auto problems = check_meanings(wrong, *lexicon);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].where == wrong.entries.at("grab").where);
}

TEST_CASE("the example of the format's page is a sound machine") {
  const auto page = read_file((fs::path(source_dir()) / "engine/automaton/FORMAT.md").string()).value();
  const std::string begin = "```json\n";
  const auto from = page.find(begin) + begin.size();
  const auto machine =
      parse_machine(page.substr(from, page.find("```", from) - from), "FORMAT.md", WorldFacts::signature());
  if (!machine) FAIL(machine.error().text());
  CHECK(machine->transitions.size() == 3);
}

TEST_CASE("the machine of the recorded system has its states and transitions") {
  const auto path = fs::path(source_dir()) / "engine/knowledge/machines/diana2018.json";
  const auto machine = load_machine(path.string(), WorldFacts::signature());
  REQUIRE(machine.ok());
  CHECK(machine->states.size() == 29);
  CHECK(machine->transitions.size() == 111);
}
