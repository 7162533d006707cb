#include "automaton/machine_loader.h"

#include "machines.h"

using namespace continua;

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
  CHECK(error("size(optoins) > 1").find("m.json:2:68: ") == 0);
  CHECK(error("size(optoins) > 1").find("did you mean 'options'?") != std::string::npos);
  CHECK(error("size(region) > 1").find("m.json:2:68: ") == 0);
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
