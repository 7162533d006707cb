// The names the tests of terms use besides those of the language, and short ways to read and evaluate.
#pragma once

#include <map>
#include <string>

#include "continua/term/evaluate.h"
#include "support/catch.h"

namespace continua {

inline const Signature& test_names() {
  static const Signature names = [] {
    Signature all = term_signature();
    const auto add = [&](const char* name, const char* type) { all.emplace(name, Type::parse(type).value()); };
    for (const char* object : {"block1", "block4", "indicated"}) add(object, "e");
    add("objects", "e*");
    add("region", "loc");
    add("on", "e -> loc");
    add("put", "e -> loc -> t");
    add("actions", "term*");
    add("content", "term");
    return all;
  }();
  return names;
}

inline Term read(std::string_view text, const Signature& names = test_names()) {
  INFO(text);
  auto term = parse_term(text, names);
  if (!term) FAIL(term.error().text());
  return *term;
}

/// The error of a text, or its term.
inline std::string error_of(std::string_view text) {
  auto term = parse_term(text, test_names());
  return term ? "read as " + print(*term) : term.error().text();
}

using Slots = std::map<std::string, Term>;

inline Evaluation evaluation(const Slots& slots) {
  static const RuleTable rules({&term_rules()});
  return Evaluation(rules, [&slots](Name name) -> const Term* {
    const auto found = slots.find(name.text());
    return found == slots.end() ? nullptr : &found->second;
  });
}

inline std::string value_of(std::string_view text, const Slots& slots = {}) {
  return print(evaluation(slots).value(read(text)));
}

}  // namespace continua
