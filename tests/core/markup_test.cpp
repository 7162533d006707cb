#include "continua/core/markup.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("text is shown in HTML and XML as it is") {
  struct Case {
    const char* text;
    const char* shown;
  };
  const Case cases[] = {{"", ""},
                        {"a < b && c > d", "a &lt; b &amp;&amp; c &gt; d"},
                        {"\"quoted\" 'so'", "&quot;quoted&quot; &apos;so&apos;"},
                        {"<script>", "&lt;script&gt;"},
                        {"Grüße → ε 積木 🤖", "Grüße → ε 積木 🤖"},
                        {"a\nb\tc\x01", "a\nb␉c␁"},
                        {"no \xC3 UTF-8 \xFF", "no \uFFFD UTF-8 \uFFFD"},
                        {"\xED\xA0\x80", "\uFFFD\uFFFD\uFFFD"},
                        {"\xEF\xBF\xBE and \xEF\xBF\xBF", "\uFFFD and \uFFFD"}};
  for (const auto& [text, shown] : cases) {
    CAPTURE(text);
    CHECK(in_markup(text) == shown);
  }
}
