#include "continua/core/trimmed.h"

#include <string_view>

#include "support/catch.h"

using continua::trimmed;

TEST_CASE("a text is trimmed at its ends alone") {
  struct Case {
    std::string_view text, blanks, expected;
  };
  const Case cases[] = {{"", " ", ""},          {"   ", " ", ""},     {"a b", " ", "a b"},
                        {"  a b ", " ", "a b"}, {"\ta ", " ", "\ta"}, {"\r\n a\t", " \t\r\n", "a"}};
  for (const auto& [text, blanks, expected] : cases) {
    CAPTURE(text, blanks);
    CHECK(trimmed(text, blanks) == expected);
  }
}
