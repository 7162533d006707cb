#include "continua/term/rules.h"

#include <utility>
#include <vector>

namespace continua {
namespace {

struct Language {
  Rules rules;
  Signature signature = core_signature();
  Language() {
    add_operators(rules, signature);
    add_list_functions(rules, signature);
    add_term_functions(rules, signature);
    add_place_functions(rules, signature);
    signature.emplace("each", Type::parse("'a* -> 'a").value());  // without a rule: readings contain it
    signature.emplace("dot", pointing_constructor().type());      // without a rule: a pointing is made with it
  }
};

const Language& language() {
  static const Language it;
  return it;
}

// The kind of literal that a function with this parameter relies on; null if it takes all kinds.
Term::Kind relied_on(const Type& parameter) {
  if (parameter.kind() == Type::Kind::list) return Term::Kind::list;
  if (parameter == Type::number()) return Term::Kind::number;
  if (parameter == Type::text_type()) return Term::Kind::text;
  if (parameter == Type::location() || parameter == Type::region()) return Term::Kind::place;
  return Term::Kind::null;
}

}  // namespace

void add_functions(std::initializer_list<Function> functions, Rules& rules, Signature& signature) {
  for (const auto& function : functions) {
    const Type type = Type::parse(function.type).value();
    const auto [known, added] = signature.emplace(function.name, type);
    require(added || known->second == type, "a function has one type");
    std::vector<Term::Kind> kinds;
    for (Type rest = type; rest.kind() == Type::Kind::function; rest = Type(rest.to()))
      kinds.push_back(relied_on(rest.from()));
    Rule rule;
    rule.arity = kinds.size();
    rule.takes_null = function.takes_null;
    rule.compute = [kinds = std::move(kinds), compute = function.compute](std::span<const Term> arguments,
                                                                          Evaluation& evaluation) {
      for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i] != Term::Kind::null && arguments[i].kind() != kinds[i]) return Term::null();
      return compute(arguments, evaluation);
    };
    require(rules.emplace(function.name, std::move(rule)).second, "a function is declared once");
  }
}

const Rules& term_rules() { return language().rules; }
const Signature& term_signature() { return language().signature; }

}  // namespace continua
