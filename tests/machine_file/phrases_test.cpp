// Phrases from a file: read with the machine that uses them, with the place of each problem.
#include <fmt/format.h>

#include "continua/machine_file/machine_loader.h"
#include "continua/machine_file/phrase_file.h"
#include "support/machines.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string machine = R"({"machine":1,"name":"m","start":"A","phrases":"talk","slots":{"n":"num","at":"loc"},
  "transitions":[{"id":"a","from":"A","on":"x","to":"A","do":[{"phrase":"count"}]}]})";

// The phrase file that has these cases for `count`.
std::string with_cases(const std::string& cases) { return R"({"phrases":1,"say":{"count":)" + cases + "}}"; }

// All that is wrong with the machine and its phrases; the folder's name left out.
std::string errors_of(const std::string& phrases, const std::string& text = machine) {
  TemporaryFolder folder;
  folder.file("talk.json", phrases);
  std::string errors;
  for (const auto& error : check_machine(text, "m", {}, folder.path().string())) errors += error.text() + "\n";
  const auto path = folder.path().string() + "/";
  for (auto at = errors.find(path); at != std::string::npos; at = errors.find(path)) errors.erase(at, path.size());
  return errors;
}

}  // namespace

TEST_CASE("the first case of a phrase whose condition holds is said, with all its variants that can be filled") {
  TemporaryFolder folder;
  folder.file("talk.json", with_cases(R"([{"when":"n = 1","say":"one"},
    {"when":"n > 1","say":["{n} of them","{at}","{n}!"]},{"when":"n < 0","say":"{at}"}])"));
  const auto said = [&](const std::string& n) {
    auto text = machine;
    const std::string slots = R"("slots")";
    text.insert(text.find(slots), R"("bottom":{"n":")" + n + "\"},");
    const auto loaded = parse_machine(text, "m", {}, folder.path().string());
    REQUIRE(loaded.ok());
    Player player(std::make_shared<const Machine>(*loaded));
    std::string all;
    for (const auto& one : player.feed("x").all<Said>()) {
      CHECK(one.text == one.variants.front());
      for (const auto& variant : one.variants) all += variant + "|";
    }
    return all;
  };
  CHECK(said("1") == "one|");
  CHECK(said("3") == "3 of them|3!|");
  CHECK(said("0").empty());
  CHECK(said("-1").empty());
}

TEST_CASE("definitions and wordings of a phrase file serve its phrases, and a language replaces the file") {
  TemporaryFolder folder;
  folder.file("talk.json", R"({"phrases":1,"define":{"many":"n > 1","word":{"2":"'two'"}},
    "wordings":[{"of":"\\x: num. x","when":"x > 1","say":"{word(text(x))} things"}],
    "say":{"count":[{"when":"many","say":"{wording(n)}"},{"say":"one"}]}})");
  folder.file("rede.json", R"({"phrases":1,"say":{"count":[{"say":"{n} Dinge"}]}})");
  auto text = machine;
  text.insert(text.find(R"("slots")"), R"("lexicon":"talk","bottom":{"n":"2"},)");
  const auto said = [&](const std::string& language) {
    const auto loaded = parse_machine(text, "m", {}, folder.path().string(), language);
    REQUIRE(loaded.ok());
    CHECK(loaded->lexicon == (language.empty() ? "talk" : language));
    CHECK(loaded->phrases == (language.empty() ? "talk" : language));
    return Player(std::make_shared<const Machine>(*loaded)).feed("x").all<Said>().at(0).text;
  };
  CHECK(said("") == "two things");
  CHECK(said("rede") == "2 Dinge");
}

TEST_CASE("what a phrase file defines is known to it alone, and is nothing that the machine has") {
  const auto with_definition = [](const std::string& name) {
    return R"({"phrases":1,"define":{")" + name + R"(":"n > 1"},"say":{"count":[{"say":"one"}]}})";
  };
  auto deciding = machine;
  deciding.insert(deciding.find(R"("to":"A")"), R"("when":"many",)");
  CHECK(errors_of(with_definition("many")).empty());
  CHECK_THAT(errors_of(with_definition("many"), deciding), Catch::Contains("unknown name 'many'"));
  CHECK(errors_of(with_definition("n")) ==
        "talk.json:1:24: the name 'n' is taken by an earlier declaration; expected another (read for the machine m)\n");
}

TEST_CASE("ways to say something may stand in the machine itself") {
  Player player(R"({"machine":1,"name":"m","start":"A","transitions":[
    {"id":"a","from":"A","on":"x","to":"A","do":[{"say":["Which?","Which one?"]}]}]})");
  CHECK(player.feed("x").all<Said>().at(0).variants == std::vector<std::string>{"Which?", "Which one?"});
}

TEST_CASE("what is wrong with phrases is told with the line of their file, and the machine they were read for") {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {with_cases(R"([{"when":"m = 1","say":"one"}])"),
       "talk.json:1:39: unknown name 'm', in 'm = 1' (read for the machine m)\n"},
      {with_cases(R"([{"when":"n","say":"one"}])"),
       "talk.json:1:39: found num, expected t, in 'n' (read for the machine m)\n"},
      {with_cases(R"([{"say":["one","{n"]}])"), "talk.json:1:45: a '{' without its '}' (read for the machine m)\n"},
      {with_cases(R"([{"say":["{size(n)}"]}])"),
       "talk.json:1:45: 'size' takes a list, found num, in 'size(n)' (read for the machine m)\n"},
      {R"({"phrases":1,"say":{"cuont":[{"say":"one"}],"other":[{"say":"{unknown}"}]}})",
       "m:2:73: no phrase 'count' in talk.json (did you mean 'cuont'?)\n"},
      {R"({"phrases":2,"say":{"count":[{"say":"one"}]}})",
       "talk.json:1:12: found 2, expected 1, the version of the format\n"},
      {R"({"phrases":1,"say":{"count":[{"say":"one"}],"count":[{"say":"one"}]}})",
       "talk.json:1:45: the key 'count' a second time in this object\n"},
      {R"({"phrases":1})", "talk.json:1:1: there is no \"say\"; expected names and what is said, an object\n"},
      {R"([])", "talk.json:1:1: found a list, expected phrases, an object\n"},
      {R"({"phrases":1,"say":{"count":"one"}})",
       "talk.json:1:29: found 'one', expected the cases of a phrase, a list\n"},
      {with_cases("[{}]"), "talk.json:1:30: there is no \"say\"; expected what is said\n"},
      {with_cases(R"([{"say":"one"},{"say":"two"}])"),
       "talk.json:1:44: never said: the case before it has no condition\n"},
      {with_cases(R"([{"says":"one","say":"one"}])"),
       "talk.json:1:31: unknown key 'says' of a case (did you mean 'say'?)\n"},
      {with_cases(R"([{"when":1,"say":[]}])"),
       "talk.json:1:38: found 1, expected a condition, a string\n"
       "talk.json:1:46: found a list, expected what is said, a string, or several ways to say it, "
       "a list of strings\n"},
      {"", "talk.json:1:1: the file is empty; expected a JSON document\n"},
  };
  for (const auto& [phrases, expected] : rows) {
    CAPTURE(phrases);
    CHECK(errors_of(phrases) == expected);
  }
}

TEST_CASE("phrases are looked for in the folder that is given") {
  auto elsewhere = machine;
  elsewhere.replace(elsewhere.find("talk"), 4, "tolk");
  const auto errors = errors_of(with_cases(R"([{"say":"one"}])"), elsewhere);
  CHECK(errors.find('\n') == errors.size() - 1);
  CHECK(errors.starts_with("m:1:47: there are no phrases 'tolk' (did you mean 'talk'?); expected a name in "));
  auto none = machine;
  none.erase(none.find(R"("phrases":"talk",)"), 17);
  CHECK(errors_of("{}", none) ==
        "m:2:73: there are no phrases without their file; expected \"phrases\" in the machine\n");
  CHECK(errors_of(with_cases(R"([{"say":"one"}])")).empty());
}
