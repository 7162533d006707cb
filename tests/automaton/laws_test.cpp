// Laws of stacks and of runs, on random stacks, random machines and random words.
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>
#include <set>

#include "continua/automaton/stack_operation.h"
#include "reference/naive_exploration.h"
#include "reference/naive_machines.h"
#include "support/small_engine.h"

using namespace continua;

namespace {

using Kind = Operation::Kind;
using Contents = std::vector<std::optional<Cell>>;

// The same stacks and machines in every run; RC_PARAMS="seed=2 max_success=20000" asks for others.
void law(const std::string& what, const auto& property) {
  setenv("RC_PARAMS", "seed=1 max_success=200", 0);
  INFO(what);
  CHECK(rc::check(what, property));
}

// Uniform from the first test on: unresized, a range begins with its smallest values only.
int pick(int below) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, below)); }

// ---- stacks ----

const std::size_t slots = 3;
const std::size_t persisting = 2;

const Machine& some_machine() {
  static const auto machine = machine_of(
      R"({"machine":1,"name":"m","start":"A","states":{"A":{},"B":{}},
          "slots":{"n":"num","m":"num","held":{"type":"num","persists":true}},
          "transitions":[{"id":"t","from":"A","on":"x","to":"A","pop_until":"B"}]})");
  return *machine;
}

Cell any_cell() { return {pick(4) == 0 ? Term::null() : Term::number(pick(3)), {pick(5)}}; }
Symbol any_symbol() { return {any_cell(), any_cell(), any_cell()}; }

Configuration any_configuration(int least = 1) {
  Configuration configuration;
  for (int depth = least + pick(5); depth > 0; --depth)
    configuration.stack = configuration.stack.push(any_symbol(), configuration.next.symbol++);
  return configuration;
}

// For some slots, or for all.
std::pair<Operation, Contents> any_change(Kind kind, bool all = false) {
  Operation operation;
  operation.kind = kind;
  Contents contents;
  for (std::size_t slot = 0; slot < slots; ++slot) {
    if (!all && pick(2) == 0) continue;
    operation.contents.push_back({slot, Term::null()});
    contents.push_back(pick(4) == 0 ? std::nullopt : std::optional<Cell>(any_cell()));
  }
  return {operation, contents};
}

Operation operation_of(Kind kind) {
  Operation operation;
  operation.kind = kind;
  return operation;
}

Configuration applied(const std::pair<Operation, Contents>& change, Configuration to) {
  const auto result = apply_operation(change.first, change.second, some_machine(), to);
  RC_ASSERT(result.trouble.empty());
  to.stack = result.stack;
  to.next.symbol = result.next_symbol;
  return to;
}
Configuration applied(Kind kind, const Configuration& to) { return applied({operation_of(kind), {}}, to); }

// ---- runs ----

naive::Machine any_machine() {
  return naive::sampled_machine(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint64_t>(0, 1U << 30)));
}

std::string any_word(int longest) {
  std::string word;
  for (int left = pick(longest + 1); left > 0; --left) word += pick(2) == 0 ? 'a' : 'b';
  return word;
}

// Confidences are powers of two, so that they scale weights exactly.
std::vector<naive::Offer> any_offers() {
  std::vector<naive::Offer> offers;
  for (int left = 1 + pick(4); left > 0; --left)
    offers.push_back({static_cast<char>('a' + pick(3)), std::ldexp(1.0, -pick(4))});
  return offers;
}

// Where a machine may come to; nothing if it does not come to rest there.
std::optional<Configuration> any_configuration_of(SmallEngine& engine) {
  auto step = engine.begin();
  for (const char input : any_word(5)) step = engine.step(step.after, input);
  if (has<Trouble>(step.events)) return std::nullopt;
  return step.after;
}

using Texts = std::set<std::string>;

Texts texts_of(const std::vector<Branch>& branches) {
  Texts all;
  for (const auto& branch : branches) all.insert(text_of(branch.configuration));
  return all;
}

}  // namespace

TEST_CASE("a pop undoes a push") {
  law("pop after push is identity", [] {
    const auto before = any_configuration();
    const auto pushed = applied(any_change(Kind::push), before);
    RC_ASSERT(pushed.stack.depth() == before.stack.depth() + 1);
    RC_ASSERT(applied(Kind::pop, pushed).stack == before.stack);
  });
}

TEST_CASE("a rewrite is a pop and a push") {
  law("with every slot mentioned they are the same", [] {
    const auto before = any_configuration(2);
    auto change = any_change(Kind::rewrite, true);
    const auto rewritten = applied(change, before);
    change.first.kind = Kind::push;
    RC_ASSERT(rewritten.stack == applied(change, applied(Kind::pop, before)).stack);
  });
  law("else the new symbol is as if it was pushed on the old one", [] {
    const auto before = any_configuration();
    auto change = any_change(Kind::rewrite);
    const auto rewritten = applied(change, before);
    change.first.kind = Kind::push;
    RC_ASSERT(same_values(rewritten.stack.top(), applied(change, before).stack.top()));
    RC_ASSERT(rewritten.stack.pop() == before.stack.pop());
  });
}

TEST_CASE("flush") {
  law("twice is once", [] {
    const auto flushed = applied(Kind::flush, any_configuration());
    RC_ASSERT(applied(Kind::flush, flushed).stack == flushed.stack);
    RC_ASSERT(flushed.stack.depth() == 1U);
  });
  law("keeps what persists, whatever else happens to the stack between flushes", [] {
    auto configuration = any_configuration();
    const Cell held = configuration.stack.top()[persisting];
    for (int left = pick(5); left > 0; --left) {
      auto change = any_change(pick(2) == 0 ? Kind::push : Kind::rewrite, true);
      change.first.contents.pop_back();
      change.second.pop_back();
      configuration = applied(Kind::flush, pick(2) == 0 ? applied(change, configuration) : configuration);
    }
    RC_ASSERT(configuration.stack.top()[persisting].value == held.value);
  });
  law("is what pop_until does where the state was never entered", [] {
    const auto before = any_configuration();
    Operation until = operation_of(Kind::pop_until);
    until.state = 1;
    RC_ASSERT(applied({until, {}}, before).stack == applied(Kind::flush, before).stack);
  });
}

TEST_CASE("a configuration that was kept stays as it was, however the run goes on") {
  law("snapshots never change", [] {
    SmallEngine engine(naive::json(any_machine()));
    std::vector<std::pair<Configuration, std::string>> kept;
    auto now = engine.begin().after;
    for (const char input : any_word(8)) {
      kept.push_back({now, text_of(now)});
      const auto step = engine.step(now, input);
      if (has<Trouble>(step.events)) break;
      now = step.after;
    }
    for (const auto& [configuration, text] : kept) RC_ASSERT(text_of(configuration) == text);
  });
}

TEST_CASE("a refused input changes nothing") {
  law("state, stack, registers and the next symbol stay", [] {
    SmallEngine engine(naive::json(any_machine()));
    auto now = engine.begin().after;
    for (const char input : any_word(8)) {
      const auto step = engine.step(now, input);
      if (has<RefusedInput>(step.events)) {
        RC_ASSERT(step.after.same_as(now));
        RC_ASSERT(step.after.stack.id() == now.stack.id());
        RC_ASSERT(step.after.next.symbol == now.next.symbol);
        RC_ASSERT(!has<Fired>(step.events));
      }
      if (has<Trouble>(step.events)) break;
      now = step.after;
    }
  });
}

TEST_CASE("exploring a set is exploring each of its configurations, equal ones merged or not") {
  law("the futures are the same", [] {
    const auto machine = any_machine();
    const std::size_t most = 30;
    auto twin = naive::explored(machine, most);  // tells where there are too many
    if (!twin) RC_DISCARD("stacks grow without end");
    SmallEngine engine(naive::json(machine), 10 * most);
    auto together = engine.explore();
    std::vector<Branch> alone = together.after.branches;
    for (const char input : any_word(5)) {
      const auto after = naive::explored(machine, *twin, input, most);
      if (!after) return;
      if (after->empty()) continue;
      twin = after;
      together = engine.explore(together.after, input);
      std::vector<Branch> next;
      for (const auto& branch : alone) {
        Exploration one;
        one.branches = {branch};
        const auto step = engine.explore(one, input);
        if (!has<RefusedInput>(step.events))
          next.insert(next.end(), step.after.branches.begin(), step.after.branches.end());
      }
      alone = next;
      RC_ASSERT(texts_of(together.after.branches) == texts_of(alone));
      if (alone.size() > 10 * most) return;
    }
  });
}

TEST_CASE("inputs that are alternatives of one another") {
  law("how sure all of them are together decides nothing", [] {
    SmallEngine engine(naive::json(any_machine()));
    const auto before = any_configuration_of(engine);
    if (!before) RC_DISCARD("no rest");
    auto offers = any_offers();
    const auto step = engine.step(*before, offers);
    for (auto& offer : offers) offer.confidence /= 8;
    RC_ASSERT(text_of(engine.step(*before, offers).after) == text_of(step.after));
  });
  law("one that is not taken, or of which nothing is sure, takes no part", [] {
    SmallEngine engine(naive::json(any_machine()));
    const auto before = any_configuration_of(engine);
    if (!before) RC_DISCARD("no rest");
    auto offers = any_offers();
    const auto step = engine.step(*before, offers);
    for (const naive::Offer idle : {naive::Offer{'z', 1}, naive::Offer{'a', 0}, naive::Offer{'b', 0}})
      offers.insert(offers.begin() + pick(static_cast<int>(offers.size()) + 1), idle);
    const auto more = engine.step(*before, offers);
    RC_ASSERT(text_of(more.after) == text_of(step.after));
    RC_ASSERT(has<RefusedInput>(more.events) == has<RefusedInput>(step.events));
  });
  law("what exploring them leads to is what each of them leads to", [] {
    SmallEngine engine(naive::json(any_machine()));
    const auto before = engine.explore().after;
    const auto offers = any_offers();
    const auto together = engine.explore(before, offers);
    Texts alone;
    for (const auto& offer : offers) {
      const auto step = engine.explore(before, {offer});
      if (has<RefusedInput>(step.events)) continue;
      if (step.after.branches.size() > 100) RC_DISCARD("stacks grow without end");
      alone.merge(texts_of(step.after.branches));
    }
    RC_ASSERT(has<RefusedInput>(together.events) == alone.empty());
    if (!alone.empty()) RC_ASSERT(texts_of(together.after.branches) == alone);
  });
}
