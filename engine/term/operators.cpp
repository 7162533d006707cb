// The rules of the operators, and of functions of numbers. `and`, `or` and `if` evaluate only the arguments they need
// and are therefore part of the evaluation.
#include <algorithm>
#include <cmath>

#include "continua/term/rules.h"

namespace continua {
namespace {

using Arguments = std::span<const Term>;

double number(const Term& term) { return term.number_value(); }

bool equal(Arguments a, Evaluation& evaluation) {
  if (a[0].kind() == Term::Kind::number && a[1].kind() == Term::Kind::number)
    evaluation.note_compared(number(a[0]), number(a[1]));
  return a[0] == a[1];
}

template <class Compare>
auto comparing(Compare compare) {
  return [compare](Arguments a, Evaluation& evaluation) {
    evaluation.note_compared(number(a[0]), number(a[1]));
    return Term::truth(compare(number(a[0]), number(a[1])));
  };
}

template <class Compute>
auto computing(Compute compute) {
  return [compute](Arguments a, Evaluation&) { return Term::number(compute(number(a[0]), number(a[1]))); };
}

template <class Compute>
auto computing_one(Compute compute) {
  return [compute](Arguments a, Evaluation&) { return Term::number(compute(number(a[0]))); };
}

}  // namespace

void add_operators(Rules& rules, Signature& signature) {
  add_functions(
      {
          {"not", "t -> t", [](Arguments a, Evaluation&) { return Term::truth(!a[0].is_true()); }, true},
          {"=", "'a -> 'a -> t", [](Arguments a, Evaluation& e) { return Term::truth(equal(a, e)); }, true},
          {"!=", "'a -> 'a -> t", [](Arguments a, Evaluation& e) { return Term::truth(!equal(a, e)); }, true},
          {"<", "num -> num -> t", comparing([](double a, double b) { return a < b; })},
          {"<=", "num -> num -> t", comparing([](double a, double b) { return a <= b; })},
          {">", "num -> num -> t", comparing([](double a, double b) { return a > b; })},
          {">=", "num -> num -> t", comparing([](double a, double b) { return a >= b; })},
          {"+", "num -> num -> num", computing([](double a, double b) { return a + b; })},
          {"-", "num -> num -> num", computing([](double a, double b) { return a - b; })},
          {"*", "num -> num -> num", computing([](double a, double b) { return a * b; })},
          {"/", "num -> num -> num", computing([](double a, double b) { return a / b; })},
          {"negate", "num -> num", computing_one([](double a) { return -a; })},
          {"min", "num -> num -> num", computing([](double a, double b) { return std::min(a, b); })},
          {"max", "num -> num -> num", computing([](double a, double b) { return std::max(a, b); })},
          {"abs", "num -> num", computing_one([](double a) { return std::abs(a); })},
          {"round", "num -> num", computing_one([](double a) { return std::round(a); })},
      },
      rules, signature);
}

}  // namespace continua
