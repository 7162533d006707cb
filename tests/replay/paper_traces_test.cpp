// The paper's examples, replayed in the kinematic world.
#include <filesystem>
#include <set>

#include "played.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const auto folder = fs::path(CONTINUA_SOURCE_DIR) / "traces/paper";

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
  CHECK(applications ==
        std::vector<std::string>{"\\w. put(block7, on(w)) @ block1 = put(block7, on(block1))",
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
