#include "continua/replay/log/run_index.h"

#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

Error error_of(const std::string& text) {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("bad.run.jsonl", text));
  REQUIRE(!run.ok());
  return run.error();
}

}  // namespace

TEST_CASE("the index knows kind, time, cause and place of every record") {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("small.run.jsonl", small_log().text()));
  REQUIRE(run.ok());
  CHECK(run->size() == 22);
  CHECK(run->complete());
  CHECK(run->trouble().empty());
  CHECK(run->kind(2) == "input");
  CHECK(run->kind(20) == "novelty");
  CHECK(run->entry(2).t.seconds() == Approx(1.5));
  CHECK(run->cause(5) == 2u);
  CHECK(run->cause(2) == std::nullopt);
  CHECK(run->of_kind("transition") == std::vector<std::size_t>{5, 8, 13});
  CHECK(run->of_kind("nothing").empty());
  const auto record = run->record(6);
  REQUIRE(record.ok());
  CHECK((*record)["text"] == "Which block?");
}

TEST_CASE("a snapshot is a walk down the symbols") {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("small.run.jsonl", small_log().text()));
  REQUIRE(run.ok());
  CHECK(run->mark_at(4) == std::nullopt);
  REQUIRE(run->mark_at(9).has_value());
  CHECK(run->stack_marks()[*run->mark_at(9)].n == 8);
  CHECK(run->stack_ids(2) == std::vector<std::int64_t>{2, 1});
  CHECK(run->stack_ids(77).empty());
  const auto stack = run->snapshot(3);
  REQUIRE(stack.ok());
  CHECK(
      compact(*stack) ==
      R"j([{"id":3,"below":1,"made":12,"slots":{"action":"put(block2, on(block1))"}},{"id":1,"below":null,"made":1,"slots":{}}])j");
}

TEST_CASE("a log cut short is read up to its last whole line") {
  const ScratchFolder folder;
  const auto text = small_log().text();
  SECTION("in the middle of a line") {
    const auto run = RunIndex::open(folder.write("cut.run.jsonl", text.substr(0, text.size() - 20)));
    REQUIRE(run.ok());
    CHECK(run->size() == 21);
    CHECK_FALSE(run->complete());
    CHECK(run->trouble() == "Line 22 is cut short; the log is shown up to record 20.");
  }
  SECTION("between two lines") {
    const auto end = text.rfind('\n', text.size() - 2) + 1;
    const auto run = RunIndex::open(folder.write("cut.run.jsonl", text.substr(0, end)));
    REQUIRE(run.ok());
    CHECK(run->size() == 21);
    CHECK_THAT(run->trouble(), Contains("no end record"));
  }
  SECTION("before the last line's end alone: nothing is missing") {
    const auto run = RunIndex::open(folder.write("cut.run.jsonl", text.substr(0, text.size() - 1)));
    REQUIRE(run.ok());
    CHECK(run->size() == 22);
    CHECK(run->complete());
  }
  SECTION("at every byte: never a crash, never a record more than there are lines") {
    for (std::size_t bytes = 1; bytes < text.size(); bytes += 7) {
      const auto run = RunIndex::open(folder.write("cut.run.jsonl", text.substr(0, bytes)));
      if (run) CHECK(run->size() <= 22);
    }
  }
}

TEST_CASE("what is no run log is refused with file and line") {
  CHECK_THAT(RunIndex::open("/nowhere/a.run.jsonl").error().text(), Contains("/nowhere/a.run.jsonl: cannot be read"));
  CHECK_THAT(RunIndex::open("/tmp").error().text(), Contains("cannot be read"));
  CHECK_THAT(error_of("").text(), Contains("empty"));
  CHECK_THAT(error_of("hello\n").text(), Contains(":1: not a run log"));
  CHECK_THAT(error_of("{\"kind\":\"ru").text(), Contains(":1: not a run log"));
  CHECK_THAT(error_of(std::string(3000, '\0')).text(), Contains(":1: not a run log"));
  CHECK_THAT(error_of("{\"kind\":\"trace\",\"version\":1}\n").text(), Contains(":1: not a run log"));
  CHECK_THAT(error_of("{\"kind\":\"run\",\"n\":0,\"t\":0,\"version\":2}\n").text(), Contains("another version"));
}

TEST_CASE("a broken line in the middle is refused with its number") {
  const std::string head = "{\"kind\":\"run\",\"n\":0,\"t\":0,\"version\":1}\n",
                    next = "{\"kind\":\"rest\",\"n\":2,\"t\":0}\n";
  CHECK_THAT(error_of(head + "{\"kind\":\"rest\",\"n\":1\n" + next).text(),
             Contains(":2: not a JSON object on one line"));
  CHECK_THAT(error_of(head + "\n" + next).text(), Contains(":2: not a JSON object"));
  CHECK_THAT(error_of(head + next).text(), Contains(":2: record number 2 where 1 was expected"));
  CHECK_THAT(error_of(head + "{\"n\":1,\"t\":0}\n").text(), Contains(":2: a record without 'kind'"));
  CHECK_THAT(error_of(head + "{\"kind\":\"rest\",\"n\":1}\n").text(), Contains(":2: a record without its time"));
}

TEST_CASE("keys in any order, spaces and braces inside texts do not mislead the index") {
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.line(
      R"j( { "t" : 1.25 , "text" : "a \"}],{ \\" , "deep" : {"stack":[7,{"n":9}]}, "n":1, "kind" : "utterance", "cause":0 } )j");
  const auto run = RunIndex::open(folder.write("odd.run.jsonl", log.text()));
  REQUIRE(run.ok());
  CHECK(run->kind(1) == "utterance");
  CHECK(run->entry(1).t.us == 1250000);
  CHECK(run->cause(1) == 0u);
  CHECK(run->stack_marks().empty());
}

TEST_CASE("symbols that name each other in a ring do not make a snapshot endless") {
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("symbol", 0, {{"id", 1}, {"below", 2}, {"slots", Json::object()}});
  log.add("symbol", 0, {{"id", 2}, {"below", 1}, {"slots", Json::object()}});
  log.add("symbol", 0, {{"id", 3}, {"below", 3}, {"slots", Json::object()}});
  const auto run = RunIndex::open(folder.write("ring.run.jsonl", log.text()));
  REQUIRE(run.ok());
  CHECK(run->stack_ids(2) == std::vector<std::int64_t>{2, 1});
  CHECK(run->stack_ids(3) == std::vector<std::int64_t>{3});
}

TEST_CASE("a log longer than what is read at once is indexed whole") {
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}, {"scene", {{"mjcf", std::string(2'500'000, 'x')}}}});
  for (int i = 0; i < 20'000; ++i) log.add("pose", i * 0.01, {{"bodies", {{"hand", {i, 0, 0, 1, 0, 0, 0}}}}});
  const auto run = RunIndex::open(folder.write("long.run.jsonl", log.text()));
  REQUIRE(run.ok());
  CHECK(run->size() == 20'001);
  CHECK((*run->record(20'000))["bodies"]["hand"][0] == 19'999);
}
