#include "continua/machine_file/machine_effects.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/machine_file/machine_keys.h"

namespace continua {
namespace {

const std::vector<std::string> effect_keys = {"say",    "phrase", "gesture", "act",          "remember", "learn",
                                              "forget", "attend", "rewrite", "rewrite_each", "do"};

// Whether the effects after this one are never performed.
bool ends_effects(const Effect& effect) {
  if (effect.when) return false;
  if (std::holds_alternative<Rewrite>(effect.what)) return true;
  const auto* group = std::get_if<Group>(&effect.what);
  return group && std::any_of(group->effects.begin(), group->effects.end(), ends_effects);
}

std::optional<Lesson> read_lesson(const Item& lesson) {
  std::optional<Lesson> found;
  for (const auto of : {Lesson::gesture, Lesson::word, Lesson::noun}) {
    if (!lesson.member(name_of(of)).exists()) continue;
    if (found) lesson.problem(fmt::format("found {} and {}, expected one of them", name_of(*found), name_of(of)));
    if (found) return std::nullopt;
    found = of;
  }
  if (!found) lesson.problem("found none, expected one of gesture, word, noun");
  return found;
}

}  // namespace

std::vector<Effect> EffectReader::effects(const Item& list) {
  std::vector<Effect> effects;
  bool over = false;
  for (const auto& item : list.elements("effects")) {
    auto read = effect(item);
    if (over) item.problem("never performed: the rewrite before it ends the effects");
    over = read && ends_effects(*read);
    if (read) effects.push_back(std::move(*read));
  }
  return effects;
}

std::optional<Effect> EffectReader::effect(const Item& object) {
  if (!expect_kind(object, "an effect")) return std::nullopt;
  std::vector<std::string> kinds;
  for (const auto& kind : effect_keys)
    if (object.member(kind).exists()) kinds.push_back(kind);
  if (kinds.size() != 1) {
    object.problem(fmt::format("found {}, expected one of {}",
                               kinds.empty() ? "none" : fmt::to_string(fmt::join(kinds, ", ")),
                               fmt::join(effect_keys, ", ")));
    return std::nullopt;
  }
  const auto when = object.member("when");
  Effect effect{terms_.term(when, Type::truth()), Group{}};
  if (auto read = what(object, kinds[0])) effect.what = std::move(*read);
  // An effect whose condition cannot be read must not pass for an unconditional one.
  return when.exists() && !effect.when ? std::nullopt : std::optional(std::move(effect));
}

std::optional<EffectReader::What> EffectReader::what(const Item& object, const std::string& kind) {
  const auto item = object.member(kind);
  const auto some = [](auto read) { return read ? std::optional<What>(std::move(*read)) : std::nullopt; };
  if (kind == "say") return some(phrases_.say(item));
  if (kind == "phrase") return some(phrases_.phrase(item));
  if (kind == "remember") return remember(item);
  if (kind == "learn") return some(learn(item));
  if (kind == "forget") return some(forget(item));
  if (kind == "attend") {
    const auto number = terms_.term(item, Type::number());
    return number ? std::optional<What>(Attend{*number}) : std::nullopt;
  }
  if (kind == "do") return Group{effects(item)};
  if (kind == "rewrite" || kind == "rewrite_each") return Rewrite{operations_.operation(object)};
  const auto term = terms_.term(item, Type::term());
  if (!term) return std::nullopt;
  return kind == "gesture" ? What(Gesture{*term}) : What(Act{*term});
}

Remember EffectReader::remember(const Item& registers) const {
  Remember remember;
  for (const auto& [name, item] : registers.members("registers and their values")) {
    const auto entry = declared_.register_index.find(name);
    if (entry == declared_.register_index.end()) {
      std::vector<std::string> known;
      for (const auto& each : declared_.memory) known.push_back(each.name);
      item.problem_at_key(item.unknown("register", name, known));
    } else if (const auto term = terms_.content(item, declared_.memory[entry->second].type)) {
      remember.registers.emplace_back(entry->second, *term);
    }
  }
  return remember;
}

std::optional<Learn> EffectReader::learn(const Item& lesson) const {
  if (!expect_kind(lesson, "what is learned")) return std::nullopt;
  const auto of = read_lesson(lesson);
  if (!of) return std::nullopt;
  const bool word = *of == Lesson::word;
  if (const auto other = lesson.member(word ? "means" : "acts"); other.exists())
    other.problem_at_key(word ? "a word stands for \"acts\"" : fmt::format("a {} has \"means\"", name_of(*of)));
  const auto name = terms_.term(lesson.member(name_of(*of)), Type::text_type());
  const auto value = word ? terms_.term(lesson.required("acts", "a list of acts, a term"), Type::list(Type::term()))
                          : terms_.term(lesson.required("means", "the meaning, a term"), Type::term());
  if (!name || !value) return std::nullopt;
  const auto fixed = lesson.member("fixed");
  if (fixed.exists() && !word) fixed.problem_at_key("only a word has acts whose objects may be fixed");
  return Learn{*of, *name, *value, fixed.truth(false)};
}

std::optional<Forget> EffectReader::forget(const Item& lesson) const {
  if (lesson.json() == "all") return Forget{std::nullopt, Term::null()};
  if (!lesson.is_object()) return lesson.mismatch("'all', or what is forgotten, an object"), std::nullopt;
  expect_kind(lesson, "what is forgotten");
  const auto of = read_lesson(lesson);
  if (!of) return std::nullopt;
  const auto name = terms_.term(lesson.member(name_of(*of)), Type::text_type());
  if (!name) return std::nullopt;
  return Forget{*of, *name};
}

}  // namespace continua
