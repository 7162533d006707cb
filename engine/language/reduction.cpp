#include "continua/language/reduction.h"

#include <algorithm>

#include "continua/term/name.h"

namespace continua {
namespace {

constexpr int most_steps = 20'000;
constexpr std::size_t largest_term = 4096;

class Reducer {
 public:
  // function(argument), both in normal form.
  Term apply(const Term& function, const Term& argument) {
    if (!spend(function.size() + argument.size())) return Term();
    if (is_group_for_one(function.type(), argument.type())) {
      const Type one_of = Type::function(argument.type(), argument.type().element());
      return apply(function, Term::apply(Term::constant("each", one_of), argument));
    }
    if (function.kind() == Term::Kind::lambda) return substituted(function.body(), 0, argument);
    static const Name conjunction("and");
    const auto is_and = [](const Term& term) {
      return term.kind() == Term::Kind::constant && term.interned_name() == conjunction;
    };
    const auto is_pair = [&](const Term& term) {
      return term.kind() == Term::Kind::apply && term.function().kind() == Term::Kind::apply &&
             is_and(term.function().function());
    };
    const bool is_conjunction = function.kind() == Term::Kind::apply && is_and(function.function());
    if (is_conjunction && function.argument().is_true()) return argument;
    if (is_conjunction && argument.is_true()) return function.argument();
    if (is_conjunction && is_pair(argument)) {
      const auto first = apply(function, argument.function().argument());
      return Term::apply(Term::apply(function.function(), first), argument.argument());
    }
    return Term::apply(function, argument);
  }

  Term normal(const Term& term) {
    if (!spend(1)) return Term();
    switch (term.kind()) {
      case Term::Kind::lambda:
        return Term::lambda(term.name(), term.variable_type(), normal(term.body()));
      case Term::Kind::apply:
        return apply(normal(term.function()), normal(term.argument()));
      case Term::Kind::list:
        return list(term, [&](const Term& each) { return normal(each); });
      default:
        return term;
    }
  }

  bool gave_up() const { return steps_ <= 0; }

 private:
  // Whether the function takes one object and the argument is several: it is then applied to each.
  static bool is_group_for_one(const Type& function, const Type& argument) {
    return function.kind() == Type::Kind::function && argument.kind() == Type::Kind::list &&
           !consistent(function.from(), argument) && consistent(function.from(), argument.element());
  }

  static bool is_each(const Term& term) {
    static const Name each("each");
    return term.kind() == Term::Kind::apply && term.function().kind() == Term::Kind::constant &&
           term.function().interned_name() == each;
  }

  bool spend(std::size_t size) {
    if (size > largest_term) steps_ = 0;
    return steps_ > 0 && --steps_ > 0;
  }

  // `term` with `argument` in place of the variable of the binder `depth` levels above it. The binder is removed.
  Term substituted(const Term& term, int depth, const Term& argument) {
    if (term.reach() <= depth) return term;
    if (!spend(1)) return Term();
    switch (term.kind()) {
      case Term::Kind::bound:
        return term.index() == depth ? shifted(argument, depth, 0) : Term::bound(term.index() - 1, term.type());
      case Term::Kind::lambda:
        return Term::lambda(term.name(), term.variable_type(), substituted(term.body(), depth + 1, argument));
      case Term::Kind::apply:
        return apply(substituted(term.function(), depth, argument), substituted(term.argument(), depth, argument));
      case Term::Kind::list:
        return list(term, [&](const Term& each) { return substituted(each, depth, argument); });
      default:
        return term;
    }
  }

  // `term` moved under `by` more binders; `inside` counts the binders of its own.
  Term shifted(const Term& term, int by, int inside) {
    if (by == 0 || term.reach() <= inside) return term;
    if (!spend(1)) return Term();
    switch (term.kind()) {
      case Term::Kind::bound:
        return Term::bound(term.index() + by, term.type());
      case Term::Kind::lambda:
        return Term::lambda(term.name(), term.variable_type(), shifted(term.body(), by, inside + 1));
      case Term::Kind::apply:
        return Term::apply(shifted(term.function(), by, inside), shifted(term.argument(), by, inside));
      case Term::Kind::list:
        return list(term, [&](const Term& each) { return shifted(each, by, inside); });
      default:
        return term;
    }
  }

  template <class Change>
  static Term list(const Term& term, const Change& change) {
    std::vector<Term> elements;
    for (const auto& each : term.elements()) {
      const auto changed = change(each);
      const auto* inner = is_each(changed) ? &changed.argument() : &changed;
      if (inner->kind() == Term::Kind::list)
        elements.insert(elements.end(), inner->elements().begin(), inner->elements().end());
      else
        elements.push_back(changed);
    }
    return Term::list(std::move(elements), term.type().element());
  }

  int steps_ = most_steps;
};

Term renamed(const Term& term, std::size_t entities, std::size_t places) {
  static const char* const entity_names[] = {"x", "y", "z"};
  static const char* const place_names[] = {"v", "w"};
  switch (term.kind()) {
    case Term::Kind::lambda: {
      const auto& type = term.variable_type();
      if (type == Type::entity())
        return Term::lambda(entity_names[entities % 3], type, renamed(term.body(), entities + 1, places));
      if (type == Type::location())
        return Term::lambda(place_names[places % 2], type, renamed(term.body(), entities, places + 1));
      return Term::lambda(term.name(), type, renamed(term.body(), entities, places));
    }
    case Term::Kind::apply:
      return Term::apply(renamed(term.function(), entities, places), renamed(term.argument(), entities, places));
    case Term::Kind::list: {
      std::vector<Term> elements;
      for (const auto& each : term.elements()) elements.push_back(renamed(each, entities, places));
      return Term::list(std::move(elements), term.type().element());
    }
    default:
      return term;
  }
}

}  // namespace

Term applied(const Term& function, const Term& argument) {
  Reducer reducer;
  auto result = reducer.apply(function, argument);
  return reducer.gave_up() ? Term() : result;
}

Term composed(const Term& first, const Term& second, const Type& argument) {
  Reducer reducer;
  auto inner = reducer.apply(second, Term::bound(0, argument));
  auto result = Term::lambda("x", argument, reducer.apply(first, inner));
  return reducer.gave_up() ? Term() : result;
}

Term normal(const Term& term) {
  Reducer reducer;
  auto result = reducer.normal(term);
  return reducer.gave_up() ? Term() : result;
}

Term with_nice_variables(const Term& term) { return renamed(term, 0, 0); }

bool occurs(const Term& part, const Term& whole) {
  if (whole.size() < part.size()) return false;
  if (whole == part) return true;
  switch (whole.kind()) {
    case Term::Kind::lambda:
      return occurs(part, whole.body());
    case Term::Kind::apply:
      return occurs(part, whole.function()) || occurs(part, whole.argument());
    case Term::Kind::list:
      return std::any_of(whole.elements().begin(), whole.elements().end(),
                         [&](const Term& each) { return occurs(part, each); });
    default:
      return false;
  }
}

}  // namespace continua
