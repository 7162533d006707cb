// "What if?": until an instant the run is the trace's own, from then on the changes count.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/commands/replay.h"
#include "continua/replay/session/session.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const fs::path traces = fs::path(source_dir()) / "traces";

// Counts its inputs, on the stack and in a register; `back` returns to the state of the last question.
const char* counter = R"json({"machine":1,"name":"counter","start":"Idle",
  "slots":{"word":"text","spot":"loc"},"memory":{"heard":{"type":"text","initial":"'none'"}},
  "states":{"Idle":{},"Told":{"enter":[{"say":"Told {word}."}]},"Asked":{"enter":[{"say":"Last was {heard}."}]}},
  "transitions":[
  {"id":"one","from":"*","on":"speech one","to":"Told","push":{"word":"'one'"},"do":[{"remember":{"heard":"'one'"}}]},
  {"id":"two","from":"*","on":"speech two","to":"Told","push":{"word":"'two'"},"do":[{"remember":{"heard":"'two'"}}]},
  {"id":"ask","from":"Told","on":"speech ask","to":"Asked"},
  {"id":"again","from":"Asked","on":"speech again","to":"Told","weight":2},
  {"id":"afresh","from":"Asked","on":"speech again","to":"Idle"},
  {"id":"back","from":"*","on":"speech back","to":"Told","pop_until":"Asked"}]})json";

const std::string head = R"({"kind":"trace","version":1,"scene":"staircase","machine":"counter.json"})";

std::string said_at(std::initializer_list<std::pair<double, const char*>> events) {
  std::string text = head + "\n";
  for (const auto& [t, words] : events)
    text += fmt::format("{{\"t\":{},\"kind\":\"speech\",\"text\":\"{}\"}}\n", t, words);
  return text;
}

struct Run {
  ReplaySummary summary;
  std::vector<Json> records;

  // The records, without the header and its digests, are the same up to the first at or after the instant.
  void check_same_until(double t, const Run& other) const {
    for (std::size_t i = 1; i < records.size() && records[i]["t"] < t && records[i]["kind"] != "end"; ++i) {
      REQUIRE(i < other.records.size());
      if (records[i]["kind"] != "block") CHECK(records[i] == other.records[i]);
    }
  }
  std::string told(const std::string& kind, const char* field, double from = 0) const {
    std::string all;
    for (const auto& record : records)
      if (record["kind"] == kind && record["t"] >= from) all += record[field].get<std::string>() + " ";
    return all;
  }
};

// The run, or the reason for its absence.
Result<Run> run_of(const std::string& trace, ReplayOptions options = {}) {
  options.physics = false;
  auto session = Session::load(trace, std::move(options));
  if (!session) return session.error();
  std::stringstream log;
  Run run{session->run(log), {}};
  if (run.summary.stopped) return *run.summary.stopped;
  for (std::string line; std::getline(log, line);) run.records.push_back(Json::parse(line));
  return run;
}

Run done(const std::string& trace, const ReplayOptions& options = {}) {
  auto run = run_of(trace, options);
  if (!run) FAIL(run.error().text());
  return std::move(*run);
}

struct Lab {
  Lab() {
    folder.file("counter.json", counter);
    trace =
        folder.file("x.trace.jsonl",
                    said_at({{1, "one"}, {2, "ask"}, {3, "two"}, {4, "back"}, {5, "ask"}, {6, "again"}, {7, "ask"}}));
  }

  // The machine with one piece of its text replaced.
  std::string edited(const std::string& old, const std::string& by) const {
    std::string text = counter;
    for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size()))
      text.replace(at, old.size(), by);
    return folder.file("edited.json", text);
  }

  TemporaryFolder folder;
  std::string trace;
};

ReplayOptions from(double t) {
  ReplayOptions options;
  options.from = t;
  return options;
}

}  // namespace

TEST_CASE("where nothing is changed, what if is what was, but for the header and its digests") {
  for (const std::string name : {"paper/correction", "paper/dialogue_gesture", "paper/disambiguation",
                                 "paper/one_shot_learning", "paper/special_npda", "talk/n_best", "talk/staircase"}) {
    CAPTURE(name);
    const auto path = (traces / (name + ".trace.jsonl")).string();
    ReplayOptions options;
    options.shelf = std::make_shared<Shelf>();
    const auto plain = done(path, options);
    std::vector<double> times;
    for (const auto& input : plain.records)
      if (input["kind"] == "input" && input["line"].is_number()) times.push_back(input["t"]);
    for (const double t : {0.0, times.front(), times[times.size() / 2], times.back()}) {
      options.from = t;
      if (t == times.back()) options.with = path;
      const auto what_if = done(path, options);
      REQUIRE(what_if.summary.changed);
      REQUIRE(what_if.records.size() == plain.records.size());
      what_if.check_same_until(1e9, plain);
      CHECK(what_if.records.back()["decisions"] == plain.records.back()["decisions"]);
      auto header = what_if.records.front();
      CHECK(header["what_if"]["from"] == t);
      CHECK(header["what_if"].size() == (options.with.empty() ? 1 : 2));
      header.erase("what_if");
      CHECK(header == plain.records.front());
    }
  }
}

TEST_CASE("from the instant on another machine answers, in the state, on the stack and with the registers that were") {
  const Lab lab;
  const auto plain = done(lab.trace);
  CHECK(plain.told("utterance", "text") ==
        "Told one. Last was one. Told two. Told one. Last was two. Told one. Last was two. ");

  auto options = from(3.5);
  options.machine = lab.edited("Last was", "It was");
  const auto what_if = done(lab.trace, options);
  what_if.check_same_until(3.5, plain);
  CHECK(what_if.told("utterance", "text") ==
        "Told one. Last was one. Told two. Told one. It was two. Told one. It was two. ");
  const auto& header = what_if.records.front();
  CHECK(header["machine"]["name"] == "counter");
  CHECK(header["machine"] == plain.records.front()["machine"]);
  CHECK(header["what_if"]["machine"]["document"] == Json::parse(read_file(options.machine).value()));
  CHECK(header["what_if"].size() == 2);

  // Step numbers, symbols and acts run on.
  std::vector<int> steps, symbols;
  for (const auto& record : what_if.records) {
    if (record["kind"] == "transition") steps.push_back(record["step"]);
    if (record["kind"] == "symbol") symbols.push_back(record["id"]);
  }
  CHECK(steps == std::vector<int>{1, 2, 3, 4, 5, 6, 7});
  CHECK(symbols == std::vector<int>{0, 1, 2});
}

TEST_CASE("slots and registers go over by name, whatever their order") {
  const Lab lab;
  auto options = from(3.5);
  options.machine = lab.edited(R"("slots":{"word":"text","spot":"loc"},"memory":{)",
                               R"("slots":{"more":"e","spot":"loc","word":"text"},"memory":{"new":{"type":"e"},)");
  const auto what_if = done(lab.trace, options);
  CHECK(what_if.told("utterance", "text") ==
        "Told one. Last was one. Told two. Told one. Last was two. Told one. Last was two. ");
}

TEST_CASE("what the edited machine has no place for is told with the nearest name") {
  const Lab lab;
  struct Row {
    double from;
    const char *old, *by, *told;
  };
  for (const auto& [t, old, by, told] :
       std::vector<Row>{{2.5, "Asked", "Askedd",
                         "the run is in the state 'Asked', which this machine lacks (did you mean 'Askedd'?)"},
                        {3.5, "Asked", "Askedd", ""},
                        {2.5, "word", "worded",
                         "the stack's slot 'word' holds 'one', and this machine lacks it (did you mean 'worded'?)"},
                        {0.5, "word", "worded", ""},
                        {2.5, "heard", "heart",
                         "the register 'heard' holds 'one', and this machine lacks it (did you mean 'heart'?)"},
                        {0.5, "heard", "heart", ""},
                        {2.5, R"("word":"text","spot":"loc")", R"("word":"e","spot":"loc")",
                         "of type text; this machine has it for"},
                        {2.5, R"(,"spot":"loc")", "", ""}}) {
    CAPTURE(t, old, by);
    auto options = from(t);
    std::string text = lab.edited(old, by);
    // An utterance or a register of another type would not make a machine.
    if (std::string(told).find("of type") != std::string::npos)
      text = lab.folder.file("edited.json", R"json({"machine":1,"name":"other","start":"Asked","slots":{"word":"e"},
        "memory":{"heard":{"type":"text"}},"states":{"Asked":{}},"transitions":[]})json");
    options.machine = text;
    const auto what_if = run_of(lab.trace, options);
    CHECK(what_if.ok() == std::string(told).empty());
    if (!what_if) CHECK(what_if.error().text().find(told) != std::string::npos);
  }
}

TEST_CASE("choice, seed and force count from the instant on, steps as in the whole run") {
  const Lab lab;
  auto options = from(4.5);
  options.forced = {{6, "afresh"}};
  auto what_if = done(lab.trace, options);
  CHECK(what_if.told("transition", "id") == "one ask two back ask afresh ");
  CHECK(what_if.records.front()["forced"] == Json::object());
  CHECK(what_if.records.front()["what_if"]["forced"] == Json{{"6", "afresh"}});
  CHECK(what_if.summary.not_forced.empty());

  options.forced = {{4, "afresh"}};
  what_if = done(lab.trace, options);
  CHECK(what_if.told("transition", "id") == "one ask two back ask again ask ");
  CHECK(what_if.summary.not_forced == options.forced);

  options = from(100);
  options.forced = {{8, "afresh"}};
  what_if = done(lab.trace, options);
  CHECK_FALSE(what_if.summary.changed);
  CHECK(what_if.summary.not_forced.size() == 1);

  options = from(4.5);
  options.choice = Choice::explore;
  what_if = done(lab.trace, options);
  CHECK(what_if.told("transition", "id", 4.5) == "ask again ask ");
  CHECK(std::any_of(what_if.records.begin(), what_if.records.end(),
                    [](const Json& record) { return record["kind"] == "branches"; }));
  CHECK(what_if.records.front()["what_if"]["choice"] == "explore");

  options = from(4.5);
  options.choice = Choice::sample;
  std::set<std::string> taken;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    options.seed = seed;
    what_if = done(lab.trace, options);
    taken.insert(what_if.told("transition", "id"));
  }
  CHECK(taken == std::set<std::string>{"one ask two back ask again ask ", "one ask two back ask afresh "});
}

TEST_CASE("from explore on one branch is gone on with") {
  const Lab lab;
  lab.folder.file("counter.json", std::string(counter).replace(1, 0, R"("choice":"explore",)"));
  auto options = from(6.5);
  options.choice = Choice::likeliest;
  const auto what_if = done(lab.trace, options);
  CHECK(what_if.told("transition", "id") == "one ask two back ask again ask ");
  std::set<int> symbols;
  int last = 0;
  for (const auto& record : what_if.records) {
    if (record["kind"] == "symbol") CHECK(symbols.insert(record["id"].get<int>()).second);
    if (record["kind"] == "transition")
      CHECK(std::exchange(last, record["step"].get<int>()) < record["step"].get<int>());
  }
}

TEST_CASE("an edited trace takes over at the instant") {
  const Lab lab;
  const auto edited = said_at({{0.5, "two"}, {3, "one"}, {4, "ask"}});
  auto options = from(3);
  options.with = lab.folder.file("edited.trace.jsonl", edited);
  const auto what_if = done(lab.trace, options);
  what_if.check_same_until(3, done(lab.trace));
  CHECK(what_if.told("input", "symbol") == "speech one speech ask speech one speech ask ");
  const auto& header = what_if.records.front();
  CHECK(header["trace"]["name"] == "x.trace.jsonl");
  CHECK(header["what_if"]["trace"]["name"] == "edited.trace.jsonl");
  CHECK(header["what_if"].size() == 2);

  // Its machine and seed count, and oddities in its lines are told when they come.
  lab.edited("Last was", "It was");
  auto other = edited;
  other.replace(other.find("counter.json"), 12, "edited.json").replace(other.find("\"version\""), 0, "\"seed\":3,");
  lab.folder.file("edited.trace.jsonl", other + "{\"t\":5,\"kind\":\"wink\"}\n");
  const auto whole = done(lab.trace, options);
  CHECK(whole.told("utterance", "text") == "Told one. Last was one. Told one. It was one. ");
  CHECK(whole.records.front()["what_if"]["seed"] == 3);
  const auto note = std::find_if(whole.records.begin(), whole.records.end(),
                                 [](const Json& record) { return record["kind"] == "problem"; });
  REQUIRE(note != whole.records.end());
  CHECK((*note)["t"] == 3.0);
}

TEST_CASE("what cannot change in mid-run is told") {
  const Lab lab;
  auto options = from(3);
  const auto with = [&](const std::string& first_line) {
    options.with = lab.folder.file("edited.trace.jsonl", first_line + "\n");
    const auto run = run_of(lab.trace, options);
    return run.ok() ? std::string() : run.error().text();
  };
  CHECK(with(head).empty());
  CHECK(with(R"({"kind":"trace","version":1})").empty());
  CHECK(with(R"({"kind":"trace","version":1,"scene":"place_setting","machine":"counter.json"})")
            .find("edited.trace.jsonl:1: found another 'scene'") != std::string::npos);
  CHECK(with(R"({"kind":"trace","version":1,"scene":"staircase","machine":"counter.json","objects":{"block1":null}})")
            .find("edited.trace.jsonl:1: found other 'objects'") != std::string::npos);
  CHECK(with("{}").find("edited.trace.jsonl:1") != std::string::npos);
  options.from.reset();
  CHECK(with(head).find("--with: found no --from") != std::string::npos);
}

TEST_CASE("the command leaves no run that was stopped, and does not take the place of the run itself") {
  const Lab lab;
  const auto before = fs::current_path();
  fs::current_path(lab.folder.path());
  ReplayCommandOptions options;
  options.traces = {lab.trace};
  options.replay.physics = false;
  options.replay.from = 2.5;
  CHECK(run_replay(options) == exit_done);
  CHECK(fs::exists("x.what_if.run.jsonl"));
  CHECK_FALSE(fs::exists("x.run.jsonl"));
  options.replay.machine = lab.edited("Asked", "Aksed");
  options.output = lab.folder.at("stopped.run.jsonl");
  CHECK(run_replay(options) == exit_impossible);
  CHECK_FALSE(fs::exists(options.output));
  fs::current_path(before);
}
