#include "continua/core/document_reader.h"

#include <fmt/format.h>

#include "support/catch.h"

using namespace continua;

namespace {

LocatedJson document_of(std::string_view text, const std::string& name = "d") {
  return LocatedJson::parse(text, name).value();
}

std::string listed(const DocumentReader& reader) {
  std::string all;
  for (const auto& error : reader.problems()) all += (all.empty() ? "" : "\n") + error.text();
  return all;
}

// The problems that `read` notes about a document with this text.
template <class Read>
std::string problems_of(std::string_view text, Read read) {
  const auto document = document_of(text);
  DocumentReader reader;
  read(reader.root(document));
  CHECK(reader.sound() == reader.problems().empty());
  return listed(reader);
}

enum class Light { red, amber, green };
constexpr NamedValue<Light> lights[] = {{Light::red, "red"}, {Light::amber, "amber"}, {Light::green, "green"}};

}  // namespace

TEST_CASE("the example of document_reader.h gives the problems that it names") {
  const auto document = document_of(R"({"nam": "Lee", "fruit": ["apple", 7]})", "shop.json");
  DocumentReader reader;
  const auto root = reader.root(document);
  REQUIRE(root.expect_object("a shop", {"name", "open", "fruit"}));
  CHECK(root.required("name", "the shop's name").name("the shop's name").empty());
  CHECK(root.member("open").truth(true));
  std::vector<std::string> fruit;
  for (const auto& each : root.member("fruit").elements("kinds of fruit"))
    fruit.push_back(each.text("a kind of fruit"));
  CHECK(fruit == std::vector<std::string>{"apple", ""});
  CHECK(listed(reader) ==
        "shop.json:1:1: there is no \"name\"; expected the shop's name\n"
        "shop.json:1:2: unknown key 'nam' of a shop (did you mean 'name'?)\n"
        "shop.json:1:35: found 7, expected a kind of fruit, a string");
}

TEST_CASE("values of the right shape are read without a problem") {
  const auto document = document_of(
      R"({"text": "", "list": ["a", "b"], "number": 0.5, "whole": 3, "yes": true, "a/b~": {"k": null}, "light": "green"})");
  DocumentReader reader;
  const auto root = reader.root(document);
  CHECK(root.where() == "d:1:1");
  CHECK(root.member("text").text("a text").empty());
  CHECK(root.member("list").texts("texts") == std::vector<std::string>{"a", "b"});
  CHECK(root.member("list").element(1).text("a text") == "b");
  CHECK(root.member("number").number("a share", 0, 0, 1) == 0.5);
  CHECK(root.member("whole").whole_number("a count", 0, 0, 3) == 3);
  CHECK(root.member("yes").truth(false));
  CHECK(root.member("light").one_of({"red", "green"}) == "green");
  CHECK(root.member("light").one_of(lights, "a light") == Light::green);
  CHECK(root.member("a/b~").member("k").where() == "d:1:88");
  CHECK(root.members("anything").size() == 7);
  CHECK(root.members("anything")[5].key == "a/b~");
  CHECK(root.members("anything")[5].item.member("k").json().is_null());
  CHECK(reader.sound());
}

TEST_CASE("an absent value is no problem of its own and gives the default") {
  CHECK(problems_of("[1]", [](const Item& root) {
          for (const auto& absent : {root.member("a"), root.element(1), root.member("a").element(0), Item()}) {
            CHECK_FALSE(absent.exists());
            CHECK(absent.text("a text").empty());
            CHECK(absent.name("a name").empty());
            CHECK(absent.texts("texts").empty());
            CHECK(absent.number("a number", 7, 0, 1) == 7);
            CHECK(absent.whole_number("a number", 7, 0, 1) == 7);
            CHECK(absent.truth(true));
            CHECK_FALSE(absent.one_of({"a", "b"}));
            CHECK_FALSE(absent.one_of(lights, "a light"));
            CHECK_FALSE(absent.expect_object("an object", {}));
            CHECK(absent.members("members").empty());
            CHECK(absent.elements("elements").empty());
          }
          CHECK(root.element(1).where() == "d:1:1");
        }) == "");
}

TEST_CASE("a value of the wrong shape is a problem at its place") {
  struct Row {
    const char* text;
    void (*read)(const Item& root);
    const char* problems;
  };
  const Row rows[] = {
      {"7", [](const Item& root) { root.text("a text"); }, "d:1:1: found 7, expected a text, a string"},
      {"\"\"", [](const Item& root) { root.name("a name"); }, "d:1:1: found '', expected a name"},
      {"{}", [](const Item& root) { root.name("a name"); }, "d:1:1: found an object, expected a name, a string"},
      {"[\"a\", null]", [](const Item& root) { root.texts("words"); }, "d:1:7: found null, expected a string"},
      {"{}", [](const Item& root) { root.texts("words"); }, "d:1:1: found an object, expected words, a list"},
      {"[]", [](const Item& root) { root.members("names"); }, "d:1:1: found a list, expected names, an object"},
      {"\"1\"", [](const Item& root) { root.number("a share", 0, 0, 1); },
       "d:1:1: found '1', expected a share, a number from 0 to 1"},
      {"1.5", [](const Item& root) { root.number("a share", 0, 0, 1); },
       "d:1:1: found 1.5, expected a share, a number from 0 to 1"},
      {"1.5", [](const Item& root) { root.whole_number("a count", 0, 0, 9); },
       "d:1:1: found 1.5, expected a count, a whole number from 0 to 9"},
      {"-1", [](const Item& root) { root.whole_number("a count", 0, 0, 9); },
       "d:1:1: found -1, expected a count, a whole number from 0 to 9"},
      {"0", [](const Item& root) { root.truth(false); }, "d:1:1: found 0, expected true or false"},
      {"\"grene\"", [](const Item& root) { root.one_of(lights, "a light"); },
       "d:1:1: found 'grene', expected red, amber or green (did you mean 'green'?)"},
      {"true", [](const Item& root) { root.one_of(lights, "a light"); },
       "d:1:1: found true, expected a light, a string"},
      {"[]",
       [](const Item& root) {
         root.one_of({"a", "b"});
       },
       "d:1:1: found a list, expected a or b, a string"},
      {"{\"a\": 1}", [](const Item& root) { root.required("b", "a thing"); },
       "d:1:1: there is no \"b\"; expected a thing"},
      {"{\"about\": 1}", [](const Item& root) { root.expect_object("a thing", {"about"}); },
       "d:1:11: found 1, expected what it is about, a string"},
      {"{\"v\": 2}", [](const Item& root) { root.expect_version("v", 1); },
       "d:1:7: found 2, expected 1, the version of the format"},
      {"{}", [](const Item& root) { root.expect_version("v", 1); },
       "d:1:1: there is no \"v\"; expected 1, the version of the format"},
      {"{\"a\": [\"x\"]}", [](const Item& root) { root.member("a").element(0).problem("wrong"); }, "d:1:8: wrong"},
      {"{\"a\": [\"x\"]}", [](const Item& root) { root.member("a").problem_at_key("wrong"); }, "d:1:2: wrong"},
      {R"({"a": "\"xy"})", [](const Item& root) { root.member("a").problem_in_text(2, "wrong"); }, "d:1:11: wrong"},
      {R"({"a": "xy"})",
       [](const Item& root) {
         root.member("a").problem_in_text({"column 2", "wrong"});
       },
       "d:1:9: wrong"},
      {"{}",
       [](const Item& root) {
         root.problem(root.unknown("fruit", "aple", {"pear", "apple"}));
       },
       "d:1:1: unknown fruit 'aple' (did you mean 'apple'?)"},
      {R"({"a": 1, "a": 2})", [](const Item&) {}, "d:1:10: the key 'a' a second time in this object"},
  };
  for (const auto& row : rows) {
    CAPTURE(row.text, row.problems);
    CHECK(problems_of(row.text, row.read) == row.problems);
  }
}

TEST_CASE("problems stand in the order of the documents and of their texts, each once") {
  const auto first = document_of("{\"a\": 1, \"b\": 2}", "z"), second = document_of("[]", "a");
  DocumentReader reader;
  const auto root = reader.root(first), other = reader.root(second, " (read for z)");
  other.problem("third");
  root.member("b").problem("second");
  root.member("a").problem("first");
  root.member("b").problem("second");
  CHECK(listed(reader) == "z:1:7: first\nz:1:15: second\na:1:1: third (read for z)");
}

TEST_CASE("of very many problems the first are kept, and names are not compared any more") {
  const auto document = document_of("{}");
  DocumentReader reader;
  const auto root = reader.root(document);
  for (std::size_t i = 0; i < DocumentReader::most_problems; ++i) {
    CHECK(root.nearest("aple", {"apple"}) == " (did you mean 'apple'?)");
    root.problem(fmt::format("problem {}", i));
  }
  CHECK(reader.full());
  root.problem("one more");
  CHECK(root.nearest("aple", {"apple"}).empty());
  CHECK(reader.problems().size() == DocumentReader::most_problems);
  CHECK(reader.problems().back().sentence == "problem 999");
}

TEST_CASE("names are listed as a sentence expects them") {
  CHECK(any_of({}).empty());
  CHECK(any_of({"a"}) == "a");
  CHECK(any_of({"a", "b"}) == "a or b");
  CHECK(any_of({"a", "b", "c"}) == "a, b or c");
}
