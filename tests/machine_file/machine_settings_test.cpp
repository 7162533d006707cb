#include "continua/machine_file/machine_settings.h"

#include "continua/machine_file/machine_parameters.h"
#include "continua/term/term_text.h"
#include "support/machines.h"

namespace continua {
namespace {

const std::string text = R"json({"machine":1,"name":"m","start":"A","parameters":{"patience":{"value":2}},
  "slots":{"n":{"type":"num"}},
  "states":{"A":{},"B":{"gate":{"when":"n > 3","else":"A"}},"C":{"gate":{"when":"n > 3 and n < 5","else":"A"}}},
  "transitions":[{"id":"guess","from":"A","on":"x","to":"B"},{"id":"wait","from":"A","on":"x","to":"C","weight":2}],
  "beliefs":{"concepts":{"point":{}},"evidence":[{"inputs":["p"],"concepts":["point"],"levels":[0.5,1]}]}})json";

std::string problem_with(const Json& values) {
  Machine machine = *machine_of(text);
  const auto problem = apply_settings(machine, values, "--set");
  return problem ? problem->text() : "";
}

}  // namespace

TEST_CASE("each number of a machine has a name by which it is set") {
  Machine machine = *machine_of(text);
  CHECK(names_of_settings(machine) == std::vector<std::string>{"patience", "weights.guess", "weights.wait", "gate.B",
                                                               "belief.1.1", "belief.1.2", "belief.overheard"});
  REQUIRE_FALSE(apply_settings(
      machine,
      {{"patience", 5}, {"weights.wait", 0.25}, {"gate.B", 7}, {"belief.1.1", 0.75}, {"belief.overheard", 0.5}},
      "--set"));
  CHECK(parameter_values(machine) == Json{{"patience", 5.0}});
  // The document in the log has them too, but for parameters, which the log has apart.
  const auto again = machine_of(machine.document);
  for (const Machine* each : {&std::as_const(machine), &*again}) {
    CHECK(each->transitions[1].weight == 0.25);
    CHECK(print(each->states[1].gate->when) == "n > 7");
    CHECK(each->beliefs.evidence[0].levels == std::vector{0.75, 1.0});
    CHECK(each->beliefs.overheard == 0.5);
  }
}

TEST_CASE("a value that a machine does not have, or cannot have, is told") {
  CHECK(problem_with({{"patienc", 1}}) == "--set: the machine m has no parameter 'patienc' (did you mean 'patience'?)");
  CHECK(problem_with({{"weights.wat", 1}}) ==
        "--set: the machine m has no value 'weights.wat' that can be set (did you mean 'weights.wait'?)");
  CHECK(problem_with({{"gate.C", 1}}) ==
        "--set: the machine m has no value 'gate.C' that can be set (did you mean 'gate.B'?)");
  CHECK(problem_with({{"weights.wait", 0}}) ==
        "--set: the value 'weights.wait' of the machine m is 0; expected a number above 0 and up to 1000000000");
  CHECK(problem_with({{"belief.1.2", 0.25}}) ==
        "--set: the value 'belief.1.2' of the machine m is 0.25; expected a number from 0.5 and up to 1");
  CHECK(problem_with({{"gate.B", "high"}}) ==
        "--set: the value 'gate.B' of the machine m is \"high\"; expected a number from -1000000000 and up to "
        "1000000000");
}

TEST_CASE("a setting is a name and a value, which is JSON or else a text") {
  CHECK(read_setting("a=1.5", "--set")->second == Json(1.5));
  CHECK(read_setting("a=true", "--set")->second == Json(true));
  CHECK(read_setting("a=b=c", "--set")->second == Json("b=c"));
  CHECK(read_setting("a=", "--set")->second == Json(""));
  for (const char* wrong : {"a", "=1", ""})
    CHECK(read_setting(wrong, "--set").error().sentence.ends_with("expected NAME=VALUE"));
}

}  // namespace continua
