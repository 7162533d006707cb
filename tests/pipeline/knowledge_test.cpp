// The machines that come with the project load.
#include <filesystem>

#include "automaton/machine_loader.h"
#include "composition/methods.h"
#include "support/catch.h"

using namespace continua;

TEST_CASE("every machine of the knowledge folder is sound") {
  const auto folder = std::filesystem::path(CONTINUA_SOURCE_DIR) / "engine/knowledge/machines";
  int machines = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".json") continue;
    ++machines;
    const auto machine = load_machine(file.path().string(), Methods::signature());
    if (!machine) FAIL(machine.error().text());
  }
  CHECK(machines > 0);
}

TEST_CASE("the machine of the recorded system has its states and transitions") {
  const auto machine = load_machine(std::string(CONTINUA_SOURCE_DIR) + "/engine/knowledge/machines/diana2018.json",
                                    Methods::signature());
  REQUIRE(machine.ok());
  CHECK(machine->states.size() == 29);
  CHECK(machine->transitions.size() == 109);
}
