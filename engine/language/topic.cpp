#include "continua/language/topic.h"

#include "continua/term/substitution.h"

namespace continua {

Term with_topic(const Term& condition, const Term& topic, const Operators& operators) {
  Term with = condition;
  for (const auto& [name, pro] : operators.proforms)
    if (pro.source == Proform::Source::topic) with = replaced(with, Term::constant(name, property()), topic);
  return with;
}

bool describes_more(const Term& condition, const Operators& operators) {
  if (condition.kind() != Term::Kind::lambda) return false;
  const auto* pro = proform_of(condition.body().spine().head, operators);
  return !(pro && pro->source == Proform::Source::topic) && !says(condition, Proform::Source::other, operators);
}

bool compares_topics(const Term& part, const Operators& operators) {
  if (part.kind() == Term::Kind::lambda) return compares_topics(part.body(), operators);
  if (part.kind() != Term::Kind::apply || determiner_of(part, operators)) return false;
  const auto& argument = part.argument();
  return (argument.kind() == Term::Kind::lambda && says(argument, Proform::Source::topic, operators)) ||
         compares_topics(part.function(), operators) || compares_topics(argument, operators);
}

}  // namespace continua
