#include "continua/machine_file/machine_declarations.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "continua/machine_file/machine_keys.h"
#include "continua/machine_file/machine_operations.h"
#include "continua/term/evaluate.h"
#include "continua/term/read_type.h"

namespace continua {

Signature read_programs(const Item& item, TermReader& terms) {
  Signature programs;
  for (const auto& [name, entry] : item.members("programs")) {
    const auto type = read_type(entry);
    programs.emplace(name, type);
    terms.declare(entry, name, type);
  }
  return programs;
}

std::vector<Slot> read_slots(const Item& item, TermReader& terms) {
  std::vector<Slot> slots;
  for (const auto& [name, entry] : item.members("slots")) {
    Slot slot{name, Type::term(), false};
    if (entry.is_object()) {
      expect_kind(entry, "a slot");
      if (const auto type = entry.required("type", "the slot's type"); type.exists()) slot.type = read_type(type);
      slot.persists = entry.member("persists").truth(false);
    } else {
      slot.type = read_type(entry);
    }
    terms.declare(entry, name, slot.type);
    slots.push_back(std::move(slot));
  }
  return slots;
}

Symbol read_bottom(const Item& item, const Machine& declared) {
  static const RuleTable rules({&term_rules()});
  Symbol bottom;
  for (const auto& slot : declared.slots) bottom.push_back({empty_value(slot.type), {}});
  for (const auto& content : read_contents(item, false, declared, TermReader::of_programs(declared.programs))) {
    if (!content.term) continue;
    Evaluation evaluation(rules, [](Name) { return nullptr; });
    bottom[content.slot].value = evaluation.value(*content.term);
    if (evaluation.exhausted)
      item.member(declared.slots[content.slot].name).problem("the evaluation of this term does not end");
  }
  return bottom;
}

std::vector<Register> read_memory(const Item& item, TermReader& terms) {
  std::vector<Register> memory;
  for (const auto& [name, entry] : item.members("memory")) {
    if (!expect_kind(entry, "a register")) continue;
    Register read{name, read_type(entry.required("type", "the register's type")), Term::null()};
    read.initial = empty_value(read.type);
    if (const auto initial = terms.term(entry.member("initial"), read.type)) read.initial = *initial;
    for (const auto& operation : entry.member("cleared_by").elements("operations that clear it")) {
      const auto named = operation.one_of({"flush", "pop_until"});
      read.cleared_by_flush = read.cleared_by_flush || named == "flush";
      read.cleared_by_pop_until = read.cleared_by_pop_until || named == "pop_until";
    }
    terms.declare(entry, name, read.type);
    memory.push_back(std::move(read));
  }
  return memory;
}

void check_memory(const Item& item, const Machine& machine) {
  const auto performs = [&](Operation::Kind kind) {
    const auto is_one = [kind](const Operation& operation) { return operation.kind == kind; };
    return std::any_of(machine.transitions.begin(), machine.transitions.end(),
                       [&](const Transition& each) { return is_one(each.operation); }) ||
           std::any_of(machine.states.begin(), machine.states.end(),
                       [&](const State& each) { return each.gate && is_one(each.gate->operation); });
  };
  for (const auto& each : machine.memory)
    for (const auto& operation : item.member(each.name).member("cleared_by").elements("operations that clear it")) {
      if (!operation.is_text()) continue;
      const auto name = operation.json().get<std::string>();
      const bool flushes = name == "flush" && performs(Operation::Kind::flush);
      const bool pops = name == "pop_until" && performs(Operation::Kind::pop_until);
      if ((name == "flush" || name == "pop_until") && !flushes && !pops)
        operation.problem(fmt::format("no transition and no gate of this machine does {}: it never clears {}",
                                      in_quotes(name), in_quotes(each.name)));
    }
}

}  // namespace continua
