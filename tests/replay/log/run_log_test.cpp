#include "continua/replay/log/run_log.h"

#include <sstream>

#include "support/catch.h"

using namespace continua;

namespace {

SimTime seconds(double t_s) { return SimTime::from_seconds(t_s); }

Json last_line(const std::string& text) { return Json::parse(text.substr(text.rfind('\n', text.size() - 2) + 1)); }

log::Transition transition(const std::string& id, std::optional<double> margin) {
  log::Transition record;
  record.id = id;
  if (margin) record.margin.emplace(*margin);
  return record;
}

log::Pose pose(double x) { return {{{"block", {x, 2, 3, 1, 0, 0, 0}}}}; }

log::Act act(std::int64_t number, const std::string& status, std::optional<std::int64_t> step = {}) {
  return {.act = number, .program = "grasp(cup)", .status = status, .step = step, .because = {}, .result = {}};
}

// The digests that a log ends with after these records, and an act that is done at `act_s`.
Json end_of(const log::Record& decision, const log::Pose& poses, double act_s = 2.5) {
  std::ostringstream out;
  RunLog written(out);
  written.write(decision, seconds(1), 7);
  written.write(poses, seconds(2));
  written.write(act(1, "done"), seconds(act_s));
  written.finish(seconds(3));
  return last_line(out.str());
}

}  // namespace

TEST_CASE("a log numbers its lines, and its last line counts and digests those before") {
  std::ostringstream out;
  RunLog written(out);
  CHECK(written.write(log::Memory{"x", "5"}, seconds(1.25)) == 0);
  CHECK(written.write(log::Utterance{"Hello.", {0}}, seconds(1.25), 0, true) == 1);
  const auto before = out.str();
  CHECK(before ==
        "{\"kind\":\"memory\",\"n\":0,\"t\":1.25,\"register\":\"x\",\"value\":\"5\"}\n"
        "{\"kind\":\"utterance\",\"n\":1,\"t\":1.25,\"cause\":0,\"text\":\"Hello.\",\"because\":[0],"
        "\"measured\":true}\n");
  written.finish(seconds(2));
  const auto end = Json::parse(out.str().substr(before.size()));
  CHECK(end["digest"] == digest(before));
  CHECK(end["counts"] == Json{{"memory", 1}, {"utterance", 1}});
}

TEST_CASE("where there is nowhere to write, records are numbered and counted as in a log") {
  std::ostringstream out;
  std::ostream nowhere(nullptr);
  RunLog written(out), thrown_away(nowhere);
  for (int i = 0; i < 3 * records_per_block; ++i)
    CHECK(written.write(log::Utterance{"Hello.", {}}, seconds(1)) ==
          thrown_away.write(log::Utterance{"Hello.", {}}, seconds(1)));
  written.finish(seconds(2));
  thrown_away.finish(seconds(2));
  CHECK(written.counts() == thrown_away.counts());
}

TEST_CASE("decisions are digested apart from poses, from margins, and from what depends on them") {
  const auto same = end_of(transition("a", 0.1), pose(1));
  const auto other_pose = end_of(transition("a", 0.1), pose(1.5));
  CHECK(other_pose["decisions"] == same["decisions"]);
  CHECK(other_pose["physics"] != same["physics"]);
  CHECK(end_of(transition("a", 0.2), pose(1))["decisions"] == same["decisions"]);
  CHECK(end_of(transition("a", 0.1), pose(1), 2.6)["decisions"] == same["decisions"]);
  CHECK(end_of(transition("b", 0.1), pose(1))["decisions"] != same["decisions"]);
  const auto said = end_of(log::Utterance{"Hi.", {5, 8}}, pose(1));
  CHECK(end_of(log::Utterance{"Hi.", {6, 9}}, pose(1))["decisions"] == said["decisions"]);
  CHECK(end_of(log::Utterance{"Ho.", {5, 8}}, pose(1))["decisions"] != said["decisions"]);
}

TEST_CASE("reasons for refusals are measured: they are no decisions, the transitions refused are") {
  const auto refused = [](const std::string& id, const std::string& reason) {
    return log::Refusal{.state = "A", .input = "x", .reason = "none", .refused = {{id, reason, {}, {}}}};
  };
  const auto same = end_of(refused("a", "0.1 < 0.2"), pose(1))["decisions"];
  CHECK(end_of(refused("a", "0.1 < 0.3"), pose(1))["decisions"] == same);
  CHECK(end_of(refused("b", "0.1 < 0.2"), pose(1))["decisions"] != same);
}

TEST_CASE("decisions near to others are fragile, and the log's end names them") {
  std::ostringstream out;
  RunLog written(out);
  written.write(transition("a", 0.2), SimTime{});
  written.write(transition("a", std::nullopt), SimTime{});
  written.write(transition("b", -0.00002), SimTime{});
  log::Reading reading;
  reading.resolved = {log::Resolution(), log::Resolution()};
  reading.resolved->at(0).margin.emplace(0.5);
  reading.resolved->at(1).margin.emplace(0.0);
  written.write(reading, SimTime{});
  CHECK(written.fragile() == 2);
  written.finish(SimTime{});
  CHECK(compact(last_line(out.str())["fragile"]) == R"([{"n":2,"margin":2e-05},{"n":3,"margin":0.0}])");
}

TEST_CASE("between which records an act goes on does not count, what it came to does") {
  const log::Utterance said{"OK.", {}};
  const auto done = act(1, "done"), other = act(2, "done"), step = act(1, "done", 1);
  const auto decisions = [](const std::vector<log::Record>& records) {
    std::ostringstream out;
    RunLog written(out);
    for (const auto& record : records) written.write(record, SimTime{});
    written.finish(SimTime{});
    return last_line(out.str())["decisions"].get<std::string>();
  };
  const auto one = decisions({done, other, said});
  CHECK(decisions({other, said, done}) == one);
  CHECK(decisions({step, done, other, said}) == one);
  CHECK(decisions({act(1, "missed"), other, said}) != one);
}
