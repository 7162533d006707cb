#include "reference/naive_machines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/random.h"

namespace naive {

namespace {

using Kind = Operation::Kind;

const char* const slot_names[] = {"symbol", "held"};

std::string state_name(int state) { return std::string(1, static_cast<char>('P' + state)); }

std::string term(char value) {
  if (value == '-') return "null";
  return value == '0' || value == '1' ? slot_names[value - '0'] : fmt::format("'{}'", value);
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string condition(const Pattern& pattern) {
  std::vector<std::string> parts;
  for (std::size_t slot = 0; slot < pattern.size(); ++slot)
    if (pattern[slot] != '.') parts.push_back(fmt::format("{} = {}", slot_names[slot], term(pattern[slot])));
  return quoted(parts.empty() ? "true" : fmt::format("{}", fmt::join(parts, " and ")));
}

// { slot: content, … }
std::string contents(const Pattern& pattern) {
  std::vector<std::string> members;
  for (std::size_t slot = 0; slot < pattern.size(); ++slot)
    if (pattern[slot] != '.')
      members.push_back(
          fmt::format("\"{}\":{}", slot_names[slot], pattern[slot] == '-' ? "null" : quoted(term(pattern[slot]))));
  return fmt::format("{{{}}}", fmt::join(members, ","));
}

// { slot: list, … }; the symbol has a list even where that is empty.
std::string lists(const std::vector<Pattern>& patterns) {
  std::vector<std::string> members;
  for (std::size_t slot = 0; slot < (patterns.empty() ? 1 : patterns[0].size()); ++slot) {
    std::vector<std::string> elements;
    for (const auto& pattern : patterns)
      if (pattern[slot] != '.') elements.push_back(term(pattern[slot]));
    if (patterns.empty() || !elements.empty())
      members.push_back(fmt::format("\"{}\":\"[{}]\"", slot_names[slot], fmt::join(elements, ", ")));
  }
  return fmt::format("{{{}}}", fmt::join(members, ","));
}

std::string operation_member(const Operation& operation) {
  switch (operation.kind) {
    case Kind::none:
      return "\"none\":true";
    case Kind::push:
      return "\"push\":" + contents(operation.contents[0]);
    case Kind::push_each:
      return "\"push_each\":" + lists(operation.contents);
    case Kind::pop:
      return fmt::format("\"pop\":{}", operation.count);
    case Kind::rewrite:
      return "\"rewrite\":" + contents(operation.contents[0]);
    case Kind::rewrite_each:
      return "\"rewrite_each\":" + lists(operation.contents);
    case Kind::flush:
      return "\"flush\":" + contents(operation.contents[0]);
    case Kind::pop_until:
      return "\"pop_until\":" + quoted(state_name(operation.state));
  }
  return {};
}

std::string state_member(const State& state, int index) {
  std::string gate;
  if (state.gate)
    gate = fmt::format("\"gate\":{{\"when\":{},\"else\":{},{}}}", condition(state.gate->when),
                       quoted(state_name(state.gate->otherwise)), operation_member(state.gate->operation));
  return fmt::format("{}:{{{}}}", quoted(state_name(index)), gate);
}

std::string transition_text(const Transition& transition, std::size_t index) {
  std::vector<std::string> from, on;
  for (const int state : transition.from) from.push_back(quoted(state_name(state)));
  for (const char input : transition.on) on.push_back(quoted(std::string(1, input)));
  return fmt::format("{{\"id\":\"t{}\",\"from\":[{}],\"on\":{},\"when\":{},\"to\":{},\"rank\":{},\"weight\":{},{}}}",
                     index, fmt::join(from, ","), on.empty() ? "null" : fmt::format("[{}]", fmt::join(on, ",")),
                     condition(transition.when), quoted(state_name(transition.to)), transition.rank, transition.weight,
                     operation_member(transition.operation));
}

// Draws the parts of a machine.
class Sampler {
 public:
  Sampler(std::uint64_t number, const Limits& limits) : random_(number), limits_(limits) {}

  Machine machine() {
    machine_.slots = 1 + pick(2);
    machine_.unique = one_in(6);
    machine_.epsilon_always = !limits_.after_rewrite || !one_in(6);
    machine_.states.resize(1 + pick(3));
    const int states = static_cast<int>(machine_.states.size());
    for (int i = 0; i < states; ++i) {
      machine_.states[i].accepting = one_in(2);
      if (states > 1 && one_in(4))
        machine_.states[i].gate = Gate{condition(), (i + 1 + pick(states - 1)) % states, operation()};
    }
    for (int count = 2 + pick(6); count > 0; --count) machine_.transitions.push_back(transition());
    return machine_;
  }

 private:
  int pick(int below) { return static_cast<int>(random_.next() % static_cast<std::uint64_t>(below)); }
  bool one_in(int chances) { return pick(chances) == 0; }
  int any_state() { return pick(static_cast<int>(machine_.states.size())); }
  template <class T>
  T any_of(const std::vector<T>& these) {
    return these[pick(static_cast<int>(these.size()))];
  }

  Pattern pattern(const std::string& first, const std::string& second) {
    const auto any_in = [this](const std::string& these) { return these[pick(static_cast<int>(these.size()))]; };
    return {any_in(first), machine_.slots > 1 ? any_in(second) : '.'};
  }
  Pattern condition() { return pattern("...AB-", "....AB-"); }
  Pattern content() { return machine_.slots > 1 ? pattern(".-AB1", "..-AB0") : pattern(".-AABB", ""); }

  // All of one shape: a slot has a list or none.
  std::vector<Pattern> contents() {
    std::vector<Pattern> drawn;
    const bool second = one_in(2);
    for (int count = pick(4); count > 0; --count) drawn.push_back(pattern("AB-", second ? "AB-0" : "."));
    return drawn;
  }

  Operation operation() {
    Operation drawn;
    drawn.kind = any_of<Kind>({Kind::none, Kind::push, Kind::push, Kind::push_each, Kind::pop, Kind::rewrite,
                               Kind::rewrite_each, Kind::flush, limits_.pop_until ? Kind::pop_until : Kind::push});
    if (drawn.kind == Kind::push || drawn.kind == Kind::rewrite) drawn.contents = {content()};
    if (drawn.kind == Kind::push_each || drawn.kind == Kind::rewrite_each) drawn.contents = contents();
    if (drawn.kind == Kind::flush) drawn.contents = {pattern(".", "..-")};
    if (drawn.kind == Kind::pop) drawn.count = 1 + pick(3);
    drawn.state = any_state();
    return drawn;
  }

  Transition transition() {
    Transition drawn;
    for (int state = 0; state < static_cast<int>(machine_.states.size()); ++state)
      if (one_in(2)) drawn.from.insert(state);
    if (drawn.from.empty()) drawn.from.insert(any_state());
    drawn.on = any_of<std::string>({"a", "a", "b", "b", "ab", "", ""});
    drawn.when = condition();
    drawn.to = any_state();
    drawn.rank = any_of<int>({0, 0, 0, 1, -1});
    drawn.weight = any_of<double>({1, 1, 2, 0.5});
    drawn.operation = operation();
    return drawn;
  }

  continua::Random random_;
  Limits limits_;
  Machine machine_;
};

std::vector<Operation> every_operation() {
  return {{},
          {Kind::push, {"A."}},
          {Kind::push, {"-A"}},
          {Kind::push, {"1B"}},
          {Kind::push_each, {}},
          {Kind::push_each, {"A.", "B."}},
          {Kind::push_each, {"AB", "A-"}},
          {Kind::pop, {}, 1},
          {Kind::pop, {}, 2},
          {Kind::rewrite, {"B."}},
          {Kind::rewrite, {"10"}},
          {Kind::rewrite_each, {}},
          {Kind::rewrite_each, {"B.", "A."}},
          {Kind::flush, {".."}},
          {Kind::flush, {".-"}},
          {Kind::pop_until, {}, 1, 0},
          {Kind::pop_until, {}, 1, 1}};
}

}  // namespace

std::string json(const Machine& machine) {
  std::vector<std::string> accept, states, transitions;
  for (std::size_t i = 0; i < machine.states.size(); ++i) {
    states.push_back(state_member(machine.states[i], static_cast<int>(i)));
    if (machine.states[i].accepting) accept.push_back(quoted(state_name(static_cast<int>(i))));
  }
  for (std::size_t i = 0; i < machine.transitions.size(); ++i)
    transitions.push_back(transition_text(machine.transitions[i], i));
  return fmt::format(
      "{{\"machine\":1,\"name\":\"sample\",\"start\":\"P\",\"accept\":[{}],\"choice\":\"{}\",\"epsilon\":\"{}\",\n"
      " \"slots\":{{\"symbol\":\"text\"{}}},\n \"states\":{{{}}},\n \"transitions\":[\n  {}]}}",
      fmt::join(accept, ","), machine.unique ? "unique" : "likeliest",
      machine.epsilon_always ? "always" : "after_rewrite",
      machine.slots > 1 ? ",\"held\":{\"type\":\"text\",\"persists\":true}" : "", fmt::join(states, ","),
      fmt::join(transitions, ",\n  "));
}

std::vector<Machine> machines_of_two_operations() {
  const auto operations = every_operation();
  std::vector<Machine> machines;
  for (const auto& at_a : operations)
    for (const auto& at_b : operations) {
      Machine machine;
      machine.slots = 2;
      machine.states = {{true, {}}, {false, {}}};
      machine.transitions = {
          {{0, 1}, "a", "..", 1, 1, at_a}, {{1}, "b", "..", 0, 1, at_b}, {{0}, "b", "..", 1, 1, at_b}};
      if (machines.size() % 4 == 3) {
        machine.transitions.push_back({{0}, "", "A.", 1, 1, {}});
        machine.transitions.push_back({{1}, "", "A.", 1, 1, {Kind::pop, {}, 1}});
        machine.epsilon_always = machines.size() % 8 == 3;
      }
      machines.push_back(machine);
    }
  return machines;
}

Machine sampled_machine(std::uint64_t number, const Limits& limits) { return Sampler(number, limits).machine(); }

}  // namespace naive
