// Terms taken apart for readers that do not know the notation.
#include "continua/term/term_structure.h"

#include <string>

#include "support/catch.h"

using namespace continua;

namespace {

// {"kind": "apply", …} as "apply(head, args)", so that a row shows the whole structure.
std::string told(const Json& structure) {
  const auto& kind = structure["kind"].get_ref<const std::string&>();
  if (kind == "literal") return structure["text"];
  if (kind == "name") return (structure["quoted"] ? "quoted " : "") + structure["name"].get<std::string>();
  if (kind == "lambda") {
    const auto type = structure["type"].is_null() ? std::string() : ": " + structure["type"].get<std::string>();
    return "lambda " + structure["name"].get<std::string>() + type + " {" + told(structure["body"]) + "}";
  }
  std::string text = kind;
  if (kind == "apply") text += " {" + told(structure["head"]) + "}";
  for (const auto& part : structure[kind == "apply" ? "args" : "parts"]) text += " {" + told(part) + "}";
  return text;
}

}  // namespace

TEST_CASE("the structure of a term needs no declarations") {
  struct Row {
    const char* text;
    const char* structure;
  };
  const Row rows[] = {
      {"plate", "plate"},
      {"`red block`", "quoted red block"},
      {"-2.5", "-2.5"},
      {"'it\\'s'", "'it\\'s'"},
      {"null", "null"},
      {"true", "true"},
      {"-x", "apply {negate} {x}"},
      {"(+)", "+"},
      {"(a)", "a"},
      {"[[], [a]]", "list {list} {list {a}}"},
      {"<0.1, -0.2, 0>", "point {0.1} {-0.2} {0}"},
      {"<x, -1, 0.5>", "point {x} {-1} {0.5}"},
      {"box(<0, 0, 0>, <1, 1, 1>)", "apply {box} {point {0} {0} {0}} {point {1} {1} {1}}"},
      {"put(cup, on( plate ))", "apply {put} {cup} {apply {on} {plate}}"},
      {"f(a)(b)", "apply {f} {a} {b}"},
      {"(a or b) and c", "apply {and} {apply {or} {a} {b}} {c}"},
      {"(\\x. f(x))(a, b)", "apply {lambda x {apply {f} {x}}} {a} {b}"},
      {"λx y. x", "lambda x {lambda y {x}}"},
      {"\\x: e -> t. x", "lambda x: e -> t {x}"},
  };
  for (const auto& row : rows) CHECK(told(term_structure(row.text)) == row.structure);
}

TEST_CASE("a text that is no term is a literal of the whole text") {
  for (const std::string text : {"", " ", "(", "f(", "a b", "\\. x", "<1, 2>", "'open", "§", "f(a))", "1..2", "[a,]"})
    CHECK(term_structure(text) == Json({{"kind", "literal"}, {"text", text}}));
  const std::string deep(5000, '(');
  CHECK(term_structure(deep)["text"] == deep);
}
