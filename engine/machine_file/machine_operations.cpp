#include "continua/machine_file/machine_operations.h"

#include <optional>

#include <fmt/format.h>

namespace continua {
namespace {

constexpr NamedValue<Operation::Kind> operation_keys[] = {
    {Operation::Kind::none, "none"},           {Operation::Kind::push, "push"},
    {Operation::Kind::push_each, "push_each"}, {Operation::Kind::pop, "pop"},
    {Operation::Kind::rewrite, "rewrite"},     {Operation::Kind::rewrite_each, "rewrite_each"},
    {Operation::Kind::flush, "flush"},         {Operation::Kind::pop_until, "pop_until"},
};

constexpr int most_popped = 1'000'000;

std::optional<std::size_t> slot_named(const NamedItem& member, const Machine& declared) {
  if (const auto slot = declared.slot_index.find(member.key); slot != declared.slot_index.end()) return slot->second;
  std::vector<std::string> known;
  for (const auto& slot : declared.slots) known.push_back(slot.name);
  member.item.problem_at_key(member.item.unknown("slot", member.key, known));
  return std::nullopt;
}

}  // namespace

std::vector<Content> read_contents(const Item& item, bool lists, const Machine& declared, const TermReader& terms) {
  std::vector<Content> contents;
  for (const auto& member : item.members("slots and their contents")) {
    const auto slot = slot_named(member, declared);
    if (!slot) continue;
    const auto& type = declared.slots[*slot].type;
    Content content{*slot, std::nullopt};
    if (!member.item.json().is_null()) {
      content.term = lists ? terms.term(member.item, Type::list(type)) : terms.content(member.item, type);
      if (!content.term) continue;
    }
    contents.push_back(std::move(content));
  }
  return contents;
}

Operation OperationReader::operation(const Item& object) {
  // The kind of the operation is its key among the members; a second such key is a problem.
  Operation operation;
  std::string key;
  for (const auto& [kind, name] : operation_keys) {
    const auto item = object.member(name);
    if (!item.exists()) continue;
    if (!key.empty()) {
      item.problem_at_key(fmt::format("a second operation, '{}', besides '{}'; expected one", name, key));
      continue;
    }
    key = name;
    operation.kind = kind;
  }
  const auto item = object.member(key);
  if (key.empty() || !item.exists()) {
    operation.source = R"({"none":true})";
    return operation;
  }
  // The value of the key has the contents, which differ by kind.
  operation.source = compact(Json{{key, item.json()}});
  switch (operation.kind) {
    case Operation::Kind::none:
      if (item.json() != true) item.mismatch("true");
      break;
    case Operation::Kind::push:
      operation.contents = read_contents(item, false, declared_, terms_);
      break;
    case Operation::Kind::push_each:
    case Operation::Kind::rewrite_each:
      operation.contents = read_contents(item, true, declared_, terms_);
      break;
    case Operation::Kind::rewrite:
      operation.keeps_stack = item.json().is_null();
      if (!operation.keeps_stack) operation.contents = read_contents(item, false, declared_, terms_);
      break;
    case Operation::Kind::flush:
      if (item.json() != true) operation.contents = cleared_slots(item);
      break;
    case Operation::Kind::pop:
      operation.count = static_cast<std::size_t>(item.whole_number("how many symbols to pop", 1, 1, most_popped));
      break;
    case Operation::Kind::pop_until:
      operation.state = states_.named(item).value_or(0);
      break;
  }
  return operation;
}

std::vector<Content> OperationReader::cleared_slots(const Item& item) const {
  std::vector<Content> contents;
  for (const auto& member : item.members("the slots to clear too")) {
    if (const auto slot = slot_named(member, declared_)) contents.push_back({*slot, std::nullopt});
    if (!member.item.json().is_null()) member.item.mismatch("null for each slot that is cleared too");
  }
  return contents;
}

}  // namespace continua
