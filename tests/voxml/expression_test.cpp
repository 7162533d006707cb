#include "continua/voxml/expression.h"

#include <algorithm>

#include "term/law.h"

using namespace continua;

namespace {

struct Row {
  const char* text;
  const char* printed;  ///< or the error
};

// Each parser's result for its rows; the printed result reads back as the same.
template <class Parse>
void check(const std::vector<Row>& rows, Parse parse) {
  for (const auto& [text, printed] : rows) {
    INFO(text);
    const auto read = parse(text);
    CHECK((read ? print(*read) : read.error().text()) == printed);
    if (read) CHECK(parse(print(*read)).value() == *read);
  }
}

}  // namespace

TEST_CASE("Expressions are read in every spelling and printed in one") {
  check(
      {
          {"x", "x"},
          {" grasp ( x ,\n y ) ", "grasp(x, y)"},
          {"sit()", "sit()"},
          {"put(x, on([1]))", "put(x, on([1]))"},
          {"put(x,in([ 2 ]))", "put(x, in([2]))"},
          {"def(loc(y),as('l1'))", "def(loc(y), as('l1'))"},
          {"def(loc(y),as(\"it's\"))", "def(loc(y), as(\"it's\"))"},
          {"def(vec(x->y×z),as(w))", "def(vec(x -> y × z), as(w))"},
          {"vec( x → y * on(z) )", "vec(x -> y × on(z))"},
          {"vec(x)", "vec(x)"},
          {"vec(x->y)", "character 9: found ')', expected '×', as in vec(x -> y × z)"},
          {"repeat(5,'switch(y,z)')", "repeat(5, 'switch(y,z)')"},
          {"move(x,y,z,'',loc(y),z,y)", "move(x, y, z, '', loc(y), z, y)"},
          {"move_1(x,y,z,A.B.Find2)", "move_1(x, y, z, A.B.Find2)"},
          {"align(_Y([1]),E_y)", "align(_Y([1]), E_y)"},
          {"top(+Y)", "top(+Y)"},
          {"hold(x,y)^!at(y,z)", "hold(x, y) ^ !at(y, z)"},
          {"hold(x,y) && ¬at(y,z)", "hold(x, y) ^ !at(y, z)"},
          {"hold(x,y)∧~at(y,z)", "hold(x, y) ^ !at(y, z)"},
          {"a & (b ^ c)", "a ^ b ^ c"},
          {"a|b^c||d", "a | b ^ c | d"},
          {"(a ∨ b)^c", "(a | b) ^ c"},
          {"!(a ^ b)", "!(a ^ b)"},
          {"!!((a))", "!!a"},
          {"grasp(x, handle[2])", "grasp(x, handle[2])"},
          {"switch(two(y[]))", "switch(two(y[]))"},
          {"at(y,<0.549; 0.9,-0.11>)", "at(y, <0.549; 0.9; -0.11>)"},
          {"größe(x)", "größe(x)"},
          {"", "character 1: found the end, expected a name"},
          {"grasp(x,,y)", "character 9: found ',', expected a name"},
          {"grasp(x", "character 8: found the end, expected ')'"},
          {"grasp(x))", "character 9: found ')', expected the end"},
          {"größe(x)→", "character 9: found '→', expected the end"},
          {"a ^", "character 4: found the end, expected a name"},
          {"f('l1)", "character 3: found ''', expected a text with a closing quotation mark"},
          {"at(y,<1; 2)", "character 11: found ')', expected '>'"},
          {"\xff", "character 1: found byte 0xff, expected a name"},
      },
      parse_expression);
}

TEST_CASE("Subevents are read as published documents have them") {
  check(
      {
          {"grasp(x,y)", "grasp(x, y)"},
          {"graspp(x,y)", "graspp(x, y)"},
          {"while(hold(x,y)^!at(y,z)):move(x,y,z)", "while(hold(x, y) ^ !at(y, z)):move(x, y, z)"},
          {"while ( hold(x,y) ^ !at(y,z) ) : move(x,y,z,'A.B.Plan',loc(y),z,y)",
           "while(hold(x, y) ^ !at(y, z)):move(x, y, z, 'A.B.Plan', loc(y), z, y)"},
          {"while(hold(x,y)^!at(y,z))", "while(hold(x, y) ^ !at(y, z))"},
          {"while(hold(x,y),move(x))", "while(hold(x, y)):move(x)"},
          {"[while(hold(x,y),move(x)]", "while(hold(x, y)):move(x)"},
          {"while(a, b, c):d", "while(a ^ b ^ c):d"},
          {"if(at(y,z)):ungrasp(x,y)", "if(at(y, z)):ungrasp(x, y)"},
          {"at(y,z)->ungrasp(x,y)", "if(at(y, z)):ungrasp(x, y)"},
          {"[at(y,z) → ungrasp(x,y)", "if(at(y, z)):ungrasp(x, y)"},
          {"[at(y,z)->ungrasp(x,y)]", "if(at(y, z)):ungrasp(x, y)"},
          {"E_1 = grasp(x,y)", "grasp(x, y)"},
          {"e3: at(y,z)->ungrasp(x,y)", "if(at(y, z)):ungrasp(x, y)"},
          {"grasp(x,y", "grasp(x, y)"},
          {"grasp(x,y)))", "grasp(x, y)"},
          {"iffy(x)", "iffy(x)"},
          {"", "character 1: found the end, expected a name"},
          {"if(at(y,z))", "character 12: found the end, expected ':' and what happens then"},
          {"while(hold(x,y)):", "character 18: found the end, expected a name"},
          {"grasp(x,y) lift(x,y)", "character 12: found 'l', expected ';' or the end"},
          {"grasp(x);lift(x)", "found 2 steps, expected one"},
      },
      parse_subevent);
}

TEST_CASE("Several steps may stand in one text") {
  const auto steps = parse_subevents("def(loc(y),as('l1'));[while(a):b]; put(z,l1);");
  REQUIRE(steps);
  std::string printed;
  for (const auto& each : *steps) printed += print(each) + "\n";
  CHECK(printed == "def(loc(y), as('l1'))\nwhile(a):b\nput(z, l1)\n");
}

TEST_CASE("Affordances are read as published documents have them") {
  check(
      {
          {"H->[put(x, on([1]))]support([1], x)", "H->[put(x, on([1]))]support([1], x)"},
          {"H[2]->[put(x, in([1]))]contain([1], x)", "H[2]->[put(x, in([1]))]contain([1], x)"},
          {"H->[grasp(x, [1])]", "H->[grasp(x, [1])]"},
          {"H,hold(x, [1])->[lift([1])]", "H,hold(x, [1])->[lift([1])]"},
          {"H[5],contain(x, [1])->[stir([1])]", "H[5],contain(x, [1])->[stir([1])]"},
          {"H->[put([1], in(x))]contain(x, [1])]", "H->[put([1], in(x))]contain(x, [1])"},
          {"H->[put([2], on([4]))]close([1])", "H->[put([2], on([4]))]close([1])"},
          {"H_[2] → [E] R", "H[2]->[E]R"},
          {"H2 -> [E]R", "H[2]->[E]R"},
          {"H_2->[E]", "H[2]->[E]"},
          {"H[12]∧¬hold(x,[1])&&clear([2]) -> [ a(x) , b(x) ] c(x) ; d(x)^e(x)",
           "H[12],!hold(x, [1]), clear([2])->[a(x) ^ b(x)]c(x), d(x), e(x)"},
          {"hold(x,[1])->[lift([1])]", "H,hold(x, [1])->[lift([1])]"},
          {"[lift([1])]", "H->[lift([1])]"},
          {"H->grasp(x,[1])", "H->[grasp(x, [1])]"},
          {"H->[grasp(x,[1])],hold(x,[1])", "H->[grasp(x, [1])]hold(x, [1])"},
          {"H->[grasp(x,[1])][hold(x,[1])]", "H->[grasp(x, [1])]hold(x, [1])"},
          {"H->[grasp(x,[1)", "character 15: found ')', expected ']'"},
          {"H->[put(x, on([1])]support([1], x)", "H->[put(x, on([1]))]support([1], x)"},
          {"H->[grasp(x, [1]", "H->[grasp(x, [1])]"},
          {"Hot(x)->[cool(x)]", "H,Hot(x)->[cool(x)]"},
          {"H", "character 2: found the end, expected '->'"},
          {"H->[]", "character 5: found ']', expected a name"},
          {"H->[grasp(x)] = y", "character 15: found '=', expected a name"},
          {"", "character 1: found the end, expected a name"},
      },
      parse_affordance);
}

TEST_CASE("Brackets are nested at most a hundred deep") {
  const auto nested = [](int depth) { return std::string(depth, '(') + "x" + std::string(depth, ')'); };
  CHECK(parse_expression(nested(99)));
  CHECK(parse_expression(nested(100)).error().text() ==
        "character 101: found 'x', expected at most 100 brackets in each other");
  for (const char* opening : {"(", "[", "!", "f(", "H,[", "while("}) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += opening;
    CHECK(!parse_expression(text));
    CHECK(!parse_subevent(text));
    CHECK(!parse_affordance(text));
  }
}

namespace {

rc::Gen<std::string> name() {
  return rc::gen::element<std::string>("x", "y", "E_y", "A.Plan", "hold", "+Y", "5", "-0.1", "handle[2]", "y[]",
                                       "größe", "<1; -2>");
}

rc::Gen<Expression> expression(int depth);

rc::Gen<std::vector<Expression>> expressions(int depth, std::size_t least) {
  return rc::gen::mapcat(rc::gen::inRange<std::size_t>(least, least + 3), [depth](std::size_t count) {
    return rc::gen::container<std::vector<Expression>>(count, expression(depth));
  });
}

// Joined parts are not joined again.
rc::Gen<Expression> joined(Expression::Kind kind, int depth) {
  return rc::gen::suchThat(rc::gen::map(expressions(depth, 2),
                                        [kind](std::vector<Expression> arguments) {
                                          return Expression{kind, "", std::move(arguments)};
                                        }),
                           [](const Expression& all) {
                             return std::none_of(all.arguments.begin(), all.arguments.end(),
                                                 [&](const Expression& each) { return each.kind == all.kind; });
                           });
}

rc::Gen<Expression> expression(int depth) {
  using Kind = Expression::Kind;
  const auto plain = rc::gen::map(name(), [](std::string text) { return Expression{Kind::name, std::move(text), {}}; });
  const auto quoted = rc::gen::map(rc::gen::element<std::string>("", "l1", "it's", "a \"b\"", "’", "switch(y,z)"),
                                   [](std::string text) {
                                     return Expression{Kind::text, std::move(text), {}};
                                   });
  const auto part = rc::gen::map(rc::gen::inRange(0, 20), [](int number) {
    return Expression{Kind::component, std::to_string(number), {}};
  });
  if (depth == 0) return rc::gen::oneOf(plain, quoted, part);
  const auto call =
      rc::gen::map(rc::gen::pair(rc::gen::element<std::string>("f", "put", "näher"), expressions(depth - 1, 0)),
                   [](std::pair<std::string, std::vector<Expression>> of) {
                     return Expression{Kind::call, std::move(of.first), std::move(of.second)};
                   });
  const auto negation = rc::gen::map(expression(depth - 1), [](Expression of) {
    return Expression{Kind::negation, "", {std::move(of)}};
  });
  return rc::gen::oneOf(plain, quoted, part, call, negation, joined(Kind::both, depth - 1),
                        joined(Kind::either, depth - 1));
}

rc::Gen<std::string> noise() {
  const auto piece = rc::gen::element<std::string>("(", ")", "[", "]", "H", "[1]", "->", "→", "while(", "if(", ":", ",",
                                                   ";", "^", "!", "|", "'", "\"", "<", ">", "x", "put(", " ", "\n", "=",
                                                   "\xe2", "\x80", "’", "-", "&");
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(piece), [](const std::vector<std::string>& pieces) {
    std::string text;
    for (const auto& each : pieces) text += each;
    return text;
  });
}

}  // namespace

TEST_CASE("Reading what was printed gives the same") {
  law("expressions", [] {
    const auto x = *expression(3);
    RC_ASSERT(parse_expression(print(x)).value() == x);
  });
  // Steps and affordances consist of calls, as in documents: a bracket at the beginning belongs to the whole.
  const auto event =
      rc::gen::suchThat(expression(3), [](const Expression& x) { return x.kind == Expression::Kind::call; });
  law("subevents", [event] {
    Subevent x{*rc::gen::element(Subevent::When::always, Subevent::When::once, Subevent::When::during), {}, *event};
    if (x.when != Subevent::When::always) x.condition = *expression(2);
    if (x.when == Subevent::When::during && *rc::gen::arbitrary<bool>()) x.event = {};
    RC_ASSERT(parse_subevent(print(x)).value() == x);
  });
  law("affordances", [event] {
    Affordance x{*rc::gen::element<std::string>("", "2", "14"), *rc::gen::container<std::vector<Expression>>(event),
                 *event, *rc::gen::container<std::vector<Expression>>(event)};
    RC_ASSERT(parse_affordance(print(x)).value() == x);
  });
}

TEST_CASE("Noise is read or refused, and what is read can be printed and read again") {
  law("noise", [] {
    const auto text = *rc::gen::oneOf(noise(), rc::gen::arbitrary<std::string>());
    if (const auto read = parse_expression(text)) RC_ASSERT(parse_expression(print(*read)).value() == *read);
    if (const auto read = parse_subevents(text)) RC_ASSERT(!read->empty());
    (void)parse_affordance(text);
  });
}
