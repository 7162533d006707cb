#include "continua/term/substitution.h"

#include "generate_terms.h"
#include "law.h"
#include "named_terms.h"

namespace continua {
namespace {

// Structural equality up to the names of variables, by recursion.
bool alpha_equivalent(const Term& a, const Term& b) {
  if (a.kind() != b.kind()) return false;
  switch (a.kind()) {
    case Term::Kind::null:
      return true;
    case Term::Kind::truth:
      return a.truth_value() == b.truth_value();
    case Term::Kind::number:
      return a.number_value() == b.number_value();
    case Term::Kind::text:
      return a.text_value() == b.text_value();
    case Term::Kind::place:
      return a.place_value() == b.place_value();
    case Term::Kind::constant:
      return a.name() == b.name();
    case Term::Kind::bound:
      return a.index() == b.index();
    case Term::Kind::lambda:
      return alpha_equivalent(a.body(), b.body());
    case Term::Kind::apply:
      return alpha_equivalent(a.function(), b.function()) && alpha_equivalent(a.argument(), b.argument());
    case Term::Kind::list:
      return std::equal(a.elements().begin(), a.elements().end(), b.elements().begin(), b.elements().end(),
                        alpha_equivalent);
  }
  return false;
}

// A copy built anew, with other names of variables, and the leaf number `at` changed; counted down on the way.
Term altered(const Term& term, int& at) {
  switch (term.kind()) {
    case Term::Kind::lambda:
      return Term::lambda(term.name() + "_", term.variable_type(), altered(term.body(), at));
    case Term::Kind::apply: {
      Term function = altered(term.function(), at);
      return Term::apply(std::move(function), altered(term.argument(), at));
    }
    case Term::Kind::list: {
      std::vector<Term> elements;
      for (const auto& each : term.elements()) elements.push_back(altered(each, at));
      return Term::list(std::move(elements), term.type().element());
    }
    default:
      break;
  }
  if (at-- != 0) return term;
  switch (term.kind()) {
    case Term::Kind::number:
      return Term::number(term.number_value() + 1);
    case Term::Kind::text:
      return Term::text(term.text_value() + "!");
    case Term::Kind::truth:
      return Term::truth(!term.truth_value());
    case Term::Kind::constant:
      return Term::constant(term.name() + "s", term.type());
    case Term::Kind::bound:
      return Term::bound(term.index() > 0 ? term.index() - 1 : term.index(), term.type());
    case Term::Kind::place:
      return Term::place({term.place_value().max, term.place_value().min, !term.place_value().region});
    default:
      return term;
  }
}

void same_as_recursion(const Term& a, const Term& b) {
  const bool equivalent = alpha_equivalent(a, b);
  RC_ASSERT((a == b) == equivalent);
  RC_ASSERT((a.digest() == b.digest()) == equivalent);
  RC_ASSERT(!equivalent || TermHash{}(a) == TermHash{}(b));
  RC_CLASSIFY(equivalent, "equal");
}

}  // namespace

TEST_CASE("digests are equal just where terms are, up to the names of variables") {
  law("of small terms", [] {
    TermGenerator generate;
    const Type type = generate.type(1);
    const Term one = generate.term(type, {}, 1), other = generate.term(type, {}, 1);
    same_as_recursion(one, other);
  });
  law("of a term and its copy with a leaf changed", [](const TypedTerm& typed) {
    int at = *rc::gen::inRange(0, 12);
    same_as_recursion(typed.term, altered(typed.term, at));
  });
  law("of the parts of a term, which are different but for themselves", [](const TypedTerm& typed) {
    if (typed.term.kind() == Term::Kind::apply) {
      same_as_recursion(typed.term, typed.term.argument());
      same_as_recursion(typed.term.function(), typed.term.argument());
    }
  });
}

TEST_CASE("a term's digest is the same in every program") {
  // Held down because digests may be written: one that changes invalidates them.
  const auto digest = read("\\x. put(x, on(block1))").digest();
  CHECK(digest.high == 0x77dee8cd102ead22);
  CHECK(digest.low == 0x10132a6e46ed818f);
}

TEST_CASE("instantiating does what substituting for a named variable does") {
  law("numbered and named variables agree", [] {
    TermGenerator generate;
    const Type outer = generate.type(1), inner = generate.type(1);
    const Term body = generate.term(generate.type(2), {outer, inner}, 4);
    const Term argument = generate.term(inner, {outer}, 2);
    const Named substitute = substituted(named(body, {"x", "(argument)"}), "(argument)", named(argument, {"x"}));
    RC_ASSERT(instantiate(body, argument) == numbered(substitute, {"x"}));
    RC_CLASSIFY(mentions(body, 0) && argument.reach() > 0, "could be captured");
  });
}

TEST_CASE("what is taken out of a term can be put back") {
  const auto something = [](const Type& type) { return Term::constant("something", type); };
  law("instantiating undoes abstracting", [] {
    TermGenerator generate;
    const Term term = generate.term(generate.type(2), {}, 5);
    const char* const parts[] = {"block1", "block4", "true", "on(block1)", "\\x: e. on(x)"};
    const Term part = read(parts[*rc::gen::inRange(0, 5)]);
    const Term body = abstracted(term, part);
    RC_ASSERT(instantiate(body, part) == term);
    RC_ASSERT(mentions(body, 0) == contains(term, part));
    RC_ASSERT(!contains(body, part));
    RC_CLASSIFY(contains(term, part), "contained");
  });
  law("abstracting undoes instantiating with what is new", [&] {
    TermGenerator generate;
    const Type type = generate.type(1);
    const Term body = generate.term(generate.type(2), {type}, 4);
    RC_ASSERT(abstracted(instantiate(body, something(type)), something(type)) == body);
  });
}

TEST_CASE("a part is replaced, and applied where it was") {
  const auto with = [](const char* text, const char* part, const char* by) {
    return print(replaced(read(text), read(part), read(by)));
  };
  CHECK(with("\\y. put(block1, on(y))", "block1", "block4") == "\\y. put(block4, on(y))");
  CHECK(with("\\y. [on(y), on(block1)]", "on", "\\x. center(region)") == "\\y. [center(region), center(region)]");
  CHECK(with("\\y. on(y)", "on", "\\x: e. put(x)") == "\\y. put(y)");
  CHECK(with("\\y. map(objects, on)", "on", "\\x. center(region)") == "\\y. map(objects, \\x. center(region))");
  CHECK(with("block1", "block1", "block4") == "block4");
  CHECK(with("block1", "on", "on") == "block1");
}

TEST_CASE("eta-contraction keeps what a function gives") {
  law("a function and its contraction give the same", [] {
    TermGenerator generate;
    const Type from = generate.type(1), to = generate.type(1);
    const Term function = generate.term(Type::function(from, to), {}, 3);
    const Term argument = generate.term(from, {}, 2);
    RC_ASSERT(evaluation({}).value(Term::apply(function, argument)) ==
              evaluation({}).value(Term::apply(eta_contracted(function), argument)));
  });
  const auto contracted = [](const char* text) { return print(eta_contracted(read(text))); };
  CHECK(contracted("\\x. on(x)") == "on");
  CHECK(contracted("\\x y. put(x, y)") == "put");
  CHECK(contracted("\\x. put(block1, x)") == "put(block1)");
  CHECK(contracted("\\x. put(x, on(x))") == "\\x. put(x, on(x))");
  CHECK(contracted("\\x. put(x, region)") == "\\x. put(x, region)");
  CHECK(contracted("\\f: e -> e. \\x. f(x)") == "\\f. f");
  CHECK(contracted("\\x. null(x)") == "\\x. null(x)");
}

TEST_CASE("the order in which a term is reduced does not change its normal form") {
  static const RuleTable no_rules({});
  law("outermost first, by names, and by value, by numbers", [] {
    TermGenerator generate;
    const Type type = generate.type(2), other = generate.type(2);
    const Term function = Term::lambda("x", other, generate.term(type, {other}, 4));
    const Term term = Term::apply(function, generate.term(other, {}, 3));
    Named at = named(term, {});
    int steps = 0;
    for (auto next = reduced_once(at); next && steps < 300; next = reduced_once(at), ++steps) at = std::move(*next);
    RC_PRE(steps < 300);
    Evaluation evaluation(no_rules, nullptr);
    RC_ASSERT(evaluation.value(term) == numbered(at, {}));
    RC_CLASSIFY(steps > 2, "several steps");
  });
}

}  // namespace continua
