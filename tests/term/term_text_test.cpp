#include "continua/term/term_text.h"

#include "read_terms.h"

namespace continua {
namespace {

std::string typed(std::string_view text) {
  const Term term = read(text);
  return print(term) + " : " + term.type().text();
}

}  // namespace

TEST_CASE("terms are read, typed and printed") {
  CHECK(typed("\\x. put(x, region)") == "\\x. put(x, region) : e -> t");
  CHECK(typed("λx y.put(x,on(y))") == "\\x y. put(x, on(y)) : e -> e -> t");
  CHECK(typed("\\x. \\y. put(x)(on(y))") == "\\x y. put(x, on(y)) : e -> e -> t");
  CHECK(typed("\\x: loc. x") == "\\x. x : loc -> loc");
  CHECK(typed("\\f: e -> t. map(objects, f)") == "\\f. map(objects, f) : (e -> t) -> t*");
  CHECK(typed("[]") == "[] : term*");
  CHECK(typed("[ block1,indicated ]") == "[block1, indicated] : e*");
  CHECK(typed("[null, block1]") == "[null, block1] : e*");
  CHECK(typed("<0.10, -0.2, 0>") == "<0.1, -0.2, 0> : loc");
  CHECK(typed("<0, y(region), 1>") == "<0, y(region), 1> : loc");
  CHECK(typed("xyz(1, 2, 3)") == "xyz(1, 2, 3) : loc");
  CHECK(typed("box(<1, 1, 0>, <0, 2, 0>)") == "box(<0, 1, 0>, <1, 2, 0>) : loc");
  CHECK(typed("(box)(<1, 1, 0>, <0, 2, 0>)") == "(box)(<1, 1, 0>, <0, 2, 0>) : loc");
  CHECK(typed("box(<1, 1, 0>, region)") == "box(<1, 1, 0>, region) : loc");
  CHECK(typed("'it\\'s \\\\ here'") == "'it\\'s \\\\ here' : text");
  CHECK(typed("null") == "null : term");
  CHECK(typed("true") == "true : t");
  CHECK(typed("012.50") == "12.5 : num");
  CHECK(typed("0.1") == "0.1 : num");
  CHECK(typed("1e-7") == "1e-07 : num");
  CHECK(typed("0.30000000000000004") == "0.30000000000000004 : num");
  CHECK(typed("-0") == "0 : num");
  CHECK(typed("`block1`") == "block1 : e");
  CHECK(typed("(+)(1)") == "(+)(1) : num -> num");
  CHECK(typed("(not)") == "(not) : t -> t");
  CHECK(typed("map(objects, on)") == "map(objects, on) : loc*");
  CHECK(typed("if(true, null, block1)") == "if(true, null, block1) : e");
}

TEST_CASE("operators bind in the usual order, and print with no more parentheses than they need") {
  CHECK(typed("1 + 2 * 3 - (4 - 5)") == "1 + 2 * 3 - (4 - 5) : num");
  CHECK(typed("(1 + 2) * -x(region)") == "(1 + 2) * -x(region) : num");
  CHECK(typed("not true and (false or not 1 < 2)") == "not true and (false or not 1 < 2) : t");
  CHECK(typed("not (true = false)") == "not true = false : t");
  CHECK(typed("(not true) = false") == "(not true) = false : t");
  CHECK(typed("(true or false) and true or false") == "(true or false) and true or false : t");
  CHECK(typed("1 - -2") == "1 - -2 : num");
  CHECK(typed("-(3)") == "negate(3) : num");
  CHECK(typed("--3") == "negate(-3) : num");
  CHECK(typed("<0,0,0>=region") == "<0, 0, 0> = region : t");
  CHECK(typed("1/2/3") == "1 / 2 / 3 : num");
  CHECK(typed("(\\x. x)(1) + 1") == "(\\x. x)(1) + 1 : num");
}

TEST_CASE("a variable keeps its name unless that would mean something else") {
  CHECK(print(Term::lambda("x", Type::entity(), read("\\y. put(y, on(y))"))) == "\\x y. put(y, on(y))");
  const Type e = Type::entity();
  const Term pair =
      Term::apply(Term::apply(read("put"), Term::bound(0, e)), Term::apply(read("on"), Term::bound(1, e)));
  CHECK(print(Term::lambda("x", e, Term::lambda("x", e, pair))) == "\\x x'. put(x', on(x))");
  CHECK(print(Term::lambda("x", e, Term::lambda("x", e, Term::bound(0, e)))) == "\\x x. x");
  CHECK(print(Term::lambda("put", e, Term::apply(read("put"), Term::bound(0, e)))) == "\\put'. put(put')");
  CHECK(print(Term::lambda("true", e, Term::bound(0, e))) == "\\x. x");
  CHECK(print(Term::constant("red block", e)) == "`red block`");
  CHECK(print(Term::constant("not`", e)) == "`not\\``");
  CHECK(print(Term::constant("null", e)) == "`null`");
}

TEST_CASE("for people a lambda is a λ") {
  CHECK(print(read("\\x y. put(x, on(y))"), Lambda::greek) == "λx y. put(x, on(y))");
  CHECK(print(read("map(objects, \\x. `\\\\`)", {{"objects", Type::list(Type::entity())},
                                                 {"\\", Type::entity()},
                                                 {"map", Type::parse("'a* -> ('a -> 'b) -> 'b*").value()}}),
              Lambda::greek) == "map(objects, λx. `\\\\`)");
}

TEST_CASE("a name is what the innermost lambda says") {
  CHECK(read("\\block1. put(block1, region)") == read("\\x. put(x, region)"));
  CHECK(read("\\x. \\x. on(x)") == read("\\a b. on(b)"));
  CHECK_FALSE(read("\\x y. put(x, on(y))") == read("\\x y. put(y, on(x))"));
}

TEST_CASE("what is no term is said where it stands, and what was expected there") {
  CHECK(error_of("") == "column 1: found the end, expected a term");
  CHECK(error_of("1 +") == "column 4: found the end, expected a term");
  CHECK(error_of("put(block1, region") == "column 19: found the end, expected ',' or ')'");
  CHECK(error_of("[1, 2)") == "column 6: found ')', expected ',' or ']'");
  CHECK(error_of("block1 block4") == "column 8: found 'block4', expected an operator or the end");
  CHECK(error_of("objects()") ==
        "column 9: found ')', expected an argument; a name without arguments is written without parentheses");
  CHECK(error_of("<1, 2>") == "column 6: found '>', expected ',': a point has three coordinates");
  CHECK(error_of("<1, 2, 3") == "column 9: found the end, expected '>'");
  CHECK(error_of("\\. x") == "column 2: found '.', expected the name of a variable");
  CHECK(error_of("\\true. 1") == "column 2: found 'true', expected the name of a variable");
  CHECK(error_of("\\x put(x)") == "column 7: found '(', expected '.' before the body");
  CHECK(error_of("\\x: lok. x") == "column 5: unknown type 'lok' (did you mean 'loc'?)");
  CHECK(error_of("\\x y: e. x") == "column 5: found ':' after several variables; write \\x: e. \\y: e. …");
  CHECK(error_of("1 < 2 < 3") == "column 7: found '<' after a comparison; put one of the two in parentheses");
  CHECK(error_of("size('abc") == "column 6: the text that begins here has no closing '");
  CHECK(error_of("`abc") == "column 1: the name that begins here has no closing `");
  CHECK(error_of("'a\\n'") == "column 3: found '\\n', expected \\' or \\\\");
  CHECK(error_of("1 # 2") == "column 3: found '#', which begins no part of a term");
  CHECK(error_of("1 \x01") == "column 3: found byte 0x01, which begins no part of a term");
  CHECK(error_of("1e999") == "column 1: found a number that is too large or too small to be held");
  CHECK(error_of("3x") == "column 2: found 'x' right after a number");
  CHECK(error_of("x == 1") == "column 4: found '=', expected a term");
}

TEST_CASE("what has the wrong type is said where it stands") {
  CHECK(error_of("size(indicatd)") == "column 6: unknown name 'indicatd' (did you mean 'indicated'?)");
  CHECK(error_of("\\theme. put(teme, region)") == "column 13: unknown name 'teme' (did you mean 'theme'?)");
  CHECK(error_of("zzzzzzzzz") == "column 1: unknown name 'zzzzzzzzz'");
  CHECK(error_of("true and 1 < size(3)") == "column 19: 'size' takes a list, found num");
  CHECK(error_of("put(block1, block4)") == "column 13: 'put' takes loc as argument 2, found e");
  CHECK(error_of("map([1], \\x. x and true)") == "column 14: 'and' takes t, found num");
  CHECK(error_of("filter([1], \\x. x)") ==
        "column 13: 'filter' takes a function from num to t as argument 2, found a function from num to num");
  CHECK(error_of("map([1], 3)") == "column 10: 'map' takes a function from num as argument 2, found num");
  CHECK(error_of("1 + 'a'") == "column 5: '+' takes num, found text");
  CHECK(error_of("block1 = 3") == "column 10: '=' takes e, found num");
  CHECK(error_of("size(objects, 1)") == "column 15: 'size' takes 1 argument, found 2");
  CHECK(error_of("block1(1)") == "column 1: 'block1' is no function but e; found 1 argument for it");
  CHECK(error_of("[1, 'a']") == "column 5: the elements of a list have one type: found text after num");
  CHECK(error_of("\\x. x(x)") == "column 7: 'x' cannot be applied to what contains it");
  CHECK(parse_term("1 + 1", test_names(), Type::truth()).error().text() == "column 1: found num, expected t");
  CHECK(parse_term("head(objects)", test_names(), Type::location()).error().text() ==
        "column 1: found e, expected loc");
}

TEST_CASE("the dynamic type asks for nothing") {
  CHECK(typed("put(content, content)") == "put(content, content) : t");
  CHECK(typed("content(1)(block1)") == "content(1, block1) : term");
  CHECK(typed("head(actions)(block1)") == "head(actions, block1) : term");
  CHECK(typed("map(actions, \\a. put(a, a))") == "map(actions, \\a. put(a, a)) : t*");
  CHECK(parse_term("\\x. put(x, region)", test_names(), Type::term()).ok());
  const Type terms = Type::list(Type::term());
  CHECK(parse_term("[block1, on(block1), \\x. x]", test_names(), terms).value().type() == terms);
  CHECK(typed("append(actions, [1, 'a'])") == "append(actions, [1, 'a']) : term*");
  CHECK(typed("\\x. head(append(actions, [1, x, 'a']))") == "\\x. head(append(actions, [1, x, 'a'])) : term -> term");
  CHECK(parse_term("content", test_names(), Type::truth()).ok());
}

TEST_CASE("nesting has a bound, whatever nests") {
  const auto nested = [](std::string open, std::string inner, std::string close, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += open;
    text += inner;
    for (int i = 0; i < times; ++i) text += close;
    return error_of(text);
  };
  CHECK(nested("(", "1", ")", 150) == "read as 1");
  CHECK(nested("(", "1", ")", 100000) == "column 201: the term is nested deeper than 200");
  CHECK(nested("[", "1", "]", 100000) == "column 201: the term is nested deeper than 200");
  CHECK(nested("\\x. ", "1", "", 100000) == "column 799: the term is nested deeper than 200");
  CHECK(nested("-", "1", "", 100000) == "column 201: the term is nested deeper than 200");
  CHECK(nested("not ", "true", "", 100000) == "column 801: the term is nested deeper than 200");
  CHECK(nested("1 + ", "1", "", 100000) == "column 1: the term is nested deeper than 200");
  std::string many = "\\";
  for (int i = 0; i < 1000; ++i) many += "x ";
  CHECK(error_of(many + ". 1") == "column 2002: the term is nested deeper than 200");
  std::string applied = "content";
  for (int i = 0; i < 1000; ++i) applied += "(1)";
  CHECK(error_of(applied) == "column 1: the term is nested deeper than 200");
}

TEST_CASE("types that grow with every step are given up, not followed") {
  std::string text = "[";
  for (int i = 0; i < 150; ++i)
    text += "x" + std::to_string(i) + " = (\\y. if(true, y, x" + std::to_string(i + 1) + ")), ";
  text += "true]";
  std::string binders = "\\";
  for (int i = 0; i <= 150; ++i) binders += "x" + std::to_string(i) + " ";
  CHECK(error_of(binders + ". " + text) == "column 1: the types of this term grow too large to be followed");
}

}  // namespace continua
