#include "continua/language/spellings.h"

#include "support/catch.h"

using continua::spellings;

TEST_CASE("alternatives, groups and parts that may be left out") {
  const struct {
    const char* text;
    std::vector<std::string> all;
  } table[] = {
      {"put", {"put"}},
      {"put | place", {"put", "place"}},
      {"put|", {"put", ""}},
      {"(can|could) you", {"can you", "could you"}},
      {"can you [please]", {"can you please", "can you"}},
      {"[please] put", {"please put", "put"}},
      {"(a|b) c [d]", {"a c d", "a c", "b c d", "b c"}},
      {"i (would [really] like|want) to", {"i would really like to", "i would like to", "i want to"}},
      {", (no|wait) ,", {", no ,", ", wait ,"}},
      {"(a", {"(a"}},
      {"a) b", {"a) b"}},
      {"[a)", {"[a)"}},
  };
  for (const auto& [text, all] : table) {
    CAPTURE(text);
    CHECK(spellings(text) == all);
  }
}

TEST_CASE("a text for too many ways stands for itself") {
  std::string text;
  for (int i = 0; i < 13; ++i) text += "[a] ";
  CHECK(spellings(text) == std::vector{text});
}
