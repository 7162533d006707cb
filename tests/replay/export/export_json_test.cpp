#include "continua/replay/export/json.h"

#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

TEST_CASE("the export is one document with every snapshot expanded") {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("small.run.jsonl", small_log().text()));
  REQUIRE(run.ok());
  const auto text = export_json(*run);
  REQUIRE(text.ok());
  const auto document = Json::parse(*text);
  CHECK(document["header"]["kind"] == "run");
  CHECK(document["end"]["kind"] == "end");
  REQUIRE(document["records"].size() == 20);
  CHECK(document["records"][0]["n"] == 1);
  const auto& agree = document["records"][12];
  CHECK(agree["id"] == "agree");
  CHECK(compact(agree["snapshot"]) == R"j([{"action":"put(block2, on(block1))"},{}])j");
  CHECK_FALSE(document["records"][1].contains("snapshot"));
}

TEST_CASE("nothing of the log is lost in the export") {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("small.run.jsonl", small_log().text()));
  auto document = Json::parse(*export_json(*run));
  for (std::size_t n = 1; n + 1 < run->size(); ++n) {
    auto& record = document["records"][n - 1];
    record.erase("snapshot");
    CHECK(compact(record) == *run->line(n));
  }
  CHECK(compact(document["header"]) == *run->line(0));
}

TEST_CASE("a log cut short is exported without an end") {
  const ScratchFolder folder;
  const auto text = small_log().text();
  SECTION("after some records") {
    const auto run = RunIndex::open(folder.write("cut.run.jsonl", text.substr(0, text.size() - 20)));
    const auto document = Json::parse(*export_json(*run));
    CHECK(document["end"].is_null());
    CHECK(document["records"].size() == 20);
  }
  SECTION("after the header") {
    const auto run = RunIndex::open(folder.write("cut.run.jsonl", text.substr(0, text.find('\n') + 1)));
    const auto document = Json::parse(*export_json(*run));
    CHECK(document["records"].empty());
  }
}
