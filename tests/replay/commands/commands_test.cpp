#include <filesystem>

#include "continua/core/located_json.h"
#include "continua/replay/check/file_kinds.h"
#include "continua/replay/commands/accept.h"
#include "continua/replay/commands/check.h"
#include "continua/replay/commands/export.h"
#include "continua/replay/commands/import.h"
#include "continua/replay/commands/machine.h"
#include "continua/replay/commands/validate.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const std::string session_log = "1\tHS\tYES\t1\n";
const std::string trace = "{\"kind\":\"trace\",\"version\":1}\n{\"t\":1,\"kind\":\"end\"}\n";

}  // namespace

TEST_CASE("import writes one trace, or a folder of them") {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", session_log), b = folder.file("b.txt", session_log);
  CHECK(run_import({{a}, folder.at("a.jsonl")}) == exit_done);
  CHECK(run_validate({{folder.at("a.jsonl")}}) == exit_done);
  CHECK(run_import({{a, b}, folder.at("deep/out")}) == exit_done);
  CHECK(read_file(folder.at("deep/out/b.trace.jsonl")).value().find("\"source\":\"b.txt\"") != std::string::npos);
  CHECK(run_import({{a}, folder.at("deep/out2/")}) == exit_done);
  CHECK(fs::exists(folder.at("deep/out2/a.trace.jsonl")));
}

TEST_CASE("import sets the machine's parameters to what they were when the log was recorded") {
  const TemporaryFolder folder;
  const auto header_of = [&](const std::string& name) {
    const auto log = folder.file(name, session_log);
    REQUIRE(run_import({{log}, folder.at("out.jsonl")}) == exit_done);
    const auto text = read_file(folder.at("out.jsonl")).value();
    return Json::parse(text.substr(0, text.find('\n')));
  };
  const auto first = header_of("P1-2018-02-05-000000.txt"), last = header_of("P9-2019-01-01-000000.txt");
  REQUIRE(first["parameters"].size() == last["parameters"].size());
  for (const auto& [name, value] : last["parameters"].items()) CHECK(first["parameters"][name] != value);
  CHECK_FALSE(header_of("undated.txt").contains("parameters"));
}

TEST_CASE("import does what it can and reports the rest") {
  const TemporaryFolder folder;
  const auto good = folder.file("good.txt", session_log), empty = folder.file("empty.txt", "");
  CHECK(run_import({{empty, good, folder.at("none.txt")}, folder.at("out")}) == exit_impossible);
  CHECK(fs::exists(folder.at("out/good.trace.jsonl")));
  CHECK_FALSE(fs::exists(folder.at("out/empty.trace.jsonl")));
}

TEST_CASE("import overwrites nothing that it reads, and writes no file twice") {
  const TemporaryFolder folder;
  const auto a = folder.file("x/a.txt", session_log), other_a = folder.file("y/a.txt", session_log);
  CHECK(run_import({{a}, a}) == exit_impossible);
  CHECK(read_file(a).value() == session_log);
  CHECK(run_import({{a, other_a}, folder.at("out")}) == exit_impossible);
  CHECK(run_import({{a, other_a}, folder.file("file", "")}) == exit_impossible);
  CHECK(run_import({{a}, folder.at("no/such/folder/a.jsonl")}) == exit_impossible);
}

TEST_CASE("validate tells what is wrong with a file of a lexicon and with raising rules") {
  const TemporaryFolder folder;
  const auto grammar =
      folder.file("lexicon/small/grammar.json",
                  R"json({"categories":{"N":{"type":"e -> t","move":"N"}},"names":{"cup":"e -> t"}})json");
  const auto words = folder.file("lexicon/small/words.json", R"json({"words":{"cup":[["N","\\x. cop(x)"]]}})json");
  CHECK(check_file(read_file(grammar).value(), grammar).problems.empty());
  const auto lexicon = check_file(read_file(words).value(), words);
  REQUIRE(lexicon.problems.size() == 1);
  CHECK(lexicon.problems[0].text().find(words + ":1:") == 0);
  CHECK(lexicon.problems[0].text().find("unknown name 'cop' (did you mean 'cup'?)") != std::string::npos);
  const std::string rules = R"json({"raising":1,"rules":[{"name":"a","from":"e","to":"e","by":"\\x. x"}]})json";
  CHECK(check_file(rules, "r.json").summary == "1 raising rule");
  CHECK(check_file(R"json({"raising":2,"rules":[]})json", "r.json").problems.size() == 1);
}

TEST_CASE("validate tells what is wrong with what live sessions begin with") {
  const auto path = source_dir() + "/engine/knowledge/live.json";
  CHECK(run_validate({{path}}) == exit_done);
  const std::string sound = read_file(path).value();
  const auto told = [&](const std::string& was, const std::string& is) {
    auto text = sound;
    REQUIRE(text.find(was) != std::string::npos);
    text.replace(text.find(was), was.size(), is);
    const auto problems = check_file(text, path).problems;
    return problems.empty() ? "" : problems.front().text().substr(path.size());
  };
  CHECK(told("\"scene\": \"place_setting\"", "\"scene\": \"place_seting\"").find("did you mean 'place_setting'?") !=
        std::string::npos);
  CHECK(told("\"machine\": \"interaction\"", "\"machine\": 7") == ":4:14: expected a text as 'machine'");
  CHECK(told("\"scene\"", "\"scenery\"").find("unknown key 'scenery'") != std::string::npos);
  CHECK(told("\"label\": \"No\", ", "") == ":7:5: expected a text as 'label'");
  CHECK(told("\"key\": \"n\"", "\"key\": \"y\"") == ":7:29: the key 'y' has another button already");
  CHECK(told("\"key\": \"n\"", "\"key\": \"no\"") == ":7:29: found 'no'; expected one letter");
  CHECK(told("\"text\": \"No.\"", "\"txt\": \"No.\"").find("speech has no 'text'") != std::string::npos);
}

TEST_CASE("validate knows a file by its content") {
  CHECK(check_file(trace, "x").summary == "trace, 1 event");
  CHECK(check_file(trace, "x").problems.empty());
  CHECK(check_file(session_log, "x").summary == "session log, 1 row");
  CHECK(check_file("\xEF\xBB\xBF\n" + trace, "x").problems.empty());
  const auto other = check_file("hello\n", "x.txt");
  REQUIRE(other.problems.size() == 1);
  CHECK(other.problems[0].text().find("x.txt:1:1: none of the project's files: not valid JSON") == 0);
}

TEST_CASE("validate finds every problem") {
  const auto check = check_file(trace + "{\"t\":2}\n{\"t\":3,\"kind\":\"speech\"}\n", "x");
  REQUIRE(check.problems.size() == 2);
  CHECK(check.problems[0].text() == "x:3: the event has no 'kind'");
  CHECK(check.problems[1].text() == "x:4: speech has no 'text' or 'alternatives'");
}

TEST_CASE("a broken machine is told line by line, and cannot be used") {
  const TemporaryFolder folder;
  const std::string text = "{\n  \"machine\": 1, \"nam\": \"m\", \"start\": 3 }\n";
  const auto check = check_file(text, "m.json");
  REQUIRE(check.problems.size() == 4);
  CHECK(check.problems[2].text() == "m.json:2:17: unknown key 'nam' of a machine (did you mean 'name'?)");
  CHECK(check_file("[]", "m.json").problems.at(0).text() == "m.json:1:1: found a list, expected a machine, an object");
  CHECK(run_validate({{folder.file("m.json", text)}}) == exit_impossible);
  CHECK(run_validate({{folder.file("m.json", "{")}}) == exit_impossible);
}

TEST_CASE("validate ends with 0 for valid, 1 for invalid, 2 for unreadable") {
  const TemporaryFolder folder;
  const auto good = folder.file("good.jsonl", trace), bad = folder.file("bad.jsonl", trace + "{}\n");
  CHECK(run_validate({{good}}) == exit_done);
  CHECK(run_validate({{good, bad}}) == exit_no);
  CHECK(run_validate({{bad, folder.at("none")}}) == exit_impossible);
}

TEST_CASE("a word is its parts between spaces, or its characters") {
  using Symbols = std::vector<std::string>;
  CHECK(symbols_of_word("") == Symbols{});
  CHECK(symbols_of_word("aé*") == Symbols{"a", "é", "*"});
  CHECK(symbols_of_word("speech grab") == Symbols{"speech", "grab"});
  CHECK(symbols_of_word("  ab  c ") == Symbols{"ab", "c"});
  CHECK(symbols_of_word(" ") == Symbols{});
}

TEST_CASE("accept ends with 0 if all words are accepted, 1 if not, 2 if it cannot be said") {
  const TemporaryFolder folder;
  const auto json = folder.file(
      "m.json",
      R"({"machine":1,"name":"m","start":"A","accept":["A"],"transitions":[{"id":"go","from":"A","on":"go","to":"A"}]})");
  const auto jff = folder.file("m.jff",
                               "<structure><type>fa</type><state id='0'><initial/><final/></state>"
                               "<transition><from>0</from><to>0</to><read>a</read></transition></structure>");
  const auto words = folder.file("words.txt", "\naa\r\na");
  CHECK(run_accept({json, {"", " go", "go go"}, "", false}) == exit_done);
  CHECK(run_accept({json, {"go"}, "", false}) == exit_no);
  CHECK(run_accept({jff, {"", "a", "a a"}, "", false}) == exit_done);
  CHECK(run_accept({jff, {"a", "b"}, "", false}) == exit_no);
  CHECK(run_accept({jff, {}, words, false}) == exit_done);
  CHECK(run_accept({jff, {"b"}, words, false}) == exit_no);
  CHECK(run_accept({jff, {}, "", false}) == exit_impossible);
  CHECK(run_accept({jff, {"a"}, folder.at("none"), false}) == exit_impossible);
  CHECK(run_accept({folder.at("none.jff"), {"a"}, "", false}) == exit_impossible);
}

TEST_CASE("validate knows JFLAP's files, by name or by root element") {
  const std::string fa =
      "<?xml version='1.0'?>\n<structure><type>fa</type><state id='0'><initial/></state></structure>";
  CHECK(check_file(fa, "x").summary == "machine, 1 state, 0 transitions");
  CHECK(check_file("\xEF\xBB\xBF" + fa, "x").problems.empty());
  CHECK(check_file("<structure>\n<type>", "x").problems.at(0).text().find("x:2: not valid XML") == 0);
  CHECK(check_file("hello", "x.jff").problems.at(0).text().find("x.jff:1: not valid XML") == 0);
}

TEST_CASE("validate knows voxemes, and reads folders") {
  const TemporaryFolder folder;
  const std::string voxeme = "<VoxML><Entity Type='Object'/><Lex><Pred>jug</Pred></Lex>\n<Extra/></VoxML>";
  const auto check = check_file(voxeme, "v.xml");
  CHECK(check.problems.empty());
  CHECK(check.summary == "voxeme, the object jug");
  CHECK(check.notes == std::vector<std::string>{"v.xml:2: the element <Extra> is unknown"});
  CHECK(check_file("<VoxML/>", "v.xml").problems.at(0).where == "v.xml:1");
  folder.file("a/jug.xml", voxeme);
  folder.file("a/notes.txt", "none of the project's files");
  CHECK(run_validate({{folder.at("a")}}) == exit_done);
  folder.file("a/b/bad.xml", "<VoxML/>");
  CHECK(run_validate({{folder.at("a")}}) == exit_no);
}

TEST_CASE("check counts voxemes, and tells programs of which no step exists") {
  const TemporaryFolder folder;
  const auto program = [](const char* step) {
    return std::string("<VoxML><Entity Type='Program'/><Lex><Pred>sit</Pred></Lex><Type><Args><Arg Value='x:agent'/>") +
           "</Args><Body><Subevent Value='" + step + "'/></Body></Type></VoxML>";
  };
  CheckOptions options;
  options.paths = {folder.at("voxemes")};
  folder.file("voxemes/programs/sit.xml", program("sit(x)"));
  CHECK(run_check(options) == exit_done);
  folder.file("voxemes/programs/sit.xml", program("stand(x)"));
  CHECK(run_check(options) == exit_no);
  folder.file("voxemes/programs/sit.xml", "<VoxML/>");
  CHECK(run_check(options) == exit_impossible);
}

TEST_CASE("machine describes a machine, or draws it") {
  const TemporaryFolder folder;
  const auto file = folder.file("m.json", R"({"machine":1,"name":"m","start":"A","transitions":[)"
                                          R"({"id":"a","from":"A","on":"x","to":"B"}]})");
  CHECK(run_machine({file, "", false, false, folder.at("m.txt")}) == exit_done);
  CHECK(read_file(folder.at("m.txt")).value().starts_with("m: "));
  CHECK(run_machine({file, "", true, false, folder.at("m.dot")}) == exit_done);
  CHECK(read_file(folder.at("m.dot")).value().starts_with("digraph \"m\" {\n"));
  CHECK(run_machine({"diana2018", "", false, true, folder.at("d.svg")}) == exit_done);
  CHECK(read_file(folder.at("d.svg")).value().starts_with("<svg "));
  CHECK(run_machine({file, "", false, true, folder.at("no/such/folder/m.svg")}) == exit_impossible);
  CHECK(run_machine({"no such machine", "", false, true, "-"}) == exit_impossible);
  CHECK(run_machine({folder.file("bad.json", "{}"), "", false, true, "-"}) == exit_impossible);
}

TEST_CASE("an export that fails leaves what was there") {
  const TemporaryFolder folder;
  const auto broken = folder.file("none.run.jsonl", "{\"kind\":\"run\",\"n\":0,\"t\":0,\"version\":1}\n");
  const auto old = folder.file("old.svg", "a picture");
  CHECK(run_export({{broken}, "svg", old}) == exit_impossible);
  CHECK(std::filesystem::file_size(old) == 9);
  CHECK(!std::filesystem::exists(old + ".part"));
}

TEST_CASE("export draws what a run visited") {
  const TemporaryFolder folder;
  const auto run = folder.file("small.run.jsonl", small_log().text());
  CHECK(run_export({{run}, "dot", folder.at("small.dot")}) == exit_done);
  CHECK(read_file(folder.at("small.dot")).value().find("1× d") != std::string::npos);
  CHECK(run_export({{run}, "svg", folder.at("small.svg")}) == exit_done);
  CHECK(read_file(folder.at("small.svg")).value().find("1× d") != std::string::npos);
  CHECK(
      run_export({{folder.file("none.run.jsonl", "{\"kind\":\"run\",\"n\":0,\"t\":0,\"version\":1}\n")}, "svg", "-"}) ==
      exit_impossible);
}
