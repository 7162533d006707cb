// Which words are accepted: the engine's saturation against the naive twin, which tabulates, and walks through all
// configurations where they are few.
#include <algorithm>
#include <deque>

#include "continua/analysis/acceptance.h"
#include "reference/naive_exploration.h"
#include "reference/naive_machines.h"
#include "support/machines.h"
#include "support/twin_samples.h"

using namespace continua;

namespace {

struct By {
  AcceptBy engine;
  naive::Acceptance twin;
};
const By both[] = {{AcceptBy::final_state, naive::Acceptance::final_state},
                   {AcceptBy::empty_stack, naive::Acceptance::empty_stack}};

// Nothing where there are more configurations than are compared.
std::optional<bool> found(const naive::Machine& machine, const std::optional<naive::Configurations>& all,
                          naive::Acceptance by) {
  if (!all) return std::nullopt;
  return std::any_of(all->begin(), all->end(), [&](const auto& one) { return naive::accepts(machine, one, by); });
}

// Every word in order of length. Where `tabulates` is false, only as far as the configurations can be walked through.
void compare_acceptance(const naive::Machine& machine, bool tabulates, Agreement& agreed) {
  const std::string text = naive::json(machine);
  CAPTURE(text);
  const auto loaded = machine_of(text);
  Acceptance engines[] = {Acceptance(loaded, both[0].engine), Acceptance(loaded, both[1].engine)};
  struct Run {
    std::string word;
    std::optional<naive::Configurations> all;
  };
  std::deque<Run> runs = {{"", naive::explored(machine, most_compared)}};
  for (; !runs.empty(); runs.pop_front()) {
    const auto& [word, all] = runs.front();
    CAPTURE(word);
    std::vector<std::string> inputs;
    for (const char input : word) inputs.emplace_back(1, input);
    for (std::size_t i = 0; i < std::size(both); ++i) {
      CAPTURE(i);
      const auto walked = found(machine, all, both[i].twin);
      if (!walked && !tabulates) continue;
      const auto accepted = engines[i].accepts(inputs);
      if (!accepted) FAIL(accepted.error().text());
      if (walked) REQUIRE(*accepted == *walked);
      if (tabulates) REQUIRE(*accepted == naive::accepts(machine, word, both[i].twin));
    }
    ++agreed.words;
    if (word.size() == longest_word) continue;
    for (const char input : {'a', 'b'})
      runs.push_back({word + input, all ? naive::explored(machine, *all, input, most_compared) : std::nullopt});
  }
  ++agreed.machines;
}

}  // namespace

TEST_CASE("the engine accepts the words that its naive twin accepts, also where stacks grow without end") {
  naive::Limits limits;
  limits.pop_until = limits.after_rewrite = false;
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(40); ++number) {
    CAPTURE(number);
    compare_acceptance(naive::sampled_machine(number, limits), true, agreed);
  }
  agreed.tell();
}

TEST_CASE("the engine accepts the words that its naive twin accepts, with pop_until") {
  naive::Limits limits;
  limits.after_rewrite = false;
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(40); ++number) {
    CAPTURE(number);
    compare_acceptance(naive::sampled_machine(number, limits), false, agreed);
  }
  agreed.tell();
}
