#include "continua/automaton/choice.h"

#include "support/machines.h"

namespace continua {
namespace {

const std::string ranked = R"json({"machine":1,"name":"m","start":"A","slots":{"at":"loc"},"transitions":[
  {"id":"usual","from":"A","on":["x","y"],"to":"A"},
  {"id":"rival","from":"A","on":"x","to":"A","weight":3},
  {"id":"special","from":"A","on":"x","when":"at != null","to":"A","rank":2},
  {"id":"set","from":"A","on":"s","to":"A","push":{"at":"target"}},
  {"id":"rest","from":"A","on":["x","y","z"],"to":"A","rank":-1}]})json";

std::string candidates_of(const Player& player, const std::shared_ptr<const Machine>& machine) {
  std::string ids;
  const auto fired = player.all<Fired>().at(0);
  for (const auto& one : fired.candidates) ids += (ids.empty() ? "" : " ") + machine->transitions[one.transition].id;
  return ids;
}

// Takes the last candidate, and keeps what it was asked.
class Last : public OutsidePolicy {
 public:
  std::optional<std::size_t> choose(const OpenChoice& open) override {
    asked.push_back(open.candidates.size());
    return declines ? std::nullopt : std::optional(open.candidates.size() - 1);
  }
  std::vector<std::size_t> asked;
  bool declines = false;
};

}  // namespace

TEST_CASE("A transition applies only where none of a higher rank does") {
  const auto machine = machine_of(ranked);
  Player player(machine);
  player.feed("x");
  CHECK(candidates_of(player, machine) == "usual rival");
  const auto fired = player.all<Fired>().at(0);
  CHECK(fired.probability == Approx(0.75));
  REQUIRE(fired.refused.size() == 2);
  CHECK(machine->transitions[fired.refused[0].transition].id == "special");
  CHECK_FALSE(fired.refused[0].outranked_by);
  CHECK(machine->transitions[fired.refused[1].transition].id == "rest");
  CHECK(fired.refused[1].outranked_by);
  player.feed("s").feed("x");
  CHECK(candidates_of(player, machine) == "special");
  CHECK(player.all<Fired>().at(0).refused.at(0).reason == "'special' applies too, of rank 2 against 0");
  player.feed("z");
  CHECK(candidates_of(player, machine) == "rest");
}

TEST_CASE("Ranks exclude for each input of its own") {
  const auto machine = machine_of(ranked);
  Player player(machine);
  player.offer("z 0.5, y 0.4");
  CHECK(candidates_of(player, machine) == "rest usual");
  CHECK(player.fired() == "rest");
}

TEST_CASE("Ranks leave a unique transition where weights leave rivals") {
  CHECK(Player(ranked, Choice::unique).feed("y").fired() == "usual");
  CHECK(Player(ranked, Choice::unique).feed("x").fired().empty());
}

TEST_CASE("Force takes a transition whose rank is too low") {
  const auto machine = machine_of(ranked);
  const Rules none;
  const Stepper stepper(machine, none);
  const Beliefs beliefs(machine->beliefs);
  Chooser chooser{Choice::likeliest, Random(1), {{1, 4}, {2, 2}}, 0};
  Input input;
  input.symbol = "x";
  auto step = stepper.step(stepper.initial(), input, {.beliefs = &beliefs}, chooser);
  const auto fired = std::get<Fired>(step.events.at(0));
  CHECK(machine->transitions[fired.transition].id == "rest");
  CHECK(fired.forced);
  CHECK(fired.probability == 0);
  // A transition whose condition fails is not taken, forced or not.
  step = stepper.step(step.after, input, {.beliefs = &beliefs}, chooser);
  CHECK(machine->transitions[std::get<Fired>(step.events.at(0)).transition].id == "rival");
  CHECK(chooser.forced.size() == 1);
}

TEST_CASE("A policy from outside chooses among the candidates") {
  const auto machine = machine_of(ranked);
  const Rules none;
  const Stepper stepper(machine, none);
  const Beliefs beliefs(machine->beliefs);
  const auto last = std::make_shared<Last>();
  Chooser chooser{Choice::unique, Random(1), {}, 0, last};
  Input input;
  input.symbol = "x";
  auto step = stepper.step(stepper.initial(), input, {.beliefs = &beliefs}, chooser);
  CHECK(machine->transitions[std::get<Fired>(step.events.at(0)).transition].id == "rival");
  input.symbol = "z";
  step = stepper.step(step.after, input, {.beliefs = &beliefs}, chooser);
  CHECK(last->asked == std::vector<std::size_t>{2, 1});
  last->declines = true;
  step = stepper.step(step.after, input, {.beliefs = &beliefs}, chooser);
  CHECK(std::holds_alternative<RefusedInput>(step.events.at(0)));
  CHECK(chooser.steps == 2);
}

}  // namespace continua
