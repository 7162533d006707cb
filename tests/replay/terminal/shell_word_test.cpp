// Commands that are shown to be typed.
#include "continua/replay/terminal/shell_word.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("a word is written as a shell takes it") {
  struct Case {
    const char* word;
    const char* words;
  };
  const Case cases[] = {{"traces/a-b_1.jsonl", "traces/a-b_1.jsonl"},
                        {"my traces/a", "'my traces/a'"},
                        {"it's", "'it'\\''s'"},
                        {"$(rm)", "'$(rm)'"},
                        {"~", "'~'"},
                        {"", "''"},
                        {"Grüße", "'Grüße'"}};
  for (const auto& [word, words] : cases) CHECK(shell_word(word) == words);
}
