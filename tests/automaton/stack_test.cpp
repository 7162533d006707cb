#include "continua/automaton/stack.h"

#include "support/catch.h"

using namespace continua;

namespace {
Symbol symbol(double value) { return {Cell{Term::number(value), {}}}; }
}  // namespace

TEST_CASE("push then pop gives the same stack, and a snapshot never changes") {
  const Stack one = Stack().push(symbol(1), 0);
  const Stack two = one.push(symbol(2), 1);
  CHECK(two.pop() == one);
  CHECK(two.depth() == 2);
  CHECK(one.depth() == 1);
  CHECK(two.id_below() == 0);
  CHECK_FALSE(one.id_below().has_value());
  const Stack other = two.pop().push(symbol(3), 2);
  CHECK(two.top()[0].value == Term::number(2));
  CHECK(other.top()[0].value == Term::number(3));
}

TEST_CASE("equality of stacks is of their symbols, not of ids or origins") {
  const Stack a = Stack().push(symbol(1), 0).push({Cell{Term::number(2), {7}}}, 1);
  const Stack b = Stack().push(symbol(1), 5).push({Cell{Term::number(2), {}}}, 6);
  CHECK(a == b);
  CHECK_FALSE(a == b.pop());
  CHECK_FALSE(a == a.pop().push(symbol(3), 9));
}

TEST_CASE("a stack of a million symbols is let go without recursion") {
  Stack stack;
  for (int i = 0; i < 1'000'000; ++i) stack = stack.push({}, i);
  CHECK(stack.depth() == 1'000'000);
}
