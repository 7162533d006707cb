// Each problem of a machine file is reported at load, with its place: the table of machine_errors.txt, and a
// fuzz of the project's own machines.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "continua/core/located_json.h"
#include "continua/core/random.h"
#include "continua/machine_file/machine_keys.h"
#include "continua/machine_file/machine_loader.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const auto source = fs::path(source_dir());

struct Row {
  std::vector<std::pair<std::string, std::string>> edits;
  std::string errors;
};

struct Table {
  std::string machine;
  std::vector<Row> rows;
};

Table read_table() {
  Table table;
  std::istringstream lines(read_file((source / "tests/machine_file/machine_errors.txt").string()).value());
  bool in_machine = false, in_row = false;
  for (std::string line; std::getline(lines, line);) {
    const auto mark = line.substr(0, line.find(' '));
    const auto text = line.size() > mark.size() ? line.substr(mark.size() + 1) : "";
    if (mark == "=") {
      in_machine = text == "the machine";
    } else if (in_machine) {
      table.machine += line + "\n";
    } else if (mark == "-") {
      if (!in_row) table.rows.emplace_back();
      table.rows.back().edits.emplace_back(text, "");
      in_row = true;
    } else if (mark == "+") {
      table.rows.back().edits.back().second = text;
    } else if (mark == "!" || mark == "!!") {
      table.rows.back().errors += "m:" + text + "\n";
    } else {
      in_row = false;
    }
  }
  return table;
}

std::string edited(std::string machine, const Row& row) {
  for (const auto& [from, to] : row.edits) {
    const auto at = machine.find(from);
    if (at == std::string::npos) FAIL("the machine does not contain " + from);
    machine.replace(at, from.size(), to);
  }
  return machine;
}

std::string errors_of(std::string_view text) {
  std::string errors;
  for (const auto& error : check_machine(text, "m", {})) errors += error.text() + "\n";
  return errors;
}

std::size_t pick(Random& random, std::size_t count) {
  return std::min(count - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
}

// One random edit of the text: in bytes, in lines, in a value.
std::string mutated(std::string text, Random& random) {
  static const std::vector<std::string> values = {
      "null", "true", "-1", "1e999",         "0.5",   "\"\"",        "\"Wait\"",   "\"*\"", "\"\\\\x. x(x)\"",
      "[]",   "[[]]", "{}", R"({"when":1})", "\"{\"", "\"\\u0000\"", "\"\\ud800\""};
  const auto at = pick(random, text.size());
  const auto line = text.rfind('\n', at) + 1, next = std::min(text.find('\n', at), text.size() - 1) + 1;
  const auto colon = text.find(": ", at);
  switch (pick(random, 6)) {
    case 0:
      text[at] = static_cast<char>(pick(random, 256));
      break;
    case 1:
      text.erase(line, next - line);
      break;
    case 2:
      text.insert(next, text.substr(line, next - line));
      break;
    case 3:
      text.replace(line, next - line, text.substr(pick(random, text.size()), 80));
      break;
    case 4:
      text.resize(at);
      break;
    default:
      if (colon != std::string::npos)
        text.replace(colon + 2, text.find_first_of(",}\n", colon + 2) - colon - 2, values[pick(random, values.size())]);
  }
  return text;
}

}  // namespace

TEST_CASE("what is wrong with a machine is told in the order of the file, with line and column") {
  const auto table = read_table();
  CHECK(errors_of(table.machine) == "");
  CHECK(table.rows.size() > 180);
  for (const auto& row : table.rows) {
    const auto text = edited(table.machine, row);
    CAPTURE(row.edits);
    CHECK(errors_of(text) == row.errors);
  }
}

TEST_CASE("without a list of states, a name that is a slip away from another is taken for it") {
  const auto errors = [](const std::string& to) {
    return errors_of(R"({"machine":1,"name":"m","start":"Waiting","transitions":[
      {"id":"1","from":"Waiting","on":"x","to":"Asking"}, {"id":"2","from":"Asking","on":"x","to":")" +
                     to + "\"}]}");
  };
  const auto slip = [](const std::string& name, const std::string& meant) {
    return "m:2:99: nothing else names the state '" + name + "' (did you mean '" + meant + "'?)\n";
  };
  CHECK(errors("Wating") == slip("Wating", "Waiting"));
  CHECK(errors("Aksing") == slip("Aksing", "Asking"));
  CHECK(errors("asking") == slip("asking", "Asking"));
  for (const auto* meant : {"Elsewhere", "Asking2", "Askings", "Waiting", "Tasking"}) CHECK(errors(meant).empty());
}

TEST_CASE("a file that holds no machine is told so") {
  CHECK(errors_of("") == "m:1:1: the file is empty; expected a JSON document\n");
  CHECK(errors_of("\xEF\xBB\xBF [1]") == "m:1:2: found a list, expected a machine, an object\n");
  CHECK(errors_of("null") == "m:1:1: found null, expected a machine, an object\n");
  CHECK(errors_of("\"machine\"") == "m:1:1: found 'machine', expected a machine, an object\n");
  CHECK(errors_of("{}").find("m:1:1: there is no \"machine\"; expected 1, the version of the format\n") == 0);
  CHECK(errors_of("{\"name\":\"\xFF\"}").find("m:1:10: not valid JSON: ") == 0);
}

TEST_CASE("absurd machines are refused within a moment") {
  const auto repeat = [](const std::string& text, int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += fmt::format(fmt::runtime(text), i, i + 1);
    out.pop_back();  // the last comma
    return out;
  };
  const std::string head = R"({"machine":1,"name":"m","start":"s0",)";
  const std::string none = R"("transitions":[{"id":"a","from":"s0","on":"x","to":"s0"}]})";
  const std::vector<std::pair<std::string, std::string>> absurd = {
      {std::string(100'000, '['), "nested deeper than 200 levels"},
      {head + R"("states":{)" + repeat(R"("s{0}":{{}},)", 20'000) + "}}", "more than 10000 members"},
      {head + R"("states":{)" + repeat(R"("s{0}":{{}},)", 3'000) + R"(},"transitions":[)" +
           repeat(R"({{"id":"{0}","from":"*","on":"x","to":"s1"}},)", 3'000) + "]}",
       "more than 1000000 transitions"},
      {head + R"("transitions":[)" +
           repeat(R"({{"id":"{0}","from":"state{0}","on":"x","to":"s0","push":{{"n":"a"}}}},)", 3'000) + "]}",
       "unknown slot 'n'"},
      {head + R"("inputs":{"a0":["x*"],)" + repeat(R"("a{1}":["a{0}","a{0}"],)", 60) + "}," + none, ""},
      {head + R"("inputs":{)" + repeat(R"("a{0}":["a{1}"],)", 3'000) + "}," + none, "sets nested deeper than 100"},
      {head + R"("define":{)" + repeat(R"("a{0}":"a{1}",)", 3'000) + "}," + none, "unknown name 'a"},
      {head + R"("define":{"a":")" + std::string(100'000, '(') + "\"}," + none, "deeper than"},
      {head + R"("states":{")" + std::string(1'000'000, 'x') + R"(":{"enterr":[]}},)" + none, "unknown key 'enterr'"},
      {head + R"("slots":{"a":")" + std::string(100'000, '(') + "\"}," + none, "nested deeper than 64"},
  };
  for (const auto& [text, expected] : absurd) {
    CAPTURE(text.substr(0, 120), expected);
    const auto errors = errors_of(text);
    CHECK((expected.empty() ? errors.empty() : errors.find(expected) != std::string::npos));
  }
}

TEST_CASE("whatever is done to a machine, it loads or is told where it is wrong") {
  Random random(1);
  for (const auto& file : fs::directory_iterator(source / "engine/knowledge/machines")) {
    if (file.path().extension() != ".json") continue;
    const auto machine = read_file(file.path().string()).value();
    for (int i = 0; i < 60; ++i) {
      auto text = mutated(machine, random);
      if (i % 3 == 0 && !text.empty()) text = mutated(text, random);
      std::pair<std::size_t, std::size_t> last;
      for (const auto& error : check_machine(text, "m", {})) {
        std::pair<std::size_t, std::size_t> place;
        CAPTURE(error.text());
        REQUIRE(std::sscanf(error.where.c_str(), "m:%zu:%zu", &place.first, &place.second) == 2);
        REQUIRE(place.first >= 1);
        REQUIRE(place.second >= 1);
        REQUIRE(place >= last);
        REQUIRE_FALSE(error.sentence.empty());
        last = place;
      }
    }
  }
}

TEST_CASE("the schema has the keys that the reader knows, and no others") {
  const auto schema = LocatedJson::read((source / "engine/automaton/machine.schema.json").string()).value().root();
  std::map<std::string, std::vector<std::string>, std::less<>> stated;
  const auto note = [&](const Json& kind) {
    if (!kind.contains("title")) return;
    for (const auto& [key, value] : kind["properties"].items()) stated[kind["title"].get<std::string>()].push_back(key);
  };
  note(schema);
  for (const auto& [name, kind] : schema["definitions"].items()) note(kind);
  auto known = machine_keys();
  for (auto* keys : {&known, &stated})
    for (auto& [kind, names] : *keys) std::sort(names.begin(), names.end());
  CHECK(stated == known);
}
