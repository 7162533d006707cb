#include "continua/moves/understanding.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "continua/language/anaphora.h"
#include "continua/language/reduction.h"
#include "continua/language/scope.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

// The longest chain of definitions that is followed.
constexpr int most_definitions = 10;

std::vector<std::string> words_at(const Utterance& utterance, const std::vector<std::size_t>& places, WordSpan span) {
  std::vector<std::string> words;
  for (const auto place : places)
    if (place >= span.begin && place < span.end) words.push_back(utterance.words[place]);
  return words;
}

// The words from the end of the fragment before to the beginning of the next: the fragment owns the words skipped
// around it.
WordSpan surroundings(const Utterance& utterance, std::size_t fragment) {
  const auto& fragments = utterance.fragments;
  return {fragment == 0 ? 0 : fragments[fragment].words.begin,
          fragment + 1 == fragments.size() ? utterance.words.size() : fragments[fragment + 1].words.begin};
}

// The words of the sentences that the fragment is a part of.
WordSpan sentence_of(const Utterance& utterance, std::size_t fragment) {
  const auto& words = utterance.fragments[fragment].words;
  const auto& ends = utterance.ends;
  const auto begin = std::upper_bound(ends.begin(), ends.end(), words.begin);
  const auto end = std::lower_bound(ends.begin(), ends.end(), words.end);
  return {begin == ends.begin() ? 0 : *(begin - 1), end == ends.end() ? utterance.words.size() : *end};
}

std::vector<std::string> left_out_in(const Utterance& utterance, WordSpan span) {
  auto places = utterance.unknown;
  places.insert(places.end(), utterance.unused.begin(), utterance.unused.end());
  places.insert(places.end(), utterance.guessed.begin(), utterance.guessed.end());
  std::sort(places.begin(), places.end());
  return words_at(utterance, places, span);
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

// The thing asked for by "which block is red?": a condition that stands as a program's argument.
std::optional<Term> asked_for(const Term& question) {
  const auto arguments = question.spine().arguments;
  const bool is_condition = arguments.size() == 1 && arguments[0].closed() &&
                            arguments[0].kind() == Term::Kind::lambda && arguments[0].type() == property();
  return is_condition && question.type() == Type::truth() ? std::optional(arguments[0]) : std::nullopt;
}

// Whether a noun only helps to describe another: "the block behind the cup".
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

// The attributes that a condition gives to the thing itself, in the order of its words: for "the leftmost red block
// behind the cup" red and block.
void collect_attributes(const Term& condition, std::vector<Term>& attributes) {
  if (condition.kind() == Term::Kind::constant) attributes.push_back(condition);
  if (condition.kind() == Term::Kind::lambda) return collect_attributes(condition.body(), attributes);
  const auto [head, arguments] = condition.spine();
  if (head.kind() != Term::Kind::constant || arguments.empty()) return;
  if (head.name() == "and" || arguments.size() > 1) {
    for (const auto& each : arguments)
      if (head.name() == "and" || each.type() == property()) collect_attributes(each, attributes);
  } else if (arguments[0].kind() == Term::Kind::bound) {
    attributes.push_back(head);
  }
}

// The properties of the thing itself, \x. red(x) and block(x); null if there are none.
Term attributes_in(const Term& condition) {
  static const Term both = Term::constant("and", Type::parse("t -> t -> t").value());
  std::vector<Term> attributes;
  collect_attributes(condition, attributes);
  if (attributes.empty()) return Term::null();
  const auto holds = [](const Term& attribute) { return Term::apply(attribute, Term::bound(0, Type::entity())); };
  Term all = holds(attributes.front());
  for (std::size_t i = 1; i < attributes.size(); ++i)
    all = Term::apply(Term::apply(both, std::move(all)), holds(attributes[i]));
  return Term::lambda("x", Type::entity(), std::move(all));
}

}  // namespace

// The noun of a phrase, without its adjectives and the words behind it; null if it has none ("the blue one").
Term Understanding::noun_in(const WordSpan& words, const Utterance& utterance) const {
  static const Type modifier = Type::function(property(), property());
  const auto has_type = [](const Type& type) {
    return [&type](const WordSense* sense) { return sense->term.type() == type; };
  };
  for (auto at = words.begin; at < words.end; ++at) {
    Vocabulary::Walk walk(*vocabulary_);
    const WordSense* noun = nullptr;
    for (auto end = at; end < words.end && !walk.is_over(); ++end) {
      const auto senses = Vocabulary::senses(walk.step(utterance.words[end]));
      if (std::any_of(senses.begin(), senses.end(), has_type(modifier))) continue;
      const auto sense = std::find_if(senses.begin(), senses.end(), has_type(property()));
      if (sense != senses.end()) noun = *sense;
    }
    if (noun) return is_topic(noun->term) ? Term::null() : noun->term;
  }
  return Term::null();
}

bool Understanding::is_topic(const Term& term) const {
  return says(term, Proform::Source::topic, language_.lexicon->operators);
}

// The nouns among the phrases and before a word that "one" can stand for, each with its adjectives, then alone.
std::vector<std::vector<Term>> Understanding::nouns(const Reading& reading, const Utterance& utterance,
                                                    const std::vector<Phrase>& phrases, std::size_t before) const {
  std::map<std::size_t, std::vector<Term>> found;
  for (const auto& phrase : phrases) {
    if (!(phrase.term.type() == property()) || phrase.words.end > before || is_nested(phrase, reading)) continue;
    const Term noun = noun_in(phrase.words, utterance);
    if (noun.is_null()) continue;
    auto& of_phrase = found[phrase.words.begin];
    if (Term kind = attributes_in(phrase.term); !kind.is_null()) of_phrase.insert(of_phrase.begin(), std::move(kind));
    of_phrase.push_back(noun);
  }
  std::vector<std::vector<Term>> nouns;
  for (auto& [begin, of_phrase] : found) nouns.push_back(std::move(of_phrase));
  return nouns;
}

// "the white cup … the blue one": the antecedent of "one" stands just before.
Context Understanding::within(const Reading& reading, const Utterance& utterance, Context context) const {
  auto said = reading.phrases;
  said.insert(said.end(), reading.taken_back.begin(), reading.taken_back.end());
  for (const auto& phrase : reading.phrases) {
    if (!is_topic(phrase.term)) continue;
    for (const auto& noun : nouns(reading, utterance, said, phrase.words.begin))
      context.topics.insert(context.topics.begin(), noun.begin(), noun.end());
  }
  return context;
}

// In terms that the machine knows: words for attributes are the lexicon's. A condition that a question asks about is
// replaced by its referents.
Term Understanding::in_machine_terms(const Term& meaning) const {
  const auto arguments = meaning.spine().arguments;
  if (!arguments.empty() && arguments[0].type() == property()) return meaning;
  Term term = meaning;
  for (int definitions = 0; definitions < most_definitions; ++definitions) {
    const Term before = term;
    term = normal(rewritten(before, [this](const Term& part) -> std::optional<Term> {
      const auto* known = part.kind() == Term::Kind::constant ? vocabulary_->definition(part.name()) : nullptr;
      return known && known->type() == part.type() ? std::optional(*known) : std::nullopt;
    }));
    if (term.is_null()) return meaning;
    if (term.same_node(before) || term == before) break;
  }
  return term;
}

Meanings Understanding::meanings() const {
  return {&rules_, [this](Name name) { return vocabulary_->definition(name.text()); }, &language_.lexicon->operators};
}

Move Understanding::understood(const Utterance& utterance, std::size_t fragment, const Context& context) const {
  const auto& part = utterance.fragments[fragment];
  std::vector<Interpretation> interpretations;
  for (const auto& reading : part.readings)
    interpretations.push_back(interpret(in_scope(with_antecedents(reading, language_.lexicon->operators), *vocabulary_),
                                        utterance.words, within(reading, utterance, context), meanings(),
                                        language_.raising));
  Move move;
  move.chosen = preferred(interpretations);
  move.readings = part.readings;
  move.interpretation = std::move(interpretations[move.chosen]);
  const auto& reading = move.readings[move.chosen];
  move.kind = reading.move;
  for (const auto& noun : nouns(reading, utterance, reading.phrases, part.words.end))
    for (const auto& each : noun)
      if (std::find(move.nouns.begin(), move.nouns.end(), each) == move.nouns.end()) move.nouns.push_back(each);
  if (const auto* phrase = noun_phrase(move.interpretation)) move.reference = phrase->reference;
  // In the meaning, "right of this" names the thing that is pointed at.
  auto question = asked_for(move.interpretation.meaning);
  if (!question) question = asked_for(reading.term);
  if (question) move.reference = refer(*question, Determiner{}, within(reading, utterance, context), meanings());
  move.meaning = in_machine_terms(move.interpretation.meaning);
  for (auto word = part.words.begin; word < part.words.end; ++word) move.words.push_back(utterance.words[word]);
  const auto around = surroundings(utterance, fragment);
  move.unknown = words_at(utterance, utterance.unknown, around);
  move.unused = words_at(utterance, utterance.unused, around);
  move.repaired = words_at(utterance, utterance.repaired, around);
  move.left_out = left_out_in(utterance, sentence_of(utterance, fragment));
  return move;
}

std::vector<Demonstrative> Understanding::demonstratives(const Utterance& utterance) const {
  std::vector<Demonstrative> all;
  for (const auto& fragment : utterance.fragments) {
    const auto found = continua::demonstratives(fragment.readings.front(), language_.lexicon->operators);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

Term Understanding::meaning_of(const std::string& text) const {
  const auto term = parse_term(text, vocabulary_->names());
  return term && term->closed() ? *term : Term::null();
}

Move Understanding::shown(const Term& term, const std::string& kind, const Context& context) const {
  Move move;
  move.kind = kind;
  Reading reading;
  reading.term = term;
  reading.move = kind;
  move.interpretation = interpret(reading, {}, context, meanings(), language_.raising);
  move.meaning = move.interpretation.meaning;
  if (const auto* phrase = noun_phrase(move.interpretation)) move.reference = phrase->reference;
  move.readings.push_back(std::move(reading));
  return move;
}

Move Understanding::not_understood(const Utterance& utterance) const {
  Move move;
  const WordSpan all{0, utterance.words.size()};
  move.words = utterance.words;
  move.unknown = words_at(utterance, utterance.unknown, all);
  move.unused = words_at(utterance, utterance.unused, all);
  move.left_out = left_out_in(utterance, all);
  return move;
}

}  // namespace continua
