#include "continua/machine_file/machine_loader.h"

#include "support/machines.h"

using namespace continua;

TEST_CASE("the bottom symbol holds what the machine says, and is empty elsewhere") {
  Player player(R"json({"machine":1,"name":"m","start":"A","slots":{"n":"num","rest":"num*","names":"num*","at":"loc"},
    "bottom":{"n":"1 + 2","rest":null,"at":null,"names":"reverse([1, 2])"},
    "transitions":[{"id":"a","from":"A","on":"push","to":"A","push":{"n":"7"}},{"id":"b","from":"A","on":"pop","to":"A","pop":9},
      {"id":"c","from":"A","on":"flush","to":"A","flush":{}}]
})json");
  CHECK(player.slot("n") == "3");
  CHECK(player.feed("push, pop").slot("n") == "3");
  CHECK(player.feed("push, flush").slot("n") == "3");
  CHECK(player.slot("names") == "[2, 1]");
  CHECK(player.slot("rest") == "[]");
  CHECK(player.slot("at") == "null");
}

TEST_CASE("examples are read: inputs with where they lead, words with whether they are accepted") {
  const auto machine = machine_of(R"({"machine":1,"name":"m","start":"A","transitions":[
      {"id":"1","from":"A","on":["a","long","speech go on","é"],"to":"B"}],
    "examples":[{"input":"speech go on, a","ends":"B"},{"word":"aéa","accepted":true},{"word":"","accepted":false},
      {"word":"a long","accepted":true,"by":"empty_stack"},{"word":"xyz","accepted":false}]})");
  REQUIRE(machine->examples.size() == 5);
  const auto& run = std::get<RunExample>(machine->examples[0]);
  CHECK(run.inputs == std::vector<std::string>{"speech go on", "a"});
  CHECK(machine->states[run.ends].name == "B");
  const auto word = [&](std::size_t i) { return std::get<WordExample>(machine->examples[i]); };
  CHECK(word(1).word == std::vector<std::string>{"a", "é", "a"});
  CHECK((word(1).accepted && !word(1).by_empty_stack));
  CHECK((word(2).word.empty() && !word(2).accepted));
  CHECK(word(3).word == std::vector<std::string>{"a", "long"});
  CHECK(word(3).by_empty_stack);
}

TEST_CASE("definitions may use each other in any order, but not in a circle") {
  const auto load = [](const std::string& define) {
    return parse_machine(R"({"machine":1,"name":"m","start":"A","define":)" + define +
                             R"(,"transitions":[{"id":"a","from":"A","on":"x","to":"A","when":"b"}]})",
                         "m.json", {});
  };
  CHECK(load(R"({"b":"c and true","c":"1 = 1"})").ok());
  CHECK_FALSE(load(R"({"b":"c","c":"b"})").ok());
}

TEST_CASE("what understands gestures and how long words and pointing wait for each other is the machine's to say") {
  const auto with = [](const std::string& keys) {
    return machine_of(R"({"machine":1,"name":"m","start":"A","transitions":[{"id":"a","from":"A","on":"x","to":"A"}])" +
                      keys + "}");
  };
  CHECK(with("")->gestures.empty());
  CHECK_FALSE(with("")->fusion);
  const auto machine = with(R"(,"gestures":"hands","fusion":{"after":0.25})");
  CHECK(machine->gestures == "hands");
  REQUIRE(machine->fusion);
  CHECK(machine->fusion->before_s == 2);
  CHECK(machine->fusion->after_s == 0.25);
  CHECK(machine->fusion->lateness_s == 0);
}

TEST_CASE("moves are the members of an object, or a list where names differ only in case") {
  const auto with = [](const std::string& moves) {
    return parse_machine(R"({"machine":1,"name":"m","start":"A","moves":)" + moves +
                             R"(,"transitions":[{"id":"a","from":"A","on":["x","y"],"to":"A"}]})",
                         "m.json", {});
  };
  const auto moves_of = [&](const std::string& moves) {
    std::string told;
    const auto machine = with(moves).value();
    for (const auto& move : machine.moves) told += move.name + " " + std::to_string(move.inputs.names.size()) + ";";
    return told;
  };
  CHECK(moves_of(R"([{"move":"N","inputs":["x","y"]},{"move":"n","inputs":"y","about":"no"}])") == "N 2;n 1;");
  CHECK(moves_of(R"({"N":["x","y"],"n":"y"})") == "N 2;n 1;");
  CHECK(with(R"([{"move":"N"}])").error().text() ==
        "m.json:1:46: there is no \"inputs\"; expected the inputs of the move");
  CHECK(with(R"(["N"])").error().sentence == "found 'N', expected a move, an object");
}
