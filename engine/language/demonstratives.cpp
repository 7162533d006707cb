#include "continua/language/demonstratives.h"

#include <algorithm>

namespace continua {
namespace {

// The things that one points at, one after the other, for "these".
constexpr int most_shown = 6;

bool is_shown(const Term& term, const Operators& operators) {
  const auto* proform = proform_of(term, operators);
  return proform && proform->source == Proform::Source::pointed;
}

// Whether a part of the term asks for pointing; a thing inside it that is pointed at by itself does not count.
bool asks(const Term& term, const Operators& operators) {
  if (is_shown(term, operators)) return !(term.type() == Type::entity());
  switch (term.kind()) {
    case Term::Kind::lambda:
      return asks(term.body(), operators);
    case Term::Kind::apply:
      return !is_shown_thing(term, operators) && (asks(term.function(), operators) || asks(term.argument(), operators));
    case Term::Kind::list:
      return std::any_of(term.elements().begin(), term.elements().end(),
                         [&](const Term& each) { return asks(each, operators); });
    default:
      return false;
  }
}

bool takes_pointing(const Phrase& phrase, const Reading& reading, const Operators& operators) {
  const Term& term = phrase.term;
  if (term == reading.term && term.type() == Type::function(Type::entity(), Type::truth())) return true;
  if (const auto* proform = proform_of(term, operators))
    return proform->source == Proform::Source::pointed ||
           (proform->source == Proform::Source::focus && term.type() == Type::entity());
  const auto* determiner = determiner_of(term, operators);
  return determiner && (determiner->definite || determiner->deictic || asks(term, operators));
}

}  // namespace

bool is_shown_thing(const Term& phrase, const Operators& operators) {
  const auto* determiner = determiner_of(phrase, operators);
  return determiner ? determiner->deictic : is_shown(phrase, operators) && phrase.type() == Type::entity();
}

std::vector<Demonstrative> demonstratives(const Reading& reading, const Operators& operators) {
  auto said = reading.phrases;
  for (const auto& phrase : reading.taken_back)
    if (is_shown_thing(phrase.term, operators)) said.push_back(phrase);
  std::stable_sort(said.begin(), said.end(),
                   [](const Phrase& a, const Phrase& b) { return a.words.begin < b.words.begin; });
  std::vector<Demonstrative> found;
  std::size_t end = 0;  // of the outermost phrase so far
  for (const auto& [term, words] : said) {
    if (!takes_pointing({term, words}, reading, operators)) continue;
    const bool by_itself = is_shown_thing(term, operators);
    if (words.begin < end) {
      if (!by_itself || words.begin == found.back().words.begin) continue;
      found.back().words.end = std::min(found.back().words.end, words.begin);
    }
    const bool asks_place = !by_itself && asks(term, operators);
    // Each of "these two" is pointed at.
    const auto* determiner = by_itself ? determiner_of(term, operators) : nullptr;
    const int things = determiner ? std::max(determiner->count, 1) : 1;
    const bool open = determiner && determiner->many && determiner->count == 0;
    for (int k = 1; open && k < most_shown; ++k) found.push_back({words, false, false, true});
    for (int k = 0; k < things; ++k) found.push_back({words, by_itself || asks_place, asks_place});
    end = std::max(end, words.end);
  }
  return found;
}

}  // namespace continua
