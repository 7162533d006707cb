#include "moves/understanding.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "term/substitution.h"

namespace continua {
namespace {

std::vector<std::string> words_at(const Utterance& utterance, const std::vector<std::size_t>& places, WordSpan span) {
  std::vector<std::string> words;
  for (const auto place : places)
    if (place >= span.begin && place < span.end) words.push_back(utterance.words[place]);
  return words;
}

// The words from the end of the fragment before to the beginning of the next: what was skipped around it counts to it.
WordSpan surroundings(const Utterance& utterance, std::size_t fragment) {
  const auto& fragments = utterance.fragments;
  return {fragment == 0 ? 0 : fragments[fragment].words.begin,
          fragment + 1 == fragments.size() ? utterance.words.size() : fragments[fragment + 1].words.begin};
}

const Type& property() {
  static const Type type = Type::function(Type::entity(), Type::truth());
  return type;
}

// The noun phrase that matters most: the one that is asked about first, else the last of the words. Referents are
// looked for from the last argument to the first.
const Resolution* noun_phrase(const Interpretation& interpretation) {
  const Resolution *open = nullptr, *last = nullptr;
  for (const auto& resolution : interpretation.resolutions) {
    if (!resolution.has_referents()) continue;
    if (resolution.value.is_null()) open = &resolution;
    if (!last) last = &resolution;
  }
  return open ? open : last;
}

// Of "which block is red?" what is asked for: a condition that stands as a program's argument.
std::optional<Term> asked_for(const Reading& reading) {
  const auto arguments = reading.term.spine().arguments;
  const bool is_condition = arguments.size() == 1 && arguments[0].closed() &&
                            arguments[0].kind() == Term::Kind::lambda && arguments[0].type() == property();
  return is_condition && reading.term.type() == Type::truth() ? std::optional(arguments[0]) : std::nullopt;
}

}  // namespace

Understanding::Understanding(const Language& language, const WorldSnapshot& world, const RuleTable& rules)
    : language_(language), rules_(rules), vocabulary_(language.lexicon, world) {}

// A noun: of type e -> t, no adjective that stands alone ("red"), and not said by "one".
bool Understanding::is_noun(const Phrase& phrase, const Utterance& utterance) const {
  if (!(phrase.term.type() == property())) return false;
  for (const auto& [name, proform] : language_.lexicon->operators.proforms)
    if (proform.source == Proform::Source::topic && contains(phrase.term, Term::constant(name, property())))
      return false;
  if (phrase.words.size() != 1) return true;
  const auto* entry = vocabulary_.find(utterance.words[phrase.words.begin]);
  static const Type modifier = Type::function(property(), property());
  return !entry || std::none_of(entry->senses.begin(), entry->senses.end(),
                                [](const WordSense& sense) { return sense.term.type() == modifier; });
}

// A noun that only helps to say what another one is: "the block behind the cup".
bool is_nested(const Phrase& noun, const Reading& reading) {
  const auto inside = [](const WordSpan& a, const WordSpan& b) {
    return a.begin >= b.begin && a.end <= b.end && a.size() < b.size();
  };
  return std::any_of(reading.phrases.begin(), reading.phrases.end(), [&](const Phrase& thing) {
    if (thing.term.type().kind() == Type::Kind::function || !inside(noun.words, thing.words)) return false;
    return std::any_of(reading.phrases.begin(), reading.phrases.end(), [&](const Phrase& around) {
      return around.term.type() == property() && inside(thing.words, around.words);
    });
  });
}

// The last noun before a word, without the adjectives and relations around it.
Term Understanding::last_noun(const Reading& reading, const Utterance& utterance, std::size_t before) const {
  const Phrase* noun = nullptr;
  for (const auto& phrase : reading.phrases) {
    if (phrase.words.end > before || !is_noun(phrase, utterance) || is_nested(phrase, reading)) continue;
    const bool inside = noun && phrase.words.begin >= noun->words.begin && phrase.words.end <= noun->words.end;
    if (!noun || inside || phrase.words.begin > noun->words.begin) noun = &phrase;
  }
  return noun ? noun->term : Term::null();
}

// "the white cup … the blue one": what "one" stands for has been said just before.
Context Understanding::within(const Reading& reading, const Utterance& utterance, Context context) const {
  for (const auto& [name, proform] : language_.lexicon->operators.proforms) {
    if (proform.source != Proform::Source::topic) continue;
    const Term one = Term::constant(name, property());
    for (const auto& phrase : reading.phrases) {
      if (!contains(phrase.term, one)) continue;
      if (auto noun = last_noun(reading, utterance, phrase.words.begin); !noun.is_null())
        context.topic = std::move(noun);
    }
  }
  return context;
}

Meanings Understanding::meanings() const {
  return {&rules_, [this](Name name) { return vocabulary_.definition(name.text()); }, &language_.lexicon->operators};
}

Move Understanding::understood(const Utterance& utterance, std::size_t fragment, const Context& context) const {
  const auto& part = utterance.fragments[fragment];
  std::vector<Interpretation> interpretations;
  for (const auto& reading : part.readings)
    interpretations.push_back(
        interpret(reading, utterance.words, within(reading, utterance, context), meanings(), language_.raising));
  Move move;
  move.chosen = preferred(interpretations);
  move.readings = part.readings;
  move.interpretation = std::move(interpretations[move.chosen]);
  const auto& reading = move.readings[move.chosen];
  move.kind = reading.move;
  move.noun = last_noun(reading, utterance, part.words.end);
  if (const auto* phrase = noun_phrase(move.interpretation)) move.reference = phrase->reference;
  if (const auto question = asked_for(reading)) move.reference = refer(*question, Determiner{}, context, meanings());
  for (auto word = part.words.begin; word < part.words.end; ++word) move.words.push_back(utterance.words[word]);
  const auto around = surroundings(utterance, fragment);
  move.unknown = words_at(utterance, utterance.unknown, around);
  move.unused = words_at(utterance, utterance.unused, around);
  return move;
}

Move Understanding::not_understood(const Utterance& utterance) const {
  Move move;
  const WordSpan all{0, utterance.words.size()};
  move.words = utterance.words;
  move.unknown = words_at(utterance, utterance.unknown, all);
  move.unused = words_at(utterance, utterance.unused, all);
  return move;
}

}  // namespace continua
