#include <map>
#include <sstream>

#include "continua/replay/export/chrome.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

Json events_of(const std::string& log) {
  const auto run = RunIndex::of_text(log, "small.run.jsonl").value();
  std::ostringstream out;
  REQUIRE_FALSE(export_chrome(run, out));
  return Json::parse(out.str())["traceEvents"];
}

// "ts name" of the events of a phase, one a line; with how long they last, if they say it.
std::string told(const Json& events, const std::string& phase) {
  std::string text;
  for (const auto& event : events) {
    if (event["ph"] != phase) continue;
    text += compact(event["ts"]) + (event.contains("dur") ? "+" + compact(event["dur"]) : "") + " " +
            event["name"].get<std::string>() + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("a time line has what was done and said, the states one after the other, and acts as spans") {
  const auto events = events_of(small_log().text());
  CHECK(told(events, "X") ==
        "0+1500000 Wait\n1500000+1500000 AskWhichBlock\n3000000+7000000 Wait\n"
        "1500000+1000000 “Put it there.”\n3000000+1000000 right point start\n"
        "1500000+40000 ask\n2000000+40000 stay\n3000000+40000 agree\n"
        "1500000+1000000 “Which block?”\n"
        "3100000+1900000 put(block2, on(block1))\n");
}

TEST_CASE("steps are spans inside of their act, and end with it") {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  const auto act = [&](double t, const char* program, const char* status, int step) {
    Json fields{{"act", 1}, {"program", program}, {"status", status}};
    if (step > 0) fields["step"] = step;
    log.add("act", t, fields);
  };
  act(1, "put(a, on(b))", "asked", 0);
  act(1, "put(a, on(b))", "started", 0);
  act(1, "grasp(a)", "started", 1);
  act(2, "grasp(a)", "done", 1);
  act(2, "move(a, on(b))", "started", 2);
  act(3, "put(a, on(b))", "dropped", 0);
  act(4, "lift(a)", "started", 0);
  log.add("rest", 6);
  const auto events = events_of(log.text());
  CHECK(told(events, "X") ==
        "1000000+2000000 put(a, on(b))\n1000000+1000000 grasp(a)\n2000000+1000000 move(a, on(b))\n"
        "4000000+2000000 lift(a)\n");
}

TEST_CASE("slices of a lane nest or follow one another, and arrows lead from causes to what came of them") {
  const auto run = RunIndex::open(source_dir() + "/traces/building_blocks.run.jsonl");
  REQUIRE(run);
  std::ostringstream out;
  REQUIRE_FALSE(export_chrome(*run, out));
  const Json events = Json::parse(out.str())["traceEvents"];
  std::map<int, std::vector<std::pair<std::int64_t, std::int64_t>>> lanes;
  std::map<std::int64_t, std::int64_t> begun;
  std::size_t arrows = 0;
  for (const auto& event : events) {
    const std::int64_t from = event.value("ts", 0);
    if (event["ph"] == "X") {
      auto& open = lanes[event["tid"].get<int>()];
      const auto until = from + event["dur"].get<std::int64_t>();
      while (!open.empty() && open.back().second <= from) open.pop_back();
      if (!open.empty()) CHECK((open.back().first <= from && until <= open.back().second));
      open.emplace_back(from, until);
    } else if (event["ph"] == "s") {
      begun[event["id"].get<std::int64_t>()] = from;
    } else if (event["ph"] == "f") {
      ++arrows;
      REQUIRE(begun.contains(event["id"].get<std::int64_t>()));
      CHECK(begun[event["id"].get<std::int64_t>()] <= from);
    }
  }
  CHECK(lanes.size() == 5);
  CHECK(arrows > 100);
}

TEST_CASE("of a log cut short what there is makes a time line") {
  const auto text = small_log().text();
  for (const auto length : {text.find('\n') + 1, text.size() / 2, text.size() - 3}) {
    const auto events = events_of(text.substr(0, length));
    CHECK(events.size() >= 11);
    for (const auto& event : events) CHECK((event["ph"] == "M" || event["ts"].is_number_integer()));
  }
}
