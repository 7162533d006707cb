#include "continua/replay/terminal/terminal.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("control characters are shown, not obeyed") {
  struct Case {
    const char* text;
    const char* shown;
  };
  for (const auto& [text, shown] : {
           Case{"plain\ttext\n", "plain\ttext\n"},
           Case{"Grüße ☕", "Grüße ☕"},
           Case{"\x1b]0;title\x07", "\\u001b]0;title\\u0007"},
           Case{"\x1b[2J", "\\u001b[2J"},
           Case{"\xc2\x9b"
                "2J",
                "\\u009b2J"},
           Case{"a\rb\x7f", "a\\u000db\\u007f"},
           Case{"\x1b[1mbold\x1b[0m", "\x1b[1mbold\x1b[0m"},
           Case{"\x1b[8mhidden", "\\u001b[8mhidden"},
           Case{"\x1b[", "\\u001b["},
       }) {
    INFO(shown);
    CHECK(printable(text) == shown);
  }
}
