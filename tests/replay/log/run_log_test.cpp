#include "continua/replay/log/run_log.h"

#include <sstream>

#include "support/catch.h"

using namespace continua;

namespace {

// The digests that a log ends with after these two records, and an act that is done at `act_s`.
Json end_of(const Json& transition, const Json& pose, double act_s = 2.5) {
  std::ostringstream out;
  RunLog log(out);
  log.write("transition", SimTime::from_seconds(1), transition, 7);
  log.write("pose", SimTime::from_seconds(2), pose);
  log.write("act", SimTime::from_seconds(act_s), {{"act", 1}, {"status", "done"}});
  log.finish(SimTime::from_seconds(3));
  std::istringstream lines(out.str());
  std::string line;
  for (int i = 0; i < 4; ++i) std::getline(lines, line);
  return Json::parse(line);
}

}  // namespace

TEST_CASE("a log numbers its lines, and its last line counts and digests those before") {
  std::ostringstream out;
  RunLog log(out);
  CHECK(log.write("input", SimTime::from_seconds(1.25), {{"symbol", "x"}}) == 0);
  CHECK(log.write("utterance", SimTime::from_seconds(1.25), {{"text", "Hello."}}, 0) == 1);
  const auto before = out.str();
  CHECK(before ==
        "{\"kind\":\"input\",\"n\":0,\"t\":1.25,\"symbol\":\"x\"}\n"
        "{\"kind\":\"utterance\",\"n\":1,\"t\":1.25,\"cause\":0,\"text\":\"Hello.\"}\n");
  log.finish(SimTime::from_seconds(2));
  const auto end = Json::parse(out.str().substr(before.size()));
  CHECK(end["digest"] == digest(before));
  CHECK(end["counts"] == Json{{"input", 1}, {"utterance", 1}});
}

TEST_CASE("decisions are digested apart from poses, from margins, and from what depends on them") {
  const Json transition{{"id", "a"}, {"margin", 0.1}, {"because", {5, 8}}};
  const Json pose{{"bodies", {{"block", {1, 2, 3}}}}};
  const auto same = end_of(transition, pose);
  const auto other_pose = end_of(transition, {{"bodies", {{"block", {1, 2, 4}}}}});
  CHECK(other_pose["decisions"] == same["decisions"]);
  CHECK(other_pose["physics"] != same["physics"]);
  CHECK(end_of({{"id", "a"}, {"margin", 0.2}}, pose)["decisions"] == same["decisions"]);
  CHECK(end_of({{"id", "a"}, {"because", {6, 9}}}, pose)["decisions"] == same["decisions"]);
  CHECK(end_of(transition, pose, 2.6)["decisions"] == same["decisions"]);
  CHECK(end_of({{"id", "b"}, {"margin", 0.1}}, pose)["decisions"] != same["decisions"]);
}

TEST_CASE("decisions near to others are fragile, and the log's end names them") {
  std::ostringstream out;
  RunLog log(out);
  log.write("transition", SimTime{}, {{"id", "a"}, {"margin", 0.2}});
  log.write("transition", SimTime{}, {{"id", "a"}, {"margin", nullptr}});
  log.write("transition", SimTime{}, {{"id", "b"}, {"margin", -0.00002}});
  log.write("reading", SimTime{}, {{"resolved", {{{"margin", 0.5}}, {{"margin", 0.0}}}}});
  log.write("utterance", SimTime{}, {{"margin", 0.0}});
  CHECK(log.fragile() == 2);
  log.finish(SimTime{});
  const auto text = out.str();
  CHECK(compact(Json::parse(text.substr(text.rfind('\n', text.size() - 2) + 1))["fragile"]) ==
        R"([{"n":2,"margin":2e-05},{"n":3,"margin":0.0}])");
}

TEST_CASE("between which records an act goes on does not count, what it came to does") {
  const Json said{{"text", "OK."}}, act{{"act", 1}, {"status", "done"}}, other{{"act", 2}, {"status", "done"}};
  const auto decisions = [](const std::vector<std::pair<std::string, Json>>& records) {
    std::ostringstream out;
    RunLog log(out);
    for (const auto& [kind, fields] : records) log.write(kind, SimTime{}, fields);
    log.finish(SimTime{});
    const auto all = out.str();
    return Json::parse(all.substr(all.rfind('\n', all.size() - 2) + 1))["decisions"].get<std::string>();
  };
  const Json step{{"act", 1}, {"step", 1}, {"status", "done"}};
  const auto one = decisions({{"act", act}, {"act", other}, {"utterance", said}});
  CHECK(decisions({{"act", other}, {"utterance", said}, {"act", act}}) == one);
  CHECK(decisions({{"act", step}, {"act", act}, {"act", other}, {"utterance", said}}) == one);
  CHECK(decisions({{"act", {{"act", 1}, {"status", "missed"}}}, {"act", other}, {"utterance", said}}) != one);
}
