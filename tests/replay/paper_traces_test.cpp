// The paper's examples, replayed in the kinematic world.
#include <filesystem>
#include <map>
#include <set>

#include "replay/played.h"
#include "support/folders.h"
#include "support/sources.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const auto folder = fs::path(source_dir()) / "traces/paper";

}  // namespace

TEST_CASE("the paper's examples and other conversations go as their traces expect") {
  int traces = 0;
  for (const auto& examples : {folder, folder.parent_path() / "talk"})
    for (const auto& file : fs::directory_iterator(examples)) {
      if (!file.path().string().ends_with(".trace.jsonl")) continue;
      CAPTURE(file.path());
      ++traces;
      const auto played = play(file.path());
      CHECK(played.summary.expectations > 0);
      CHECK(played.summary.expectations_met == played.summary.expectations);
      CHECK(played.summary.problems == 0);
      CHECK(played.summary.refusals == 0);
      CHECK(played.summary.acts_done == played.summary.acts);
    }
  CHECK(traces >= 10);
}

TEST_CASE("the figure's stack symbols hold the options that are left and what the command becomes with the first") {
  const auto played = play(folder / "figure_pda_disambiguation.trace.jsonl");
  std::vector<std::string> symbols, applications, moves;
  for (const auto& symbol : played.all("symbol"))
    if (const auto& slots = symbol["slots"]; slots.contains("event"))
      symbols.push_back(slots["options"].get<std::string>() + " | " + slots["event"].get<std::string>());
  for (const auto& application : played.all("application"))
    applications.push_back(application["function"].get<std::string>() + " @ " +
                           application["argument"].get<std::string>() + " = " +
                           application["result"].get<std::string>());
  for (const auto& transition : played.all("transition"))
    moves.push_back(transition["id"].get<std::string>() + " " + compact(transition["stack"]));
  CHECK(applications == std::vector<std::string>{
                            "on @ w = on(w)", "put @ block7 = put(block7)", "put(block7) @ on(w) = put(block7, on(w))",
                            "\\w. put(block7, on(w)) @ block1 = put(block7, on(block1))",
                            "\\w. put(block7, on(w)) @ block6 = put(block7, on(block6))",
                            "\\w. put(block7, on(w)) @ <-0.075, 0, 0> = put(block7, on(<-0.075, 0, 0>))"});
  // 𝒞 is at the bottom of the three, 𝒜 on top.
  CHECK(symbols == std::vector<std::string>{"[<-0.075, 0, 0>] | put(block7, on(<-0.075, 0, 0>))",
                                            "[block6, <-0.075, 0, 0>] | put(block7, on(block6))",
                                            "[block1, block6, <-0.075, 0, 0>] | put(block7, on(block1))"});
  CHECK(moves ==
        std::vector<std::string>{"theme 1", "command 2", "destination 3", "offer 6", "next 5", "next 4", "agree 4"});
}

TEST_CASE("one state asks about any number of objects, three states about three") {
  const auto states_of = [](const std::string& trace) {
    std::set<std::string> states;
    for (const auto& transition : play(folder / (trace + ".trace.jsonl")).all("transition"))
      states.insert(transition["to"]);
    return states;
  };
  CHECK(states_of("figure_three_states") == std::set<std::string>{"?cup", "?knife", "?plate", "Chosen"});
  CHECK(states_of("figure_one_state") == std::set<std::string>{"?arg", "Chosen"});
  CHECK(states_of("figure_one_state_exhausted") == std::set<std::string>{"?arg", "Exhausted"});
}

namespace {

// The human's words and gestures behind an act, by following `because` and `cause` from its record back to inputs.
std::string contributions(const Played& played, const Json& act) {
  std::set<std::size_t> inputs;
  for (auto record = act;;) {
    inputs.merge(inputs_behind(played.records, record));
    if (record["kind"] == "input") inputs.insert(record["n"].get<std::size_t>());
    if (!record.contains("cause")) break;
    record = played.records.at(record["cause"].get<std::size_t>());
  }
  std::string all;
  for (const auto n : inputs) {
    const auto& event = played.records.at(n)["event"];
    const auto kind = event["kind"].get<std::string>();
    all += (all.empty() ? "" : " + ") + (kind == "speech"    ? event["text"].get<std::string>()
                                         : kind == "gesture" ? event["name"].get<std::string>()
                                                             : kind);
  }
  return all;
}

}  // namespace

TEST_CASE("an act's record leads back to each word and gesture that it came of") {
  const std::map<std::string, std::vector<std::string>> expected = {
      {"dialogue_language", {"put(plate, in_front(avatar)) <- The plate. + Put it in front of you."}},
      {"dialogue_gesture", {"put(plate, <-0.1, -0.15, 0>) <- The plate. + pointing + Put it there."}},
      {"one_breath", {"put(knife, in(cup_blue)) <- Put the knife in the blue cup."}},
      {"predicate_first", {"put(plate, <-0.1, -0.15, 0>) <- pointing + Put it there. + The plate."}},
      {"region_place",
       {"put(knife, in(cup_blue)) <- The knife. + In that blue cup. + point",
        "put(knife, in(cup_blue)) <- The knife. + In that blue cup. + point + act + act + Put it there."}},
      {"disambiguation", {"grasp(block6) <- Take the block. + Yes."}},
      {"one_shot_learning",
       {"grasp(cup) <- two_fingers + Grasp the cup. + two_fingers",
        "ungrasp(cup) <- two_fingers + Grasp the cup. + two_fingers + act + Let go of it.",
        "put(cup, on(plate)) <- two_fingers + Grasp the cup. + Put on the plate. + two_fingers"}},
      {"live_composition",
       {"grasp(cup) <- Take the white cup.", "lift(cup) <- Take the white cup. + act + Lift it.",
        "ungrasp(cup) <- Take the white cup. + act + Lift it. + act + Let go of it.",
        "grasp(cup_blue) <- Watch. + Take the white cup. + act + Lift it. + Call that hoist. + Hoist the blue cup.",
        "lift(cup_blue) <- Watch. + Take the white cup. + act + Lift it. + Call that hoist. + Hoist the blue cup."}},
      {"correction",
       {"put(cup, <-0.05, -0.18, 0>) <- Put the white cup there. + point", "stop <- No, that one. + point",
        "put(cup, was(cup)) <- Put the white cup there. + point + No, that one. + point",
        "put(cup_blue, <-0.05, -0.18, 0>) <- Put the white cup there. + point + No, that one. + point"}},
  };
  for (const auto& [trace, acts] : expected) {
    const auto played = play(folder / (trace + ".trace.jsonl"));
    std::vector<std::string> found;
    for (const auto& act : played.all("act"))
      if (act["status"] == "asked")
        found.push_back(act["program"].get<std::string>() + " <- " + contributions(played, act));
    INFO(trace);
    CHECK(found == acts);
  }
}
