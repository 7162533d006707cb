#include "continua/moves/readings.h"

#include "continua/moves/known_words.h"
#include "language/english.h"

using namespace continua;

namespace {

// Reads with the English lexicon, in an empty scene.
struct Reader {
  Language language{english(), nullptr, {}, nullptr};
  RuleTable rules = RuleTable({&term_rules()});
  KnownWords words = known_words(english(), {});

  Understanding understanding() const { return {language, words.all, rules}; }
};

InputEvent said(const std::string& words, std::vector<Alternative> alternatives = {}) {
  InputEvent event;
  event.text = words;
  event.alternatives = std::move(alternatives);
  return event;
}

Deixis pointing(double t_s) {
  Deixis deixis;
  deixis.from = deixis.until = SimTime::from_seconds(t_s);
  deixis.serials = {7};
  return deixis;
}

}  // namespace

TEST_CASE("speech is read once, in each alternative") {
  const Reader reader;
  const auto event = said("put it there", {{"cut it there", 0.4}, {"that cup", 0.2}});
  const auto readings = readings_of(event, reader.understanding());
  REQUIRE(readings->alternatives.size() == 3);
  CHECK(readings->alternatives[0].event.text == "put it there");
  CHECK(readings->alternatives[2].event.confidence == 0.2);
  CHECK(readings->alternatives[2].utterance.words == std::vector<std::string>{"that", "cup"});
  CHECK(readings_of(event, reader.understanding(), readings) == readings);
}

TEST_CASE("speech is read anew once a word was learned") {
  Reader reader;
  const auto event = said("hoist the cup");
  const auto before = readings_of(event, reader.understanding());
  CHECK(before->alternatives[0].utterance.unknown == std::vector<std::size_t>{0});

  Learned learned;
  learned.programs.emplace("hoist", Program{parse_term("\\x: e. [x]", {}).value()});
  reader.words = with_taught(reader.words, learned);
  const auto after = readings_of(event, reader.understanding(), before);
  REQUIRE(after != before);
  CHECK(after->alternatives[0].utterance.unknown.empty());
}

TEST_CASE("pointings go with the words of the alternative that is asked about") {
  const Reader reader;
  const auto readings = readings_of(said("put it there", {{"that", 0.4}, {"yes", 0.4}}), reader.understanding());
  Ensemble ensemble;
  ensemble.bound = {std::nullopt, pointing(0.9)};
  const auto words = [&](std::size_t alternative) {
    std::string all;
    const auto& speech = readings->alternatives[alternative];
    for (const auto& shown : shown_words(speech, ensemble, {})) all += speech.utterance.words[shown.words.begin] + " ";
    return all;
  };
  CHECK(words(0) == "there ");
  CHECK(words(1) == "that ");
  CHECK(words(2).empty());
}

TEST_CASE("a sentence may go on unless it is whole or ends with a mark") {
  const Reader reader;
  const std::pair<const char*, bool> table[] = {{"put the knife", true},        {"the red one", true},
                                                {"take the knife", false},      {"put the knife.", false},
                                                {"put that cup there", true},   {"the frobnicate", true},
                                                {"take the zork knife", true},  {"", false},
                                                {"is this cup", true},          {"is this cup?", false},
                                                {"put this on the cup", false}, {"what is this", true},
                                                {"put that there.", false},     {"take that cup here now", false}};
  for (const auto& [words, unfinished] : table) {
    CAPTURE(words);
    CHECK(is_unfinished(readings_of(said(words), reader.understanding())->alternatives[0]) == unfinished);
  }
}

TEST_CASE("two pieces read as one if they make fewer moves or lose fewer words") {
  const Reader reader;
  const auto read = [&](const std::string& words) { return readings_of(said(words), reader.understanding()); };
  const auto as_one = [&](const std::string& first, const std::string& second) {
    return reads_as_one(*read(first), *read(second), *read(first + " " + second));
  };
  CHECK(as_one("put that cup", "behind the plate"));
  CHECK(as_one("the red", "block"));
  CHECK_FALSE(as_one("the knife", "yes"));
}
