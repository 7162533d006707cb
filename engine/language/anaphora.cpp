#include "continua/language/anaphora.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "continua/language/reduction.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

bool is_noun_phrase(const Phrase& phrase) {
  return phrase.term.kind() == Term::Kind::apply && phrase.term.type() == Type::entity() && phrase.term.closed();
}

bool is_plural(const Term& term) { return term.type() == Type::list(Type::entity()); }

bool inside(const WordSpan& a, const WordSpan& b) { return a.begin >= b.begin && a.end <= b.end; }

// Among the noun phrases that end before `word` and satisfy `fit`, the one that begins last; nullptr if there is none.
template <typename Fit>
const Phrase* last_before(std::size_t word, const Reading& reading, Fit fit) {
  const Phrase* last = nullptr;
  for (const auto& phrase : reading.phrases)
    if (is_noun_phrase(phrase) && phrase.words.end <= word && fit(phrase) &&
        (!last || phrase.words.begin > last->words.begin))
      last = &phrase;
  return last;
}

// Among the noun phrases that end before `word` and satisfy `fit`, the one that begins first: the subject.
template <typename Fit>
const Phrase* first_before(std::size_t word, const Reading& reading, Fit fit) {
  const Phrase* first = nullptr;
  for (const auto& phrase : reading.phrases)
    if (is_noun_phrase(phrase) && phrase.words.end <= word && fit(phrase) &&
        (!first || phrase.words.begin < first->words.begin))
      first = &phrase;
  return first;
}

const Phrase* smallest_around(const WordSpan& words, const Reading& reading) {
  const Phrase* around = nullptr;
  for (const auto& phrase : reading.phrases)
    if (is_noun_phrase(phrase) && inside(words, phrase.words) &&
        (!around || phrase.words.size() < around->words.size()))
      around = &phrase;
  return around;
}

Reading with(const Term& part, const Term& meant, Reading reading) {
  reading.term = normal(replaced(reading.term, part, meant));
  for (auto& phrase : reading.phrases) phrase.term = normal(replaced(phrase.term, part, meant));
  return reading;
}

// Whether the arguments of a reading's term are two clauses, "if the plate is empty, put the cup on it", or a thing and
// a clause, "without moving the cup, put the knife beside it".
bool are_clauses(const std::vector<Term>& arguments) {
  const auto is_clause = [](const Term& term) { return consistent(term.type(), Type::truth()); };
  return arguments.size() == 2 && is_clause(arguments[1]) &&
         (is_clause(arguments[0]) || arguments[0].type() == Type::entity());
}

Reading with_it(Reading reading, const Operators& operators) {
  const auto says_it = [&](const Phrase& phrase) {
    const auto* proform = proform_of(phrase.term, operators);
    return proform && proform->source == Proform::Source::focus && phrase.term.type() == Type::entity();
  };
  const auto& phrases = reading.phrases;
  const auto found = std::find_if(phrases.begin(), phrases.end(), says_it);
  if (found == phrases.end()) return reading;
  const Phrase it = *found;
  const bool nested = std::any_of(found, phrases.end(), [&](const Phrase& phrase) {
    return says_it(phrase) && smallest_around(phrase.words, reading) != nullptr;
  });
  if (nested && std::count_if(found, phrases.end(), says_it) != 1) return reading;
  const auto clauses = reading.term.spine().arguments;
  if (!nested && !are_clauses(clauses)) return reading;
  const auto is_of_other_clause = [&](const Phrase& phrase) {
    return std::none_of(clauses.begin(), clauses.end(),
                        [&](const Term& clause) { return contains(clause, it.term) && contains(clause, phrase.term); });
  };
  const auto is_definite = [&](const Phrase& phrase) {
    const auto* determiner = determiner_of(phrase.term, operators);
    return determiner && determiner->definite && is_of_other_clause(phrase);
  };
  const auto* antecedent = nested ? last_before(it.words.begin, reading, [](const Phrase&) { return true; })
                                  : first_before(it.words.begin, reading, is_definite);
  // "If there is a red block, lift it."
  if (!antecedent && !nested) antecedent = first_before(it.words.begin, reading, is_of_other_clause);
  if (!antecedent) return reading;
  const Term meant = antecedent->term;
  std::erase_if(reading.phrases, says_it);
  return with(it.term, meant, std::move(reading));
}

// "If the red block and the cup are there, stack them": all things of the other clause that stand in no other phrase.
Reading with_them(Reading reading, const Operators& operators) {
  const auto clauses = reading.term.spine().arguments;
  if (!are_clauses(clauses)) return reading;
  const auto says_them = [&](const Phrase& phrase) {
    const auto* proform = proform_of(phrase.term, operators);
    return proform && proform->source == Proform::Source::focus && is_plural(phrase.term);
  };
  const auto them = std::find_if(reading.phrases.begin(), reading.phrases.end(), says_them);
  if (them == reading.phrases.end()) return reading;
  const Term said = them->term;
  const auto is_meant = [&](const Phrase& phrase) {
    return is_noun_phrase(phrase) && phrase.words.end <= them->words.begin && contains(clauses[0], phrase.term) &&
           !contains(clauses[1], phrase.term) &&
           std::none_of(reading.phrases.begin(), reading.phrases.end(), [&](const Phrase& around) {
             return is_noun_phrase(around) && around.words.size() > phrase.words.size() &&
                    inside(phrase.words, around.words);
           });
  };
  std::vector<Term> things;
  for (const auto& phrase : reading.phrases)
    if (is_meant(phrase) && std::find(things.begin(), things.end(), phrase.term) == things.end())
      things.push_back(phrase.term);
  if (things.size() < 2) return reading;
  std::erase_if(reading.phrases, says_them);
  return with(said, Term::list(std::move(things), Type::entity()), std::move(reading));
}

// Collects the names of properties (cup, white) in `kinds`; `any`: the term contains a "one", which fits every kind.
void collect_kinds(const Term& term, const Operators& operators, std::set<std::string>& kinds, bool& any) {
  switch (term.kind()) {
    case Term::Kind::constant:
      if (const auto* proform = proform_of(term, operators))
        any = any || proform->source == Proform::Source::topic;
      else if (term.type() == property())
        kinds.insert(term.name());
      break;
    case Term::Kind::lambda:
      return collect_kinds(term.body(), operators, kinds, any);
    case Term::Kind::apply:
      collect_kinds(term.function(), operators, kinds, any);
      return collect_kinds(term.argument(), operators, kinds, any);
    default:
      break;
  }
}

// How much the phrases are about the same kind of thing.
enum class Likeness { none, in_part, whole };

// Whole: of `a` all is said that is said of `b`, as "a white cup" for "the other cup".
Likeness likeness(const Term& a, const Term& b, const Operators& operators) {
  std::set<std::string> of_a, of_b;
  bool any = false;
  collect_kinds(a, operators, of_a, any);
  collect_kinds(b, operators, of_b, any);
  if (any || std::includes(of_a.begin(), of_a.end(), of_b.begin(), of_b.end())) return Likeness::whole;
  const bool shared = std::any_of(of_a.begin(), of_a.end(), [&](const auto& kind) { return of_b.contains(kind); });
  return shared ? Likeness::in_part : Likeness::none;
}

// The noun phrases that say `other`, of one thing or several, the smallest first.
std::vector<Phrase> phrases_saying(const Term& other, const Reading& reading) {
  const auto names_several = [](const Phrase& phrase) {
    return phrase.term.kind() == Term::Kind::apply && is_plural(phrase.term) && phrase.term.closed();
  };
  std::vector<Phrase> found;
  for (const auto& phrase : reading.phrases)
    if ((is_noun_phrase(phrase) || names_several(phrase)) && contains(phrase.term, other)) found.push_back(phrase);
  std::stable_sort(found.begin(), found.end(),
                   [](const Phrase& a, const Phrase& b) { return a.words.size() < b.words.size(); });
  return found;
}

// The noun phrases before the phrase from which "other" tells its thing apart: the last one of its kind, or all of them
// where the kind is not said, as in "the other one". A thing that is itself "the other one" does not tell which.
std::vector<Term> others_before(const Phrase& around, const Term& other, const Reading& reading,
                                const Operators& operators) {
  std::vector<Term> all;
  for (const auto& phrase : reading.phrases)
    if (is_noun_phrase(phrase) && phrase.words.end <= around.words.begin && !contains(phrase.term, other) &&
        std::find(all.begin(), all.end(), phrase.term) == all.end())
      all.push_back(phrase.term);
  if (says(around.term, Proform::Source::topic, operators)) return all;
  const auto last_like = [&](Likeness least) {
    return last_before(around.words.begin, reading, [&](const Phrase& phrase) {
      return !contains(phrase.term, other) && likeness(phrase.term, around.term, operators) >= least;
    });
  };
  const auto* antecedent = last_like(Likeness::whole);
  if (!antecedent) antecedent = last_like(Likeness::in_part);
  return antecedent ? std::vector{antecedent->term} : std::vector<Term>();
}

// The condition of not being what "other" tells the phrase's thing apart from; none if there is no such thing.
std::optional<Term> not_that(const Phrase& around, const Term& other, const Reading& reading,
                             const Operators& operators) {
  static const Term differs = Term::constant("!=", Type::parse("e -> e -> t").value());
  static const Term both = Term::constant("and", Type::parse("t -> t -> t").value());
  std::optional<Term> condition;
  for (const auto& each : others_before(around, other, reading, operators)) {
    const Term differs_from = Term::apply(Term::apply(differs, Term::bound(0, Type::entity())), each);
    condition = condition ? Term::apply(Term::apply(both, *condition), differs_from) : differs_from;
  }
  if (!condition) return std::nullopt;
  return Term::lambda("x", Type::entity(), *condition);
}

// "Put a red block on the plate and the other red block on it": which block "a" means is known when the first command
// has been read, so its thing is in focus then.
bool is_told_by_focus(const Phrase& around, const Reading& reading, const Operators& operators) {
  if (reading.term.kind() != Term::Kind::list) return false;
  const auto is_indefinite = [&](const Phrase& phrase) {
    const auto* determiner = determiner_of(phrase.term, operators);
    return determiner && !determiner->definite && is_noun_phrase(phrase) && phrase.words.end <= around.words.begin &&
           likeness(phrase.term, around.term, operators) != Likeness::none;
  };
  const auto& commands = reading.term.elements();
  return std::any_of(reading.phrases.begin(), reading.phrases.end(), [&](const Phrase& phrase) {
    return is_indefinite(phrase) && std::none_of(commands.begin(), commands.end(), [&](const Term& command) {
             return contains(command, phrase.term) && contains(command, around.term);
           });
  });
}

// The reading with one phrase more told apart from the thing before it; none if none can be. A phrase that says `other`
// several times is left alone: its term would grow with each.
std::optional<Reading> told_apart(const Term& other, const Reading& reading, const Operators& operators) {
  for (const auto& around : phrases_saying(other, reading)) {
    if (is_told_by_focus(around, reading, operators)) continue;
    const auto meant = not_that(around, other, reading, operators);
    if (!meant || contains(first_replaced(around.term, other, *meant), other)) continue;
    const Term told = normal(replaced(around.term, other, *meant));
    Reading next = reading;
    next.term = normal(replaced(reading.term, around.term, told));
    for (auto& phrase : next.phrases)
      phrase.term = normal(inside(phrase.words, around.words) ? replaced(phrase.term, other, *meant)
                                                              : replaced(phrase.term, around.term, told));
    return next;
  }
  return std::nullopt;
}

Reading with_other(Reading reading, const Operators& operators) {
  for (const auto& [name, proform] : operators.proforms) {
    if (proform.source != Proform::Source::other) continue;
    const Term other = Term::constant(name, property());
    while (auto next = told_apart(other, reading, operators)) reading = std::move(*next);
  }
  return reading;
}

}  // namespace

Reading with_antecedents(const Reading& reading, const Operators& operators) {
  return with_other(with_them(with_it(reading, operators), operators), operators);
}

}  // namespace continua
