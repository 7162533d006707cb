// Records of a run log about the automaton: transitions, its stack, registers and certainties.
#pragma once

#include <fmt/format.h>

#include "continua/replay/log/brief_words.h"
#include "continua/replay/log/fields.h"

namespace continua::log {

struct Belief {
  std::string concept_name;
  double value = 0, was = 0;

  static constexpr Kind kind{.name = "belief",
                             .when = "A certainty changed.",
                             .decision = Decision::yes,
                             .stop = Stop::never,
                             .brief_adds = "(was )"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("concept", &Belief::concept_name, Says::what, "Name of the concept.", {.in_brief = true});
    use("value", &Belief::value, Says::what, "The certainty now, 0 to 1.", {.in_brief = true});
    use("was", &Belief::was, Says::how, "The certainty before.", {.in_brief = true});
  }
  std::string brief() const {
    return fmt::format("{} {} (was {})", concept_name, number_text(value), number_text(was));
  }
};

struct Memory {
  std::string register_name, value;
  std::optional<std::vector<std::int64_t>> because = {};

  static constexpr Kind kind{.name = "memory",
                             .when = "A register changed.",
                             .decision = Decision::yes,
                             .stop = Stop::never,
                             .brief_adds = ":="};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("register", &Memory::register_name, Says::what, "Name of the register.", {.in_brief = true});
    use("value", &Memory::value, Says::what, "Its new value.", {.form = "term", .in_brief = true});
    use("because", &Memory::because, Says::aside, of_sources, {.form = "record"});
  }
  std::string brief() const { return fmt::format("{} := {}", register_name, value); }
};

/// A transition that could have fired.
struct Candidate {
  std::string id;
  double weight = 0;
  std::optional<std::int64_t> alternative;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &Candidate::id, Says::how, "The transition.");
    use("weight", &Candidate::weight, Says::how, "Its weight.");
    use("alternative", &Candidate::alternative, Says::how,
        "The input that it takes, from 0; left out where one was offered.");
  }
};

/// A transition that could not fire.
struct Refused {
  std::string id, reason;
  std::optional<std::int64_t> alternative;
  std::optional<std::string> outranked_by;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &Refused::id, Says::how, "The transition.");
    use("reason", &Refused::reason, Says::aside,
        "The first part of its condition that did not hold, with its value; or the rank that was higher.");
    use("alternative", &Refused::alternative, Says::how,
        "The input that it would take, from 0; left out where one was offered.");
    use("outranked_by", &Refused::outranked_by, Says::how,
        "A transition of a higher rank that applies to the same input; left out where its own "
        "condition failed.");
  }
};

/// The condition of a state that was entered.
struct Gate {
  std::string state, condition;
  bool passed = false;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("state", &Gate::state, Says::how, "The state.");
    use("condition", &Gate::condition, Says::how, "Its condition.", {.form = "term"});
    use("passed", &Gate::passed, Says::how, "Whether it held; else the way went on to `else`.");
  }
};

struct Transition {
  std::string id;
  std::int64_t step = 0;
  std::string from, to;
  OrNull<std::string> input;
  Json operation;
  double weight = 0, probability = 0;
  OrNull<double> draw;
  bool forced = false;
  std::vector<Candidate> candidates;
  std::vector<Refused> refused;
  std::vector<Gate> gates;
  std::int64_t stack = 0, depth = 0;
  Margin margin;
  std::optional<std::int64_t> alternative;

  static constexpr Kind kind{.name = "transition",
                             .when = "A transition fired.",
                             .decision = Decision::yes,
                             .stop = Stop::if_sample_changed_stack,
                             .brief_adds = "→"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &Transition::id, Says::what, "The machine's id of the transition.");
    use("step", &Transition::step, Says::where, "Running number of the step, from 1.");
    use("from", &Transition::from, Says::what, "The state before.", {.in_brief = true});
    use("to", &Transition::to, Says::what, "The state after.", {.in_brief = true});
    use("input", &Transition::input, Says::what, "The input symbol; null for ε.");
    use("operation", &Transition::operation, Says::how,
        "As in the machine file, an object with one key: `none`, `push`, `push_each`, `pop`, `rewrite`, "
        "`rewrite_each`, `flush` or `pop_until`.");
    use("weight", &Transition::weight, Says::how, "Its weight.");
    use("probability", &Transition::probability, Says::how,
        "Its share of the weights of all candidates; 0 if it was forced against its rank.");
    use("draw", &Transition::draw, Says::how, "The random number that chose it, or null.");
    use("forced", &Transition::forced, Says::how, "Whether the run's options forced it.");
    use("candidates", &Transition::candidates, Says::how,
        "All transitions that could fire, each of the highest rank for its input.");
    use("refused", &Transition::refused, Says::how, "Those of fitting state and input that could not.");
    use("gates", &Transition::gates, Says::how,
        "Conditions of the state that it leads to, then of each `else` on the way.");
    use("stack", &Transition::stack, Says::where, "Id of the top symbol afterwards.");
    use("depth", &Transition::depth, Says::how, "Number of symbols on the stack afterwards.");
    use("margin", &Transition::margin, Says::aside,
        "Smallest distance of a compared number from the comparison, or null.");
    use("alternative", &Transition::alternative, Says::how,
        "Which of the inputs offered was taken, from 0; left out where one was offered.");
  }
  std::string brief() const { return fmt::format("{} → {}", from, to); }
};

struct Correction {
  std::string id, from, to;
  OrNull<std::int64_t> implied;
  std::int64_t stack = 0, depth = 0;

  static constexpr Kind kind{.name = "correction",
                             .when =
                                 "In the variant `teacher`: the engine did otherwise than was observed, and goes "
                                 "on from the state that the observation implies.",
                             .decision = Decision::yes,
                             .brief_adds = "→"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &Correction::id, Says::where, "`observed`.");
    use("from", &Correction::from, Says::what, "The state before.", {.in_brief = true});
    use("to", &Correction::to, Says::what, "The state after.", {.in_brief = true});
    use("implied", &Correction::implied, Says::how,
        "Row of the machine's `implied`, from 1; null: nothing was observed, so all is as before the input.");
    use("stack", &Correction::stack, Says::where, "Id of the top symbol afterwards.");
    use("depth", &Correction::depth, Says::how, "Number of symbols on the stack afterwards.");
  }
  std::string brief() const { return fmt::format("{} → {}", from, to); }
};

/// One configuration that the automaton may be in.
struct Branch {
  std::int64_t id = 0, parent = 0;
  std::string state;
  std::int64_t stack = 0, depth = 0;
  double weight = 0;
  bool settled = false;
  std::vector<std::string> by;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &Branch::id, Says::where, "Number of the branch.");
    use("parent", &Branch::parent, Says::where, "The branch that it comes from.");
    use("state", &Branch::state, Says::what, "Its state.");
    use("stack", &Branch::stack, Says::where, "Id of its top symbol.");
    use("depth", &Branch::depth, Says::what, "Number of symbols on its stack.");
    use("weight", &Branch::weight, Says::what, "Its weight; all weights sum to 1.");
    use("settled", &Branch::settled, Says::what, "Whether no ε-transition applies.");
    use("by", &Branch::by, Says::what, "The transitions of this step that led to it.");
  }
};

struct Branches {
  std::vector<Branch> branches;
  std::vector<std::int64_t> dropped;
  std::int64_t merged = 0, pruned = 0;

  static constexpr Kind kind{.name = "branches",
                             .when =
                                 "Under `explore`, after a step, while there is more than one branch. The records "
                                 "before it are the leading branch's, but for those of kind `branched`.",
                             .decision = Decision::yes,
                             .brief_adds = "or"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("branches", &Branches::branches, Says::what, "The branches, the leading one first.", {.in_brief = true});
    use("dropped", &Branches::dropped, Says::how, "The branches that could not take the input.");
    use("merged", &Branches::merged, Says::how, "Number of configurations that equalled another.");
    use("pruned", &Branches::pruned, Says::how, "Number of configurations beyond the bound.");
  }
  std::string brief() const;
};

/// A record of a branch that does not lead.
struct Branched {
  std::int64_t branch = 0, parent = 0;
  std::string what;
  Json record;

  static constexpr Kind kind{.name = "branched",
                             .when =
                                 "Under `explore`: a branch that does not lead went on. Nothing is carried out of it. "
                                 "Written before the record of `branches`, for each branch its whole way since the "
                                 "input, so branches that forked later repeat the transitions that they share (with "
                                 "one `step`).",
                             .decision = Decision::yes,
                             .stop = Stop::never};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("branch", &Branched::branch, Says::where, "Number of the branch, as in `branches`.", {.in_brief = true});
    use("parent", &Branched::parent, Says::where, "The branch that it comes from.");
    use("what", &Branched::what, Says::what,
        "Kind of the record: `transition`, `rewrite`, `application`, `memory`, `utterance`, `gesture`, `act`, "
        "`problem`.",
        {.in_brief = true});
    use("record", &Branched::record, Says::what,
        "Its members, as that kind has them, without those of every record; an act has the number 0.",
        {.in_brief = true, .leaves_out = {"stack", "step"}});
  }
  std::string brief() const;
};

struct Symbol {
  std::int64_t id = 0;
  OrNull<std::int64_t> below;
  Named<std::string> slots;
  std::optional<std::vector<std::int64_t>> because = {};

  static constexpr Kind kind{.name = "symbol",
                             .when =
                                 "A stack symbol was made. Written once, before the first record that names it; "
                                 "the stack is a walk down the ids.",
                             .decision = Decision::yes,
                             .stop = Stop::never,
                             .brief_adds = "# ,"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &Symbol::id, Says::where, "Id of the symbol in this log.", {.in_brief = true});
    use("below", &Symbol::below, Says::where, "Id of the symbol below it; null at the bottom.");
    use("slots", &Symbol::slots, Says::what, "{slot: term}, without slots that are null or empty.",
        {.form = "term", .in_brief = true});
    use("because", &Symbol::because, Says::aside, of_sources, {.form = "record"});
  }
  std::string brief() const;
};

struct Rewrite {
  std::string state;
  Json operation;
  std::int64_t stack = 0, depth = 0;

  static constexpr Kind kind{.name = "rewrite",
                             .when = "The entry behaviour of a state changed the stack.",
                             .decision = Decision::yes,
                             .stop = Stop::if_sample_changed_stack};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("state", &Rewrite::state, Says::what, "The state.", {.in_brief = true});
    use("operation", &Rewrite::operation, Says::how, "As in the machine file, an object with one key.",
        {.in_brief = true});
    use("stack", &Rewrite::stack, Says::where, "Id of the top symbol afterwards.");
    use("depth", &Rewrite::depth, Says::how, "Number of symbols on the stack afterwards.");
  }
  std::string brief() const;
};

/// The types of a function, its argument and its result.
struct ApplicationTypes {
  std::string function, argument, result;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("function", &ApplicationTypes::function, Says::how, "Type of the function.");
    use("argument", &ApplicationTypes::argument, Says::how, "Type of the argument.");
    use("result", &ApplicationTypes::result, Says::how, "Type of the result.");
  }
};

struct Application {
  std::string function, argument, result;
  ApplicationTypes types;
  OrNull<std::string> rule;
  std::vector<std::int64_t> because;

  static constexpr Kind kind{
      .name = "application", .when = "A continuation was applied.", .decision = Decision::yes, .brief_adds = "@ ="};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("function", &Application::function, Says::what, "The function.", {.form = "term", .in_brief = true});
    use("argument", &Application::argument, Says::what, "The argument.", {.form = "term", .in_brief = true});
    use("result", &Application::result, Says::what, "The result.", {.form = "term", .in_brief = true, .follows = true});
    use("types", &Application::types, Says::how, "Their types.");
    use("rule", &Application::rule, Says::how, "The raising rule that made the argument fit, or null.");
    use("because", &Application::because, Says::aside, of_sources, {.form = "record"});
  }
  std::string brief() const { return fmt::format("{} @ {} = {}", function, argument, result); }
};

struct Refusal {
  std::string state, input, reason;
  std::vector<Refused> refused;

  static constexpr Kind kind{.name = "refusal",
                             .when = "No transition could take the input.",
                             .decision = Decision::yes,
                             .stop = Stop::unless_of_sample,
                             .brief_adds = "in :"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("state", &Refusal::state, Says::what, "The state.", {.in_brief = true});
    use("input", &Refusal::input, Says::what, "The input symbol, the first of those offered.", {.in_brief = true});
    use("reason", &Refusal::reason, Says::how, "The reason, a sentence.", {.in_brief = true});
    use("refused", &Refusal::refused, Says::how, "The transitions of this state and input.");
  }
  std::string brief() const { return joined({input, "in", state + ":", reason}); }
};

using RecordsOfAutomaton =
    Kinds<Belief, Memory, Transition, Correction, Branches, Branched, Symbol, Rewrite, Application, Refusal>;

}  // namespace continua::log
