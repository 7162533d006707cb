#include "language/demonstratives.h"

#include <algorithm>
#include <optional>

namespace continua {
namespace {

const Determiner* determiner_of(const Term& term, const Operators& operators) {
  if (term.kind() != Term::Kind::apply || term.function().kind() != Term::Kind::constant) return nullptr;
  const auto found = operators.determiners.find(term.function().name());
  return found == operators.determiners.end() ? nullptr : &found->second;
}

bool is_shown(const Term& term, const Operators& operators) {
  if (term.kind() != Term::Kind::constant) return false;
  const auto found = operators.proforms.find(term.name());
  return found != operators.proforms.end() && found->second.source == Proform::Source::pointed;
}

// Whether something in the term asks for pointing.
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
