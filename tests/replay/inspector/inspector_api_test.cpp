#include "continua/replay/inspector/inspector_api.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/columns.h"

using namespace continua;

namespace {

// A folder with one whole run, one cut short and one that is no run, and its API.
struct Served {
  Served() {
    const auto text = small_log().text();
    write("small.run.jsonl", text, 30);
    write("below/cut one.run.jsonl", text.substr(0, text.size() - 20), 10);
    write("garbage.run.jsonl", "hello\n", 20);
    folder.write("notes.txt", "not served");
  }
  // As if it had been written so many seconds ago.
  void write(const std::string& name, const std::string& text, int ago_s) {
    const auto path = folder.write(name, text);
    std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - std::chrono::seconds(ago_s));
  }
  Json get(const std::string& target, int status = 200) {
    const auto answer = api.get(target);
    INFO(target << " gave " << answer.body);
    CHECK(answer.status == status);
    CHECK(answer.content_type == "application/json");
    return Json::parse(answer.body);
  }
  std::string message(const std::string& target, int status) {
    return get(target, status)["error"]["message"].get<std::string>();
  }

  ScratchFolder folder;
  InspectorApi api{{folder.path()}};
};

Json column(const Json& list, const char* key) {
  Json values = Json::array();
  for (const auto& one : list) values.push_back(one[key]);
  return values;
}

}  // namespace

TEST_CASE("the list of runs tells what is in each, and which cannot be read") {
  Served served;
  const auto runs = served.get("/api/runs")["runs"];
  REQUIRE(runs.size() == 3);
  CHECK(column(runs, "id") == Json{"below.cut_one", "garbage", "small"});
  CHECK(column(runs, "live") == Json{true, false, false});
  CHECK(runs[0]["changed"].get<double>() - runs[2]["changed"].get<double>() == Approx(20).margin(1));
  CHECK(runs[2]["first"] == 6);
  CHECK_FALSE(runs[2].contains("pending"));
  const auto& small = runs[2];
  CHECK(small["duration"] == 10);
  CHECK(small["utterances"] == 1);
  CHECK(small["acts"] == 1);
  CHECK(small["refusals"] == 1);
  CHECK(small["machine"] == "two");
  CHECK(small["scene"] == "table");
  CHECK(small["complete"] == true);
  CHECK(small["counts"]["transition"] == 3);
  CHECK(runs[0]["complete"] == false);
  CHECK_THAT(runs[1]["error"]["message"].get<std::string>(), Contains("garbage.run.jsonl:1: not a run log"));
}

TEST_CASE("a run that is not yet read is pending, and read in the background") {
  Served served;
  served.api.start_preparing();
  Json runs;
  for (int tries = 0; tries < 100; ++tries) {
    runs = served.get("/api/runs")["runs"];
    REQUIRE(runs.size() == 3);
    CHECK(runs[0]["bytes"].get<int>() > 0);
    if (std::none_of(runs.begin(), runs.end(), [](const Json& run) { return run.contains("pending"); })) break;
    CHECK(tries < 99);
  }
  CHECK(runs[2]["utterances"] == 1);
  CHECK_THAT(runs[1]["error"]["message"].get<std::string>(), Contains("not a run log"));
  served.write("new.run.jsonl", small_log().text(), 0);
  while (runs.size() < 4 || runs[0].contains("pending")) runs = served.get("/api/runs")["runs"];
  CHECK(runs[0]["id"] == "new");
  CHECK(runs[0]["records"] == 22);
  served.api.stop_preparing();
}

TEST_CASE("what a page draws from comes as bytes") {
  Served served;
  const auto answer = served.api.get("/api/runs/small/columns");
  CHECK(answer.status == 200);
  CHECK(answer.content_type == "application/octet-stream");
  CHECK(Columns(answer.body).numbers("t").size() == 22);
  CHECK(served.api.get("/api/runs/small/columns").body == answer.body);
  const auto found = served.api.get("/api/runs/small/find?text=which+BLOCK&kind=*");
  CHECK(found.content_type == "application/octet-stream");
  REQUIRE(found.body.size() % 4 == 0);
  CHECK(found.body.substr(0, 4) == std::string("\5\0\0\0", 4));
}

TEST_CASE("the schema names each kind and member of records with its meaning") {
  Served served;
  const auto schema = served.get("/api/schema");
  CHECK(column(schema["stamp"], "name") == Json{"n", "t", "cause", "measured"});
  const auto kinds = column(schema["kinds"], "name");
  const auto act = std::find(kinds.begin(), kinds.end(), "act");
  REQUIRE(act != kinds.end());
  const auto& members = schema["kinds"][static_cast<std::size_t>(act - kinds.begin())]["members"];
  CHECK(members[0] == Json{{"name", "act"},
                           {"type", "integer"},
                           {"optional", false},
                           {"says", "where"},
                           {"meaning", "Running number of the act, from 1."}});
}

TEST_CASE("how far a run has come") {
  Served served;
  CHECK(Json::parse(served.api.growth("small").body) ==
        Json{{"records", 22}, {"t", 10.0}, {"complete", true}, {"live", false}});
  CHECK(Json::parse(served.api.growth("below.cut_one").body)["complete"] == false);
  CHECK(Json::parse(served.api.growth("below.cut_one").body)["live"] == true);
  served.write("below/cut one.run.jsonl", small_log().text().substr(0, 1200), 60);
  CHECK(Json::parse(served.api.growth("below.cut_one").body)["live"] == false);
  CHECK(served.api.growth("none").status == 404);
  CHECK(served.api.growth("garbage").status == 422);
}

TEST_CASE("runs that appear, change or go are noticed") {
  Served served;
  const auto added = served.folder.write("another.run.jsonl", small_log().text());
  CHECK(served.get("/api/runs")["runs"].size() == 4);
  CHECK(served.get("/api/runs/another")["records"] == 22);
  auto longer = small_log();
  longer.add("problem", 11, {{"line", 1}, {"message", "more"}});
  served.folder.write("another.run.jsonl", longer.text());
  CHECK(served.get("/api/runs/another")["records"] == 23);
  std::filesystem::remove(added);
  CHECK_THAT(served.message("/api/runs/another", 404), Contains("no run 'another'"));
}

TEST_CASE("a run's summary leaves out the long texts and names where to begin") {
  Served served;
  const auto summary = served.get("/api/runs/small");
  CHECK(summary["id"] == "small");
  CHECK(summary["first"] == 6);
  CHECK(summary["header"]["trace"]["name"] == "small");
  CHECK_FALSE(summary["header"]["scene"].contains("mjcf"));
  CHECK_FALSE(summary["header"]["machine"].contains("document"));
  CHECK_FALSE(summary["header"].contains("graph"));
  CHECK_THAT(served.get("/api/runs/below.cut_one")["trouble"].get<std::string>(), Contains("cut short"));
}

TEST_CASE("records are chosen by kind, time and number") {
  Served served;
  CHECK(column(served.get("/api/runs/small/records")["records"], "n").size() == 22);
  CHECK(column(served.get("/api/runs/small/records?kind=transition,act")["records"], "n") ==
        Json{5, 8, 13, 14, 15, 16});
  CHECK(column(served.get("/api/runs/small/records?from=2&to=3.05&kind=input")["records"], "n") == Json{7, 10});
  const auto page = served.get("/api/runs/small/records?after=3&limit=2");
  CHECK(column(page["records"], "n") == Json{3, 4});
  CHECK(page["next"] == 5);
  CHECK(served.get("/api/runs/small/records?after=21")["next"].is_null());
  CHECK(served.get("/api/runs/small/records?kind=nothing")["records"].empty());
}

TEST_CASE("the graph counts what was visited") {
  Served served;
  const auto graph = served.get("/api/runs/small/graph");
  CHECK(graph["start"] == "Wait");
  CHECK(column(graph["states"], "visits") == Json{1, 2});
  CHECK(column(graph["edges"], "visits") == Json{1, 1, 1, 0});
}

TEST_CASE("a transition that a gate turned away has an edge of its own") {
  const ScratchFolder folder;
  LogBuilder log;
  const Json edge{{"id", "a"},    {"from", "A"},          {"to", "B"},
                  {"input", "x"}, {"condition", nullptr}, {"operation", "push"}};
  log.add("run", 0,
          {{"version", 1}, {"graph", {{"states", Json::array()}, {"start", "A"}, {"edges", Json::array({edge})}}}});
  log.add("transition", 1, transition_fields("a", "A", "Refuge", 1, 1));
  InspectorApi api({folder.write("gate.run.jsonl", log.text())});
  const auto edges = Json::parse(api.get("/api/runs/gate/graph").body)["edges"];
  REQUIRE(edges.size() == 2);
  CHECK(edges[0]["visits"] == 0);
  CHECK(edges[1]["to"] == "Refuge");
  CHECK(edges[1]["input"] == "x");
  CHECK(edges[1]["diverted"] == true);
  CHECK(edges[1]["visits"] == 1);
}

TEST_CASE("refusals of pointing samples are counted apart and are no stops") {
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("input", 1, {{"event", {{"kind", "pointing"}, {"hand", "left"}}}, {"symbol", "p"}});
  log.add("refusal", 1, {{"state", "A"}, {"input", "p"}, {"reason", "nobody asked"}}, 1);
  log.add("input", 2, {{"event", {{"kind", "speech"}, {"text", "x"}}}, {"symbol", "x"}});
  log.add("refusal", 2, {{"state", "A"}, {"input", "x"}, {"reason", "no"}}, 3);
  InspectorApi api({folder.write("refused.run.jsonl", log.text())});
  const auto summary = Json::parse(api.get("/api/runs/refused").body);
  const Columns columns(api.get("/api/runs/refused/columns").body);
  CHECK(summary["refusals"] == 2);
  CHECK(summary["refused_samples"] == 1);
  CHECK(columns.numbers("stop") == std::vector<double>{3, 4});
  CHECK(columns.numbers("flag.n") == std::vector<double>{4});
}

TEST_CASE(
    "a run is judged by its acts, opens at the one that failed, and a gesture's end that nobody awaited is no flag") {
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("utterance", 1, {{"text", "Which block?"}});
  log.add("input", 2, {{"event", {{"kind", "gesture"}, {"name", "yes"}, {"phase", "stop"}}}, {"symbol", "y"}});
  log.add("refusal", 2, {{"state", "A"}, {"input", "y"}, {"reason", "no"}}, 2);
  const auto act = [&](int number, const char* status, const Json& more = Json::object(), int cause = -1) {
    Json fields{{"act", number}, {"program", "put(b, on(c))"}, {"status", status}};
    fields.update(more);
    return static_cast<int>(log.add("act", 3, fields, cause));
  };
  act(1, "done", Json::object(), act(1, "asked"));
  act(2, "stopped", Json::object(), act(2, "asked"));
  const auto third = act(3, "asked");
  act(3, "blocked", {{"step", 1}}, third);
  const auto failed = act(3, "blocked", {{"result", {{"reason", "it would fall"}}}}, third);
  act(4, "asked");
  InspectorApi api({folder.write("acts.run.jsonl", log.text())});
  const auto summary = Json::parse(api.get("/api/runs/acts").body);
  CHECK(summary["acts"] == 4);
  CHECK(summary["acts_done"] == 1);
  CHECK(summary["acts_failed"] == 1);
  CHECK(summary["first_failed"] == Json{{"n", failed}, {"status", "blocked"}, {"reason", "it would fall"}});
  CHECK(summary["first"] == failed);
  const Columns columns(api.get("/api/runs/acts/columns").body);
  CHECK(columns.numbers("flag.n") == std::vector<double>{static_cast<double>(failed)});
}

TEST_CASE("the stack at a record tells what its last change did") {
  Served served;
  const auto pushed = served.get("/api/runs/small/stack?n=6");
  CHECK(pushed["at"] == 5);
  CHECK(column(pushed["symbols"], "change") == Json{"added", "added"});
  CHECK(pushed["symbols"][0]["slots_changed"]["options"]["now"] == "[block2, block3]");

  const auto kept = served.get("/api/runs/small/stack?n=9");
  CHECK(kept["at"] == 8);
  CHECK(column(kept["symbols"], "change") == Json{"same", "same"});

  const auto rewritten = served.get("/api/runs/small/stack?n=13");
  CHECK(column(rewritten["symbols"], "change") == Json{"changed", "same"});
  CHECK(
      compact(rewritten["symbols"][0]["slots_changed"]) ==
      R"j({"action":{"was":"\\b. put(b, on(block1))","now":"put(block2, on(block1))"},"options":{"was":"[block2, block3]","now":null}})j");
  CHECK(rewritten["removed"].empty());

  CHECK(served.get("/api/runs/small/stack?n=2")["at"].is_null());
}

TEST_CASE("a pop leaves the removed symbols to be seen") {
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  for (int id = 1; id <= 3; ++id)
    log.add("symbol", 0, {{"id", id}, {"below", id > 1 ? Json(id - 1) : Json()}, {"slots", {{"depth", id}}}});
  log.add("transition", 1, transition_fields("a", "A", "A", 3, 3));
  log.add("transition", 2, transition_fields("b", "A", "A", 1, 1));
  InspectorApi api({folder.write("pop.run.jsonl", log.text())});
  const auto stack = Json::parse(api.get("/api/runs/pop/stack?n=5").body);
  CHECK(column(stack["symbols"], "id") == Json::array({1}));
  CHECK(column(stack["symbols"], "change") == Json::array({"same"}));
  CHECK(column(stack["removed"], "id") == Json{3, 2});
}

TEST_CASE("a derivation leads back to all that contributed") {
  Served served;
  const auto why = served.get("/api/runs/small/derivation?n=16");
  CHECK(column(why["chain"], "n") == Json{16, 15, 14, 13, 10});
  CHECK(column(why["applications"], "n") == Json{3, 11});
  CHECK(column(why["inputs"], "n") == Json{2, 10});
  CHECK_THAT(why["inputs"][0]["brief"].get<std::string>(), Contains("Put it there."));
  CHECK(served.get("/api/runs/small/derivation?n=9")["applications"].empty());
}

TEST_CASE("what cannot be answered is said with its status") {
  Served served;
  CHECK_THAT(served.message("/api/nothing", 404), Contains("/api/nothing"));
  CHECK_THAT(served.message("/api/runs/none", 404), Contains("no run 'none'"));
  CHECK_THAT(served.message("/api/runs/garbage/columns", 422), Contains("not a run log"));
  CHECK_THAT(served.message("/api/runs/small/nothing", 404), Contains("nothing"));
  CHECK_THAT(served.message("/api/runs/small/stack", 400), Contains("n is missing"));
  CHECK_THAT(served.message("/api/runs/small/stack?n=22", 400), Contains("records 0 to 21"));
  CHECK_THAT(served.message("/api/runs/small/stack?n=-1", 400), Contains("n=-1"));
  CHECK_THAT(served.message("/api/runs/small/records?limit=many", 400), Contains("limit=many"));
  CHECK_THAT(served.message("/api/runs/small/frame?t=1", 501), Contains("not served"));
  CHECK_THAT(served.message("/api/sessions", 501), Contains("not served"));
  CHECK_THAT(served.message("/api/runs/small/labels?n=5,22", 400), Contains("records 0 to 21"));
  CHECK_THAT(served.message("/api/runs/small/labels?from=x", 400), Contains("from=x"));
  CHECK(served.get("/api/runs/small/labels?from=20&limit=50")["labels"].size() == 2);
}

TEST_CASE("records are given as they stand in the log, and one that is no JSON is named") {
  Served served;
  auto text = small_log().text();
  const auto second = text.find('\n') + 1, third = text.find('\n', second) + 1;
  const auto given = served.api.get("/api/runs/small/records?after=1&limit=1").body;
  CHECK(given == "{\"records\":[" + text.substr(second, third - second - 1) + "],\"next\":2}");
  text.insert(third - 2, ",\"more\":tru");
  served.write("broken.run.jsonl", text, 30);
  CHECK(served.get("/api/runs/broken/records?limit=1")["next"] == 1);
  CHECK_THAT(served.message("/api/runs/broken/records", 500), Contains("broken.run.jsonl:2: not valid JSON"));
}

TEST_CASE("two runs are held against each other") {
  Served served;
  auto other = small_log().text();
  const std::string said = "Which block?";
  other.replace(other.find(said), said.size(), "Which one?  ");
  served.folder.write("other.run.jsonl", other);
  CHECK(served.get("/api/diff?a=small&b=small")["sameness"] == "same");
  const auto diff = served.get("/api/diff?a=small&b=other");
  CHECK(diff["same"] == false);
  CHECK(diff["differences"].size() == 1);
  CHECK(diff["differences"][0]["a"][0]["brief"] == "“Which block?”");
  CHECK(served.get("/api/diff?a=small&b=other") == diff);
  CHECK_THAT(served.message("/api/diff?a=small", 400), Contains("b is missing"));
  CHECK_THAT(served.message("/api/diff?a=small&b=none", 404), Contains("no run 'none'"));
  CHECK_THAT(served.message("/api/diff?a=small&b=garbage", 422), Contains("not a run log"));
  CHECK_THAT(served.message("/api/diff?a=small&b=other&tolerance=-1", 400), Contains("tolerance=-1"));

  // Answers are kept as long as both logs are as they were.
  served.folder.write("other.run.jsonl", small_log().text());
  CHECK(served.get("/api/diff?a=small&b=other")["sameness"] == "same");
}

TEST_CASE("no address leads out of the served folders") {
  Served served;
  const ScratchFolder outside;
  outside.write("secret.run.jsonl", small_log().text());
  for (const std::string& id : {"../" + outside.path() + "/secret", std::string("..%2f..%2fetc%2fpasswd"),
                                outside.path() + "/secret.run.jsonl"})
    CHECK(served.api.get("/api/runs/" + id).status == 404);
}

TEST_CASE("a target is split and decoded") {
  const auto [path, query] = split_target("/api/runs/a%20b?kind=a%2Cb&text=x+y&flag&kind=second");
  CHECK(path == "/api/runs/a b");
  CHECK(query.at("kind") == "a,b");
  CHECK(query.at("text") == "x y");
  CHECK(query.at("flag").empty());
}

TEST_CASE("of several configurations each has its stack") {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}, {"machine", "m"}, {"scene", "s"}});
  log.add("symbol", 0, {{"id", 1}, {"below", nullptr}, {"slots", {{"x", "a"}}}}, 0);
  log.add("branches", 0,
          {{"branches",
            {{{"id", 0}, {"parent", 0}, {"state", "A"}, {"stack", 1}, {"depth", 1}},
             {{"id", 1}, {"parent", 0}, {"state", "B"}, {"stack", nullptr}, {"depth", 0}}}}});
  log.add("symbol", 1, {{"id", 2}, {"below", 1}, {"slots", {{"x", "b"}}}}, 0);
  log.add("branches", 1, {{"branches", {{{"id", 2}, {"parent", 0}, {"state", "C"}, {"stack", 2}, {"depth", 2}}}}});
  log.add("branches", 2, {{"branches", "none"}});
  const ScratchFolder folder;
  folder.write("many.run.jsonl", log.text());
  InspectorApi api({folder.path()});

  const auto stack = [&](const std::string& query) { return api.get("/api/runs/many/stack?" + query); };
  const auto leading = Json::parse(stack("n=2&branch=0").body);
  CHECK(leading["branch"]["state"] == "A");
  CHECK(leading["depth"] == 1);
  CHECK(leading["depth_before"] == 0);
  const auto grown = Json::parse(stack("n=4&branch=2").body);
  CHECK(grown["at"] == 4);
  CHECK(grown["depth_before"] == 1);
  CHECK(grown["symbols"][0]["change"] == "added");
  CHECK(Json::parse(stack("n=3&branch=1").body)["symbols"].empty());
  for (const auto& [query, status] :
       {std::pair{"n=4&branch=0", 404}, {"n=1&branch=0", 404}, {"n=5&branch=2", 404}, {"n=4&branch=x", 400}})
    CHECK(stack(query).status == status);
  CHECK(stack("n=4&branch=0").body.find("there are 2") != std::string::npos);
}
