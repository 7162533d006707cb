// Everything in a machine file that is computed: definitions, conditions, contents, templates, effects, wordings.
#include <algorithm>

#include <fmt/format.h>

#include "automaton/machine_reader.h"

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

// "\x y. put(x, y)" gives "\x y. "; a term that is no lambda gives "".
std::string binders_of(const std::string& lambda) {
  const auto begin = lambda.find_first_not_of(' ');
  const bool is_lambda = begin != std::string::npos && (lambda[begin] == '\\' || lambda.compare(begin, 2, "λ") == 0);
  const auto dot = lambda.find('.');
  return is_lambda && dot != std::string::npos ? lambda.substr(0, dot + 1) + " " : std::string();
}

}  // namespace

std::optional<Term> MachineReader::parse(const Item& item, const Type& expected) {
  return parse_text(item, text_of(item, "a term"), expected);
}

std::optional<Term> MachineReader::parse_text(const Item& at, const std::string& text, const Type& expected) {
  auto term = parse_term(text, scope_, expected);
  if (term) return *term;
  problem(at, fmt::format("{}, in \"{}\"", term.error().text(), text));
  return std::nullopt;
}

// Definitions may use one another in any order: those whose names are all known are read first, until none is left.
void MachineReader::read_definitions(const Item& definitions) {
  if (!definitions.json || !expect_object(definitions, "definitions")) return;
  std::vector<std::string> waiting;
  for (const auto& [name, value] : definitions.json->items()) {
    if (value.is_object())
      declare(member(definitions, name), name, Type::function(Type::text_type(), Type::term()));
    else
      waiting.push_back(name);
  }
  for (bool progress = true; progress && !waiting.empty();) {
    progress = false;
    for (auto name = waiting.begin(); name != waiting.end();) {
      const auto item = member(definitions, *name);
      const auto text = item.json->is_string() ? item.json->get<std::string>() : std::string();
      const auto term = parse_term(text, scope_);
      if (!term) {
        ++name;
        continue;
      }
      declare(item, *name, term->type());
      machine_.definitions.emplace(*name, *term);
      name = waiting.erase(name);
      progress = true;
    }
  }
  for (const auto& name : waiting) parse(member(definitions, name), Type::term());
  for (const auto& [name, value] : definitions.json->items()) {
    if (!value.is_object()) continue;
    const auto table = member(definitions, name);
    auto& entries = machine_.tables[name];
    for (const auto& [key, entry] : value.items())
      if (const auto term = parse(member(table, key), Type::term())) entries.emplace(key, *term);
  }
}

void MachineReader::read_wordings(const Item& wordings) {
  if (!wordings.json || !expect_array(wordings, "the wordings")) return;
  for (std::size_t i = 0; i < wordings.json->size(); ++i) {
    const auto item = element(wordings, i);
    if (!expect_object(item, "a wording", {"of", "when", "say", "about"})) continue;
    const auto of = member(item, "of");
    const auto pattern = parse(of, Type::term());
    if (!pattern) continue;
    const auto binders = binders_of(of.json->get<std::string>());
    Wording wording{{}, *pattern, std::nullopt, {}};
    while (wording.pattern.kind() == Term::Kind::lambda && wording.variables.size() < 16) {
      wording.variables.push_back(wording.pattern.variable_type());
      wording.pattern = Term(wording.pattern.body());
    }
    if (const auto when = member(item, "when"); when.json)
      wording.when = parse_text(when, binders + text_of(when, "a condition"), Type::term());
    const auto say = read_template(member(item, "say"), binders);
    if (!say) continue;
    wording.say = *say;
    machine_.wordings.push_back(std::move(wording));
  }
}

std::optional<Template> MachineReader::read_template(const Item& item, const std::string& binders) {
  const auto text = text_of(item, "what is said");
  Template result;
  std::size_t at = 0;
  for (;;) {
    const auto open = text.find('{', at);
    result.literals.push_back(text.substr(at, open == std::string::npos ? open : open - at));
    if (open == std::string::npos) return result;
    const auto close = text.find('}', open);
    if (close == std::string::npos) {
      problem(item, fmt::format("a '{{' without its '}}' in \"{}\"", text));
      return std::nullopt;
    }
    const auto hole = parse_text(item, binders + text.substr(open + 1, close - open - 1), Type::term());
    if (!hole) return std::nullopt;
    result.holes.push_back(*hole);
    at = close + 1;
  }
}

Operation MachineReader::read_operation(const Item& object) {
  Operation operation;
  const OperationKey* found = nullptr;
  for (const auto& key : operation_keys) {
    if (!member(object, key.name).json) continue;
    if (found)
      problem(member(object, key.name),
              fmt::format("a second operation, '{}', beside '{}'; expected one", key.name, found->name));
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
      if (item.json->is_boolean()) break;
      operation.contents = read_contents(item, false);
      for (const auto& content : operation.contents)
        if (content.term) problem(item, "flush clears slots: expected null for each slot it names");
      break;
    case Operation::Kind::pop: {
      const auto count = number_of(item, "how many symbols to pop", 1);
      if (count < 1 || count > 1e6 || count != static_cast<double>(static_cast<long>(count)))
        problem(item, "expected how many symbols to pop, a whole number from 1");
      else
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
    const auto slot = machine_.slot_index.find(name);
    if (slot == machine_.slot_index.end()) {
      std::vector<std::string> known;
      for (const auto& entry : machine_.slots) known.push_back(entry.name);
      problem(item, fmt::format("unknown slot '{}'{}", name, did_you_mean(name, known)));
      continue;
    }
    const auto& type = machine_.slots[slot->second].type;
    Content content{slot->second, std::nullopt};
    if (!value.is_null()) {
      content.term = parse(item, lists ? Type::list(type) : type);
      if (!content.term) continue;
    }
    contents.push_back(std::move(content));
  }
  return contents;
}

std::vector<Effect> MachineReader::read_effects(const Item& list) {
  std::vector<Effect> effects;
  if (!expect_array(list, "effects")) return effects;
  for (std::size_t i = 0; i < list.json->size(); ++i)
    if (auto effect = read_effect(element(list, i))) effects.push_back(std::move(*effect));
  return effects;
}

std::optional<Effect> MachineReader::read_effect(const Item& object) {
  if (!expect_object(object, "an effect",
                     {"when", "say", "gesture", "act", "remember", "rewrite", "rewrite_each", "do", "about"}))
    return std::nullopt;
  Effect effect{std::nullopt, Group{}};
  if (const auto when = member(object, "when"); when.json) {
    effect.when = parse(when, Type::truth());
    if (!effect.when) return std::nullopt;
  }
  int kinds = 0;
  if (const auto say = member(object, "say"); say.json) {
    ++kinds;
    if (auto text = read_template(say, "")) effect.what = Say{std::move(*text)};
  }
  if (const auto gesture = member(object, "gesture"); gesture.json) {
    ++kinds;
    if (const auto term = parse(gesture, Type::term())) effect.what = Gesture{*term};
  }
  if (const auto act = member(object, "act"); act.json) {
    ++kinds;
    if (const auto term = parse(act, Type::term())) effect.what = Act{*term};
  }
  if (const auto remember = member(object, "remember");
      remember.json && expect_object(remember, "registers and their values")) {
    ++kinds;
    Remember what;
    for (const auto& [name, value] : remember.json->items()) {
      const auto item = member(remember, name);
      const auto entry = machine_.register_index.find(name);
      if (entry == machine_.register_index.end()) {
        std::vector<std::string> known;
        for (const auto& one : machine_.memory) known.push_back(one.name);
        problem(item, fmt::format("unknown register '{}'{}", name, did_you_mean(name, known)));
      } else if (const auto term = parse(item, machine_.memory[entry->second].type)) {
        what.registers.emplace_back(entry->second, *term);
      }
    }
    effect.what = std::move(what);
  }
  if (member(object, "rewrite").json || member(object, "rewrite_each").json) {
    ++kinds;
    effect.what = Rewrite{read_operation(object)};
  }
  if (const auto group = member(object, "do"); group.json) {
    ++kinds;
    effect.what = Group{read_effects(group)};
  }
  if (kinds != 1) {
    problem(object, "expected one of say, gesture, act, remember, rewrite, rewrite_each, do");
    return std::nullopt;
  }
  return effect;
}

}  // namespace continua
