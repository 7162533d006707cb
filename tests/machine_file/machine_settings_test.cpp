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
        "--set: the machine m has no value 'weights.wat' that can be set: there is no transition 'wat' (did you mean "
        "'weights.wait'?)");
  CHECK(problem_with({{"weights.wait", 0}}) ==
        "--set: the value 'weights.wait' of the machine m is 0; expected a number above 0 and up to 1000000000");
  CHECK(problem_with({{"belief.1.2", 0.25}}) ==
        "--set: the value 'belief.1.2' of the machine m is 0.25; expected a number from 0.5 and up to 1");
  CHECK(problem_with({{"gate.B", "high"}}) ==
        "--set: the value 'gate.B' of the machine m is \"high\"; expected a number from -1000000000 and up to "
        "1000000000");
}

TEST_CASE("a name of a value that cannot be set is told with the nearest one of its kind") {
  struct Case {
    const char *name, *told;
  };
  const Case cases[] = {
      {"gate.A", "has no value 'gate.A' that can be set: the state 'A' has no gate (did you mean 'gate.B'?)"},
      {"gate.C",
       "has no value 'gate.C' that can be set: the gate of 'C' has not one number alone (did you mean 'gate.B'?)"},
      {"gate.Compose",
       "has no value 'gate.Compose' that can be set: there is no state 'Compose' (did you mean 'gate.B'?)"},
      {"weights.entirely_other",
       "has no value 'weights.entirely_other' that can be set: there is no transition "
       "'entirely_other' (did you mean 'weights.wait'?)"},
      {"belief.7.2",
       "has no value 'belief.7.2' that can be set: there is 1 row of evidence (did you mean 'belief.1.2'?)"},
      {"belief.1.9",
       "has no value 'belief.1.9' that can be set: row 1 of the evidence has 2 levels (did you mean 'belief.1.2'?)"},
      {"belief.0.0",
       "has no value 'belief.0.0' that can be set: there is 1 row of evidence (did you mean 'belief.1.1'?)"},
      {"belief.first",
       "has no value 'belief.first' that can be set: it is no belief.ROW.LEVEL (did you mean "
       "'belief.1.1'?)"},
      {"belief.overherd",
       "has no value 'belief.overherd' that can be set: it is no belief.ROW.LEVEL (did you mean "
       "'belief.overheard'?)"},
      {"wieghts.wait", "has no value 'wieghts.wait' that can be set (did you mean 'weights.wait'?)"},
  };
  for (const auto& [name, told] : cases)
    CHECK(problem_with({{name, 1}}) == std::string("--set: the machine m ") + told);
}

TEST_CASE("a machine without gates and beliefs says so where one is to be set") {
  const std::string plain = R"json({"machine":1,"name":"p","start":"A",
    "transitions":[{"id":"go","from":"A","on":"x","to":"A"}]})json";
  const auto told = [&](const char* name) {
    Machine machine = *machine_of(plain);
    return apply_settings(machine, {{name, 1}}, "--set")->sentence;
  };
  CHECK(told("gate.A") == "the machine p has no value 'gate.A' that can be set: the state 'A' has no gate");
  CHECK(told("belief.1.1") == "the machine p has no value 'belief.1.1' that can be set: there are 0 rows of evidence");
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
