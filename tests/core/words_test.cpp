#include "continua/core/words.h"

#include "support/catch.h"

using namespace continua;

namespace {

// The words with "|" between them, "." after a word that ends a sentence, "~" after one where it may go on, and a
// quotation mark after one that is quoted.
std::string cut_up(std::string_view text) {
  std::string out;
  for (const auto& word : words_of(text))
    out += (out.empty() ? "" : "|") + word.text + (word.quoted ? "\"" : "") +
           (word.half         ? "~"
            : word.ends_after ? "."
                              : "");
  return out;
}

}  // namespace

TEST_CASE("words are letters, digits and apostrophes within, of any alphabet") {
  struct Row {
    const char *text, *words, *bare;
  };
  for (const auto& [text, words, bare] : std::initializer_list<Row>{
           {"", "", ""},
           {"Put it there!", "put|it|there.", "put it there"},
           {"Don't; what’s 'that'?", "don't~|what's|that\".", "dont whats that"},
           {"'Take it!' he said, \"don't you\"", "take\"|it\".|he|said|,|don't\"|you\"", "take it he said dont you"},
           {"put 'em on the boys' plates", "put|em\"|on\"|the\"|boys\"|plates", "put em on the boys plates"},
           {"\"take it", "take|it", "take it"},
           {"put: it... now. there.", "put~|it~|now.|there.", "put it now there"},
           {"the cup, ,  the plate", "the|cup|,|the|plate", "the cup the plate"},
           {"light-blue 3.5 $5", "light|blue|3.|5|5", "light blue 3 5 5"},
           {"„ÖFFNE die Tür“ – bitte…", "öffne\"|die\"|tür\"|bitte~", "öffne die tür bitte"},
           {"Lies l'été", "lies|l'été", "lies lété"},
           {"ΠΟΥ ΕΙΝΑΙ; τίς", "που|ειναι~|τίσ", "που ειναι τίσ"},
           {"Где нож? Ёлка.", "где|нож.|ёлка.", "где нож ёлка"},
           {"把刀放在杯子里。好，", "把刀放在杯子里.|好|,", "把刀放在杯子里 好"},
           {"u\u0308ber so\u00ADfort \uFEFFja", "über|sofort|ja", "über sofort ja"},
           {"turn 90° δ 😀", "turn|90°|δ|😀", "turn 90° δ 😀"},
           {"a\xFFz \xC3", "az", "az"},
       }) {
    CAPTURE(text);
    CHECK(cut_up(text) == words);
    CHECK(bare_words(text) == bare);
  }
  CHECK(bare_words("Don't stop", "") == "dontstop");
}

TEST_CASE("at most so many words are read") {
  bool cut = true;
  CHECK(words_of("one, two three", 2, &cut).size() == 3);
  CHECK(cut);
  CHECK(words_of("one, two", 2, &cut).size() == 3);
  CHECK_FALSE(cut);
}
