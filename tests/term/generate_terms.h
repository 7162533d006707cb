// Random closed terms of a wanted type, for laws.
#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "read_terms.h"

namespace continua {

/// The variables that a term may use in its place, the innermost last.
using Variables = std::vector<Type>;

class TermGenerator {
 public:
  /// A term of type `type`, at most about `fuel` deep.
  Term term(const Type& type, const Variables& variables, int fuel) {
    if (fuel > 0 && pick(3) > 0) return composed(type, variables, fuel - 1);
    std::vector<int> fitting;
    for (int i = 0; i < static_cast<int>(variables.size()); ++i)
      if (variables[variables.size() - 1 - i] == type) fitting.push_back(i);
    if (!fitting.empty() && pick(3) > 0) return Term::bound(fitting[pick(static_cast<int>(fitting.size()))], type);
    return atom(type, variables, fuel);
  }

  Type type(int fuel) {
    static const Type bases[] = {Type::entity(), Type::location(), Type::truth(), Type::number(), Type::text_type()};
    const int choice = pick(fuel > 0 ? 7 : 5);
    if (choice < 5) return bases[choice];
    return choice == 5 ? Type::list(type(fuel - 1)) : Type::function(type(fuel - 1), type(fuel - 1));
  }

 private:
  // Uniform from the first test on: unresized, a range begins with its smallest values only.
  static int pick(int below) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, below)); }
  static double number() { return pick(40) / 8.0 - 2; }

  Term atom(const Type& type, const Variables& variables, int fuel) {
    if (pick(12) == 0) return Term::null();
    if (type.kind() == Type::Kind::function) return lambda(type, variables, fuel);
    if (type.kind() == Type::Kind::list) return list(type, variables, fuel, pick(3));
    if (type == Type::truth()) return Term::truth(pick(2) == 0);
    if (type == Type::number()) return Term::number(number());
    if (type == Type::text_type()) return Term::text(std::vector<std::string>{"", "it's", "a \\ b", "λ 'x'"}[pick(4)]);
    if (type == Type::location() && pick(2) == 0)
      return Term::place({{number(), number(), number()}, {number(), number(), 0}, true});
    if (type == Type::location()) return Term::point(number(), number(), number());
    return Term::entity(std::vector<std::string>{"block1", "block4", "indicated"}[pick(3)]);
  }

  Term lambda(const Type& type, Variables variables, int fuel) {
    static const std::vector<std::string> hints = {"x", "y", "x", "block1", "head", "box", "true", "on", ""};
    variables.push_back(type.from());
    const std::string& hint = hints[pick(static_cast<int>(hints.size()))];
    return Term::lambda(hint, type.from(), term(type.to(), variables, fuel > 0 ? fuel - 1 : 0));
  }

  Term list(const Type& type, const Variables& variables, int fuel, int size) {
    std::vector<Term> elements;
    for (int i = 0; i < size; ++i) elements.push_back(term(type.element(), variables, fuel > 0 ? fuel - 1 : 0));
    return Term::list(std::move(elements), type.element());
  }

  // `name` applied to terms of the given types.
  Term call(const char* name, const std::vector<Type>& types, const Type& result, const Variables& variables,
            int fuel) {
    Type type = result;
    for (auto each = types.rbegin(); each != types.rend(); ++each) type = Type::function(*each, type);
    Term built = Term::constant(name, type);
    for (const auto& each : types) built = Term::apply(built, term(each, variables, fuel));
    return built;
  }

  Term composed(const Type& type, const Variables& variables, int fuel) {
    const Type e = Type::entity(), loc = Type::location(), t = Type::truth(), num = Type::number(),
               text = Type::text_type();
    struct Choice {
      const char* name;
      std::vector<Type> arguments;
    };
    const Type other = this->type(1);
    std::vector<Choice> choices = {{"if", {t, type, type}},
                                   {"head", {Type::list(type)}},
                                   {"nth", {Type::list(type), num}},
                                   {"last", {Type::list(type)}}};
    const auto add = [&](std::initializer_list<Choice> more) { choices.insert(choices.end(), more); };
    if (type == t)
      add({{"and", {t, t}},
           {"or", {t, t}},
           {"not", {t}},
           {"=", {other, other}},
           {"!=", {other, other}},
           {"<", {num, num}},
           {">=", {num, num}},
           {"put", {e, loc}},
           {"inside", {loc, loc}},
           {"open", {other}},
           {"some", {Type::list(other), Type::function(other, t)}},
           {"contains", {Type::list(other), other}}});
    if (type == num)
      add({{"+", {num, num}},
           {"-", {num, num}},
           {"*", {num, num}},
           {"/", {num, num}},
           {"negate", {num}},
           {"x", {loc}},
           {"size", {Type::list(other)}},
           {"distance", {loc, loc}}});
    if (type == loc)
      add({{"on", {e}}, {"xyz", {num, num, num}}, {"box", {loc, loc}}, {"center", {loc}}, {"overlap", {loc, loc}}});
    if (type == text) add({{"lower", {text}}, {"text", {other}}, {"join", {Type::list(text), text}}});
    if (type.kind() == Type::Kind::list) {
      const Type element = type.element();
      add({{"tail", {type}},
           {"reverse", {type}},
           {"append", {type, type}},
           {"take", {type, num}},
           {"filter", {type, Type::function(element, t)}},
           {"sort_by", {type, Type::function(element, num)}},
           {"map", {Type::list(other), Type::function(other, element)}},
           {"concat", {Type::list(type)}}});
      if (element.kind() == Type::Kind::list) add({{"prefixes", {element}}, {"suffixes", {element}}});
    }
    const int choice = pick(static_cast<int>(choices.size()) + 2);
    if (choice == static_cast<int>(choices.size())) return atom(type, variables, fuel);
    if (choice > static_cast<int>(choices.size())) {  // (\x. …)(…)
      Term function = lambda(Type::function(other, type), variables, fuel);
      return Term::apply(std::move(function), term(other, variables, fuel));
    }
    return call(choices[choice].name, choices[choice].arguments, type, variables, fuel);
  }
};

/// A closed term with its type.
struct TypedTerm {
  Term term;
  Type type;
};

inline rc::Gen<TypedTerm> typed_terms(int fuel = 4) {
  return rc::gen::exec([fuel] {
    TermGenerator generate;
    Type type = generate.type(2);
    Term term = generate.term(type, {}, fuel);
    return TypedTerm{std::move(term), std::move(type)};
  });
}

inline void showValue(const TypedTerm& typed, std::ostream& out) {
  out << print(typed.term) << " : " << typed.type.text();
}
inline void showValue(const Term& term, std::ostream& out) { out << print(term); }

}  // namespace continua

namespace rc {
template <>
struct Arbitrary<continua::TypedTerm> {
  static Gen<continua::TypedTerm> arbitrary() { return continua::typed_terms(); }
};
}  // namespace rc
