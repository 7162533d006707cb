#include "continua/language/referring.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/language/nearest.h"
#include "continua/language/noun_phrase.h"
#include "continua/language/pointing.h"
#include "continua/language/topic.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

using By = Resolution::By;

// The longest chain of definitions that is followed.
constexpr int most_definitions = 100;

Term point(const Vec3& p_W) { return Term::point(p_W.x(), p_W.y(), p_W.z()); }

bool is_anything(const Term& condition) { return condition.kind() == Term::Kind::lambda && condition.body().is_true(); }

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
    case Proform::Source::handled:
      return By::focus;
  }
  return By::words;
}

}  // namespace

const Determiner* Referring::determiner(const Term& term) const { return determiner_of(term, *meanings_.operators); }

const Proform* Referring::proform(const Term& term) const { return proform_of(term, *meanings_.operators); }

bool Referring::is_phrase(const Term& term, const std::vector<Term>& open) const {
  if (const auto* pro = proform(term)) return pro->source != Proform::Source::other;
  return determiner(term) && term.closed() &&
         std::none_of(open.begin(), open.end(), [&](const Term& variable) { return contains(term, variable); });
}

Meant Referring::meant(const Term& phrase, std::size_t occurrence) const {
  Meant meant = [&] {
    if (const auto* pro = proform(phrase)) return by_proform(phrase, *pro, occurrence);
    return by_determiner(phrase, phrase.argument(), *determiner(phrase), occurrence);
  }();
  if (meant.resolution.by == By::pointed) meant.resolution.showing = showing_of(phrase, occurrence);
  return meant;
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
    const Term* definition = meanings_.lookup ? meanings_.lookup(at.interned_name()).value : nullptr;
    if (!definition) return false;
    at = *definition;
    ++definitions;
  }
  return false;
}

Meant Referring::meant_by_noun(const Term& noun) const {
  // Any object that fits may be meant; pointing tells which.
  Determiner any;
  any.definite = any.deictic = true;
  Meant meant = by_determiner(noun, noun, any, 0);
  if (meant.resolution.by == By::pointed) meant.resolution.showing = showing_of(noun, 0);
  return meant;
}

// If the words fit more than one object, a pointing that goes with "the cup" tells which.
Meant Referring::by_determiner(const Term& phrase, const Term& noun, Determiner determiner,
                               std::size_t occurrence) const {
  std::vector<Resolution> within;
  const Term condition = with_shown(phrase, noun, occurrence, within);
  if (auto each = by_showings(phrase, condition, determiner, words_of(noun, occurrence), occurrence)) {
    each->within = std::move(within);
    return *std::move(each);
  }
  const Context context = context_of(phrase, occurrence);
  if (determiner.deictic && !context.pointed_W && is_anything(condition))
    return undefined(phrase, determiner, occurrence);
  Reference reference = found(condition, determiner, context);
  if (determiner.many && determiner.count == 0 && !reference.referents.empty())
    if (const auto kind = kind_without_things(condition, determiner, context))
      return chosen(phrase, {}, determiner, words_of_kind(*kind, words_of(noun, occurrence)), context, occurrence);
  const auto enough = static_cast<std::size_t>(std::max(determiner.count, 1));
  if (determiner.definite && !determiner.deictic && reference.referents.size() > enough &&
      showing_of(phrase, occurrence)) {
    determiner.deictic = true;
    reference = found(condition, determiner, context);
  }
  if (determiner.definite && !is_plural(determiner) && !(determiner.deictic && context.pointed_W))
    reference = nearest_to_landmark(std::move(reference), condition, context, meanings_);
  Meant meant = chosen(phrase, std::move(reference), determiner, words_of(noun, occurrence), context, occurrence);
  meant.within = std::move(within);
  return meant;
}

// The kind without a thing, in "the red and the yellow blocks"; nothing if there is a thing of each.
std::optional<Term> Referring::kind_without_things(const Term& condition, const Determiner& determiner,
                                                   const Context& context) const {
  if (condition.kind() != Term::Kind::lambda) return std::nullopt;
  std::vector<Term> kinds = {condition.body()};
  for (std::size_t i = 0; i < kinds.size();) {
    const auto [head, parts] = kinds[i].spine();
    if (head.kind() != Term::Kind::constant || head.name() != "or" || parts.size() != 2) {
      ++i;
      continue;
    }
    kinds[i] = parts[0];
    kinds.insert(kinds.begin() + static_cast<std::ptrdiff_t>(i) + 1, parts[1]);
  }
  if (kinds.size() < 2) return std::nullopt;
  for (const auto& kind : kinds) {
    auto one = Term::lambda(condition.name(), condition.variable_type(), kind);
    if (found(one, determiner, context).referents.empty()) return one;
  }
  return std::nullopt;
}

// "yellow blocks" of "red and yellow blocks": the words that name the kind, and the last one. All words where none
// does.
std::string Referring::words_of_kind(const Term& kind, const std::string& words) {
  std::istringstream stream(words);
  std::vector<std::string> all;
  for (std::string word; stream >> word;) all.push_back(word);
  const auto names = names_in(print(kind));
  std::string named;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (names.contains(all[i]) || (i + 1 == all.size() && !named.empty())) named += (named.empty() ? "" : " ") + all[i];
  return named.empty() ? words : named;
}

// "these two" with a pointing for each, "these" with several: the thing at each of them. Nothing where there are fewer
// pointings, or where one of them shows no such thing.
std::optional<Meant> Referring::by_showings(const Term& phrase, const Term& condition, const Determiner& determiner,
                                            std::string noun, std::size_t occurrence) const {
  const auto span = span_of(phrase, occurrence);
  if (!span || !determiner.deictic || !is_plural(determiner)) return std::nullopt;
  Determiner one = determiner;
  one.count = 0;
  one.many = false;
  Reference all;
  Context there = context_;
  for (const auto& showing : context_.showings) {
    if (showing.words.begin < span->begin || showing.words.end > span->end) continue;
    there.pointed_W = showing.place_W;
    there.pointed_sd_m = showing.sd_m;
    auto shown = found(condition, one, there).referents;
    const auto* thing = shown.empty() ? nullptr : context_.facts.world->find(shown.front().object);
    if (!thing || !is_pointed_at(showing.place_W, *thing, showing.sd_m)) return std::nullopt;
    const bool known = std::any_of(all.referents.begin(), all.referents.end(),
                                   [&](const Referent& each) { return each.object == shown.front().object; });
    if (!known) all.referents.push_back(std::move(shown.front()));
  }
  const bool enough = determiner.count > 0 ? all.referents.size() == static_cast<std::size_t>(determiner.count)
                                           : all.referents.size() > 1;
  if (!enough) return std::nullopt;
  return chosen(phrase, std::move(all), determiner, std::move(noun), there, occurrence);
}

// Whether a pointing gesture goes with "it", and means a thing that the command does not name otherwise. A hand that
// only rests somewhere does not tell what "it" means.
bool Referring::shows_another(const Term& phrase, std::size_t occurrence) const {
  const auto showing = showing_of(phrase, occurrence);
  if (!showing || !context_.showings[*showing].is_gesture) return false;
  const auto pointed = refer_to_pointed(context_of(phrase, occurrence)).referents;
  const auto& shown = context_.showings[*showing];
  return !pointed.empty() &&
         is_pointed_at(shown.place_W, *context_.facts.world->find(pointed.front().object), shown.sd_m) &&
         std::find(named_.begin(), named_.end(), pointed.front().object) == named_.end();
}

// "that" without pointing means the first object in focus; a plural is left open.
Meant Referring::undefined(const Term& phrase, const Determiner& determiner, std::size_t occurrence) const {
  Meant meant;
  meant.plural = is_plural(determiner);
  meant.resolution.phrase = phrase;
  meant.resolution.words = words_of(phrase, occurrence);
  meant.resolution.by = By::focus;
  if (!meant.plural && !context_.focus.empty()) {
    meant.values.push_back(Term::entity(context_.focus.front()));
    meant.resolution.value = meant.values.front();
  } else {
    meant.gap = Gap{Gap::Why::unsaid, meant.plural ? Type::list(Type::entity()) : Type::entity(), {}, "", true};
  }
  return meant;
}

// A definite phrase means all its referents, so their number must be the one that was said. An indefinite phrase takes
// the likeliest.
Meant Referring::chosen(const Term& phrase, Reference reference, const Determiner& determiner, std::string noun,
                        const Context& context, std::size_t occurrence) const {
  const auto found = reference.referents.size();
  const auto least = static_cast<std::size_t>(std::max(determiner.count, 1));
  const bool all = determiner.many && determiner.count == 0;
  Meant meant;
  meant.plural = is_plural(determiner);
  meant.resolution.phrase = phrase;
  meant.resolution.words = words_of(phrase, occurrence);
  meant.resolution.by = determiner.deictic && context.pointed_W ? By::pointed : By::words;
  const Type type = meant.plural ? Type::list(Type::entity()) : Type::entity();
  if (found < least) {
    meant.gap = Gap{Gap::Why::none, type, {}, std::move(noun)};
  } else if (found > least && determiner.definite && !all) {
    meant.gap = Gap{Gap::Why::several, type, {}, std::move(noun)};
    for (const auto& each : reference.referents) meant.gap->choices.push_back(each.object);
    meant.gap->unshown = determiner.deictic && !context.pointed_W;
  } else {
    // "another one on it" prefers objects that the command has not named otherwise.
    auto likeliest = reference.referents;
    if (!all && !determiner.definite)
      std::stable_partition(likeliest.begin(), likeliest.end(), [this](const Referent& each) {
        return std::find(named_.begin(), named_.end(), each.object) == named_.end();
      });
    for (std::size_t i = 0; i < (all ? found : least); ++i) meant.values.push_back(Term::entity(likeliest[i].object));
    meant.resolution.value = meant.plural ? Term::list(meant.values, Type::entity()) : meant.values.front();
  }
  meant.resolution.reference = std::move(reference);
  return meant;
}

Meant Referring::by_proform(const Term& phrase, const Proform& proform, std::size_t occurrence) const {
  const Type& type = phrase.type();
  const Context context = context_of(phrase, occurrence);
  const bool shown_place = proform.source == Proform::Source::pointed && context.pointed_W;
  const bool shown_thing = proform.source == Proform::Source::focus && shows_another(phrase, occurrence);
  if ((shown_place || shown_thing) && consistent(type, Type::entity())) {
    Determiner shown;
    shown.definite = shown.deictic = true;
    return chosen(phrase, refer_to_pointed(context), shown, "", context, occurrence);
  }
  Meant meant;
  if (shown_place) {
    const auto pointed = refer_to_pointed(context).referents;
    if (!pointed.empty() && pointed.front().object != context.facts.world->held) meant.there = pointed.front().object;
  }
  meant.resolution.phrase = phrase;
  meant.resolution.words = words_of(phrase, occurrence);
  meant.resolution.by = by_of(proform.source);
  meant.plural = type.kind() == Type::Kind::list;
  if (const auto* objects = meant.plural ? objects_of(proform.source, context_) : nullptr) {
    for (const auto& object : *objects) meant.values.push_back(Term::entity(object));
  } else if (const auto value = single_value(proform, type, context)) {
    meant.values.push_back(*value);
  }
  if (meant.values.empty())
    meant.gap = Gap{Gap::Why::unsaid, type, {}, ""};
  else
    meant.resolution.value = meant.plural ? Term::list(meant.values, Type::entity()) : meant.values.front();
  return meant;
}

std::optional<Term> Referring::single_value(const Proform& proform, const Type& type, const Context& context) const {
  switch (proform.source) {
    case Proform::Source::focus:
      if (!context.focus.empty() && consistent(type, Type::entity())) return Term::entity(context.focus.front());
      return std::nullopt;
    case Proform::Source::pointed:
      if (context.pointed_W && consistent(type, Type::location())) return point(*context.pointed_W);
      return std::nullopt;
    case Proform::Source::topic:
      return topics().front();
    case Proform::Source::other:
      return std::nullopt;
    case Proform::Source::avatar:
      return Term::entity("avatar");
    case Proform::Source::human:
      return Term::entity("human");
    case Proform::Source::handled:
      return std::nullopt;
  }
  return std::nullopt;
}

std::vector<Term> Referring::topics() const {
  if (!context_.topics.empty()) return context_.topics;
  return {anything()};
}

// An answer means one of the objects asked about, of any kind. If none of them fits, or nothing was asked, "one" stands
// for the first topic that fits some object; with "this" and "that" the object must also be pointed at, "both" are two,
// and "the left one" is one of several. If no topic fits, "one" stands for any object that is pointed at, described or
// counted: "the red one".
Reference Referring::found(const Term& condition, const Determiner& determiner, Context context) const {
  const auto& operators = *meanings_.operators;
  const bool shown = determiner.deictic && context.pointed_W;
  const auto fits = [&](const Reference& reference) {
    return !reference.referents.empty() && static_cast<int>(reference.referents.size()) >= determiner.count &&
           (!shown || is_pointed_at(*context.pointed_W, *context.facts.world->find(reference.referents.front().object),
                                    context.pointed_sd_m));
  };
  Reference asked;
  if (!context.among.empty()) {
    asked = refer(with_topic(condition, anything(), operators), determiner, context, meanings_);
    if (fits(asked)) return asked;
    context.among.clear();
  }
  auto all = topics();
  if (shown || describes_more(condition, operators) || determiner.count > 1) all.push_back(anything());
  const auto first = with_topic(condition, all.front(), operators);
  auto reference = refer(first, determiner, context, meanings_);
  const bool compared = compares_topics(condition, operators);
  const auto are_several = [&](const Term& topic) {
    return !compared || refer(topic, {}, context, meanings_).referents.size() > 1;
  };
  const bool fits_first = fits(reference);
  if (fits_first && are_several(all.front())) return reference;
  for (std::size_t i = 1; i < all.size() && first != condition; ++i)
    if (auto other = refer(with_topic(condition, all[i], operators), determiner, context, meanings_);
        fits(other) && are_several(all[i]))
      return other;
  return asked.referents.empty() || fits_first ? reference : asked;
}

// The words of the phrase's use number `occurrence`, or of its last use if there are fewer.
std::optional<WordSpan> Referring::span_of(const Term& phrase, std::size_t occurrence) const {
  const Term contracted = eta_contracted(phrase);
  std::optional<WordSpan> span;
  for (const auto& each : reading_.phrases) {
    if (!(eta_contracted(each.term) == contracted) || each.words.end > words_.size() ||
        each.words.begin > each.words.end)
      continue;
    span = each.words;
    if (occurrence-- == 0) break;
  }
  return span;
}

std::string Referring::words_of(const Term& phrase, std::size_t occurrence) const {
  const auto span = span_of(phrase, occurrence);
  if (!span) return {};
  return fmt::to_string(fmt::join(words_.begin() + static_cast<std::ptrdiff_t>(span->begin),
                                  words_.begin() + static_cast<std::ptrdiff_t>(span->end), " "));
}

// The noun phrases outside these words that a part of the condition repeats: its antecedents.
std::vector<Phrase> Referring::antecedents_in(const Term& condition, const WordSpan& span) const {
  std::vector<Phrase> antecedents;
  for (const auto& each : reading_.phrases)
    if ((each.words.end <= span.begin || each.words.begin >= span.end) && each.term.closed() &&
        determiner_of(each.term, *meanings_.operators) && contains(condition, each.term))
      antecedents.push_back(each);
  return antecedents;
}

// The things within these words that are pointed at by themselves.
std::vector<Phrase> Referring::shown_inside(const WordSpan& span) const {
  std::vector<Phrase> inside;
  for (const auto& each : reading_.phrases)
    if (each.words.begin > span.begin && each.words.end <= span.end && each.term.closed() &&
        is_shown_thing(each.term, *meanings_.operators))
      inside.push_back(each);
  return inside;
}

// The condition with those things inside the phrase, and those antecedents, that are pointed at, or picked where any
// would do: "the block between (block1) and (block2)", "the other purple one", "one cup here and the other cup there".
Term Referring::with_shown(const Term& phrase, Term condition, std::size_t occurrence,
                           std::vector<Resolution>& within) const {
  const auto span = span_of(phrase, occurrence);
  if (!span) return condition;
  auto shown = context_.showings.empty() ? std::vector<Phrase>() : shown_inside(*span);
  for (auto& each : antecedents_in(condition, *span)) shown.push_back(std::move(each));
  for (const auto& [thing, words] : shown) {
    const auto number = uses_before(thing, words.begin);
    const auto* determiner = determiner_of(thing, *meanings_.operators);
    const bool is_picked = determiner && !determiner->definite;
    if (!contains(condition, thing) || (!showing_of(thing, number) && !is_picked)) continue;
    Meant inner = meant(thing, number);
    if (inner.values.size() != 1) continue;
    condition = first_replaced(condition, thing, inner.values.front());
    within.push_back(std::move(inner.resolution));
  }
  return condition;
}

std::size_t Referring::uses_before(const Term& phrase, std::size_t word) const {
  return static_cast<std::size_t>(
      std::count_if(reading_.phrases.begin(), reading_.phrases.end(),
                    [&](const Phrase& each) { return each.term == phrase && each.words.begin < word; }));
}

// The pointing that shares most words with the phrase, and does not belong to a thing inside it.
std::optional<std::size_t> Referring::showing_of(const Term& phrase, std::size_t occurrence) const {
  const auto span = span_of(phrase, occurrence);
  if (!span) return std::nullopt;
  const auto inside = shown_inside(*span);
  std::optional<std::size_t> best;
  std::size_t most = 0;
  for (std::size_t i = 0; i < context_.showings.size(); ++i) {
    const auto& words = context_.showings[i].words;
    const auto begin = std::max(words.begin, span->begin), end = std::min(words.end, span->end);
    if (end <= begin || end - begin <= most) continue;
    const auto is_around = [&](const Phrase& thing) { return thing.words.begin <= words.begin; };
    if (std::any_of(inside.begin(), inside.end(), is_around)) continue;
    most = end - begin;
    best = i;
  }
  return best;
}

Context Referring::context_of(const Term& phrase, std::size_t occurrence) const {
  if (context_.showings.empty()) return context_;
  Context context = context_;
  context.pointed_W.reset();
  if (const auto showing = showing_of(phrase, occurrence)) {
    context.pointed_W = context_.showings[*showing].place_W;
    context.pointed_sd_m = context_.showings[*showing].sd_m;
  }
  return context;
}

std::optional<Application> Referring::pointing(std::size_t showing) const {
  if (!context_.deixis || showing >= context_.showings.size()) return std::nullopt;
  const Showing& shown = context_.showings[showing];
  Context there = context_;
  there.pointed_W = shown.place_W;
  there.pointed_sd_m = shown.sd_m;
  std::vector<std::string> things;
  for (const auto& each : refer_to_pointed(there).referents) things.push_back(each.object);
  return application_of(*context_.deixis, shown.hand, shown.sd_m, shown.place_W, things);
}

void Referring::named(const std::string& object) {
  named_.push_back(object);
  const auto last = std::find(context_.focus.begin(), context_.focus.end(), object);
  if (last != context_.focus.end()) std::rotate(last, last + 1, context_.focus.end());
}

void Referring::not_it(const std::string& object) { std::erase(context_.focus, object); }

void Referring::focus_on(const std::vector<std::string>& objects) {
  named_.clear();
  for (const auto& object : objects) {
    std::erase(context_.focus, object);
    context_.focus.insert(context_.focus.begin(), object);
  }
}

}  // namespace continua
