#include "continua/analysis/machine_reads.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "continua/term/evaluate.h"

namespace continua {
namespace {

// Searches the terms that decide states, stack and registers, not the terms of utterances, gestures and acts.
class Reading {
 public:
  explicit Reading(const Machine& machine) : machine_(machine) {}

  std::optional<std::string> run() {
    if (!machine_.beliefs.evidence.empty() || !machine_.beliefs.answers.empty()) return "beliefs, which inputs change";
    for (const auto& transition : machine_.transitions) {
      read(transition.when);
      read(transition.operation);
      read(transition.effects);
    }
    for (const auto& state : machine_.states) {
      if (state.gate) read(state.gate->when);
      if (state.gate) read(state.gate->operation);
      read(state.enter);
    }
    return found_;
  }

 private:
  void read(const std::optional<Term>& term) {
    if (term) read(*term);
  }
  void read(const Operation& operation) {
    for (const auto& content : operation.contents) read(content.term);
  }
  void read(const std::vector<Effect>& effects) {
    for (const auto& effect : effects) {
      if (const auto* remember = std::get_if<Remember>(&effect.what))
        for (const auto& [index, term] : remember->registers) read(term);
      if (const auto* rewrite = std::get_if<Rewrite>(&effect.what)) read(rewrite->operation);
      if (const auto* group = std::get_if<Group>(&effect.what)) read(group->effects);
      const bool decides = !std::holds_alternative<Say>(effect.what) && !std::holds_alternative<Gesture>(effect.what) &&
                           !std::holds_alternative<Act>(effect.what) && !std::holds_alternative<Learn>(effect.what) &&
                           !std::holds_alternative<Forget>(effect.what);
      if (decides) read(effect.when);
    }
  }
  void read(const Term& term) {
    switch (term.kind()) {
      case Term::Kind::constant:
        return read_name(term.name());
      case Term::Kind::lambda:
        return read(term.body());
      case Term::Kind::apply:
        read(term.function());
        return read(term.argument());
      case Term::Kind::list:
        for (const auto& element : term.elements()) read(element);
        return;
      default:
        return;
    }
  }

  void read_name(const std::string& name) {
    using From = Binding::From;
    static constexpr std::array<std::string_view, 3> own = {"input", "in_state", "is_input"};
    static constexpr std::array carried = {From::carried, From::confidence, From::now, From::looked_at};
    const auto binding = machine_.bindings.find(Name(name));
    if (binding != machine_.bindings.end() &&
        std::find(carried.begin(), carried.end(), binding->second.from) != carried.end())
      return note(name, "which inputs carry");
    if (const auto definition = machine_.definitions.find(name); definition != machine_.definitions.end()) {
      if (visited_.insert(name).second) read(definition->second);
    } else if (const auto table = machine_.tables.find(name); table != machine_.tables.end()) {
      if (visited_.insert(name).second)
        for (const auto& [key, entry] : table->second) read(entry);
    } else if (!machine_.slot_index.contains(name) && !machine_.register_index.contains(name) &&
               !machine_.programs.contains(name) && !term_signature().contains(name) &&
               std::find(own.begin(), own.end(), name) == own.end()) {
      note(name, "a fact of the world");
    }
  }

  void note(const std::string& name, const char* what) {
    if (!found_) found_ = fmt::format("'{}', {}", name, what);
  }

  const Machine& machine_;
  std::set<std::string> visited_;
  std::optional<std::string> found_;
};

}  // namespace

std::optional<std::string> reads_from_outside(const Machine& machine) { return Reading(machine).run(); }

}  // namespace continua
