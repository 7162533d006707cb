// Terms without declared names, as logs write them.
#include "continua/term/written_term.h"

#include "support/catch.h"

using namespace continua;

namespace {

// The term's parts, each in brackets after its kind and name.
std::string told(const WrittenTerm& term) {
  static const char* const kinds[] = {"name", "number", "text", "place", "list", "call", "lambda", "other"};
  std::string text = kinds[static_cast<int>(term.kind)];
  if (term.kind == WrittenTerm::Kind::call) text += " " + term.name;
  for (const auto& binder : term.binders) text += " " + binder;
  if (term.parts.empty()) return text + " " + term.written;
  for (const auto& part : term.parts) text += " {" + told(part) + "}";
  return text;
}

}  // namespace

TEST_CASE("a term is read without any declarations") {
  struct Row {
    const char* text;
    const char* parts;
  };
  const Row rows[] = {
      {"plate", "name plate"},
      {"`red block`", "name `red block`"},
      {"-2.5", "number -2.5"},
      {"'a, (b'", "text 'a, (b'"},
      {"null", "other null"},
      {"<0.1, -0.2, 0>", "place <0.1, -0.2, 0>"},
      {"put(cup, on( plate ))", "call put {name cup} {call on {name plate}}"},
      {"[a, f(b, c)]", "list {name a} {call f {name b} {name c}}"},
      {"[]", "list []"},
      {"f((a) + b, (c))", "call f {other {name (a)} {name b}} {name (c)}"},
      {"\\x v. put(x, v)", "lambda x v {call put {name x} {name v}}"},
      {"\\x: e. \\v: loc. put(x, v)", "lambda x {lambda v {call put {name x} {name v}}}"},
      {"the(\\x. cup(x) and red(x))", "call the {lambda x {other {call cup {name x}} {call red {name x}}}}"},
      {"box(<1, 1, 0>, <0, 2, 0>)", "call box {place <1, 1, 0>} {place <0, 2, 0>}"},
      {"(f)(a)", "other {name f} {name a}"},
  };
  for (const auto& [text, parts] : rows) {
    CAPTURE(text);
    const auto term = read_written_term(text);
    REQUIRE(term.ok());
    CHECK(term->written == text);
    CHECK(told(*term) == parts);
  }
  CHECK(read_written_term("put(cup,").error().where == "column 9");
  CHECK(read_written_term("").error().sentence == "found the end, expected a term");
}

TEST_CASE("the parts of a term are texts of the term, parentheses included") {
  const auto term = read_written_term("f((a) + b, (c), \\x. x)");
  REQUIRE(term.ok());
  REQUIRE(term->parts.size() == 3);
  CHECK(term->parts[0].written == "(a) + b");
  CHECK(term->parts[1].written == "(c)");
  CHECK(term->parts[2].written == "\\x. x");
}

TEST_CASE("the last place of a term counts") {
  const auto place = [](const char* text) {
    const auto term = read_written_term(text);
    const auto* last = term ? last_place(*term) : nullptr;
    return last ? std::optional(last->min) : std::nullopt;
  };
  CHECK(place("point(rHand, <0.1, 0, 0>)") == Point{0.1, 0, 0});
  CHECK(place("put(<1, 1, 1>, near(<2, 2, 2>))") == Point{2, 2, 2});
  CHECK_FALSE(place("put(cup, plate)"));
  CHECK_FALSE(place("a < b"));
}

TEST_CASE("a name is mentioned as a whole word") {
  CHECK(mentions("put(cup, plate)", "cup"));
  CHECK_FALSE(mentions("put(cup_blue)", "cup"));
  CHECK_FALSE(mentions("cups", "cup"));
  CHECK(mentions("cups cup", "cup"));
  CHECK(mentions("the(\\x. cup(x))", "\\x. cup(x)"));
  CHECK_FALSE(mentions("anything", ""));
}
