// The rules of terms (a command that lacks an argument is a term of type function) and of texts.
#include <algorithm>
#include <string>
#include <utility>

#include "continua/core/characters.h"
#include "continua/term/raising.h"
#include "continua/term/rules.h"
#include "continua/term/substitution.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

using Arguments = std::span<const Term>;

// The body below all of a term's outer lambdas.
const Term& below_lambdas(const Term& term) {
  const Term* at = &term;
  while (at->kind() == Term::Kind::lambda) at = &at->body();
  return *at;
}

// Whether the term waits for an argument: a lambda, or a name of function type.
bool is_open(const Term& term) {
  return term.kind() == Term::Kind::lambda || term.type().kind() == Type::Kind::function;
}

Term fill(Arguments a, Evaluation& evaluation) {
  if (!is_open(a[0])) return a[0];
  const Type& wanted = a[0].type().from();
  Raised lifted{a[1], ""};
  if (!fits(a[1], wanted)) {
    auto raised_argument =
        evaluation.raising() ? raised(a[1], wanted, *evaluation.raising(), evaluation) : std::nullopt;
    if (!raised_argument) return Term::null();
    lifted = std::move(*raised_argument);
  }
  Term result = evaluation.apply(a[0], lifted.term);
  evaluation.applications.push_back({a[0], a[1], result, lifted.rule});
  return result;
}

Term program(Arguments a, Evaluation&) {
  const Term* head = &below_lambdas(a[0]);
  while (head->kind() == Term::Kind::apply) head = &head->function();
  return head->kind() == Term::Kind::constant ? Term::text(head->name()) : Term::null();
}

Term argument(Arguments a, Evaluation&) {
  const auto arguments = below_lambdas(a[0]).spine().arguments;
  const double index = a[1].number_value();
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (static_cast<double>(i) == index) return arguments[i].closed() ? arguments[i] : Term::null();
  return Term::null();
}

// The continuation of a part: the term as a function of that part.
Term lacking(Arguments a, Evaluation&) {
  if (a[1].is_null() || !a[0].closed() || !a[1].closed()) return Term::null();
  const char* hint = a[1].type() == Type::location() ? "v" : "x";
  return Term::lambda(hint, a[1].type(), abstracted(a[0], a[1]));
}

std::string characters(const Term& term) { return term.kind() == Term::Kind::text ? term.text_value() : print(term); }

Term mentions_text(Arguments a, Evaluation&) {
  return Term::truth(characters(a[0]).find(a[1].text_value()) != std::string::npos);
}

Term place(Arguments a, Evaluation&) {
  const Term* found = first_place(a[0]);
  return found ? *found : Term::null();
}

Term words(Arguments a, Evaluation& evaluation) {
  const std::string& text = a[0].text_value();
  std::vector<Term> found;
  if (!evaluation.spend(text.size() / 16)) return Term::null();
  for (std::size_t from = 0;;) {
    from = text.find_first_not_of(' ', from);
    if (from == std::string::npos) break;
    const auto to = std::min(text.find(' ', from), text.size());
    found.push_back(Term::text(text.substr(from, to - from)));
    from = to;
  }
  return Term::list(std::move(found), Type::text_type());
}

Term join(Arguments a, Evaluation& evaluation) {
  const std::string& between = a[1].text_value();
  std::string joined;
  for (const auto& each : a[0].elements()) {
    if (each.kind() != Term::Kind::text) return Term::null();
    if (!evaluation.spend((each.text_value().size() + between.size()) / 16)) return Term::null();
    if (&each != &a[0].elements().front()) joined += between;
    joined += each.text_value();
  }
  return Term::text(std::move(joined));
}

// One half of a pointing dot(things, place); null of anything else.
Term half(const Term& pointing, std::size_t which) {
  const auto [head, halves] = pointing.spine();
  return head == pointing_constructor() && halves.size() == 2 ? halves[which] : Term::null();
}

Term lower(Arguments a, Evaluation&) { return Term::text(folded(a[0].text_value())); }

}  // namespace

const Term& pointing_constructor() {
  static const Term dot = Term::constant(
      "dot", Type::function(Type::list(Type::entity()), Type::function(Type::location(), Type::pointing())));
  return dot;
}

void add_term_functions(Rules& rules, Signature& signature) {
  const auto open = [](Arguments a, Evaluation&) { return Term::truth(is_open(a[0])); };
  const auto text = [](Arguments a, Evaluation&) { return Term::text(characters(a[0])); };
  const auto type = [](Arguments a, Evaluation&) { return Term::text(a[0].type().text()); };
  const auto missing = [](Arguments a, Evaluation&) {
    return is_open(a[0]) ? Term::text(a[0].type().from().text()) : Term::null();
  };
  const auto starts_with = [](Arguments a, Evaluation&) {
    return Term::truth(a[0].text_value().starts_with(a[1].text_value()));
  };
  add_functions(
      {
          {"open", "term -> t", open},
          {"missing", "term -> text", missing},
          {"type", "term -> text", type},
          {"fill", "term -> term -> term", fill},
          {"lacking", "term -> term -> term", lacking},
          {"program", "term -> text", program},
          {"argument", "term -> num -> term", argument},
          {"mentions", "term -> text -> t", mentions_text},
          {"text", "term -> text", text},
          {"place", "term -> loc", place},
          {"things_of", "e* • loc -> e*", [](Arguments a, Evaluation&) { return half(a[0], 0); }},
          {"place_of", "e* • loc -> loc", [](Arguments a, Evaluation&) { return half(a[0], 1); }},
          {"words", "text -> text*", words},
          {"starts_with", "text -> text -> t", starts_with},
          {"join", "text* -> text -> text", join},
          {"lower", "text -> text", lower},
      },
      rules, signature);
}

}  // namespace continua
