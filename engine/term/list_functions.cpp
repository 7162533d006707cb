// The rules of lists.
#include <algorithm>
#include <cmath>
#include <utility>

#include "continua/term/rules.h"

namespace continua {
namespace {

using Arguments = std::span<const Term>;
using Elements = std::vector<Term>;

const Elements& elements(const Term& list) { return list.elements(); }
Type element_type(const Term& list) { return list.type().element(); }
Elements::const_iterator nth_of(const Elements& list, std::size_t n) {
  return list.begin() + static_cast<std::ptrdiff_t>(n);
}

// A number as a count: rounded down, at least 0 and at most `most`.
std::size_t count(const Term& number, std::size_t most) {
  const double value = std::floor(number.number_value());
  if (value <= 0) return 0;
  return value >= static_cast<double>(most) ? most : static_cast<std::size_t>(value);
}

Term part(const Term& list, std::size_t from, std::size_t to) {
  return Term::list(Elements(nth_of(elements(list), from), nth_of(elements(list), to)), element_type(list));
}

Term at(const Term& list, std::size_t index) {
  return index < elements(list).size() ? elements(list)[index] : Term::null();
}

Term nth(Arguments a, Evaluation&) {
  const double index = a[1].number_value();
  if (index < 0 || index != std::floor(index)) return Term::null();
  return at(a[0], count(a[1], elements(a[0]).size()));
}

// The element type of both lists. An empty list literal only has `term`; then the other list's type counts.
Type common_element(const Term& a, const Term& b) {
  return element_type(a) == Type::term() ? element_type(b) : element_type(a);
}

Term append(Arguments a, Evaluation&) {
  Elements joined = elements(a[0]);
  joined.insert(joined.end(), elements(a[1]).begin(), elements(a[1]).end());
  return Term::list(std::move(joined), common_element(a[0], a[1]));
}

Term concat(Arguments a, Evaluation& evaluation) {
  const Type lists = element_type(a[0]);
  Elements joined;
  for (const auto& list : elements(a[0])) {
    if (list.kind() != Term::Kind::list) return Term::null();
    if (!evaluation.spend(elements(list).size())) return Term::null();
    joined.insert(joined.end(), elements(list).begin(), elements(list).end());
  }
  return Term::list(std::move(joined), lists.kind() == Type::Kind::list ? lists.element() : Type::term());
}

Term reverse(Arguments a, Evaluation&) {
  return Term::list(Elements(elements(a[0]).rbegin(), elements(a[0]).rend()), element_type(a[0]));
}

// All beginnings or all ends of a list, each in its order.
template <class Part>
auto parts(Part part_of) {
  return [part_of](Arguments a, Evaluation& evaluation) {
    const auto size = elements(a[0]).size();
    if (!evaluation.spend(size * (size + 1) / 2)) return Term::null();
    Elements found;
    for (std::size_t i = 0; i < size; ++i) found.push_back(part_of(a[0], i, size));
    return Term::list(std::move(found), a[0].type());
  };
}

// Runs of 1, 2, 3, … elements, and the rest.
Term runs(Arguments a, Evaluation&) {
  const auto size = elements(a[0]).size();
  Elements found;
  for (std::size_t from = 0, length = 1; from < size; from += length++)
    found.push_back(part(a[0], from, std::min(from + length, size)));
  return Term::list(std::move(found), a[0].type());
}

Term map(Arguments a, Evaluation& evaluation) {
  Elements results;
  for (const auto& each : elements(a[0])) results.push_back(evaluation.apply(a[1], each));
  const auto& type = a[1].type();
  const bool known = type.kind() == Type::Kind::function && !type.polymorphic();
  return Term::list(std::move(results), known ? Type(type.to()) : Type::term());
}

Term filter(Arguments a, Evaluation& evaluation) {
  Elements kept;
  for (const auto& each : elements(a[0]))
    if (evaluation.apply(a[1], each).is_true()) kept.push_back(each);
  return Term::list(std::move(kept), element_type(a[0]));
}

Term some(Arguments a, Evaluation& evaluation) {
  return Term::truth(std::any_of(elements(a[0]).begin(), elements(a[0]).end(),
                                 [&](const Term& each) { return evaluation.apply(a[1], each).is_true(); }));
}

Term every(Arguments a, Evaluation& evaluation) {
  return Term::truth(std::all_of(elements(a[0]).begin(), elements(a[0]).end(),
                                 [&](const Term& each) { return evaluation.apply(a[1], each).is_true(); }));
}

// Elements without a numeric key come last, in their order.
Term sort_by(Arguments a, Evaluation& evaluation) {
  struct Keyed {
    double key;
    const Term* element;
  };
  std::vector<Keyed> keyed;
  for (const auto& each : elements(a[0])) {
    const Term key = evaluation.apply(a[1], each);
    keyed.push_back(
        {key.kind() == Term::Kind::number ? key.number_value() : std::numeric_limits<double>::infinity(), &each});
  }
  std::stable_sort(keyed.begin(), keyed.end(), [](const Keyed& x, const Keyed& y) { return x.key < y.key; });
  Elements sorted;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    if (i > 0 && std::isfinite(keyed[i].key)) evaluation.note_compared(keyed[i - 1].key, keyed[i].key);
    sorted.push_back(*keyed[i].element);
  }
  return Term::list(std::move(sorted), element_type(a[0]));
}

Term contains_element(Arguments a, Evaluation&) {
  return Term::truth(std::find(elements(a[0]).begin(), elements(a[0]).end(), a[1]) != elements(a[0]).end());
}

}  // namespace

void add_list_functions(Rules& rules, Signature& signature) {
  const auto size = [](Arguments a, Evaluation&) { return Term::number(static_cast<double>(elements(a[0]).size())); };
  const auto head = [](Arguments a, Evaluation&) { return at(a[0], 0); };
  const auto last = [](Arguments a, Evaluation&) {
    return elements(a[0]).empty() ? Term::null() : elements(a[0]).back();
  };
  const auto tail = [](Arguments a, Evaluation&) {
    return elements(a[0]).empty() ? a[0] : part(a[0], 1, elements(a[0]).size());
  };
  const auto take = [](Arguments a, Evaluation&) { return part(a[0], 0, count(a[1], elements(a[0]).size())); };
  const auto prefix = [](const Term& list, std::size_t i, std::size_t) { return part(list, 0, i + 1); };
  const auto suffix = [](const Term& list, std::size_t i, std::size_t end) { return part(list, i, end); };
  add_functions(
      {
          {"size", "'a* -> num", size},
          {"head", "'a* -> 'a", head},
          {"last", "'a* -> 'a", last},
          {"nth", "'a* -> num -> 'a", nth},
          {"tail", "'a* -> 'a*", tail},
          {"take", "'a* -> num -> 'a*", take},
          {"append", "'a* -> 'a* -> 'a*", append},
          {"concat", "'a** -> 'a*", concat},
          {"reverse", "'a* -> 'a*", reverse},
          {"prefixes", "'a* -> 'a**", parts(prefix)},
          {"suffixes", "'a* -> 'a**", parts(suffix)},
          {"runs", "'a* -> 'a**", runs},
          {"map", "'a* -> ('a -> 'b) -> 'b*", map},
          {"filter", "'a* -> ('a -> t) -> 'a*", filter},
          {"some", "'a* -> ('a -> t) -> t", some},
          {"every", "'a* -> ('a -> t) -> t", every},
          {"sort_by", "'a* -> ('a -> num) -> 'a*", sort_by},
          {"contains", "'a* -> 'a -> t", contains_element},
      },
      rules, signature);
}

}  // namespace continua
