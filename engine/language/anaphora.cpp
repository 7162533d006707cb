#include "language/anaphora.h"

#include <algorithm>
#include <optional>
#include <string>

#include "term/substitution.h"

namespace continua {
namespace {

bool is_it(const Phrase& phrase, const Operators& operators) {
  if (phrase.term.kind() != Term::Kind::constant || !(phrase.term.type() == Type::entity())) return false;
  const auto found = operators.proforms.find(phrase.term.name());
  return found != operators.proforms.end() && found->second.source == Proform::Source::focus;
}

bool is_noun_phrase(const Phrase& phrase) {
  return phrase.term.kind() == Term::Kind::apply && phrase.term.type() == Type::entity() && phrase.term.closed();
}

bool inside(const WordSpan& a, const WordSpan& b) { return a.begin >= b.begin && a.end <= b.end; }

}  // namespace

Reading with_antecedent(const Reading& reading, const Operators& operators) {
  const auto& phrases = reading.phrases;
  const auto says_it = [&](const Phrase& phrase) { return is_it(phrase, operators); };
  if (std::count_if(phrases.begin(), phrases.end(), says_it) != 1) return reading;
  const Phrase it = *std::find_if(phrases.begin(), phrases.end(), says_it);

  const Phrase* around = nullptr;
  for (const auto& phrase : phrases)
    if (is_noun_phrase(phrase) && inside(it.words, phrase.words) &&
        (!around || phrase.words.size() < around->words.size()))
      around = &phrase;
  if (!around) return reading;
  const Phrase* antecedent = nullptr;
  for (const auto& phrase : phrases)
    if (is_noun_phrase(phrase) && phrase.words.end <= it.words.begin &&
        (!antecedent || phrase.words.begin > antecedent->words.begin))
      antecedent = &phrase;
  if (!antecedent) return reading;

  const Term meant = antecedent->term;
  Reading bound = reading;
  bound.term = replaced(reading.term, it.term, meant);
  std::erase_if(bound.phrases, says_it);
  for (auto& phrase : bound.phrases)
    if (inside(it.words, phrase.words)) phrase.term = replaced(phrase.term, it.term, meant);
  return bound;
}

}  // namespace continua
