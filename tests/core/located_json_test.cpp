#include "continua/core/located_json.h"

#include <fmt/format.h>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

std::string error_of(std::string_view text) {
  const auto document = LocatedJson::parse(text, "m.json");
  return document ? "" : document.error().text();
}

}  // namespace

TEST_CASE("every value of a document has its line and column") {
  const auto document = LocatedJson::parse("{\n  \"a\": [1, {\"b/c\": true}],\n  \"d~e\": null }", "m.json");
  REQUIRE(document);
  CHECK(document->where("") == "m.json:1:1");
  CHECK(document->where("/a") == "m.json:2:8");
  CHECK(document->where("/a/0") == "m.json:2:9");
  CHECK(document->where("/a/1") == "m.json:2:12");
  CHECK(document->where("/a/1/b~1c") == "m.json:2:20");
  CHECK(document->where("/d~0e") == "m.json:3:10");
}

TEST_CASE("a place that does not exist is that of what encloses it") {
  const auto document = LocatedJson::parse("\n{\"a\": {\"b\": 1}}", "m.json");
  REQUIRE(document);
  CHECK(document->where("/a/b/c/d") == "m.json:2:13");
  CHECK(document->where("/x") == "m.json:2:1");
  CHECK(document->where("no pointer") == "m.json:2:1");
}

TEST_CASE("strings with escapes and empty containers do not confuse the places") {
  const auto document = LocatedJson::parse(R"({"a\"\\": "}]\\", "e": {}, "f": [ ], "\u00e9": 1.5e3})", "m.json");
  REQUIRE(document);
  CHECK(document->where("/a\"\\") == "m.json:1:11");
  CHECK(document->where("/e") == "m.json:1:24");
  CHECK(document->where("/f") == "m.json:1:33");
  CHECK(document->where("/é") == "m.json:1:48");
}

TEST_CASE("a byte order mark is skipped") {
  const auto document = LocatedJson::parse("\xEF\xBB\xBF{\"a\": 1}", "m.json");
  REQUIRE(document);
  CHECK(document->where("/a") == "m.json:1:7");
}

TEST_CASE("what is not JSON is an error at its place") {
  CHECK(error_of("") == "m.json:1:1: the file is empty; expected a JSON document");
  CHECK(error_of(" \n ") == "m.json:1:1: the file is empty; expected a JSON document");
  CHECK(error_of("{\"a\": 1,\n  nul}") ==
        "m.json:2:6: not valid JSON: syntax error while parsing object key - invalid literal; last read: "
        "'1,<U+000A>  nul}'; expected string literal");
  CHECK(error_of("[1, 2").substr(0, 28) == "m.json:1:6: not valid JSON: ");
  CHECK(error_of("{\"a\": NaN}").substr(0, 28) == "m.json:1:7: not valid JSON: ");
  CHECK(error_of("[1,\n -1e999]") == "m.json:2:2: not valid JSON: number overflow parsing '-1e999'");
  CHECK(error_of("[\"\xff\"]").substr(0, 28) == "m.json:1:3: not valid JSON: ");
  CHECK(error_of(std::string("\x00\x01\x02", 3)).substr(0, 28) == "m.json:1:1: not valid JSON: ");
  CHECK(error_of(std::string("{}\0{\"a\":1}", 10)) ==
        "m.json:1:3: found a byte of value 0 after the JSON; expected nothing more");
}

TEST_CASE("an error sentence stays short and on one line, whatever was read") {
  const auto error = error_of("[\"" + std::string(100'000, 'x') + "\n\"]");
  CHECK(error.size() < 250);
  CHECK(error.find('\n') == std::string::npos);
}

TEST_CASE("deep nesting is refused and does not exhaust the stack") {
  CHECK(error_of(std::string(100'000, '[')) == "m.json:1:201: nested deeper than 200 levels; expected fewer");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  CHECK(error_of(objects).find("nested deeper than 200 levels") != std::string::npos);
  CHECK(error_of(std::string(200, '[') + std::string(200, ']')).empty());
  CHECK(error_of("\"" + std::string(300, '[') + "\\\"" + std::string(300, '[') + "\"").empty());
}

TEST_CASE("an object with too many members is refused") {
  std::string object = "{";
  for (int i = 0; i < 10'001; ++i) object += fmt::format("\"{}\":[{{}},1],", i);
  object.back() = '}';
  CHECK(error_of(object).find(": an object with more than 10000 members; expected fewer") != std::string::npos);
  std::string list = "[";
  for (int i = 0; i < 10'001; ++i) list += "{\"a\":\":::::\"},";
  list.back() = ']';
  CHECK(error_of(list).empty());
}

TEST_CASE("keys have places, and a key that stands twice is known") {
  const auto document =
      LocatedJson::parse("{\"a\": 1,\n  \"b\" : [{}, 2], \"a\": {\"c\": 3}, \"d\": {\"c\": 4}}", "m.json");
  REQUIRE(document);
  CHECK(document->key_place("/b") == TextPlace{2, 3});
  CHECK(document->key_place("/b/1") == TextPlace{2, 14});
  CHECK(document->key_place("/d/c") == TextPlace{2, 39});
  REQUIRE(document->duplicates().size() == 1);
  CHECK(document->duplicates()[0].key == "a");
  CHECK(document->duplicates()[0].place == TextPlace{2, 18});
  CHECK(document->place("/a") == TextPlace{2, 23});
}

TEST_CASE("a byte of a text has a place, whatever escapes stand before it") {
  const auto document =
      LocatedJson::parse(R"(["abc", "\"\\\n|", "\u0041\u00e9\u20ac|", "\ud83d\ude00|", "é|", 7])", "m.json");
  REQUIRE(document);
  const auto column = [&](const char* pointer, std::size_t byte) {
    return document->place_in_text(pointer, byte).column;
  };
  CHECK(column("/0", 0) == 3);
  CHECK(column("/0", 2) == 5);
  CHECK(column("/0", 3) == 6);   // the end
  CHECK(column("/0", 99) == 6);  // beyond it
  CHECK(column("/1", 3) == 16);
  CHECK(column("/2", 6) == 39);
  CHECK(column("/3", 4) == 56);
  CHECK(column("/4", 2) == 63);
  CHECK(column("/5", 3) == 67);  // no text: the value
}

TEST_CASE("a line of JSON Lines carries its line number") {
  CHECK(parse_json_line("{\"a\":1}", "t.jsonl", 7)->at("a") == 1);
  CHECK(parse_json_line("{\"a\":}", "t.jsonl", 7).error().where == "t.jsonl:7:6");
}

TEST_CASE("a line that has a key twice says two things") {
  const auto read = [](const std::string& text) { return parse_json_line(text, "t.jsonl", 7); };
  CHECK(read(R"({"a":1,"b":{"c":"\\","d":[{"a":1}]},"c:":"\":"})").ok());
  CHECK(read(R"({"a":1,"b":2,"a":1})").error().text() == "t.jsonl:7:14: the key 'a' a second time in this object");
  CHECK(read(R"([{"b":{"a":1,"\u0061":2}}])").error().where == "t.jsonl:7:14");
  CHECK(read(std::string("{\"a\":1}\0{\"a\":1}", 15)).error().where == "t.jsonl:7:8");
}

TEST_CASE("compact JSON is one line of valid UTF-8 in the order written") {
  Json json;
  json["z"] = "a\nb\xff";
  json["a"] = 0.1;
  CHECK(compact(json) == "{\"z\":\"a\\nb\xEF\xBF\xBD\",\"a\":0.1}");
}

TEST_CASE("read_file tells why it could not") {
  const TemporaryFolder folder;
  CHECK(read_file(folder.file("empty", "")).value().empty());
  CHECK(read_file(folder.file("text", "a\r\nb")).value() == "a\r\nb");
  CHECK(read_file(folder.path().string()).error().sentence == "is a folder; expected a readable file");
  CHECK(read_file(folder.at("none")).error().text() ==
        folder.at("none") + ": there is no such file; expected a readable file");
}

TEST_CASE("names nearby are offered, others are not") {
  const std::vector<std::string> kinds = {"speech", "gesture", "pointing", "end"};
  CHECK(did_you_mean("speach", kinds) == " (did you mean 'speech'?)");
  CHECK(did_you_mean("Gesture", kinds) == " (did you mean 'gesture'?)");
  CHECK(did_you_mean("poniting", kinds) == " (did you mean 'pointing'?)");
  CHECK(did_you_mean("on", kinds).empty());
  CHECK(did_you_mean("", kinds).empty());
  CHECK(did_you_mean("banana", kinds).empty());
  CHECK(did_you_mean("speech", {}).empty());
}

TEST_CASE("quoted text is fit for a sentence") {
  CHECK(in_quotes("plain é") == "'plain é'");
  CHECK(in_quotes("a\tb\n") == "'a\\x09b\\x0a'");
  CHECK(in_quotes("\xff\xfe") == "'\\xff\\xfe'");
  CHECK(in_quotes(std::string(100, 'x')) == "'" + std::string(60, 'x') + "…'");
}
