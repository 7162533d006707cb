#include "continua/term/substitution.h"
#include "generate_terms.h"
#include "law.h"

namespace continua {
namespace {

Term value_of_term(const Term& term) { return evaluation({}).value(term); }

Term list_of(const std::vector<int>& numbers) {
  std::vector<Term> elements;
  for (int each : numbers) elements.push_back(Term::number(each));
  return Term::list(std::move(elements), Type::number());
}

// f(list), by its printed form.
std::string of_list(const std::string& f, const std::vector<int>& numbers) {
  return value_of(f + "(" + print(list_of(numbers)) + ")");
}

}  // namespace

TEST_CASE("what is printed reads back as the same term, of its type") {
  law("parse after print is identity", [](const TypedTerm& typed) {
    const auto again = parse_term(print(typed.term), test_names(), typed.type);
    if (!again) RC_FAIL(again.error().text());
    RC_ASSERT(*again == typed.term);
    RC_ASSERT(consistent(again->type(), typed.type));
    RC_ASSERT(print(*again) == print(typed.term));
    RC_CLASSIFY(typed.term.size() > 10, "large");
  });
}

TEST_CASE("evaluation preserves the type and ends in a value") {
  law("a value has its term's type", [](const TypedTerm& typed) {
    const Term value = value_of_term(typed.term);
    RC_ASSERT(value.closed());
    RC_ASSERT(consistent(value.type(), typed.type));
    const auto again = parse_term(print(value), test_names(), typed.type);
    if (!again) RC_FAIL(print(value) + ": " + again.error().text());
  });
  law("a value is its own value", [](const TypedTerm& typed) {
    const Term value = value_of_term(typed.term);
    RC_ASSERT(value_of_term(value) == value);
  });
}

TEST_CASE("instantiating captures nothing, whatever the terms") {
  // Substituting for the inner variable and then for the outer is substituting for the outer first.
  law("substitutions commute", [] {
    TermGenerator generate;
    const Type inner = generate.type(1), outer = generate.type(1);
    const Term body = generate.term(generate.type(2), {outer, inner}, 4);
    const Term argument = generate.term(inner, {outer}, 2);
    const Term closed = generate.term(outer, {}, 2);
    const Term inner_first = instantiate(instantiate(body, argument), closed);
    const Term outer_first =
        instantiate(instantiate(Term::lambda("x", inner, body), closed).body(), instantiate(argument, closed));
    RC_ASSERT(inner_first == outer_first);
    RC_ASSERT(inner_first.closed());
  });
  law("the names of variables mean nothing", [](const TypedTerm& typed) {
    const Term under = Term::lambda("x", Type::entity(), typed.term);
    RC_ASSERT(under == Term::lambda("y", Type::entity(), typed.term));
    RC_ASSERT(instantiate(under.body(), read("block1")) == typed.term);
  });
}

TEST_CASE("beginnings and ends of lists") {
  law("there are as many as elements, and the whole is one of them", [](const std::vector<int>& numbers) {
    const std::string size = std::to_string(numbers.size()), all = print(list_of(numbers));
    RC_PRE(!numbers.empty());
    RC_ASSERT(value_of("size(prefixes(" + all + "))") == size);
    RC_ASSERT(value_of("size(suffixes(" + all + "))") == size);
    RC_ASSERT(value_of("last(prefixes(" + all + "))") == all);
    RC_ASSERT(value_of("head(suffixes(" + all + "))") == all);
  });
  law("the ends of a list are the beginnings of the reversed list, reversed", [](const std::vector<int>& numbers) {
    const std::string all = print(list_of(numbers));
    RC_ASSERT(of_list("suffixes", numbers) == value_of("reverse(map(prefixes(reverse(" + all + ")), reverse))"));
  });
  law("a beginning and what is left make the list", [](const std::vector<int>& numbers) {
    const std::string all = print(list_of(numbers));
    RC_ASSERT(value_of("append(take(" + all + ", 1), tail(" + all + "))") == all);
    RC_ASSERT(of_list("concat", {}) == "[]");
  });
}

TEST_CASE("garbage is refused with a place in the text, never a crash") {
  static const std::vector<std::string> pieces = {
      "(",   ")",    "[",   "]",    "<",  ">",    ",",   ".",   ":",       "\\",     "λ",    "=",      "!=",
      "<=",  ">=",   "+",   "-",    "*",  "/",    "'",   "`",   " ",       "x",      "y",    "block1", "put",
      "on",  "size", "map", "head", "if", "fill", "box", "not", "and",     "or",     "null", "true",   "1",
      "0.5", "2e3",  "'a'", "e",    "->", "\xff", "#",   "\n",  "content", "actions"};
  const auto holds = [](const std::string& text) {
    const auto term = parse_term(text, test_names());
    if (term) {
      const auto again = parse_term(print(*term), test_names());
      RC_ASSERT(again.ok());
      RC_ASSERT(*again == *term);
      value_of_term(*term);
    } else {
      RC_ASSERT(term.error().where.starts_with("column "));
      const auto column = std::stoul(term.error().where.substr(7));
      RC_ASSERT(column >= 1);
      RC_ASSERT(column <= text.size() + 1);
    }
  };
  law("reading pieces ends in a term or in an error with a column", [&](const std::vector<std::uint8_t>& choices) {
    std::string text;
    for (const auto choice : choices) text += pieces[choice % pieces.size()];
    holds(text);
  });
  law("so does reading a damaged term", [&](const TypedTerm& typed, std::size_t at, std::size_t piece, bool remove) {
    std::string text = print(typed.term);
    at %= text.size() + 1;
    if (remove)
      text.erase(at, 1 + piece % 3);
    else
      text.insert(at, pieces[piece % pieces.size()]);
    holds(text);
  });
}

}  // namespace continua
