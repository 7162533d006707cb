#include "language/referring.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "term/substitution.h"

namespace continua {
namespace {

using By = Resolution::By;

// A definition that leads to another, and so on: no longer than this.
constexpr int most_definitions = 100;

Type property() { return Type::function(Type::entity(), Type::truth()); }

Term point(const Vec3& p_W) { return Term::point(p_W.x(), p_W.y(), p_W.z()); }

bool is_plural(const Determiner& determiner) { return determiner.many || determiner.count > 1; }

By by_of(Proform::Source source) {
  switch (source) {
    case Proform::Source::focus:
      return By::focus;
    case Proform::Source::pointed:
      return By::pointed;
    case Proform::Source::topic:
    case Proform::Source::other:
      return By::topic;
    case Proform::Source::avatar:
    case Proform::Source::human:
      return By::presence;
  }
  return By::words;
}

}  // namespace

const Determiner* Referring::determiner(const Term& term) const {
  if (term.kind() != Term::Kind::apply || term.function().kind() != Term::Kind::constant) return nullptr;
  const auto found = meanings_.operators->determiners.find(term.function().name());
  return found == meanings_.operators->determiners.end() ? nullptr : &found->second;
}

const Proform* Referring::proform(const Term& term) const {
  if (term.kind() != Term::Kind::constant) return nullptr;
  const auto found = meanings_.operators->proforms.find(term.name());
  return found == meanings_.operators->proforms.end() ? nullptr : &found->second;
}

bool Referring::is_phrase(const Term& term, const std::vector<Term>& open) const {
  if (const auto* pro = proform(term)) return pro->source != Proform::Source::other;
  return determiner(term) && term.closed() &&
         std::none_of(open.begin(), open.end(), [&](const Term& variable) { return contains(term, variable); });
}

Meant Referring::meant(const Term& phrase) const {
  if (const auto* pro = proform(phrase)) return by_proform(phrase, *pro);
  return by_determiner(phrase, phrase.argument(), *determiner(phrase));
}

bool Referring::is_noun(const Term& term) const {
  if (term.type().kind() != Type::Kind::function ||
      !consistent(term.type(), Type::function(Type::entity(), Type::truth())))
    return false;
  Term at = term;
  for (int definitions = 0; definitions < most_definitions;) {
    while (at.kind() == Term::Kind::lambda) at = Term(at.body());
    while (at.kind() == Term::Kind::apply) at = Term(at.function());
    if (at.kind() == Term::Kind::lambda) continue;
    if (at.kind() != Term::Kind::constant) return at.kind() == Term::Kind::truth;
    if (proform(at) || core_signature().contains(at.name()) || meanings_.rules->find(at.interned_name())) return true;
    const Term* definition = meanings_.lookup ? meanings_.lookup(at.interned_name()) : nullptr;
    if (!definition) return false;
    at = *definition;
    ++definitions;
  }
  return false;
}

Meant Referring::meant_by_noun(const Term& noun) const {
  // Any that fits may be meant; where the human points, that tells which.
  Determiner any;
  any.definite = any.deictic = true;
  return by_determiner(noun, noun, any);
}

Meant Referring::by_determiner(const Term& phrase, const Term& condition, const Determiner& determiner) const {
  return chosen(phrase, refer(with_topic(condition), determiner, context_, meanings_), determiner, words_of(condition));
}

// Definite phrases mean all referents that there are, so that there must be as many as are spoken of; of an indefinite
// one the likeliest are taken.
Meant Referring::chosen(const Term& phrase, Reference reference, const Determiner& determiner, std::string noun) const {
  const auto found = reference.referents.size();
  const auto least = static_cast<std::size_t>(std::max(determiner.count, 1));
  const bool all = determiner.many && determiner.count == 0;
  Meant meant;
  meant.plural = is_plural(determiner);
  meant.resolution.phrase = phrase;
  meant.resolution.words = words_of(phrase);
  meant.resolution.by = determiner.deictic && context_.pointed_W ? By::pointed : By::words;
  const Type type = meant.plural ? Type::list(Type::entity()) : Type::entity();
  if (found < least) {
    meant.gap = Gap{Gap::Why::none, type, {}, std::move(noun)};
  } else if (found > least && determiner.definite && !all) {
    meant.gap = Gap{Gap::Why::several, type, {}, std::move(noun)};
    for (const auto& each : reference.referents) meant.gap->choices.push_back(each.object);
  } else {
    for (std::size_t i = 0; i < (all ? found : least); ++i)
      meant.values.push_back(Term::entity(reference.referents[i].object));
    meant.resolution.value = meant.plural ? Term::list(meant.values, Type::entity()) : meant.values.front();
  }
  meant.resolution.reference = std::move(reference);
  return meant;
}

Meant Referring::by_proform(const Term& phrase, const Proform& proform) const {
  const Type& type = phrase.type();
  if (proform.source == Proform::Source::pointed && context_.pointed_W && consistent(type, Type::entity())) {
    Determiner shown;
    shown.definite = shown.deictic = true;
    return chosen(phrase, refer_to_pointed(context_), shown, "");
  }
  Meant meant;
  meant.resolution.phrase = phrase;
  meant.resolution.words = words_of(phrase);
  meant.resolution.by = by_of(proform.source);
  meant.plural = type.kind() == Type::Kind::list;
  if (meant.plural && proform.source == Proform::Source::focus) {
    for (const auto& object : context_.focus) meant.values.push_back(Term::entity(object));
  } else if (const auto value = single_value(proform, type)) {
    meant.values.push_back(*value);
  }
  if (meant.values.empty())
    meant.gap = Gap{Gap::Why::unsaid, type, {}, ""};
  else
    meant.resolution.value = meant.plural ? Term::list(meant.values, Type::entity()) : meant.values.front();
  return meant;
}

std::optional<Term> Referring::single_value(const Proform& proform, const Type& type) const {
  switch (proform.source) {
    case Proform::Source::focus:
      if (!context_.focus.empty() && consistent(type, Type::entity())) return Term::entity(context_.focus.front());
      return std::nullopt;
    case Proform::Source::pointed:
      if (context_.pointed_W && consistent(type, Type::location())) return point(*context_.pointed_W);
      return std::nullopt;
    case Proform::Source::topic:
      // Where nothing was named, "the red one" is any red thing.
      return context_.topic.is_null() ? Term::lambda("x", Type::entity(), Term::truth(true)) : context_.topic;
    case Proform::Source::other:
      return std::nullopt;
    case Proform::Source::avatar:
      return Term::entity("avatar");
    case Proform::Source::human:
      return Term::entity("human");
  }
  return std::nullopt;
}

// "the red one" with what "one" stands for, so that the reasons why others are ruled out say it.
Term Referring::with_topic(Term condition) const {
  for (const auto& [name, pro] : meanings_.operators->proforms)
    if (pro.source == Proform::Source::topic)
      condition = replaced(condition, Term::constant(name, property()), *single_value(pro, property()));
  return condition;
}

std::string Referring::words_of(const Term& phrase) const {
  const Term contracted = eta_contracted(phrase);
  for (const auto& each : reading_.phrases)
    if (eta_contracted(each.term) == contracted && each.words.end <= words_.size() &&
        each.words.begin <= each.words.end)
      return fmt::to_string(fmt::join(words_.begin() + static_cast<std::ptrdiff_t>(each.words.begin),
                                      words_.begin() + static_cast<std::ptrdiff_t>(each.words.end), " "));
  return {};
}

void Referring::named(const std::string& object) {
  const auto last = std::find(context_.focus.begin(), context_.focus.end(), object);
  if (last != context_.focus.end()) std::rotate(last, last + 1, context_.focus.end());
}

void Referring::focus_on(const std::vector<std::string>& objects) {
  for (const auto& object : objects) {
    std::erase(context_.focus, object);
    context_.focus.insert(context_.focus.begin(), object);
  }
}

}  // namespace continua
