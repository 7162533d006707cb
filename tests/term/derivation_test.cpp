#include "continua/term/derivation.h"

#include <fmt/format.h>

#include "read_terms.h"

namespace continua {
namespace {

// The applications of which the value of `text` is made, where those of `slots` are values that were read.
std::string derived(std::string_view text, const Slots& slots) {
  static const RuleTable rules({&term_rules()});
  Derivation derivation;
  Evaluation evaluation(rules, [&](Name name) -> Evaluation::Held {
    const auto found = slots.find(name.text());
    if (found == slots.end()) return nullptr;
    derivation.read(found->second);
    return {&found->second, true};
  });
  evaluation.derivation = &derivation;
  const auto value = evaluation.value(read(text));
  std::string told;
  for (const auto& each : derivation.of(value, evaluation.applications))
    told += fmt::format("{} @ {} = {}; ", print(each.function), print(each.argument), print(each.result));
  return told + print(value);
}

}  // namespace

TEST_CASE("applications whose results are parts of the value are told, inner ones first") {
  const Slots slots = {{"indicated", read("block1")},
                       {"content", read("put(block1, on(block4))")},
                       {"actions", read("[\\x. put(x, on(block4))]")},
                       {"region", read("on(block4)")}};
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"put(indicated, on(block4))",
       "on @ block4 = on(block4); put @ block1 = put(block1); "
       "put(block1) @ on(block4) = put(block1, on(block4)); put(block1, on(block4))"},
      {"put(indicated, region)",
       "put @ block1 = put(block1); put(block1) @ on(block4) = put(block1, on(block4)); put(block1, on(block4))"},
      {"content", "put(block1, on(block4))"},
      {"[content]", "[put(block1, on(block4))]"},
      {"put(argument(content, 0), argument(content, 1)) = content", "true"},
      {"if(content = null, put(block4, on(block1)), content)", "put(block1, on(block4))"},
      {"(\\c: term. c)(content)", "put(block1, on(block4))"},
      {"head(actions)(block1)", "\\x. put(x, on(block4)) @ block1 = put(block1, on(block4)); put(block1, on(block4))"},
      {"map([block1], \\x. on(x))", "on @ block1 = on(block1); [on(block1)]"},
      {"\\x: e. put(x, on(x))", "on @ x = on(x); put @ x = put(x); put(x) @ on(x) = put(x, on(x)); \\x. put(x, on(x))"},
      {"fill(\\x. put(x, region), indicated)", "put(block1, on(block4))"},
      {"fill(head(actions), indicated) = null or true", "true"},
  };
  for (const auto& [text, expected] : rows) {
    CAPTURE(text);
    CHECK(derived(text, slots) == expected);
  }
}

TEST_CASE("a lambda that was read is one application, with all that it brings") {
  CHECK(derived("content(block1)", {{"content", read("\\x. put(x, on(block4))")}}) ==
        "\\x. put(x, on(block4)) @ block1 = put(block1, on(block4)); put(block1, on(block4))");
  CHECK(derived("\\x: e. content(on(x))", {{"content", read("\\v. put(block1, v)")}}) ==
        "on @ x = on(x); \\v. put(block1, v) @ on(x) = put(block1, on(x)); \\x. put(block1, on(x))");
}

}  // namespace continua
