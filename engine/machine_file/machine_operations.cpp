// What happens to the stack and beside it: operations, their contents, effects.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine_file/machine_reader.h"

namespace continua {
namespace {

struct OperationKey {
  const char* name;
  Operation::Kind kind;
};

constexpr OperationKey operation_keys[] = {
    {"none", Operation::Kind::none},           {"push", Operation::Kind::push},
    {"push_each", Operation::Kind::push_each}, {"pop", Operation::Kind::pop},
    {"rewrite", Operation::Kind::rewrite},     {"rewrite_each", Operation::Kind::rewrite_each},
    {"flush", Operation::Kind::flush},         {"pop_until", Operation::Kind::pop_until},
};

// Whether nothing in the list after it is performed, whatever the moment.
bool ends_effects(const Effect& effect) {
  if (effect.when) return false;
  if (std::holds_alternative<Rewrite>(effect.what)) return true;
  const auto* group = std::get_if<Group>(&effect.what);
  return group && std::any_of(group->effects.begin(), group->effects.end(), ends_effects);
}

}  // namespace

Operation MachineReader::read_operation(const Item& object) {
  Operation operation;
  const OperationKey* found = nullptr;
  for (const auto& key : operation_keys) {
    if (!member(object, key.name).json) continue;
    if (found)
      problem_at_key(member(object, key.name),
                     fmt::format("a second operation, '{}', beside '{}'; expected one", key.name, found->name));
    else
      found = &key;
  }
  if (!found) {
    operation.source = R"({"none":true})";
    return operation;
  }
  const auto item = member(object, found->name);
  operation.kind = found->kind;
  operation.source = compact(Json{{found->name, *item.json}});
  switch (operation.kind) {
    case Operation::Kind::none:
      if (*item.json != true) mismatch(item, "true");
      break;
    case Operation::Kind::push:
      operation.contents = read_contents(item, false);
      break;
    case Operation::Kind::push_each:
    case Operation::Kind::rewrite_each:
      operation.contents = read_contents(item, true);
      break;
    case Operation::Kind::rewrite:
      operation.keeps_stack = item.json->is_null();
      if (!operation.keeps_stack) operation.contents = read_contents(item, false);
      break;
    case Operation::Kind::flush:
      if (*item.json == true || !expect_object(item, "the slots to clear too")) break;
      for (const auto& [name, value] : item.json->items()) {
        if (const auto slot = slot_named(item, name)) operation.contents.push_back({*slot, std::nullopt});
        if (!value.is_null()) mismatch(member(item, name), "null for each slot that is cleared too");
      }
      break;
    case Operation::Kind::pop: {
      const auto count = number_of(item, "how many symbols to pop", 1, 1, 1e6);
      if (count != std::floor(count)) mismatch(item, "how many symbols to pop, a whole number");
      operation.count = static_cast<std::size_t>(count);
      break;
    }
    case Operation::Kind::pop_until:
      operation.state = state_named(item);
      break;
  }
  return operation;
}

std::vector<Content> MachineReader::read_contents(const Item& object, bool lists) {
  std::vector<Content> contents;
  if (!expect_object(object, "slots and their contents")) return contents;
  for (const auto& [name, value] : object.json->items()) {
    const auto item = member(object, name);
    const auto slot = slot_named(object, name);
    if (!slot) continue;
    const auto& type = machine_.slots[*slot].type;
    Content content{*slot, std::nullopt};
    if (!value.is_null()) {
      content.term = parse(item, lists ? Type::list(type) : type);
      if (!content.term) continue;
    }
    contents.push_back(std::move(content));
  }
  return contents;
}

std::optional<std::size_t> MachineReader::slot_named(const Item& contents, const std::string& name) {
  if (const auto slot = machine_.slot_index.find(name); slot != machine_.slot_index.end()) return slot->second;
  std::vector<std::string> known;
  for (const auto& slot : machine_.slots) known.push_back(slot.name);
  problem_at_key(member(contents, name), fmt::format("unknown slot {}{}", in_quotes(name), nearest(name, known)));
  return std::nullopt;
}

std::vector<Effect> MachineReader::read_effects(const Item& list) {
  std::vector<Effect> effects;
  if (!expect_array(list, "effects")) return effects;
  bool over = false;
  for (std::size_t i = 0; i < list.json->size(); ++i) {
    auto effect = read_effect(element(list, i));
    if (over) problem(element(list, i), "never performed: the rewrite before it ends the effects");
    over = effect && ends_effects(*effect);
    if (effect) effects.push_back(std::move(*effect));
  }
  return effects;
}

std::optional<Effect> MachineReader::read_effect(const Item& object) {
  if (!expect_object(object, "an effect")) return std::nullopt;
  std::vector<std::string> kinds;
  for (const auto* kind : {"say", "phrase", "gesture", "act", "remember", "rewrite", "rewrite_each", "do"})
    if (member(object, kind).json) kinds.push_back(kind);
  if (kinds.size() != 1) {
    problem(object,
            fmt::format("found {}, expected one of say, phrase, gesture, act, remember, rewrite, rewrite_each, do",
                        kinds.empty() ? "none" : fmt::to_string(fmt::join(kinds, ", "))));
    return std::nullopt;
  }
  Effect effect{std::nullopt, Group{}};
  const auto when = member(object, "when");
  effect.when = parse(when, Type::truth());
  const auto item = member(object, kinds[0]);
  if (kinds[0] == "say") {
    if (auto say = read_say(item)) effect.what = std::move(*say);
  } else if (kinds[0] == "phrase") {
    if (auto phrase = read_phrase(item)) effect.what = std::move(*phrase);
  } else if (kinds[0] == "gesture") {
    if (const auto term = parse(item, Type::term())) effect.what = Gesture{*term};
  } else if (kinds[0] == "act") {
    if (const auto term = parse(item, Type::term())) effect.what = Act{*term};
  } else if (kinds[0] == "remember") {
    effect.what = read_remember(item);
  } else if (kinds[0] == "do") {
    effect.what = Group{read_effects(item)};
  } else {
    effect.what = Rewrite{read_operation(object)};
  }
  // What has a condition that cannot be read must not be taken for one that has none.
  return when.json && !effect.when ? std::nullopt : std::optional(std::move(effect));
}

Remember MachineReader::read_remember(const Item& registers) {
  Remember remember;
  if (!expect_object(registers, "registers and their values")) return remember;
  for (const auto& [name, value] : registers.json->items()) {
    const auto item = member(registers, name);
    const auto entry = machine_.register_index.find(name);
    if (entry == machine_.register_index.end()) {
      std::vector<std::string> known;
      for (const auto& one : machine_.memory) known.push_back(one.name);
      problem_at_key(item, fmt::format("unknown register {}{}", in_quotes(name), nearest(name, known)));
    } else if (const auto term = parse(item, machine_.memory[entry->second].type)) {
      remember.registers.emplace_back(entry->second, *term);
    }
  }
  return remember;
}

}  // namespace continua
