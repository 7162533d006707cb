#include "continua/language/spellings.h"

#include <set>

#include "support/catch.h"

using continua::parts_of_spellings;
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

TEST_CASE("the words of a text are those of all that it stands for") {
  for (const std::string text :
       {"put", "put | place", "(can|could) you [please]", "i (would [really] like|want) to", ""}) {
    CAPTURE(text);
    std::set<std::string_view> parts;
    const auto all = spellings(text);
    for (const auto& one : all)
      for (const auto part : parts_of_spellings(one)) parts.insert(part);
    const auto written = parts_of_spellings(text);
    CHECK(std::set(written.begin(), written.end()) == parts);
  }
}

TEST_CASE("a text for too many ways stands for itself") {
  std::string text;
  for (int i = 0; i < 13; ++i) text += "[a] ";
  CHECK(spellings(text) == std::vector{text});
}
