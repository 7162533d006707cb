// The ends of noisy runs.
#include "continua/replay/experiment/robust.h"

#include "support/catch.h"
#include "support/temporary_folder.h"

namespace continua {
namespace {

// "human; act lift(cup); says Okay."
std::vector<Happened> happened(const std::string& text) {
  std::vector<Happened> all;
  for (std::size_t from = 0; from < text.size();) {
    const auto end = std::min(text.find("; ", from), text.size());
    const auto one = text.substr(from, end - from);
    if (one == "human")
      all.push_back({Happened::Kind::human, ""});
    else if (one.starts_with("act "))
      all.push_back({Happened::Kind::act, one.substr(4)});
    else
      all.push_back({Happened::Kind::utterance, one.substr(5)});
    from = end + 2;
  }
  return all;
}

TEST_CASE("The end of a run is that of its first other answer") {
  const auto whole = happened("human; act a; says Okay.; human; act b; says Okay.");
  const auto end = [&](const std::string& noisy) {
    return std::string(run_end_names[static_cast<std::size_t>(run_end(whole, happened(noisy)))]);
  };
  CHECK(end("human; act a; says Okay.; human; act b; says Okay.") == "same");
  CHECK(end("human; says Pardon?; act a; human; says Okay.; act b") == "same");
  CHECK(end("human; act a; says Okay.; human; says What?") == "asks");
  CHECK(end("human; act a; says Okay.; human") == "less");
  CHECK(end("human; human; act b; says Okay.") == "less");
  CHECK(end("human; act c; says Okay.; human; act b; says Okay.") == "otherwise");
  CHECK(end("human; act a; says Okay, c.; act c; human; act b; says Okay.") == "otherwise");
  // After the question the human would have said something else.
  CHECK(end("human; says What?; human; act c; says Okay.") == "asks");
  CHECK(end("human; act b; says Okay.; human; act a; says Okay.") == "otherwise");
}

TEST_CASE("An act at about the same point is the same act") {
  const auto end = [&](const std::string& whole, const std::string& noisy) {
    return std::string(run_end_names[static_cast<std::size_t>(run_end(happened(whole), happened(noisy)))]);
  };
  CHECK(end("act put(knife, <0.1, -0.2, 0>)", "act put(knife, <0.1612, -0.16, 0>)") == "same");
  CHECK(end("act put(knife, <0.1, -0.2, 0>)", "act put(knife, <0.2, -0.3, 0>)") == "otherwise");
  CHECK(end("act put(knife, <0.1, -0.2, 0>)", "act put(plate, <0.1, -0.2, 0>)") == "otherwise");
  CHECK(end("act put(knife, <0.1, -0.2, 0>)", "act put(knife, <0.1, -0.2, 0>) x") == "otherwise");
}

TEST_CASE("An act that the body refused at its beginning did not happen") {
  const std::string asked = R"json({"kind":"act","act":1,"program":"put(knife, in(cup))","status":"asked"})json";
  const std::string started = R"json({"kind":"act","act":1,"program":"put(knife, in(cup))","status":"started"})json";
  const std::string blocked = R"json({"kind":"act","act":1,"program":"put(knife, in(cup))","status":"blocked"})json";
  const std::string taken = R"json({"kind":"act","act":1,"program":"grasp(knife)","status":"done","step":1})json";
  const std::string other = R"json({"kind":"act","act":2,"program":"grasp(knife)","status":"done","step":1})json";
  const auto acts = [](const std::vector<std::string>& lines) {
    std::string log;
    for (const auto& line : lines) log += line + "\n";
    return happenings_of(log).size();
  };
  CHECK(acts({asked, started}) == 1);
  CHECK(acts({asked, started, blocked}) == 0);
  CHECK(acts({asked, started, other, blocked}) == 0);
  CHECK(acts({asked, started, taken, blocked}) == 1);
}

// Does what it hears, and asks about words that it does not know.
const char* obedient = R"json({"machine":1,"name":"obedient","start":"A",
  "programs":{"stop":"t","retract":"t"},
  "states":{"A":{}},
  "transitions":[
  {"id":"lift","from":"A","on":"speech take cup","to":"A","do":[{"act":"stop"}]},
  {"id":"push","from":"A","on":"speech take cap","to":"A","do":[{"act":"retract"}]},
  {"id":"ask","from":"A","on":"speech*","to":"A","do":[{"say":"Pardon?"}]}]})json";

TEST_CASE("A smallest change that makes a run do something else is found") {
  TemporaryFolder folder;
  folder.file("obedient.json", obedient);
  folder.file("confusions/english.json",
              R"({"confusions":1,"confidence":{"share_wrong":0.5,"right":[1,1],"wrong":[0.5,0.5]},
                  "words":{"cup":{"cap":1},"take":{"bake":1}}})");
  const auto noise = read_noise(folder.file("n.json", R"({"noise":1,"words":{"misheard":0.3}})"), folder.path());
  REQUIRE(noise);
  std::string trace = "{\"kind\":\"trace\",\"version\":1,\"scene\":\"staircase\",\"machine\":\"obedient.json\"}\n";
  for (int i = 1; i < 6; ++i) trace += "{\"t\":" + std::to_string(i) + ",\"kind\":\"speech\",\"text\":\"take cup\"}\n";
  ReplayOptions options;
  options.physics = false;
  auto session = Session::load(folder.file("t.trace.jsonl", trace), options);
  if (!session) FAIL(session.error().text());
  const auto found = robustness_of(*session, {*noise, {0, 1}, 20, 0});
  if (!found) FAIL(found.error().text());
  REQUIRE(found->points.size() == 2);
  CHECK(found->points[0].ends[0] == 20);
  CHECK(found->points[1].runs() == 20);
  CHECK(found->points[1].share(RunEnd::asks) > 0);
  REQUIRE(found->breaks.size() == 1);
  REQUIRE(found->breaks[0].sentences.size() == 1);
  CHECK(found->breaks[0].sentences[0].find("\"take cap\" is heard for \"take cup\"") != std::string::npos);
  CHECK(found->breaks[0].acts == std::vector<std::string>{"retract"});
}

}  // namespace
}  // namespace continua
