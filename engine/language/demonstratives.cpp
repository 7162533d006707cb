#include "continua/language/demonstratives.h"

#include <algorithm>
#include <optional>

namespace continua {
namespace {

bool is_shown(const Term& term, const Operators& operators) {
  const auto* proform = proform_of(term, operators);
  return proform && proform->source == Proform::Source::pointed;
}

// Whether a part of the term asks for pointing.
bool asks(const Term& term, const Operators& operators) {
  if (is_shown(term, operators)) return true;
  switch (term.kind()) {
    case Term::Kind::lambda:
      return asks(term.body(), operators);
    case Term::Kind::apply: {
      const auto* determiner = determiner_of(term, operators);
      return (determiner && determiner->deictic) || asks(term.function(), operators) ||
             asks(term.argument(), operators);
    }
    case Term::Kind::list:
      return std::any_of(term.elements().begin(), term.elements().end(),
                         [&](const Term& each) { return asks(each, operators); });
    default:
      return false;
  }
}

bool takes_pointing(const Phrase& phrase, const Reading& reading, const Operators& operators) {
  if (phrase.term == reading.term && phrase.term.type() == Type::function(Type::entity(), Type::truth())) return true;
  if (is_shown(phrase.term, operators)) return true;
  const auto* determiner = determiner_of(phrase.term, operators);
  return determiner && (determiner->definite || asks(phrase.term, operators));
}

}  // namespace

std::vector<Demonstrative> demonstratives(const Reading& reading, const Operators& operators) {
  std::vector<Demonstrative> found;
  for (const auto& phrase : reading.phrases) {
    const bool inside = !found.empty() && phrase.words.begin < found.back().words.end;
    if (!inside && takes_pointing(phrase, reading, operators))
      found.push_back({phrase.words, asks(phrase.term, operators)});
  }
  return found;
}

}  // namespace continua
