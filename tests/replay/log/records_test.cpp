#include "continua/replay/log/records.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "continua/replay/log/log_file.h"
#include "continua/replay/log/record_json.h"
#include "continua/replay/log/record_writer.h"
#include "continua/replay/log/run_log.h"
#include "log/line_of.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

const std::filesystem::path project = source_dir();

log::Record record_of(const Json& line) {
  auto record = log::read_record(line);
  INFO(compact(line));
  if (!record) FAIL(record.error().text());
  return *std::move(record);
}

// The line when it went through its record.
std::string through_record(const Json& line) { return line_of(log::stamp_of(line), record_of(line)); }

// A writer of the log and a reader of its line count the same as the record's decision. A reader tells nothing of an
// act that goes on.
void check_decision(const Json& line) {
  DecisionOrder order;
  auto read = order.next(line);
  if (const auto outcomes = order.outcomes(); !read && !outcomes.empty()) read = outcomes.front();
  log::RecordText text, decision;
  log::RecordWriter().add(log::stamp_of(line), record_of(line), text, decision);
  const auto written = decision.view();
  if (read)
    CHECK(written == compact(*read));
  else
    CHECK((written.empty() || line["kind"] == log::Act::kind.name));
}

// The record with all members that brief() is not said to read at their defaults.
template <class T>
T only_brief_members(T record) {
  const T defaults;
  log::for_each_field<T>([&](const auto& field) {
    if (!field.in_brief) record.*(field.member) = defaults.*(field.member);
  });
  return record;
}

// Calls `use(name, field)` for each member of T and, by their paths, of objects within.
template <class T, class Use>
void each_member(const std::string& above, const Use& use) {
  log::for_each_field<T>([&]<class Struct, class Value>(const log::Field<Struct, Value>& field) {
    use(above + std::string(field.name), field);
    if constexpr (log::HasFields<log::Innermost<Value>>)
      each_member<log::Innermost<Value>>(above + std::string(field.name) + ".", use);
  });
}

}  // namespace

TEST_CASE("every line of the approved runs goes through its record unchanged, and brief() reads what it says") {
  std::map<std::string, int> lines_of;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(project / "traces")) {
    if (!entry.path().string().ends_with(".run.jsonl")) continue;
    std::istringstream file(read_run_log(entry.path().string()).value());
    for (std::string line; std::getline(file, line);) {
      const auto json = Json::parse(line);
      ++lines_of[json["kind"].get<std::string>()];
      if (through_record(json) != line) FAIL(through_record(json) << " of " << line);
      check_decision(json);
      std::visit(
          [&]<class T>(const T& record) {
            if constexpr (std::is_same_v<T, log::Unknown>)
              FAIL("a kind that no struct declares: " << line);
            else
              CHECK(only_brief_members(record).brief() == record.brief());
          },
          record_of(json));
    }
  }
  log::for_each_kind([&]<class T>() {
    INFO(T::kind.name);
    const bool in_no_approved_run = T::kind.name == "forgotten" || T::kind.name == "correction";
    CHECK((lines_of[std::string(T::kind.name)] > 0 || in_no_approved_run));
  });
}

TEST_CASE("a log of an earlier version of the program can be read") {
  std::ifstream file(project / "tests/replay/frozen/run_version_1.run.jsonl");
  int lines = 0;
  for (std::string line; std::getline(file, line); ++lines) {
    const auto record = log::read_record(Json::parse(line), "line");
    INFO(line);
    CHECK(record.ok());
  }
  CHECK(lines > 10);
}

TEST_CASE("kinds and members are declared once, each with a sentence") {
  std::set<std::string_view> kinds;
  log::for_each_kind([&]<class T>() {
    INFO(T::kind.name);
    CHECK(kinds.insert(T::kind.name).second);
    CHECK(T::kind.when.ends_with('.'));
    std::set<std::string> members;
    each_member<T>("", [&](const std::string& name, const auto& field) {
      INFO(name);
      CHECK(members.insert(name).second);
      CHECK(field.sentence.ends_with('.'));
    });
  });
  CHECK(kinds.size() == std::variant_size_v<log::Record> - 1);
}

TEST_CASE("what a log does not have, and what this program does not know, can be read") {
  const auto line = Json::parse(R"({"kind":"utterance","n":3,"t":1.5,"text":"Hi.","loudness":7})");
  CHECK(compact(log::members_of(record_of(line))) == R"({"text":"Hi.","because":[]})");
  const auto later = Json::parse(R"({"kind":"smell","n":3,"t":1.5,"cause":2,"of":"roses"})");
  CHECK(through_record(later) == compact(later));
  CHECK(log::kind_of(record_of(later)) == "smell");
  CHECK(log::brief(record_of(later)) == R"({"of":"roses"})");
  const auto act = std::get<log::Act>(record_of(Json::parse(R"({"kind":"act","act":2,"step":null})")));
  CHECK((act.act == 2 && !act.step && !act.result));
}

TEST_CASE("texts and numbers are written as the library for JSON writes them") {
  for (const std::string text :
       {"", "a \"b\" \\x. c", "tab\tand line\n", "δ → ε", "\x7f", "\xff no text", "\xed\xa0\x80", "\x01"}) {
    const log::Utterance said{text, {}};
    CHECK(line_of({}, said) ==
          compact(Json{{"kind", "utterance"}, {"n", 0}, {"t", 0.0}, {"text", text}, {"because", Json::array()}}));
  }
  for (const double t : {0.0, -0.0, 1.0, 0.1, 1e-7, 123456.789012, 1e15, 1e16, -2.5e-300}) {
    INFO(t);
    CHECK(line_of({0, t, std::nullopt, false}, log::Utterance{"", {}}) ==
          compact(Json{{"kind", "utterance"}, {"n", 0}, {"t", t}, {"text", ""}, {"because", Json::array()}}));
  }
}

TEST_CASE("each line has its own time, whatever line was written before") {
  log::RecordWriter writer;
  for (const double t : {0.0, 0.0, 0.5, 0.5, 0.0, 1e-7, 0.5}) {
    INFO(t);
    const log::Stamp stamp{3, t, std::nullopt, false};
    log::RecordText line, decision;
    writer.add(stamp, log::Utterance{"yes", {}}, line, decision);
    CHECK(line.view() == line_of(stamp, log::Utterance{"yes", {}}));
    CHECK(Json::parse(decision.view())["t"] == t);
  }
}

TEST_CASE("a character that needs an escape is found wherever it is in a text") {
  for (std::size_t size = 1; size <= 70; ++size)
    for (std::size_t at = 0; at < size; ++at)
      for (const std::string character : {"\"", "\\", "\n", "\x1f", "\x7f", "ä", "\xff", " ", "~"}) {
        const auto text = std::string(at, 'a') + character + std::string(size - at - 1, 'z');
        const auto line = line_of({}, log::Utterance{text, {}});
        const auto as_json = compact(Json(text));
        if (line.find("\"text\":" + as_json + ",") == line.npos) FAIL_CHECK(line << " lacks " << as_json);
      }
}

TEST_CASE("JSON within a record is written as the library writes it") {
  const auto line = Json::parse(
      R"({"kind":"input","n":1,"t":0.5,"line":2,"event":{"a":[],"b":{},"c":[-1,18446744073709551615,0.1,1e300,
      true,null,"\"\\δ\u0001"],"d\n":{"e":[[1],[2,3]]}},"symbol":"x"})");
  CHECK(through_record(line) == compact(line));
}

TEST_CASE("a member of another type is an error that names its place") {
  const auto [line, error] = GENERATE(table<const char*, const char*>({
      {R"({"kind":"utterance","text":5})", "run:3: utterance.text: expected text, found '5'"},
      {R"({"kind":"transition","candidates":[{"id":"a"},{"id":"b","weight":"x"}]})",
       "run:3: transition.candidates[1].weight: expected a number, found '\"x\"'"},
      {R"({"kind":"pose","bodies":{"cup":[1,2]}})",
       "run:3: pose.bodies.cup: expected a list of 7 elements, found '[1,2]'"},
      {R"({"kind":"run","seed":-1})", "run:3: run.seed: expected a whole number from 0, found '-1'"},
      {R"({"kind":"symbol","slots":[]})", "run:3: symbol.slots: expected an object, found '[]'"},
      {R"({"kind":"expect","met":"no"})", "run:3: expect.met: expected true or false, found '\"no\"'"},
      {R"({"n":1})", "run:3: a record without 'kind'"},
      {R"([])", "run:3: expected a record, found '[]'"},
  }));
  const auto record = log::read_record(Json::parse(line), "run:3");
  INFO(line);
  REQUIRE(!record.ok());
  CHECK(record.error().text() == error);
}

TEST_CASE("a value that there is not is null or left out, as its type says") {
  log::Reading reading;
  CHECK(compact(log::members_of(reading)) == R"({"move":null,"because":[]})");
  reading.margin = log::Margin();
  CHECK(compact(log::members_of(reading)) == R"({"move":null,"margin":null,"because":[]})");
  CHECK(std::get<log::Reading>(record_of(Json::parse(R"({"kind":"reading","margin":null})"))).margin.has_value());
}

TEST_CASE("a margin has nine decimals, whatever the last digit of its logarithm was") {
  const auto logged = [](double margin) {
    log::Reading reading;
    reading.margin = log::Margin(margin);
    return compact(log::members_of(reading));
  };
  CHECK(logged(0.1234567891234) == R"({"move":null,"margin":0.123456789,"because":[]})");
  CHECK(logged(-1e-12) == R"({"move":null,"margin":0.0,"because":[]})");
}

TEST_CASE("the margin of a record is the smallest in it, however deep") {
  CHECK(log::margin_of(log::Transition()) == std::numeric_limits<double>::infinity());
  CHECK(log::margin_of(record_of(Json::parse(R"({"kind":"transition","margin":-0.25})"))) == 0.25);
  CHECK(log::margin_of(record_of(
            Json::parse(R"({"kind":"reading","margin":0.5,"resolved":[{"margin":0.125},{"margin":null}]})"))) == 0.125);
  CHECK(log::margin_of(log::Utterance{.text = "Hi.", .because = {}}) == std::numeric_limits<double>::infinity());
}
