#include "continua/replay/explain/explain_cells.h"

#include <filesystem>

#include "continua/replay/explain/explain.h"
#include "continua/replay/inspector/inspector_api.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

// Two words set slots of a cell that is rewritten, pushed upon and uncovered again.
std::string cells_log() {
  LogBuilder log;
  const auto step = [&](double t, const char* id, const char* operation, const Json& content, int stack, int cause) {
    Json fields = transition_fields(id, "Wait", "Wait", stack, 1);
    fields["operation"] = Json{{operation, content}};
    log.add("transition", t, fields, cause);
  };
  const auto symbol = [&](int id, const Json& below, const Json& slots) {
    log.add("symbol", 0, {{"id", id}, {"below", below}, {"slots", slots}}, 0);
  };
  log.add("run", 0,
          {{"version", 1},
           {"graph",
            {{"states", Json::array()},
             {"start", "Wait"},
             {"edges", {{{"id", "look"}, {"from", "Wait"}, {"to", "Wait"}, {"condition", "size(things) > 1"}}}}}}});
  symbol(0, nullptr, Json::object());
  log.add("input", 1, {{"event", {{"kind", "speech"}, {"text", "Red blocks."}}}});
  log.add("reading", 1,
          {{"words", "red blocks"},
           {"meaning", "[a, b]"},
           {"resolved", {{{"words", "red blocks"}, {"value", "[a, b]"}, {"by", "words"}}}}},
          2);
  symbol(1, nullptr, {{"things", "[a, b]"}});                                   // 4
  step(1, "name", "rewrite", {{"things", "meaning"}}, 1, 2);                    // 5
  symbol(2, nullptr, {{"things", "[a, b]"}, {"mood", "calm"}});                 // 6
  step(2, "calm", "rewrite", {{"mood", "'calm'"}}, 2, 5);                       // 7
  symbol(3, 2, {{"things", "[a, b]"}, {"mood", "busy"}});                       // 8
  step(3, "look", "push", {{"mood", "'busy'"}}, 3, 7);                          // 9
  step(4, "back", "pop", 1, 2, 9);                                              // 10
  symbol(4, nullptr, {{"things", "[b]"}, {"mood", "calm"}});                    // 11
  step(5, "fewer", "rewrite", {{"things", "tail(things)"}}, 4, 10);             // 12
  symbol(5, 99, {{"things", Json::array()}, {"mood", Json::object()}});         // 13
  log.add("transition", 6, {{"id", 7}, {"operation", "x"}, {"stack", 5}}, 12);  // 14
  return log.text();
}

Json cell_at(const RunIndex& run, std::size_t n, int symbol, const char* slot) {
  const auto told = explain(run, n);
  REQUIRE(told.ok());
  for (const auto& cell : (*told)["cells"])
    if (cell["symbol"] == symbol && cell["slot"] == slot) return cell;
  return nullptr;
}

}  // namespace

TEST_CASE("a cell tells since when it has its value, from what, and who read it") {
  const auto run = RunIndex::of_text(cells_log(), "cells");
  REQUIRE(run.ok());

  const auto fresh = cell_at(*run, 5, 1, "things");
  CHECK(fresh["set"] == 5);
  CHECK(fresh["expression"] == "meaning");
  CHECK(fresh["origin"]["words"] == "red blocks");
  CHECK(fresh["read"].is_null());

  // A rewrite of another slot takes it along: the same cell under another id.
  const auto kept = cell_at(*run, 7, 2, "things");
  CHECK(kept["set"] == 5);
  CHECK(kept["t"] == 1);
  CHECK(kept["symbols"] == Json{2, 1, 0});
  CHECK(cell_at(*run, 7, 2, "mood")["set"] == 7);

  CHECK(cell_at(*run, 7, 2, "mood")["origin"]["input"] == 2);
  CHECK(cell_at(*run, 7, 2, "mood")["origin"]["text"] == "what the machine made of “Red blocks.” (0:01)");

  // A pushed symbol inherits the slots that the operation does not set.
  CHECK(cell_at(*run, 9, 3, "things")["set"] == 5);
  CHECK(cell_at(*run, 9, 3, "mood")["set"] == 9);
  CHECK(cell_at(*run, 9, 2, "things")["read"] == 9);

  const auto changed = cell_at(*run, 12, 4, "things");
  CHECK(changed["set"] == 12);
  CHECK(changed["changes"] == Json{5});
  CHECK(changed["read"] == 12);
  CHECK(changed["symbols"] == Json{4, 2, 1, 0});
  CHECK(cell_at(*run, 12, 4, "mood")["set"] == 7);
}

TEST_CASE("cells of a log that is not as it should be are told as far as they go") {
  const auto run = RunIndex::of_text(cells_log(), "cells");
  REQUIRE(run.ok());
  CHECK(cell_at(*run, 14, 5, "things")["set"] == 14);
  CHECK(cell_at(*run, 14, 5, "mood")["value"] == Json::object());
  CHECK(explain(*run, 0).ok());
  CHECK((*explain(*run, 0))["cells"] == Json::array());
}

TEST_CASE("the value of a cell has a derivation of its own") {
  const auto run = RunIndex::of_text(small_log().text(), "small");
  REQUIRE(run.ok());
  const auto told = explain_cell(*run, 13, "3.action");
  REQUIRE(told.ok());
  CHECK((*told)["value"] == "put(block2, on(block1))");
  CHECK((*told)["derivation"]["how"] == "application");
  CHECK((*told)["derivation"]["n"] == 11);
  for (const char* wrong : {"3.nothing", "99.action", "action", "x.action", ".", ""})
    CHECK_FALSE(explain_cell(*run, 13, wrong).ok());
}

TEST_CASE("the inspector explains a record, a cell, and says what is wrong with the question") {
  ScratchFolder folder;
  const auto text = small_log().text();
  folder.write("small.run.jsonl", text);
  folder.write("cut.run.jsonl", text.substr(0, text.size() - 400));
  InspectorApi api({folder.path()});
  const auto get = [&](const std::string& target, int status) {
    const auto answer = api.get(target);
    INFO(target << " gave " << answer.body);
    CHECK(answer.status == status);
    return Json::parse(answer.body);
  };
  const auto told = get("/api/runs/small/explain?n=14", 200);
  CHECK_THAT(told["headline"].get<std::string>(), Contains("puts block2 on block1"));
  CHECK(told["chain"].size() == 3);
  CHECK(told["derivation"]["how"] == "application");
  CHECK(told["cells"][0]["slot"] == "action");
  CHECK(get("/api/runs/small/explain?n=13&cell=3.action", 200)["derivation"]["n"] == 11);
  CHECK(get("/api/runs/cut/explain?n=14", 200)["trouble"] != "");
  CHECK_THAT(get("/api/runs/small/explain", 400)["error"]["message"].get<std::string>(), Contains("n is missing"));
  CHECK_THAT(get("/api/runs/small/explain?n=22", 400)["error"]["message"].get<std::string>(), Contains("0 to 21"));
  CHECK_THAT(get("/api/runs/small/explain?n=13&cell=9.x", 404)["error"]["message"].get<std::string>(),
             Contains("no cell '9.x'"));
  get("/api/runs/none/explain?n=1", 404);
}
