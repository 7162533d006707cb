// Rules that traces set: their values, when they held, and that terms read them.
#include "continua/machine_file/machine_parameters.h"

#include "support/catch.h"
#include "support/machines.h"

using namespace continua;

namespace {

const char* text = R"json({
  "machine": 1, "name": "m", "start": "A",
  "parameters": {
    "polite": { "value": true, "until": { "2018-02-05T15:00": false } },
    "least": { "value": 3, "until": { "2018-02-07": 2, "2018-02-05": 1 } },
    "greeting": { "value": "Hello." } },
  "define": { "few": "2 < least" },
  "transitions": [
    { "id": "polite", "from": "A", "on": "x", "when": "polite and few", "to": "B" },
    { "id": "curt", "from": "A", "on": "x", "when": "not polite", "to": "C" } ] })json";

Machine machine() { return *machine_of(text); }

}  // namespace

TEST_CASE("a parameter has the value that it had when something was recorded") {
  const auto [recorded, values] = GENERATE(table<std::string, std::string>({
      {"2018-02-04T23:59:59", R"({"polite":false,"least":1.0,"greeting":"Hello."})"},
      {"2018-02-05", R"({"polite":false,"least":2.0,"greeting":"Hello."})"},
      {"2018-02-05T14:59:59", R"({"polite":false,"least":2.0,"greeting":"Hello."})"},
      {"2018-02-05T15:00:00", R"({"polite":true,"least":2.0,"greeting":"Hello."})"},
      {"2018-02-07T00:00:00", R"({"polite":true,"least":3.0,"greeting":"Hello."})"},
  }));
  CHECK(compact(parameter_values_at(machine(), recorded)) == values);
}

TEST_CASE("what is set counts in conditions and definitions") {
  const auto [set, state] = GENERATE(table<std::string, std::string>(
      {{"{}", "B"}, {R"({"polite":false})", "C"}, {R"({"least":2})", "A"}, {R"({"least":2,"polite":false})", "C"}}));
  auto changed = machine();
  REQUIRE_FALSE(set_parameters(changed, Json::parse(set), "t:1"));
  CHECK(Player(std::make_shared<const Machine>(changed)).feed("x").state() == state);
  CHECK(parameter_values(changed) == [&, set = set] {
    auto values = parameter_values(machine());
    values.update(Json::parse(set));
    return values;
  }());
}

TEST_CASE("what cannot be set is told") {
  const auto [set, problem] = GENERATE(table<std::string, std::string>({
      {R"({"polit":true})", "t:1: the machine m has no parameter 'polit' (did you mean 'polite'?)"},
      {R"({"few":true})", "t:1: the machine m has no parameter 'few'"},
      {R"({"polite":1})", "t:1: the parameter 'polite' of the machine m is 1; expected true or false"},
      {R"({"least":"2"})", "t:1: the parameter 'least' of the machine m is \"2\"; expected a number"},
      {R"({"greeting":null})", "t:1: the parameter 'greeting' of the machine m is null; expected a text"},
  }));
  auto changed = machine();
  const auto outcome = set_parameters(changed, Json::parse(set), "t:1");
  REQUIRE(outcome);
  CHECK(outcome->text() == problem);
}
