#include "continua/term/evaluate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "continua/core/random.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

constexpr std::size_t most_evaluation_steps = 200000;
constexpr int deepest_evaluation = 1000;
constexpr std::size_t deepest_value = 1000;
constexpr std::size_t largest_value = 50000;

// Inserts the arguments of `term`, an application, before `arguments`; returns its head.
const Term& unwound(const Term& term, std::vector<Term>& arguments) {
  std::size_t count = 0;
  const Term* head = &term;
  for (; head->kind() == Term::Kind::apply; head = &head->function()) ++count;
  arguments.insert(arguments.begin(), count, Term());
  const Term* at = &term;
  for (; at->kind() == Term::Kind::apply; at = &at->function()) arguments[--count] = at->argument();
  return *head;
}

bool has_open(const std::vector<Term>& arguments) {
  return std::any_of(arguments.begin(), arguments.end(), [](const Term& each) { return !each.closed(); });
}

void drop(std::vector<Term>& arguments, std::size_t& ready, std::size_t count) {
  arguments.erase(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(count));
  ready -= std::min(ready, count);
}

// Whether a name of one type can have a value of the other. An object may have the same name as a function (a cup named
// cup). Types of one kind were checked when the term was read.
bool names_same(const Type& name, const Type& value) { return name.kind() == value.kind() || consistent(name, value); }

}  // namespace

Term Evaluation::value(const Term& term) {
  if (depth_ > 0) return evaluated(term);
  steps_ = 0;
  Term result = evaluated(term);
  return steps_ > most_evaluation_steps ? Term::null() : result;
}

Term Evaluation::apply(const Term& function, const Term& argument) {
  const bool outermost = depth_ == 0;
  if (outermost) steps_ = 0;
  Redex redex;
  redex.arguments.reserve(3);
  redex.head = function.kind() == Term::Kind::apply ? unwound(function, redex.arguments) : function;
  redex.arguments.push_back(argument);
  redex.ready = redex.arguments.size();  // function and argument are values, so their parts are
  ++depth_;
  Term result = depth_ > deepest_evaluation ? (give_up(), Term::null()) : reduced(std::move(redex));
  --depth_;
  return outermost && steps_ > most_evaluation_steps ? Term::null() : result;
}

bool Evaluation::spend(std::size_t steps) {
  steps_ += std::min(steps, most_evaluation_steps + 1);
  if (steps_ > most_evaluation_steps) exhausted = true;
  return steps_ <= most_evaluation_steps;
}

void Evaluation::note_compared(double a, double b) {
  if (a != std::nearbyint(a) || b != std::nearbyint(b)) note_margin(std::abs(a - b));
}

void Evaluation::give_up() { spend(most_evaluation_steps + 1); }

Term Evaluation::bounded(Term term) {
  if (term.depth() <= deepest_value && term.size() <= largest_value) return term;
  give_up();
  return Term::null();
}

RuleTable::RuleTable(std::initializer_list<const Rules*> sources, const RaisingRules* raising) : raising_(raising) {
  for (const auto* source : sources)
    for (const auto& [name, rule] : *source) rules_.emplace(Name(name), rule);
}

Term Evaluation::evaluated(const Term& term) {
  switch (term.kind()) {
    case Term::Kind::null:
    case Term::Kind::truth:
    case Term::Kind::number:
    case Term::Kind::text:
    case Term::Kind::place:
    case Term::Kind::bound:
      return term;
    default:
      break;
  }
  if (!spend(1)) return Term::null();
  if (depth_ >= deepest_evaluation) {
    give_up();
    return Term::null();
  }
  ++depth_;
  Term result;
  if (term.kind() == Term::Kind::list) {
    result = evaluated_list(term);
  } else if (term.kind() == Term::Kind::lambda) {
    if (derivation) derivation->enter(term);
    Term body = evaluated(term.body());
    if (derivation) derivation->leave();
    result = body.same_node(term.body()) ? term : Term::lambda(term.name(), term.variable_type(), std::move(body));
  } else {
    Redex redex;
    redex.head = term.kind() == Term::Kind::apply ? unwound(term, redex.arguments) : term;
    result = reduced(std::move(redex));
  }
  --depth_;
  return bounded(std::move(result));
}

Term Evaluation::evaluated_list(const Term& term) {
  const auto& elements = term.elements();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    Term first_changed = evaluated(elements[i]);
    if (first_changed.same_node(elements[i])) continue;
    std::vector<Term> values(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(i));
    values.reserve(elements.size());
    values.push_back(std::move(first_changed));
    for (++i; i < elements.size(); ++i) values.push_back(evaluated(elements[i]));
    return Term::list(std::move(values), term.type().element());
  }
  return term;
}

Term Evaluation::reduced(Redex redex) {
  for (;;) {
    if (!spend(1)) return Term::null();
    switch (redex.head.kind()) {
      case Term::Kind::apply:
        redex.head = Term(unwound(redex.head, redex.arguments));
        redex.ready = 0;
        break;
      case Term::Kind::lambda:
        if (redex.arguments.empty()) return evaluated(redex.head);
        make_ready(redex, 1);
        reduce_lambda(redex);
        drop(redex.arguments, redex.ready, 1);
        break;
      case Term::Kind::constant:
        if (reduce_constant(redex) == Step::done) return std::move(redex.head);
        break;
      case Term::Kind::bound:
        keep(redex);
        return std::move(redex.head);
      default:  // a value that is not a function: applied, it gives null
        return redex.arguments.empty() ? evaluated(redex.head) : Term::null();
    }
  }
}

void Evaluation::make_ready(Redex& redex, std::size_t count) {
  for (; redex.ready < count; ++redex.ready) redex.arguments[redex.ready] = evaluated(redex.arguments[redex.ready]);
}

void Evaluation::reduce_lambda(Redex& redex) {
  Term result = bounded(instantiate(redex.head.body(), redex.arguments[0]));
  if (derivation) derivation->applied(redex.head, redex.arguments[0], result, true);
  redex.head = std::move(result);
}

// The head has no rule and no value: it stays, applied to the values of its arguments. `told`: to the derivation.
Evaluation::Step Evaluation::keep(Redex& redex, bool told) {
  make_ready(redex, redex.arguments.size());
  for (auto& argument : redex.arguments) {
    Term result = Term::apply(redex.head, argument);
    if (derivation && told) derivation->applied(redex.head, argument, result, false);
    redex.head = std::move(result);
  }
  redex.arguments.clear();
  return Step::done;
}

Evaluation::Step Evaluation::reduce_constant(Redex& redex) {
  static const Name name_if("if"), name_and("and"), name_or("or");
  const auto name = redex.head.interned_name();
  if (name == name_if || name == name_and || name == name_or) return reduce_choice(redex);
  if (const Rule* found = rules_.find(name)) return reduce_rule(redex, *found);
  const Held held = lookup_ ? lookup_(name) : nullptr;
  if (!held.value || !names_same(redex.head.type(), held.value->type())) return keep(redex, true);
  if (definitions_wait && has_open(redex.arguments)) return keep(redex, true);
  redex.head = Term(*held.value);
  if (!redex.arguments.empty()) return Step::again;
  if (!held.kept) redex.head = value_of(name, std::move(redex.head));
  return Step::done;
}

// Definitions name one another again and again; the value of each is worked out once, but for those that draw or whose
// applications are told.
Term Evaluation::value_of(Name name, Term held) {
  const auto known = std::find_if(values_.begin(), values_.end(), [&](const auto& each) { return each.first == name; });
  if (known != values_.end()) return known->second;
  const auto effects = [this] { return std::pair(applications.size(), facts_.random ? facts_.random->state() : 0); };
  const auto before = effects();
  Term value = evaluated(held);
  if (!exhausted && effects() == before) values_.emplace_back(name, value);
  return value;
}

// `if`, `and` and `or` evaluate only the arguments they need, but all of them while they wait for a bound variable.
Evaluation::Step Evaluation::reduce_choice(Redex& redex) {
  auto& arguments = redex.arguments;
  const bool is_if = redex.head.name() == "if", is_and = redex.head.name() == "and";
  const std::size_t arity = is_if ? 3 : 2;
  if (arguments.size() < arity) return keep(redex);
  make_ready(redex, 1);
  if (!arguments[0].closed()) return keep(redex);
  const bool first = arguments[0].is_true();
  if (is_if) {
    redex.head = Term(arguments[first ? 1 : 2]);
  } else if (first != is_and) {
    redex.head = Term::truth(!is_and);
  } else {
    make_ready(redex, 2);
    if (!arguments[1].closed()) return keep(redex);
    redex.head = Term::truth(arguments[1].is_true());
  }
  drop(arguments, redex.ready, arity);
  return Step::again;
}

Evaluation::Step Evaluation::reduce_rule(Redex& redex, const Rule& rule) {
  auto& arguments = redex.arguments;
  if (arguments.size() < rule.arity) return keep(redex);
  make_ready(redex, rule.arity);
  const std::span<const Term> given(arguments.data(), rule.arity);
  if (!std::all_of(given.begin(), given.end(), [](const Term& each) { return each.closed(); })) return keep(redex);
  const bool null_given =
      !rule.takes_null && std::any_of(given.begin(), given.end(), [](const Term& each) { return each.is_null(); });
  redex.head = null_given ? Term::null() : bounded(rule.compute(given, *this));
  if (arguments.size() == rule.arity) return Step::done;
  drop(arguments, redex.ready, rule.arity);
  return Step::again;
}

}  // namespace continua
