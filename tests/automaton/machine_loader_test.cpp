#include "automaton/machine_loader.h"

#include "machines.h"

using namespace continua;

namespace {

struct Broken {
  const char* text;
  const char* message;
};

const std::vector<Broken> broken_machines = {
    {"", "m.json:1:1: the file is empty; expected a JSON document"},
    {"[1]", "m.json:1:1: expected a machine, an object, found array"},
    {R"({"machine":1,"name":"m","start":"A","transition":[]})",
     "m.json:1:50: unknown key 'transition' of a machine (did you mean 'transitions'?)"},
    {R"({"machine":2,"name":"m","start":"A","states":{"A":{}},"transitions":[]})",
     "m.json:1:12: expected \"machine\": 1, the version of the format"},
    {R"({"machine":1,"name":"m","start":"Wiat","states":{"Wait":{}},"transitions":[]})",
     "m.json:1:33: unknown state 'Wiat' (did you mean 'Wait'?)"},
    {R"({"machine":1,"name":"m","start":"A","states":{"A":{}}})", "m.json:1:1: expected \"transitions\", a list"},
    {R"({"machine":1,"name":"m","start":"A","transitions":[{"id":"a","from":"A","on":"x","to":"A","puhs":{}}]})",
     "m.json:1:98: unknown key 'puhs' of a transition (did you mean 'push'?)"},
    {R"({"machine":1,"name":"m","start":"A","transitions":[{"id":"a","from":"A","to":"A"}]})",
     "m.json:1:52: expected \"on\": input symbols, or null for an ε-transition"},
    {R"({"machine":1,"name":"m","start":"A","transitions":[{"id":"a","from":"A","on":"x","to":"A"},{"id":"a","from":"A","on":"x","to":"A"}]})",
     "m.json:1:98: a second transition with the id 'a'"},
    {R"({"machine":1,"name":"m","start":"A","slots":{"held":"e"},"transitions":[{"id":"a","from":"A","on":"x","to":"A","push":{"hled":"null"}}]})",
     "m.json:1:127: unknown slot 'hled' (did you mean 'held'?)"},
    {R"({"machine":1,"name":"m","start":"A","slots":{"held":"thing"},"transitions":[]})", ""},
    {R"({"machine":1,"name":"m","start":"A","slots":{"if":"e"},"transitions":[]})",
     "m.json:1:51: the name 'if' is taken already"},
    {R"({"machine":1,"name":"m","start":"A","inputs":{"X":["Y"],"Y":["X"]},"transitions":[]})",
     "m.json:1:51: the set 'X' contains itself"},
    {R"({"machine":1,"name":"m","start":"A","transitions":[{"id":"a","from":"A","on":"x","to":"A","weight":0}]})",
     "m.json:1:100: a weight is greater than 0"},
    {R"({"machine":1,"name":"m","start":"A","transitions":[{"id":"a","from":"A","on":"x","to":"A","pop":1,"flush":{}}]})",
     "m.json:1:107: a second operation, 'flush', beside 'pop'; expected one"},
    {R"({"machine":1,"name":"m","start":"A","states":{"A":{"enter":[{"say":"Hello {name"}]}},"transitions":[]})",
     "m.json:1:68: a '{' without its '}' in \"Hello {name\""},
};

}  // namespace

TEST_CASE("a broken machine is told by line, column, what was found and what was expected") {
  for (const auto& [text, message] : broken_machines) {
    CAPTURE(text);
    const auto machine = parse_machine(text, "m.json", {});
    REQUIRE_FALSE(machine.ok());
    if (*message) CHECK(machine.error().text() == message);
  }
}

TEST_CASE("terms of a machine are type-checked where they stand") {
  const auto error = [](const std::string& condition) {
    const auto machine = parse_machine(R"({"machine":1,"name":"m","start":"A","slots":{"options":"e*","region":"loc"},
 "transitions":[{"id":"a","from":"A","on":"x","to":"A","when":")" +
                                           condition + "\"}]}",
                                       "m.json", {});
    return machine.ok() ? "" : machine.error().text();
  };
  CHECK(error("size(options) > 1") == "");
  CHECK(error("region = null") == "");
  CHECK(error("size(optoins) > 1").find("m.json:2:63: ") == 0);
  CHECK(error("size(optoins) > 1").find("did you mean 'options'?") != std::string::npos);
  CHECK(error("size(region) > 1").find("m.json:2:63: ") == 0);
  CHECK(error("size(options)").find("m.json:2:63: ") == 0);
  CHECK(error("size(options > 1").find("m.json:2:63: ") == 0);
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
