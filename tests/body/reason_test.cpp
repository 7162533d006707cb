// Codes of reasons: their names, their statuses, and their words in the log and in each language.
#include "continua/body/reason.h"

#include <filesystem>
#include <fstream>
#include <set>

#include "continua/core/located_json.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

TEST_CASE("each code has a name of its own, an end of an act as its status, and words") {
  std::set<std::string> names;
  for (const auto code : all_reasons()) {
    INFO(name_of(code));
    CHECK(names.insert(name_of(code)).second);
    CHECK_FALSE(name_of(code).empty());
    CHECK(status_of(code) != ActStatus::started);
    CHECK_FALSE(words_of({code}).empty());
  }
  CHECK(name_of(ReasonCode::none).empty());
  CHECK(words_of({}).empty());
}

TEST_CASE("words of the log name the objects and terms of a reason") {
  struct Row {
    Reason reason;
    std::string name, status, words;
  };
  const Row rows[] = {
      {{ReasonCode::slipped, {"cup"}}, "slipped", "dropped", "cup slipped out of the fingers"},
      {{ReasonCode::missing, {"mug"}}, "missing", "unreachable", "there is no 'mug'"},
      {{ReasonCode::full, {"cup", "knife", "spoon"}}, "full", "blocked", "cup is full of knife and spoon"},
      {{ReasonCode::no_room, {"cup", "plate", "knife"}, {"between"}},
       "no_room",
       "blocked",
       "there is no room for cup between plate and knife"},
      {{ReasonCode::needs_condition, {}, {"lift(cup)", "hold(cup)"}},
       "needs_condition",
       "blocked",
       "lift(cup) needs hold(cup)"},
      {{ReasonCode::off_goal, {"cup"}, {"31"}}, "off_goal", "missed", "cup came to lie 31 mm from its goal"},
  };
  for (const auto& row : rows) {
    CHECK(name_of(row.reason.code) == row.name);
    CHECK(name_of(status_of(row.reason.code)) == row.status);
    CHECK(words_of(row.reason) == row.words);
  }
}

TEST_CASE("every language words every code, and no other") {
  std::set<std::string> codes;
  for (const auto code : all_reasons()) codes.insert(name_of(code));
  const std::filesystem::path folder = source_dir() + "/engine/knowledge/phrases";
  int languages = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    INFO(file.path());
    std::ifstream stream(file.path());
    const auto words = Json::parse(stream).at("define").at("reason_words");
    std::set<std::string> worded;
    for (const auto& [code, term] : words.items()) worded.insert(code);
    CHECK(worded == codes);
    ++languages;
  }
  CHECK(languages >= 2);
}
