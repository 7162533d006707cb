#include "continua/replay/inspector/run_columns.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "continua/core/characters.h"
#include "continua/replay/inspector/run_find.h"
#include "continua/replay/inspector/run_labels.h"
#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_listing.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/columns.h"
#include "support/folders.h"

using namespace continua;

namespace {

RunIndex index_of(const std::string& text) {
  auto run = RunIndex::of_text(text, "run");
  INFO((run ? "" : run.error().text()));
  REQUIRE(run.ok());
  return *std::move(run);
}

// The whole log as parsed records.
std::vector<Json> records_of(const RunIndex& run) {
  std::vector<Json> records;
  for (std::size_t n = 0; n < run.size(); ++n) records.push_back(*run.record(n));
  return records;
}

bool is_integer(const Json& value) { return value.is_number_integer(); }

// The expected columns, computed slowly from parsed records.
struct Naive {
  explicit Naive(const RunIndex& run) : records(records_of(run)) {
    for (std::size_t n = 0; n < records.size(); ++n) add(n);
  }

  void add(std::size_t n) {
    const auto& record = records[n];
    const auto kind = text_of(record, "kind");
    const auto& event = member_of(record, "event");
    const auto& cause = member_of(record, "cause");
    if (kind == "input" && text_of(event, "kind") == "pointing") sampled.insert(n);
    if (is_integer(cause) && sampled.count(cause.get<std::size_t>())) sampled.insert(n);
    const bool input = kind == "input";
    if (input && text_of(event, "kind") == "speech") lanes["speech"].push_back(n);
    if (input && text_of(event, "kind") == "gesture" && text_of(event, "phase") != "stop")
      lanes["gesture"].push_back(n);
    if (input && member_of(event, "confidence").is_number()) lanes["confidence"].push_back(n);
    if (kind == "utterance" || kind == "observed" || kind == "rest") lanes[kind].push_back(n);
    if (kind == "gesture") lanes["move"].push_back(n);
    if (kind == "act" && !record.contains("step") && acts.insert(compact(member_of(record, "act"))).second)
      lanes["act"].push_back(n);
    if (input && text_of(event, "kind") == "gesture" && text_of(event, "phase") == "stop") ends.insert(n);
    const bool of_end = is_integer(cause) && ends.count(cause.get<std::size_t>());
    if (kind == "problem" || (kind == "refusal" && !sampled.count(n) && !of_end) ||
        (kind == "expect" && member_of(record, "met") == false) ||
        (kind == "act" && !record.contains("step") &&
         !std::set<std::string>{"asked", "started", "done", "stopped"}.count(text_of(record, "status"))))
      lanes["flag"].push_back(n);
    if (kind == "branches" && member_of(record, "branches").size() > 1) {
      lanes["branches"].push_back(n);
      branch_counts.push_back(member_of(record, "branches").size());
    }
    bool changed = false;
    if (record.contains("stack")) {
      const auto top = is_integer(record["stack"]) ? record["stack"].get<std::int64_t>() : -1;
      changed = top != stack;
      stack = top;
      const auto& written = member_of(record, "depth");
      const auto deep = is_integer(written) ? written.get<std::size_t>() : depth_below(n, top);
      if (depths.empty() || depths.back() != deep) {
        lanes["depth"].push_back(n);
        depths.push_back(deep);
      }
    }
    if (kind == "transition") {
      step_depths.push_back(depths.empty() ? 0 : depths.back());
      for (const char* part : {"id", "from", "to"}) steps[part].push_back(text_of(record, part));
    }
    const std::set<std::string> never{"run",    "symbol", "rest",     "end",  "memory",
                                      "belief", "block",  "observed", "pose", "branched"};
    const bool step = kind == "transition" || kind == "rewrite";
    if (!never.count(kind) && (!sampled.count(n) || (kind != "input" && kind != "refusal" && (!step || changed))))
      stops.push_back(n);
  }

  std::size_t depth_below(std::size_t n, std::int64_t top) const {
    for (std::size_t i = 0; i < n; ++i)
      if (text_of(records[i], "kind") == "symbol" && member_of(records[i], "id") == top)
        return 1 + depth_below(i, is_integer(member_of(records[i], "below"))
                                      ? member_of(records[i], "below").get<std::int64_t>()
                                      : -1);
    return 0;
  }

  std::vector<Json> records;
  std::set<std::size_t> sampled, ends;
  std::set<std::string> acts;
  std::map<std::string, std::vector<std::size_t>> lanes;
  std::map<std::string, std::vector<std::string>> steps;
  std::vector<std::size_t> stops, depths, step_depths, branch_counts;
  std::int64_t stack = -1;
};

void check_columns(const std::string& text) {
  const auto run = index_of(text);
  const Naive naive(run);
  const auto bytes = run_columns(run);
  REQUIRE(bytes.ok());
  const Columns columns(*bytes);
  CHECK(columns.header["records"] == run.size());
  CHECK(columns.header["complete"] == run.complete());
  const auto t = columns.numbers("t"), kind = columns.numbers("kind"), cause = columns.numbers("cause");
  REQUIRE(t.size() == run.size());
  for (std::size_t n = 0; n < run.size(); ++n) {
    CHECK(t[n] == Approx(naive.records[n]["t"].get<double>()).margin(1e-6));
    CHECK(columns.header["kinds"][static_cast<std::size_t>(kind[n])] == naive.records[n]["kind"]);
    const auto& of = member_of(naive.records[n], "cause");
    CHECK(cause[n] == (is_integer(of) && of.get<std::size_t>() < n ? of.get<double>() : -1));
  }
  const auto as_numbers = [](const std::vector<std::size_t>& values) {
    return std::vector<double>(values.begin(), values.end());
  };
  CHECK(columns.numbers("stop") == as_numbers(naive.stops));
  for (const char* lane : {"speech", "gesture", "utterance", "move", "observed", "act", "rest", "flag", "branches",
                           "confidence", "depth"}) {
    INFO(lane);
    const auto found = naive.lanes.find(lane);
    const auto n = columns.numbers(std::string(lane) + ".n"), from = columns.numbers(std::string(lane) + ".from"),
               to = columns.numbers(std::string(lane) + ".to");
    CHECK(n == (found == naive.lanes.end() ? std::vector<double>() : as_numbers(found->second)));
    REQUIRE(from.size() == n.size());
    REQUIRE(to.size() == n.size());
    for (std::size_t i = 0; i < n.size(); ++i) CHECK(from[i] <= to[i]);
  }
  CHECK(columns.numbers("depth.value") == as_numbers(naive.depths));
  CHECK(columns.numbers("step.depth") == as_numbers(naive.step_depths));
  CHECK(columns.numbers("branches.count") == as_numbers(naive.branch_counts));
  for (const char* part : {"id", "from", "to"}) {
    const auto found = naive.steps.find(part);
    CHECK(columns.names(std::string("step.") + part) ==
          (found == naive.steps.end() ? std::vector<std::string>() : found->second));
  }
  double samples = 0;
  for (const auto count : columns.numbers("pointing.count")) samples += count;
  double expected = 0;
  for (const auto& record : naive.records)
    expected += text_of(record, "kind") == "input" && text_of(member_of(record, "event"), "kind") == "pointing";
  CHECK(samples == expected);
}

void check_find(const std::string& text, const std::string& words) {
  INFO(words);
  const auto run = index_of(text);
  const RunWords run_words(run);
  std::vector<std::uint32_t> expected;
  for (std::size_t n = 0; n < run.size(); ++n) {
    const auto record = *run.record(n);
    const auto label = brief(record) + "\n" + brief_in_words(run_words, record);
    const auto told = folded(run.kind(n) + " " + (run.kind(n) == "pose" ? "" : label));
    bool all = true;
    for (std::size_t from = 0; from < words.size();) {
      const auto end = std::min(words.find(' ', from), words.size());
      all = all && told.find(folded(words.substr(from, end - from))) != std::string::npos;
      from = end + 1;
    }
    if (all) expected.push_back(static_cast<std::uint32_t>(n));
  }
  CHECK(*run_find(run, words, "*") == expected);
}

std::vector<std::string> paper_logs() {
  std::vector<std::string> texts;
  for (const auto& file : std::filesystem::directory_iterator(source_dir() + "/traces/paper")) {
    if (!file.path().string().ends_with(".run.jsonl")) continue;
    texts.push_back(read_run_log(file.path().string()).value());
  }
  REQUIRE(texts.size() > 5);
  return texts;
}

// Members of unexpected types, unknown ids, instants that run backwards, escapes.
std::string odd_log() {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("symbol", 0, {{"id", 7}, {"below", 99}, {"slots", {{"Ärger", "x\"y"}}}});
  log.add("transition", 1, {{"id", 5}, {"from", {{"a", 1}}}, {"to", nullptr}, {"stack", 7}});
  log.add("transition", 1, {{"id", "with \"quotes\""}, {"from", "A"}, {"to", "B\\C"}, {"stack", "text"}});
  log.add("transition", 1, Json::object(), 2);
  log.add("input", 2, {{"event", "no object"}});
  log.add("input", 2, {{"event", {{"kind", "speech"}, {"text", 5}, {"until", 1.0}, {"confidence", "high"}}}});
  log.add("input", 2, {{"event", {{"kind", "gesture"}, {"name", nullptr}, {"phase", "start"}, {"confidence", 0.5}}}});
  log.add("input", 2, {{"event", {{"kind", "pointing"}, {"confidence", 0.25}}}});
  log.add("refusal", 2, {{"state", 3}}, 8);
  log.add("rewrite", 2, {{"stack", nullptr}, {"operation", {1, 2}}}, 8);
  log.add("act", 3, {{"act", "one"}, {"status", {{"a", 1}}}});
  log.add("act", 3, {{"act", "one"}, {"status", "started"}});
  log.add("rest", 3, {{"from", "x"}, {"to", -5}});
  log.add("expect", 4, {{"met", "false"}});
  log.add("expect", 4, {{"met", false}, {"expected", 1e-7}});
  log.add("branches", 4, {{"branches", 7}});
  log.add("branches", 5, {{"branches", {1, 2, 3}}});
  log.add("strange", 5, {{"stack", 7}, {"deep", {{"er", {1.50, 1e20}}}}});
  return log.text();
}

}  // namespace

TEST_CASE("columns hold what the records say") {
  check_columns(small_log().text());
  for (const auto& text : paper_logs()) check_columns(text);
}

TEST_CASE("columns of odd and cut logs") {
  check_columns(odd_log());
  const auto text = small_log().text();
  for (std::size_t size = text.size() - 1; size > text.size() / 2; size -= 97) check_columns(text.substr(0, size));
}

TEST_CASE("a lane's instants and intervals") {
  const Columns columns(*run_columns(index_of(small_log().text())));
  CHECK(columns.numbers("speech.from") == std::vector<double>{1.5});
  CHECK(columns.numbers("speech.to") == std::vector<double>{2.25});
  CHECK(columns.numbers("gesture.from") == std::vector<double>{3});
  CHECK(columns.numbers("gesture.to") == std::vector<double>{10});
  CHECK(columns.numbers("act.from") == std::vector<double>{3});
  CHECK(columns.numbers("act.to") == std::vector<double>{5});
  CHECK(columns.names("act.status") == std::vector<std::string>{"done"});
  CHECK(columns.numbers("rest.from") == std::vector<double>{5.5});
  CHECK(columns.numbers("rest.to") == std::vector<double>{8});
  CHECK(columns.numbers("stop") == std::vector<double>{2, 3, 5, 6, 10, 11, 13, 14, 15, 16, 18, 19, 20});
}

TEST_CASE("labels are what brief() says and what a lane shows") {
  for (const auto& text : {small_log().text(), odd_log()}) {
    const auto run = index_of(text);
    std::vector<std::size_t> all;
    for (std::size_t n = 0; n < run.size(); ++n) all.push_back(n);
    const auto labels = (*run_labels(run, all))["labels"];
    REQUIRE(labels.size() == run.size());
    for (const auto n : all)
      CHECK(labels[std::to_string(n)][0] == (run.kind(n) == "pose" ? "" : brief(*run.record(n))));
  }
  const auto labels = (*run_labels(index_of(small_log().text()), {2, 6, 10, 14}))["labels"];
  CHECK(labels["2"][1] == "Put it there.");
  CHECK(labels["6"][1] == "Which block?");
  CHECK(labels["10"][1] == "points");
  CHECK(labels["14"][1] == "puts block2 on block1");
  CHECK(labels["14"].size() < 4);
}

TEST_CASE("a label tells why an act went otherwise") {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("act", 3, {{"act", 1}, {"status", "blocked"}, {"result", {{"reason", "cup is in the way"}}}});
  const auto labels = (*run_labels(index_of(log.text()), {1}))["labels"];
  CHECK(labels["1"][3] == "cup is in the way");
}

TEST_CASE("words are found wherever the labels tell of them") {
  const std::vector<std::string> asked{"put",   "PUT it", "input", "at",    "→",     "wait →", "5",   "0.1", "\"",
                                       "Ärger", "äRGER",  "met",   "not",   "block", "(was",   "# ",  "1.5", "1e+20",
                                       "e",     "",       "of",    "1e-07", "c",     "bodies", "5.0", "-5",  "kind"};
  auto texts = paper_logs();
  texts.resize(3);
  texts.push_back(small_log().text());
  texts.push_back(odd_log());
  for (const auto& text : texts)
    for (const auto& words : asked) check_find(text, words);
}

TEST_CASE("what is found is of the kind asked for, or worth stopping at") {
  const auto run = index_of(small_log().text());
  CHECK(*run_find(run, "wait", "transition") == std::vector<std::uint32_t>{5, 13});
  CHECK(*run_find(run, "", "act") == std::vector<std::uint32_t>{14, 15, 16});
  CHECK(run_find(run, "", "")->size() == 13);
  CHECK(run_find(run, "put", "nothing")->empty());
}

TEST_CASE("an index that grew is that of the whole log") {
  const ScratchFolder folder;
  const auto text = small_log().text();
  for (std::size_t first = 0, size = text.size() / 3; size < text.size(); size += 61, ++first) {
    const auto path = folder.write("grown.run.jsonl", text.substr(0, size));
    const auto old = RunIndex::open(path);
    REQUIRE(old.ok());
    std::ofstream(path, std::ios::binary | std::ios::app) << text.substr(size);
    const auto grown = RunIndex::grown(*old);
    REQUIRE(grown.ok());
    CHECK(grown->size() == 22);
    CHECK(grown->complete());
    CHECK(grown->trouble().empty());
    CHECK(*run_columns(*grown) == *run_columns(index_of(text)));
  }
}

TEST_CASE("a log that was written anew is read anew") {
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("utterance", 1, {{"text", "one"}});
  const auto path = folder.write("anew.run.jsonl", log.text());
  const auto old = RunIndex::open(path);
  folder.write("anew.run.jsonl", small_log().text());
  const auto anew = RunIndex::grown(*old);
  REQUIRE(anew.ok());
  CHECK(*run_columns(*anew) == *run_columns(index_of(small_log().text())));
}
