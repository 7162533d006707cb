#include "continua/perception/gesture.h"

#include <map>

#include "continua/core/located_json.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

InputEvent shown(const std::string& name, const std::string& direction = "", const std::string& phase = "") {
  InputEvent event;
  event.modality = Modality::gesture;
  event.name = name;
  event.direction = direction;
  event.phase = phase;
  return event;
}

std::string problems_of(const std::string& text) {
  std::string all;
  for (const auto& problem : check_gestures(text, "g.json")) all += (all.empty() ? "" : "\n") + problem.text();
  return all;
}

const char* const sound = R"json({
  "gestures": {
    "point": {"kind": "δ"},
    "push | shove": {"kind": "α", "means": {"left": "\\x: e. slide(x, left(x))"}},
    "grab": {"kind": "α", "means": "\\x: e. grasp(x)", "acts_on": ["stop"]}
  },
  "examples": [{"gesture": "right shove left start", "kind": "α", "means": "\\x: e. slide(x, left(x))", "symbol": "gesture α"}]
})json";

}  // namespace

TEST_CASE("gestures are read with their kinds, meanings and phases") {
  const auto gestures = read_gestures(sound, "folder/g.json");
  if (!gestures) FAIL(gestures.error().text());
  CHECK(gestures->name == "g");
  CHECK(gestures->digest.size() == 32);
  CHECK(gestures->entries.size() == 4);
  REQUIRE(gestures->find("shove"));
  CHECK(gestures->find("shove")->name == "shove");
  REQUIRE(gestures->find("shove")->meaning("left"));
  CHECK(*gestures->find("shove")->meaning("left") == "\\x: e. slide(x, left(x))");
  CHECK_FALSE(gestures->find("shove")->meaning("up"));
  CHECK(*gestures->find("grab")->meaning("up") == "\\x: e. grasp(x)");
  CHECK_FALSE(gestures->find("point")->meaning(""));
  CHECK_FALSE(gestures->find("wink"));
  CHECK(gestures->find("grab")->where == "folder/g.json:5:13");
}

TEST_CASE("the symbol of a gesture is its kind, with the phase if it is no move") {
  const auto gestures = read_gestures(sound, "g.json").value();
  const auto symbol = [&](const InputEvent& event) { return gesture_symbol(event, gestures.find(event.name)); };
  CHECK(symbol(shown("point", "", "start")) == "gesture δ");
  CHECK(symbol(shown("point", "", "stroke")) == "gesture δ");
  CHECK(symbol(shown("point")) == "gesture δ");
  CHECK(symbol(shown("point", "", "stop")) == "gesture δ stop");
  CHECK(symbol(shown("grab", "", "start")) == "gesture α start");
  CHECK(symbol(shown("grab", "", "stop")) == "gesture α");
  CHECK(symbol(shown("wink", "", "start")) == "gesture unknown");
  CHECK(symbol(shown("wink", "", "stop")) == "gesture unknown stop");
}

TEST_CASE("what is wrong with a file of gestures is told with its place") {
  const std::map<std::string, std::string> table = {
      {"[]", "g.json:1:1: found a list, expected a file of gestures, an object"},
      {"{}", "g.json:1:1: there is no \"gestures\"; expected gestures by their names"},
      {R"({"gesture": {}, "gestures": {}})",
       "g.json:1:2: unknown key 'gesture' of a file of gestures (did you mean 'gestures'?)"},
      {R"({"gestures": {"a": {"kind": "δ"}, "a": {"kind": "δ"}}})",
       "g.json:1:36: the key 'a' a second time in this object"},
      {R"({"gestures": {"a": {"kind": "δ"}, "b | a": {"kind": "δ"}}})", "g.json:1:36: there is a gesture 'a' already"},
      {R"({"gestures": {"a": {}}})",
       "g.json:1:20: there is no \"kind\"; expected the kind of move: δ, ω, α, y, n or another that machines know"},
      {R"({"gestures": {"a": {"kind": 1}}})",
       "g.json:1:29: found 1, expected the kind of move: δ, ω, α, y, n or another that machines know, a string"},
      {R"({"gestures": {"a": {"kind": "two words"}}})", "g.json:1:29: found 'two words', expected one word"},
      {R"({"gestures": {"a": {"kind": "α"}}})",
       "g.json:1:20: there is no \"means\"; expected what a gesture of the kind α says"},
      {R"({"gestures": {"a": {"kind": "y", "means": 3}}})",
       "g.json:1:43: found 3, expected a term, or terms by direction"},
      {R"({"gestures": {"a": {"kind": "y", "means": {"lefft": "x"}}}})",
       "g.json:1:44: found 'lefft', expected left, right, front, back, up or down (did you mean 'left'?)"},
      {R"({"gestures": {"a": {"kind": "y", "acts_on": ["begin"]}}})",
       "g.json:1:46: found 'begin', expected start, stop or stroke"},
      {R"({"gestures": {"right | big wave": {"kind": "y"}}})",
       "g.json:1:15: found the name 'right'; expected one word that is no hand, or several with '|' between\n"
       "g.json:1:15: found the name 'big wave'; expected one word that is no hand, or several with '|' between"},
      {R"({"gestures": {"a": {"kind": "y"}}, "examples": [{"gesture": "left a", "kind": "n"}]})",
       "g.json:1:79: 'left a' has the kind 'y', not 'n'"},
      {R"({"gestures": {"a": {"kind": "y"}}, "examples": [{"gesture": "b", "symbol": "gesture y", "means": null}]})",
       "g.json:1:76: 'b' has the symbol 'gesture unknown', not 'gesture y'"},
      {R"({"gestures": {"a": {"kind": "y", "means": "yes"}}, "examples": [{"gesture": "a up", "means": "no"}]})",
       "g.json:1:94: 'a up' has the meaning 'yes', not 'no'"},
      {R"({"gestures": {"a": {"kind": "y"}}, "examples": [{"gesture": "a"}]})",
       "g.json:1:49: there is none of \"kind\", \"means\" and \"symbol\"; expected one of them"},
      {R"({"gestures": {}, "examples": {}})", "g.json:1:30: found an object, expected examples, a list"},
  };
  for (const auto& [text, expected] : table) {
    CAPTURE(text);
    CHECK(problems_of(text) == expected);
    CHECK_FALSE(read_gestures(text, "g.json").ok());
  }
  CHECK(problems_of("{").starts_with("g.json:1:2: "));
  CHECK(problems_of(sound).empty());
}

TEST_CASE("the gestures of the knowledge folder are sound and have an example each") {
  const std::string path = source_dir() + "/engine/knowledge/gestures/tabletop.json";
  const auto text = read_file(path).value();
  const auto gestures = read_gestures(text, path);
  if (!gestures) FAIL(gestures.error().text());
  const auto document = LocatedJson::parse(text, path).value();
  for (const auto& [name, entry] : gestures->entries) {
    CAPTURE(name);
    bool has_example = false;
    for (const auto& example : document.root()["examples"])
      has_example = has_example || event_of("gesture " + example["gesture"].get<std::string>()).name == name;
    CHECK(has_example);
    CHECK_FALSE((entry.about.empty() && !name.starts_with("count")));
  }
  // The names that the recordings' recogniser uses (traces/FORMAT.md).
  for (const auto* name : {"engage", "point", "posack", "negack", "grab", "count_one", "count_two", "count_three",
                           "count_four", "count_five"}) {
    CAPTURE(name);
    CHECK(gestures->find(name));
  }
  for (const auto* name : {"grab_move", "push"})
    for (const auto* direction : {"left", "right", "front", "back"}) {
      CAPTURE(name, direction);
      REQUIRE(gestures->find(name));
      CHECK(gestures->find(name)->meaning(direction));
    }
}
