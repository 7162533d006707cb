#include "continua/term/evaluate.h"

#include "continua/term/substitution.h"
#include "read_terms.h"

namespace continua {
namespace {

const Slots& slots() {
  static const Slots all = {
      {"region", read("box(<0, 0, 0>, <0.2, 0.4, 0>)")},
      {"objects", read("[block1, block4]")},
      {"actions", read("append(actions, [put(block1, <1, 2, 3>), \\x. put(x, on(block4))])").argument()},
      {"content", read("\\x. put(x, on(block4))")},
      {"indicated", Term::null()},
  };
  return all;
}

}  // namespace

TEST_CASE("names that compute nothing stay, whatever they are applied to") {
  CHECK(value_of("put(block4, on(block1))") == "put(block4, on(block1))");
  CHECK(value_of("put(block4)") == "put(block4)");
  CHECK(value_of("put(null, on(block1))") == "put(null, on(block1))");
}

TEST_CASE("a command is computed below its lambdas, but for what its variables hold up") {
  CHECK(value_of("\\x. put(x, center(region))", slots()) == "\\x. put(x, <0.1, 0.2, 0>)");
  CHECK(value_of("\\p. put(head(objects), toward(p, <1, 0, 0>, 1 + 1))", slots()) ==
        "\\p. put(block1, toward(p, <1, 0, 0>, 2))");
  CHECK(value_of("\\c. if(c, put(head(objects), region), put(last(objects), region))", slots()) ==
        "\\c. if(c, put(block1, box(<0, 0, 0>, <0.2, 0.4, 0>)), put(block4, box(<0, 0, 0>, <0.2, 0.4, 0>)))");
  CHECK(value_of("\\c. true and c", slots()) == "\\c. true and c");
  CHECK(value_of("\\c. false and c", slots()) == "\\c. false");
  CHECK(value_of("\\x. (\\y. put(x, on(y)))(head(objects))", slots()) == "\\x. put(x, on(block1))");
}

TEST_CASE("a definition that waits is worked out once its argument is known") {
  const Slots slots = {{"content", read("\\x. put(x, on(block4))")}};
  const auto value = [&](const char* text, bool waits) {
    auto evaluation_of = evaluation(slots);
    evaluation_of.definitions_wait = waits;
    return print(evaluation_of.value(read(text)));
  };
  CHECK(value("\\y. content(y)", false) == "\\y. put(y, on(block4))");
  CHECK(value("\\y. content(y)", true) == "\\y. content(y)");
  for (const auto* text : {"content(block1)", "(\\y. content(y))(block1)", "map([block1, block4], \\y. content(y))"}) {
    CAPTURE(text);
    CHECK(value(text, true) == value(text, false));
  }
}

TEST_CASE("null spreads through functions and counts as not true") {
  CHECK(value_of("size(null)") == "null");
  CHECK(value_of("1 + null") == "null");
  CHECK(value_of("null < 1") == "null");
  CHECK(value_of("indicated = null", slots()) == "true");
  CHECK(value_of("null(1)") == "null");
  CHECK(value_of("head([])(1)") == "null");
  CHECK(value_of("not indicated != null", slots()) == "true");
  CHECK(value_of("if(null, 1, 2)") == "2");
  CHECK(value_of("(\\x. x = null)(null)") == "true");
}

TEST_CASE("only what is needed is evaluated of if, and, or") {
  const Slots circles = {{"content", read("content(1)")}};
  for (const auto* text :
       {"if(true, 1, content)", "if(false, content, 1)", "if(false and content, 2, 1)", "if(true or content, 1, 2)"}) {
    auto evaluation_of = evaluation(circles);
    CHECK(print(evaluation_of.value(read(text))) == "1");
    CHECK_FALSE(evaluation_of.exhausted);
  }
}

TEST_CASE("definitions are evaluated where they are used, and may be functions") {
  Signature names = test_names();
  Slots held = slots();
  const auto define = [&](const char* name, const char* type, const char* text) {
    names.emplace(name, Type::parse(type).value());
    held.emplace(name, read(text, names));
  };
  define("options", "loc*", "map(objects, on)");
  define("beside", "e -> loc", "\\x. toward(center(region), on(x), 1)");
  define("move", "e -> t", "\\x. put(x, head(options))");
  define("factorial", "num -> num", "\\n. n");
  held["factorial"] = read("\\n. if(n < 2, 1, n * factorial(n - 1))", names);
  const auto value = [&](const char* text) { return print(evaluation(held).value(read(text, names))); };
  CHECK(value("size(options)") == "2");
  CHECK(value("move(block4)") == "put(block4, on(block1))");
  CHECK(value("map(objects, move)") == "[put(block1, on(block1)), put(block4, on(block1))]");
  CHECK(value("move") == "\\x. put(x, on(block1))");
  CHECK(value("\\x. move(x)") == "\\x. put(x, on(block1))");
  CHECK(value("factorial(5)") == "120");
}

TEST_CASE("a name may be an object, and with another type something that has a value") {
  const Slots held = {{"block1", read("\\x. x = block1")}};
  const Term noun = Term::constant("block1", Type::function(Type::entity(), Type::truth()));
  CHECK(print(evaluation(held).value(Term::apply(noun, read("block1")))) == "true");
  CHECK(print(evaluation(held).value(Term::apply(noun, read("block4")))) == "false");
}

TEST_CASE("a function is filled by what supplies its argument, and that is kept") {
  auto one = evaluation(slots());
  CHECK(print(one.value(read("fill(content, head(objects))"))) == "put(block1, on(block4))");
  REQUIRE(one.applications.size() == 1);
  CHECK(print(one.applications[0].function) == "\\x. put(x, on(block4))");
  CHECK(print(one.applications[0].argument) == "block1");
  CHECK(print(one.applications[0].result) == "put(block1, on(block4))");
  CHECK(one.applications[0].rule.empty());

  auto none = evaluation(slots());
  CHECK(print(none.value(read("fill(head(actions), block4)"))) == "put(block1, <1, 2, 3>)");
  CHECK(print(none.value(read("fill(content, <1, 2, 3>)"))) == "null");
  CHECK(none.applications.empty());

  auto both = evaluation(slots());
  CHECK(print(both.value(read("fill(fill(put, block4), region)"))) == "put(block4, box(<0, 0, 0>, <0.2, 0.4, 0>))");
  CHECK(both.applications.size() == 2);
}

TEST_CASE("terms of the wrong kind, which the dynamic type lets pass, give null") {
  const Slots wrong = {{"content", read("3")}, {"actions", read("[1, 2]")}};
  CHECK(value_of("size(content)", wrong) == "null");
  CHECK(value_of("content(1)", wrong) == "null");
  CHECK(value_of("center(head(actions))", wrong) == "null");
  CHECK(value_of("map(actions, content)", wrong) == "[null, null]");
  CHECK(value_of("if(content, 1, 2)", wrong) == "2");
  CHECK(value_of("center(on(block1))", wrong) == "null");
}

TEST_CASE("the margin is the smallest distance of compared numbers that are not whole") {
  const auto margin = [](const char* text) {
    auto one = evaluation(slots());
    one.value(read(text));
    return one.margin;
  };
  CHECK(margin("1 < 2 and size(objects) > 1") == std::numeric_limits<double>::infinity());
  CHECK(margin("0.5 < 2 and 1.5 > 1.25") == 0.25);
  CHECK(margin("0.5 = 0.75") == 0.25);
  CHECK(margin("inside(<0.5, 0.5, 0>, box(<0, 0, 0>, <1, 0.75, 0>))") == 0.25);
  CHECK(margin("inside(<1.5, 9, 0>, box(<0, 0, 0>, <1, 1, 0>))") == 8);
  CHECK(margin("sort_by([0.5, 3, 1.5], \\n. n)") == 1);
}

TEST_CASE("what does not end is given up") {
  Signature names = test_names();
  const auto define = [&](const char* name, const char* type) { names.emplace(name, Type::parse(type).value()); };
  define("ping", "num -> num");
  define("pong", "num -> num");
  define("self", "num");
  define("grow_list", "num* -> num*");
  define("tree", "num -> num");
  define("double", "term -> term");
  Slots held;
  const auto hold = [&](const char* name, const char* text) { held[name] = read(text, names); };
  hold("ping", "\\n. pong(n)");
  hold("pong", "\\n. 1 + ping(n)");
  hold("self", "self");
  hold("grow_list", "\\l. grow_list(append(l, l))");
  hold("tree", "\\n. tree(n) + tree(n)");
  hold("double", "\\x. double([x, x])");
  for (const auto* text : {"ping(1)", "ping", "map([1, 2], ping)", "self", "grow_list([1])", "tree(1)", "double(1)",
                           "\\x. ping(x)", "if(self = null, 1, 2)"}) {
    INFO(text);
    auto one = evaluation(held);
    CHECK(one.value(read(text, names)).is_null());
    CHECK(one.exhausted);
    CHECK(print(one.value(read("1 + 1"))) == "2");  // the next value has its own bound
  }
}

TEST_CASE("rules take part by name: without arguments, with them, with null when they say so") {
  int calls = 0;
  Rules rules;
  rules["indicated"] = {0, [&](auto, Evaluation&) { return ++calls, Term::entity("block4"); }, false};
  rules["on"] = {1, [](auto a, Evaluation&) { return a[0].is_null() ? Term::point(9, 9, 9) : Term::point(1, 2, 3); },
                 true};
  const RuleTable table({&term_rules(), &rules});
  Evaluation one(table, nullptr);
  CHECK(print(one.value(read("put(indicated, on(indicated))"))) == "put(block4, <1, 2, 3>)");
  CHECK(print(one.value(read("on(null)"))) == "<9, 9, 9>");
  CHECK(print(one.value(read("\\x. put(x, on(x))"))) == "\\x. put(x, on(x))");
  CHECK(calls == 2);
}

TEST_CASE("instantiating captures nothing") {
  const Type e = Type::entity();
  // \y. put(x, on(y)) with x := the variable of a lambda around it
  const Term body = Term::lambda(
      "y", e, Term::apply(Term::apply(read("put"), Term::bound(1, e)), Term::apply(read("on"), Term::bound(0, e))));
  CHECK(print(Term::lambda("y", e, instantiate(body, Term::bound(0, e)))) == "\\y y'. put(y, on(y'))");
  CHECK(print(instantiate(body, read("block1"))) == "\\y. put(block1, on(y))");
  CHECK(instantiate(Term::bound(1, e), read("block1")) == Term::bound(0, e));
}

}  // namespace continua
