// The machines that come with the project load, and do with their examples what these say.
#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

#include "analysis/acceptance.h"
#include "composition/methods.h"
#include "core/located_json.h"
#include "machine_file/machine_loader.h"
#include "pipeline/pipeline.h"
#include "support/catch.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const auto end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + separator.size();
  }
  return parts;
}

// The event that a symbol without a place stands for.
InputEvent event_of(const std::string& symbol) {
  auto words = split(symbol, " ");
  const auto take = [&](std::size_t at) {
    const auto word = words.at(at);
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
    return word;
  };
  static constexpr std::array<std::string_view, 6> directions = {"left", "right", "front", "back", "up", "down"};
  const auto is_direction = [](const std::string& word) {
    return std::find(directions.begin(), directions.end(), word) != directions.end();
  };
  InputEvent event;
  const auto modality = take(0);
  if (modality == "speech") {
    event.text = symbol.substr(symbol.find(' ') + 1);
    return event;
  }
  event.modality = modality == "pointing" ? Modality::pointing : Modality::gesture;
  if (is_direction(words.front())) event.hand = take(0);
  if (event.modality == Modality::pointing) return event;
  event.phase = take(words.size() - 1);
  if (is_direction(words.back())) event.direction = take(words.size() - 1);
  event.name = words.front();
  return event;
}

void check_run(const std::shared_ptr<const Machine>& machine, const RunExample& example) {
  CAPTURE(example.inputs);
  const WorldSnapshot empty_table;
  Pipeline pipeline(machine, Perspective::human);
  auto state = pipeline.begin({machine->choice, Random(0), {}, 0}, empty_table).after;
  for (const auto& symbol : example.inputs) {
    REQUIRE(symbol_of(event_of(symbol)) == symbol);
    state = pipeline.tick(state, event_of(symbol), empty_table).after;
  }
  CHECK(machine->states[state.configuration.state].name == machine->states[example.ends].name);
}

void check_word(const std::shared_ptr<const Machine>& machine, const WordExample& example) {
  CAPTURE(example.word);
  Acceptance acceptance(machine, example.by_empty_stack ? AcceptBy::empty_stack : AcceptBy::final_state);
  const auto accepted = acceptance.accepts(example.word);
  if (!accepted) FAIL(accepted.error().text());
  CHECK(*accepted == example.accepted);
}

}  // namespace

TEST_CASE("every machine of the knowledge folder is sound, and its examples are true of it") {
  const auto folder = fs::path(CONTINUA_SOURCE_DIR) / "engine/knowledge/machines";
  int machines = 0;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.path().extension() != ".json") continue;
    ++machines;
    auto loaded = load_machine(file.path().string(), Methods::signature());
    if (!loaded) FAIL(loaded.error().text());
    const auto machine = std::make_shared<const Machine>(std::move(*loaded));
    CAPTURE(file.path());
    CHECK_FALSE(machine->examples.empty());
    for (const auto& example : machine->examples)
      if (const auto* run = std::get_if<RunExample>(&example))
        check_run(machine, *run);
      else
        check_word(machine, std::get<WordExample>(example));
  }
  CHECK(machines > 0);
}

TEST_CASE("the example of the format's page is a sound machine") {
  const auto page = read_file((fs::path(CONTINUA_SOURCE_DIR) / "engine/automaton/FORMAT.md").string()).value();
  const std::string begin = "```json\n";
  const auto from = page.find(begin) + begin.size();
  const auto machine =
      parse_machine(page.substr(from, page.find("```", from) - from), "FORMAT.md", Methods::signature());
  if (!machine) FAIL(machine.error().text());
  CHECK(machine->transitions.size() == 3);
}

TEST_CASE("the machine of the recorded system has its states and transitions") {
  const auto path = fs::path(CONTINUA_SOURCE_DIR) / "engine/knowledge/machines/diana2018.json";
  const auto machine = load_machine(path.string(), Methods::signature());
  REQUIRE(machine.ok());
  CHECK(machine->states.size() == 29);
  CHECK(machine->transitions.size() == 109);
}
