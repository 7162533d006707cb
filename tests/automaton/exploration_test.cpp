// The policy explore: the configurations that are carried along, the leading one, and those that are merged, dropped
// and pruned.
#include "continua/automaton/exploration.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "support/machines.h"

using namespace continua;

namespace {

class Exploring {
 public:
  explicit Exploring(const std::string& text, std::size_t limit = 64)
      : machine_(machine_of(text)),
        stepper_(machine_, no_facts),
        explorer_(stepper_, limit),
        beliefs_(machine_->beliefs),
        latest_(explorer_.begin({.beliefs = &beliefs_})) {}

  Exploring& feed(const std::string& symbols, double confidence = 1) {
    for (const char symbol : symbols) {
      Input input;
      input.serial = ++serial_;
      input.symbol = std::string(1, symbol);
      input.confidence = confidence;
      latest_ = explorer_.step(latest_.after, input, {.beliefs = &beliefs_});
    }
    return *this;
  }

  /// "B 0.75 #0 (heavy), A 0.25 #1 (light)": state, weight, id and way of each branch, the leading one first.
  std::string branches() const {
    std::vector<std::string> all;
    for (const auto& branch : latest_.after.branches) {
      std::vector<std::string> by;
      for (const auto transition : branch.by) by.push_back(machine_->transitions[transition].id);
      all.push_back(fmt::format("{}{} {:.3g} #{} ({})", machine_->states[branch.configuration.state].name,
                                branch.settled ? "" : "…", branch.weight, branch.id, fmt::join(by, " ")));
    }
    return fmt::format("{}", fmt::join(all, ", "));
  }
  const ExplorationStep& latest() const { return latest_; }

 private:
  std::shared_ptr<const Machine> machine_;
  Stepper stepper_;
  Explorer explorer_;
  Beliefs beliefs_;
  ExplorationStep latest_;
  int serial_ = 0;
};

const std::string forking = R"({"machine":1,"name":"m","start":"A","slots":{"s":"text"},"transitions":[
  {"id":"light","from":"A","on":"x","to":"B","weight":1},
  {"id":"heavy","from":"A","on":"x","to":"C","weight":3},
  {"id":"b","from":"B","on":"b","to":"D","push":{"s":"'b'"}},
  {"id":"both b","from":["B","C"],"on":"y","to":"E"},
  {"id":"c","from":"C","on":"c","to":"A"}]})";

}  // namespace

TEST_CASE("every applicable transition is taken, the heaviest configuration leads") {
  CHECK(Exploring(forking).branches() == "A 1 #0 ()");
  CHECK(Exploring(forking).feed("x").branches() == "C 0.75 #0 (heavy), B 0.25 #1 (light)");
}

TEST_CASE("the other branches tell what they did, each its whole way since the step began") {
  Exploring exploring(forking);
  exploring.feed("x");
  const auto& others = exploring.latest().others;
  REQUIRE(others.size() == 1);
  CHECK(others[0].branch == 1);
  CHECK(others[0].parent == 0);
  REQUIRE(others[0].events.size() == 1);
  CHECK(std::get<Fired>(others[0].events[0]).step == 1);
  const auto ways = R"({"machine":1,"name":"m","start":"A","slots":{"s":"text"},"transitions":[
    {"id":"push","from":"A","on":"x","to":"B","push":{"s":"'x'"},"do":[{"say":"x"}]},
    {"id":"go","from":"B","on":null,"to":"C","weight":3},
    {"id":"stay","from":"B","on":null,"to":"D","pop":1}]})";
  Exploring forked(ways);
  forked.feed("x");
  REQUIRE(forked.latest().others.size() == 2);
  for (const auto& each : forked.latest().others) {
    CHECK(std::get<Fired>(each.events.at(0)).step == 1);
    CHECK(std::get<Said>(each.events.at(1)).text == "x");
  }
}

TEST_CASE("what follows from an input by ε draws on that input, at its time") {
  Exploring exploring(R"json({"machine":1,"name":"m","start":"A","programs":{"go":"num -> t"},"transitions":[
    {"id":"take","from":"A","on":"x","to":"B"},
    {"id":"then","from":"B","on":null,"to":"C","do":[{"act":"go(now)"}]}]})json");
  exploring.feed("x");
  const auto& acted = std::get<Acted>(exploring.latest().events.back());
  CHECK(acted.because == std::vector<int>{1});
  CHECK(print(acted.term) == "go(0)");
}

TEST_CASE("a configuration that cannot take what another can is dropped, the lead goes over") {
  Exploring exploring(forking);
  exploring.feed("xb");
  CHECK(exploring.branches() == "D 1 #1 (b)");
  CHECK(exploring.latest().dropped == std::vector<int>{0});
  const auto& fired = std::get<Fired>(exploring.latest().events.at(1));
  CHECK(fired.from != fired.to);
}

TEST_CASE("what comes out equal is one, with the larger weight") {
  Exploring exploring(forking);
  exploring.feed("xy");
  CHECK(exploring.branches() == "E 1 #0 (both b)");
  CHECK(exploring.latest().merged == 1);
}

TEST_CASE("an input that no configuration takes is refused and the set stays") {
  Exploring exploring(forking);
  exploring.feed("x");
  const auto before = exploring.branches();
  exploring.feed("z");
  CHECK(exploring.branches() == before);
  CHECK(std::get<RefusedInput>(exploring.latest().events.at(0)).reason == "no transition from C takes 'z'");
}

TEST_CASE("ε-transitions are taken and not taken, what is settled leads") {
  const auto guess = R"({"machine":1,"name":"m","start":"A","slots":{"s":"text"},"transitions":[
    {"id":"push","from":"A","on":"x","to":"A","push":{"s":"'x'"}},
    {"id":"middle","from":"A","on":null,"to":"B"},
    {"id":"pop","from":"B","on":"x","when":"s = 'x'","to":"B","pop":1}]})";
  Exploring exploring(guess);
  CHECK(exploring.branches() == "B 0.5 #0 (middle), A… 0.5 #1 ()");
  exploring.feed("x");
  CHECK(exploring.branches() == "B 0.5 #1 (push middle), A… 0.5 #2 (push)");
  exploring.feed("x");
  CHECK(exploring.latest().after.branches.size() == 3);
}

TEST_CASE("the set is bounded, the lightest go first and are counted, ids of symbols stay unique") {
  const auto doubling = R"({"machine":1,"name":"m","start":"A","slots":{"s":"text"},"transitions":[
    {"id":"a","from":"A","on":"x","to":"A","push":{"s":"'a'"},"weight":2},
    {"id":"b","from":"A","on":"x","to":"A","push":{"s":"'b'"}}]})";
  Exploring exploring(doubling, 4);
  exploring.feed("xx");
  CHECK(exploring.latest().pruned == 0);
  exploring.feed("x");
  CHECK(exploring.latest().after.branches.size() == 4);
  CHECK(exploring.latest().pruned == 4);
  std::vector<int> ids;
  for (const auto& branch : exploring.latest().after.branches) {
    CHECK(branch.weight ==
          Approx(branch.configuration.stack.top()[0].value.text_value() == "a" ? 0.3 : 0.1).margin(0.1));
    ids.push_back(branch.configuration.stack.id());
  }
  std::sort(ids.begin(), ids.end());
  CHECK(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
}

TEST_CASE("endless ε-growth ends at the bound of the set") {
  Exploring exploring(R"({"machine":1,"name":"m","start":"A","slots":{"s":"text"},"transitions":[
    {"id":"grow","from":"A","on":null,"to":"A","push":{"s":"'a'"}}]})",
                      16);
  CHECK(exploring.latest().after.branches.size() == 16);
  CHECK(exploring.latest().pruned > 0);
}

TEST_CASE("growth that gets heavier round by round ends, and says so") {
  Exploring exploring(R"({"machine":1,"name":"m","start":"A","slots":{"s":"text"},"transitions":[
    {"id":"a","from":"A","on":null,"to":"A","weight":2,"push":{"s":"'a'"}},
    {"id":"b","from":"A","on":null,"to":"A","weight":2,"push":{"s":"'b'"}}]})",
                      60);
  CHECK(exploring.latest().after.branches.size() == 60);
  CHECK(exploring.latest().after.steps < 2 * most_epsilon_steps);
  CHECK(std::holds_alternative<Trouble>(exploring.latest().events.back()));
}
