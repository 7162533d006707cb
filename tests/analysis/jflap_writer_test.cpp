// Machines as JFLAP files, and back.
#include "continua/machine_file/jflap_writer.h"

#include <random>

#include "continua/analysis/acceptance.h"
#include "continua/core/characters.h"
#include "continua/machine_file/jflap.h"
#include "support/folders.h"
#include "support/jflap_files.h"
#include "support/machines.h"

using namespace continua;

namespace {

Json read_again(const Json& machine) {
  const auto file = jflap_of(*machine_of(compact(machine)));
  if (!file) FAIL(file.error().text());
  const auto again = machine_of_jflap(*file, "m.jff");
  if (!again) FAIL(again.error().text() + "\n" + *file);
  return *again;
}

std::string error_of(const std::string& machine) { return jflap_of(*machine_of(machine)).error().text(); }

}  // namespace

TEST_CASE("a machine that was read from a JFLAP file comes back as it was") {
  std::mt19937 random(7);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto any = [&](std::initializer_list<const char*> texts) {
    return std::string(texts.begin()[below(static_cast<int>(texts.size()))]);
  };
  for (int round = 0; round < 300; ++round) {
    const bool pushdown = round % 3 > 0;
    classical::Pda pda{1 + below(4), 0, {}, {}};
    pda.start = below(pda.states);
    for (int state = 0; state < pda.states; ++state)
      if (below(2) == 1) pda.accepting.insert(state);
    for (int i = below(8); i > 0; --i)
      pda.moves.push_back({below(pda.states), any({"", "a", "b", "'", "*", "\\"}), any({"", "A", "Z", "'"}),
                           any({"", "A", "BA", "ZA", "AZ", "\\'"}), below(pda.states)});
    const auto machine = machine_of_jflap(jff_of(pda, pushdown), "m.jff");
    REQUIRE(machine);
    CHECK(read_again(*machine) == *machine);
  }
}

TEST_CASE("a range of symbols stays one transition") {
  const auto machine = machine_of_jflap(
      jff("fa",
          "<state "
          "id=\"0\"><initial/><final/></state><transition><from>0</from><to>0</to><read>[0-9]</read></transition>"),
      "m.jff");
  REQUIRE(machine);
  CHECK(read_again(*machine) == *machine);
}

TEST_CASE("a machine of characters accepts the same words as its JFLAP file") {
  for (const auto* name : {"multiples_of_three", "third_from_the_end", "palindromes"}) {
    const auto text = read_file(std::string(source_dir() + "/engine/knowledge/machines/") + name + ".json");
    REQUIRE(text);
    const auto machine = machine_of(*text);
    const auto file = jflap_of(*machine);
    INFO(name << (file ? "" : file.error().text()));
    REQUIRE(file);
    Acceptance before(machine, AcceptBy::final_state),
        after(machine_of(compact(*machine_of_jflap(*file, "m.jff"))), AcceptBy::final_state);
    for (const auto& example : machine->examples)
      if (const auto* word = std::get_if<WordExample>(&example))
        CHECK(*before.accepts(word->word) == *after.accepts(word->word));
  }
}

TEST_CASE("a machine with more than JFLAP has is refused by its name") {
  CHECK(error_of(R"({"machine":1,"name":"m","start":"a","states":{"a":{}},
    "transitions":[{"id":"x","from":"a","on":"speech yes","to":"a"}]})") ==
        "m: found the transition 'x' on 'speech yes', which is no character; a JFLAP file has no such thing");
  CHECK(error_of(
            R"({"machine":1,"name":"m","start":"a","states":{"a":{"enter":[{"say":"Hello."}]}},"transitions":[]})") ==
        "m: found the state 'a', which passes, has a gate or an effect; a JFLAP file has no such thing");
}
