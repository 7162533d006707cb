// Problems of a lexicon come with their place; all attributes of a scene's objects have words.
#include "continua/language/lexicon.h"

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/core/random.h"
#include "language/english.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string small =
    R"json({"categories": {"S": {"type": "t", "move": "V"}, "N": {"type": "e -> t", "features": ["many"]}},
"names": {"stop": "t"},
"define": {"big": {"type": "e -> t", "term": "\\x. volume(x) > 1"}},
"determiners": {"the": {"definite": true}},
"proforms": {"it": {"type": "e", "source": "focus"}},
"words": {"halt | stop it": [["S", "stop"]]},
"skip": {"please": 0},
"attributes": {"type": {"meaning": "\\v x. contains(v, attribute(x, 'type'))", "words": [{"category": "N", "term": "\\p x. p(x)"}], "values": ["cup"]}},
"plural": {"": "s"},
"unary": [{"name": "a", "from": "N", "to": "N[many]", "term": "\\n. n"}],
"examples": [{"say": "halt", "reading": "stop"}],
"sample": {"type": ["ball"]}}
)json";

std::string errors_of(const std::string& text) {
  const TemporaryFolder folder;
  folder.file("a.json", text);
  std::string errors;
  for (const auto& error : check_lexicon(folder.path().string(), WorldFacts::signature()))
    errors += (errors.empty() ? "" : "\n") + error.text().substr(folder.path().string().size() + 1);
  return errors;
}

struct Row {
  const char *from, *to, *errors;
};

const Row rows[] = {
    {"\"names\"", "\"name\"",
     "a.json:2:1: unknown key 'name' of a part of a lexicon (did you mean 'names'?)\n"
     "a.json:6:37: unknown name 'stop', in 'stop'"},
    {"\"type\": \"t\"", "\"type\": \"x\"", "unknown type 'x'"},
    {"\"move\"", "\"moves\"", "a.json:1:36: unknown key 'moves' of a category (did you mean 'move'?)"},
    {"\"stop\": \"t\"", "\"scene\": \"t\"", "the name 'scene' is taken by a fact of the world; expected another"},
    {"\"stop\": \"t\"", "\"stop\": 3", "a.json:2:19: found 3, expected a type, a string"},
    {"volume(x) > 1", "volum(x) > 1", "unknown name 'volum' (did you mean 'volume'?)"},
    {"\"type\": \"e -> t\", \"term\": \"\\\\x", "\"type\": \"e -> t\", \"compared\": true, \"term\": \"\\\\x",
     "'big' is of type e -> t; expected e*, objects to compare"},
    {"volume(x) > 1", "volume(x)", "found a function from e to num"},
    {"\"definite\": true", "\"definite\": 1", "a.json:4:37: found 1, expected true or false"},
    {"\"focus\"", "\"fokus\"",
     "found 'fokus', expected focus, pointed, topic, other, avatar, human or handled (did you mean 'focus'?)"},
    {"[\"S\", \"stop\"]", "[\"S/\", \"stop\"]", "a.json:6:34: found nothing more, expected a category, in 'S/'"},
    {"[\"S\", \"stop\"]", "[\"T\", \"stop\"]", "a.json:6:32: found 'T', expected a category, in 'T'"},
    {"[\"S\", \"stop\"]", "[\"S\", \"it\"]", "a.json:6:37: "},
    {"[\"S\", \"stop\"]", "[\"S\"]", "a.json:6:30: found 1 elements, expected a category, a term and perhaps a cost"},
    {"[\"S\", \"stop\"]", "[\"S\", \"stop\", -1]", "found -1, expected a cost, a number from 0 to 100"},
    {"halt |", "Halt |", "found 'Halt', expected words in lower case"},
    {"halt |", "halt | [now] |", "found 'halt | [now] | stop it', expected at least one word in each"},
    {"\"please\": 0", "\"please\": \"no\"", "found 'no', expected a cost"},
    {"N[many]", "N[mane]", "N has no feature 'mane' (did you mean 'many'?), in 'N[mane]'"},
    {"\"from\": \"N\", ", "", "there is no \"from\"; expected the category that changes"},
    {"\"reading\": \"stop\"", "\"reading\": \"stopp\"", "unknown name 'stopp' (did you mean 'stop'?)"},
    {", \"reading\": \"stop\"", "", "there is none of \"reading\""},
    {"[\"ball\"]", "\"ball\"", "found 'ball', expected values, a list"},
    {"\"values\": [\"cup\"]", "\"values\": [\"?\"]", "there is no word in this value"},
};

}  // namespace

TEST_CASE("what is wrong with a lexicon is told with line and column") {
  CHECK(errors_of(small) == "");
  for (const auto& [from, to, errors] : rows) {
    auto text = small;
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, std::string(from).size(), to);
    CAPTURE(to);
    CHECK_THAT(errors_of(text), Catch::Contains(errors));
  }
  const TemporaryFolder empty;
  CHECK_THAT(load_lexicon(empty.path().string(), {}).error().sentence, Catch::Contains("there is no *.json"));
  CHECK_THAT(load_lexicon("/nowhere", {}).error().sentence, Catch::Contains("expected a folder"));
}

TEST_CASE("a wrong example does not keep the words from being used") {
  const TemporaryFolder folder;
  auto text = small;
  text.replace(text.find("\"reading\": \"stop\""), 17, "\"reading\": \"stopp\"");
  folder.file("a.json", text);
  const auto lexicon = load_lexicon(folder.path().string(), WorldFacts::signature());
  REQUIRE(lexicon.ok());
  CHECK(!lexicon->words.find("stop it").empty());
  CHECK_THAT(load_examples(*lexicon).error().text(), Catch::Contains("a.json:11:42: unknown name 'stopp'"));
}

TEST_CASE("whatever is done to a lexicon, it loads or is told where it is wrong") {
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    auto text = small;
    const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(text.size()));
    switch (i % 3) {
      case 0:
        text[at] = static_cast<char>(static_cast<unsigned char>(random.uniform() * 256));
        break;
      case 1:
        text.erase(at, 1 + at % 9);
        break;
      default:
        text.insert(at, text.substr(at / 2, 12));
    }
    const auto errors = errors_of(text);
    CAPTURE(text, errors);
    REQUIRE((errors.empty() || errors.starts_with("a.json:")));
  }
}

TEST_CASE("the digest is that of the content") {
  const TemporaryFolder one, two;
  one.file("a.json", small);
  two.file("a.json", small + "\n ");
  const auto digest = [](const TemporaryFolder& folder) {
    return load_lexicon(folder.path().string(), WorldFacts::signature())->digest;
  };
  CHECK(digest(one) == digest(two));
  two.file("a.json", small.substr(0, small.find("please")) + "so" + small.substr(small.find("please") + 6));
  CHECK(digest(one) != digest(two));
  two.file("a.json", small);
  two.file("b.json", R"({"skip": {"well": 0}})");
  CHECK(digest(one) != digest(two));
}

TEST_CASE("what the scene says of its objects can be said") {
  WorldSnapshot world;
  world.objects = {object_of("b1", "type=banana color=cyan"),
                   object_of("b2", "type=orange color=light_blue"),
                   object_of("b3", "type=mug material=felt weight=heavy"),
                   object_of("b4", "type=toy_car"),
                   object_of("b5", "type=table color="),
                   object_of("banana", "type=fish")};
  const Vocabulary words(english(), world);
  const auto read_as = [&](const char* text) { return reading_of(text, words); };
  CHECK(read_as("the cyan bananas") == R"(all(\x. cyan(x) and banana(x)))");
  CHECK(read_as("the light blue one") == R"(the(\x. light_blue(x) and one(x)))");
  CHECK(read_as("the mug") == R"(the(\x. cup(x)))");
  CHECK(read_as("the violet cup") == R"(the(\x. purple(x) and cup(x)))");
  CHECK(read_as("the felt cup") == R"(the(\x. felt(x) and cup(x)))");
  CHECK(read_as("two toy cars") == R"(two(\x. toy_car(x)))");
  CHECK(read_as("the orange orange") == R"(the(\x. orange(x) and orange_type(x)))");
  CHECK(read_as("grab that table") == R"(grasp(that(\x. table_type(x))))");
  CHECK(read_as("the heavy cup") == R"(the(\x. cup(x)))");
  CHECK(print(*words.definition("cup")) ==
        R"(\x. contains(['cup', 'mug', 'beaker', 'teacup', 'tumbler'], attribute(x, 'type')))");
  CHECK(print(*words.definition("orange_type")) == R"(\x. contains(['orange'], attribute(x, 'type')))");
  CHECK(words.definition("zork") == nullptr);
  CHECK(words.definition("leftmost") != nullptr);
  CHECK_FALSE(english_words().knows("banana"));
  CHECK(words.names().at("banana").text() == "e -> t");
}

TEST_CASE("a lexicon may be based on another one") {
  const TemporaryFolder all;
  const auto known = all.path().string();
  all.file("base/a.json", small);
  all.file("own/a.json", R"({"based_on": "base", "words": {"freeze": [["S", "stop"]]}})");
  const auto own = load_lexicon(known + "/own", WorldFacts::signature(), known);
  REQUIRE(own.ok());
  CHECK(!own->words.find("halt").empty());
  CHECK(!own->words.find("freeze").empty());
  CHECK(own->folders == std::vector{known + "/base", known + "/own"});

  SECTION("which is a name among those that are known, or a path") {
    all.file("own/a.json", R"({"based_on": "../base"})");
    CHECK(load_lexicon(known + "/own", WorldFacts::signature()).ok());
  }
  SECTION("of which more are based on others, each read once") {
    all.file("third/a.json", R"({"based_on": "own"})");
    all.file("third/b.json", R"({"based_on": "base", "skip": {"well": 0}})");
    const auto third = load_lexicon(known + "/third", WorldFacts::signature(), known);
    REQUIRE(third.ok());
    CHECK(third->folders == std::vector{known + "/base", known + "/own", known + "/third"});
  }
  SECTION("but not on itself for ever") {
    all.file("base/b.json", R"({"based_on": "own"})");
    CHECK(load_lexicon(known + "/own", WorldFacts::signature(), known).ok());
  }
  const auto error_of = [&](const std::string& text) {
    all.file("own/a.json", text);
    return load_lexicon(known + "/own", WorldFacts::signature(), known).error().text();
  };
  CHECK(error_of(R"({"based_on": "bass"})") ==
        known + "/own/a.json:1:14: there is no folder '" + known +
            "/own/bass'; expected the name of a lexicon, or the path of its folder");
  CHECK(error_of(R"({"based_on": 3})") ==
        known + "/own/a.json:1:14: found 3, expected the name of a lexicon, or the path of its folder, a string");
}
