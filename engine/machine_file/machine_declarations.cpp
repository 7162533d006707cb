#include "continua/machine_file/machine_declarations.h"

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
    terms.declare(entry, name, read.type);
    memory.push_back(std::move(read));
  }
  return memory;
}

}  // namespace continua
