#include "continua/replay/inspector/run_notes.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "continua/replay/check/file_kinds.h"
#include "continua/replay/inspector/inspector_api.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

// A run of 22 records, and notes on it.
struct Noted {
  Json get(int status = 200) {
    const auto answer = api.get(address);
    INFO(answer.body);
    CHECK(answer.status == status);
    return Json::parse(answer.body);
  }
  Json put(const Json& body, int status = 200) {
    const auto answer = api.put(address, "application/json", body.dump());
    INFO(body.dump().substr(0, 300) << " gave " << answer.body.substr(0, 300));
    CHECK(answer.status == status);
    return Json::parse(answer.body);
  }
  std::string refused(const Json& notes, int status = 400) {
    return put({{"notes", notes}, {"version", get()["version"]}}, status)["error"]["message"].get<std::string>();
  }

  ScratchFolder folder;
  std::string log = folder.write("small.run.jsonl", small_log().text());
  std::string file = folder.path() + "/small.notes.json";
  InspectorApi api{{folder.path()}};
  std::string address = "/api/runs/small/notes";
};

Json note(const Json& id, const Json& n, const Json& to, const Json& text) {
  return {{"id", id}, {"n", n}, {"to", to}, {"text", text}};
}

std::vector<std::string> names_below(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("notes are kept beside the run and read again") {
  Noted noted;
  CHECK(noted.get() == Json{{"notes", Json::array()}, {"version", ""}});
  const Json notes{note("a", 5, nullptr, "Why „which block“?\nπ"), note("b", 5, 8, "x")};
  const auto kept = noted.put({{"notes", notes}, {"version", ""}});
  CHECK(kept["notes"] == notes);
  CHECK(noted.get() == kept);
  CHECK(names_below(noted.folder.path()) == std::vector<std::string>{"small.notes.json", "small.run.jsonl"});
  CHECK(check_file(*read_file(noted.file), noted.file).summary == "2 notes");
  // Others see them, and the list of runs does not take them for a run.
  InspectorApi other({noted.folder.path()});
  CHECK(Json::parse(other.get(noted.address).body) == kept);
  CHECK(Json::parse(other.get("/api/runs").body)["runs"].size() == 1);
  const auto none = noted.put({{"notes", Json::array()}, {"version", kept["version"]}});
  CHECK(none["notes"].empty());
  CHECK(none["version"] != kept["version"]);
}

TEST_CASE("notes that somebody else wrote meanwhile are not written over") {
  Noted noted;
  const auto first = noted.put({{"notes", {note("a", 1, nullptr, "mine")}}, {"version", ""}});
  CHECK_THAT(noted.put({{"notes", Json::array()}, {"version", ""}}, 409)["error"]["message"].get<std::string>(),
             Contains("meanwhile"));
  CHECK(noted.get() == first);
  // By hand, too.
  noted.folder.write("small.notes.json", R"({"notes":[{"id":"z","n":3,"text":"by hand"}]})");
  noted.put({{"notes", Json::array()}, {"version", first["version"]}}, 409);
  CHECK(noted.get()["notes"] == Json::array({note("z", 3, nullptr, "by hand")}));
}

TEST_CASE("notes that are none are refused, note by note") {
  Noted noted;
  const std::string longest(10000, 'x'), long_id(101, 'i');
  std::string umlauts;
  for (int i = 0; i < 10000; ++i) umlauts += "ü";
  noted.put({{"notes", {note("a", 21, 21, longest), note("b", 0, nullptr, umlauts)}}, {"version", ""}});
  CHECK_THAT(noted.refused(Json::array({note("a", 22, nullptr, "x")})),
             Contains("record 22; the run has records 0 to 21"));
  CHECK_THAT(noted.refused(Json::array({note("a", 1, 22, "x")})), Contains("record 22"));
  CHECK_THAT(noted.refused(Json::array({note("a", 1, nullptr, "x"), note("b", 5, 4, "x")})),
             Contains("note 2: 'to' is 4"));
  CHECK_THAT(noted.refused(Json::array({note("a", 1, "2", "x")})), Contains("'to' is \"2\""));
  CHECK_THAT(noted.refused(Json::array({note("a", 1, nullptr, "")})), Contains("0 letters"));
  CHECK_THAT(noted.refused(Json::array({note("a", 1, nullptr, longest + "x")})), Contains("10001 letters"));
  CHECK_THAT(noted.refused(Json::array({note("", 1, nullptr, "x")})), Contains("id has 0"));
  CHECK_THAT(noted.refused(Json::array({note(long_id, 1, nullptr, "x")})), Contains("id has 101"));
  CHECK_THAT(noted.refused(Json::array({note("a", 1, nullptr, "x"), note("a", 2, nullptr, "x")})),
             Contains("another's"));
  CHECK_THAT(noted.refused(Json::array({note("a", -1, nullptr, "x")})), Contains("note 1: expected"));
  CHECK_THAT(noted.refused(Json::array({note(1, 1, nullptr, "x")})), Contains("note 1: expected"));
  CHECK_THAT(noted.refused(Json::array({3})), Contains("note 1: expected"));
  CHECK_THAT(noted.refused("x"), Contains("expected"));
  Json many = Json::array();
  for (int i = 0; i <= 10000; ++i) many.push_back(note(std::to_string(i), 1, nullptr, "x"));
  CHECK_THAT(noted.refused(many), Contains("10001 notes"));
  many.erase(0);
  noted.put({{"notes", many}, {"version", noted.get()["version"]}});
  CHECK_THAT(noted.put({{"notes", Json::array()}}, 400)["error"]["message"].get<std::string>(), Contains("'version'"));
  CHECK(noted.api.put(noted.address, "text/plain", "{}").status == 415);
  CHECK(noted.api.put(noted.address, "application/json", "{").status == 400);
  CHECK(noted.api.put("/api/runs/nobody/notes", "application/json", "{}").status == 404);
  CHECK(noted.api.put("/api/runs/small/records", "application/json", "{}").status == 405);
  CHECK(noted.api.put("/api/runs//notes", "application/json", "{}").status == 405);
}

TEST_CASE("a broken file of notes is told of and left as it is") {
  for (const std::string text : {"", "{", "[]", R"({"notes":3})", R"({"notes":[{"id":"a"}]})", "\xff\xfe"}) {
    Noted noted;
    noted.folder.write("small.notes.json", text);
    INFO(text);
    CHECK_THAT(noted.get(422)["error"]["message"].get<std::string>(), Contains("small.notes.json"));
    noted.put({{"notes", Json::array()}, {"version", ""}}, 422);
    CHECK(*read_file(noted.file) == text);
    CHECK_FALSE(check_file(text, noted.file).problems.empty());
  }
}

TEST_CASE("notes that cannot be written give a sentence and nothing else") {
  if (::geteuid() == 0) {
    // Root may write anywhere, except in a folder that does not exist.
    const auto kept = keep_notes("/proc/nothing/small.notes.json", {}, "");
    CHECK(kept.how == NotesKept::How::not_writable);
    CHECK_THAT(kept.sentence, Contains("cannot be written"));
    return;
  }
  Noted noted;
  ::chmod(noted.folder.path().c_str(), 0500);
  noted.put({{"notes", {note("a", 1, nullptr, "x")}}, {"version", ""}}, 403);
  ::chmod(noted.folder.path().c_str(), 0700);
  CHECK(names_below(noted.folder.path()).size() == 1);
}

TEST_CASE("validate tells of every note that is wrong, and where") {
  Noted noted;
  const std::string text =
      "{\"notes\": [\n{\"id\":\"a\",\"n\":1,\"text\":\"x\"},\n{\"id\":\"a\",\"n\":2,\"text\":\"x\"},\n"
      "{\"id\":\"b\",\"n\":99,\"text\":\"x\"}]}\n";
  const auto check = check_file(text, noted.file);
  REQUIRE(check.problems.size() == 2);
  CHECK_THAT(check.problems[0].where, Contains("small.notes.json:3:1"));
  CHECK_THAT(check.problems[1].text(),
             Contains("small.notes.json:4:1: it is on record 99; the run has records 0 to 21"));
  const auto alone = check_file(text, "/nowhere/other.notes.json");
  CHECK(alone.problems.size() == 1);
}
