// Outputs that come in pieces of any size, whole and broken.
#include "continua/replay/recogniser/output_parts.h"

#include <rapidcheck.h>

#include "support/catch.h"

namespace continua {
namespace {

// "LINE: TEXT" for each part.
std::vector<std::string> parts_of(PartKind kind, std::string_view text, std::size_t piece) {
  OutputParts parts(kind);
  std::vector<std::string> all;
  const auto keep = [&](const std::optional<OutputPart>& part) {
    if (part) all.push_back(fmt::format("{}: {}", part->line, part->text));
    return part.has_value();
  };
  for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) {
    parts.add(text.substr(0, piece));
    while (keep(parts.next())) continue;
  }
  keep(parts.last());
  return all;
}

using Parts = std::vector<std::string>;

TEST_CASE("Parts are the same however the output comes") {
  const std::vector<std::tuple<PartKind, std::string, Parts>> outputs = {
      {PartKind::json,
       "\xEF\xBB\xBF{\"a\": [1, {\"b\": \"}\\\"\\\\\"}]}\n\n{ \"c\":\n2 }, [3]",
       {"1: {\"a\": [1, {\"b\": \"}\\\"\\\\\"}]}", "3: { \"c\":\n2 }", "4: [3]"}},
      {PartKind::json, "hello\n{\"a\": 1}\n", {"1: hello", "2: {\"a\": 1}"}},
      {PartKind::json, "{\"a\": \"cut of\n{\"b\": 1}", {"1: {\"a\": \"cut of", "2: {\"b\": 1}"}},
      {PartKind::json, "{\"a\": [1, 2\n{\"b\": 1}", {"1: {\"a\": [1, 2\n", "2: {\"b\": 1}"}},
      {PartKind::json, "{\"a\": 1,\n{\"b\": 1}", {"1: {\"a\": 1,\n", "2: {\"b\": 1}"}},
      {PartKind::xml,
       "<?xml v?>\n<a:e x='1'><b/></a:e>\n\n<?xml v?><e/><e>\n",
       {"1: <?xml v?>\n<a:e x='1'><b/></a:e>", "4: <?xml v?><e/>", "4: <e>\n"}},
      {PartKind::xml, "<e><b>\n<?xml v?><e></e>", {"1: <e><b>\n", "2: <?xml v?><e></e>"}},
      {PartKind::lines, "one\n\n two \nthree", {"1: one", "3: two ", "4: three"}}};
  for (const auto& [kind, text, expected] : outputs)
    for (std::size_t piece = 1; piece <= text.size(); ++piece) CHECK(parts_of(kind, text, piece) == expected);
}

TEST_CASE("Any text is cut, and nothing but blanks and commas is lost") {
  CHECK(rc::check([](const std::vector<std::uint8_t>& choices) {
    constexpr std::string_view letters = "{}[]\"\\,:a\n ";
    std::string text;
    for (const auto choice : choices) text += letters[choice % letters.size()];
    std::string kept;
    for (const auto& part : parts_of(PartKind::json, text, 3)) kept += part.substr(part.find(' ') + 1);
    const auto solid = [](std::string from) {
      std::erase_if(from, [](char c) { return c == ',' || c == ' ' || c == '\n'; });
      return from;
    };
    RC_ASSERT(solid(kept) == solid(text));
  }));
}

}  // namespace
}  // namespace continua
