#include "continua/term/continuation.h"

#include <string>
#include <vector>

#include "read_terms.h"

namespace continua {
namespace {

using Effects = std::vector<std::string>;
using Function = std::function<int(int)>;

// A computation that notes `name` and then gives `value`.
template <class A>
Comp<A, Effects> noting(std::string name, A value) {
  return [=](const Continuation<A, Effects>& k) {
    Effects effects = {name};
    for (const auto& each : k(value)) effects.push_back(each);
    return effects;
  };
}

const Continuation<int, Effects> written = [](int n) { return Effects{std::to_string(n)}; };
const Function twice = [](int n) { return 2 * n; };

Effects applied(Comp<Function, Effects> m, Comp<int, Effects> n) {
  return cpsApply<int, int, Effects>(std::move(m), std::move(n))(written);
}

// As a term of the language: Comp of a is (a -> r) -> r.
const char* const cps_apply = "(\\m n k. n(\\b. m(\\a. k(a(b)))))";

std::string normal(const std::string& m, const std::string& n, const std::string& k) {
  return value_of(std::string(cps_apply) + "(" + m + ", " + n + ", " + k + ")");
}

}  // namespace

TEST_CASE("a unit applied to a unit is the unit of the application") {
  CHECK(applied(unit<Effects>(twice), unit<Effects>(21)) == unit<Effects>(42)(written));
}

TEST_CASE("the argument's effects come before the function's, and those before what comes next") {
  CHECK(applied(noting("function", twice), noting("argument", 4)) == Effects{"argument", "function", "8"});
}

TEST_CASE("a computation may call its continuation several times, never, or later") {
  const Comp<int, Effects> each = [](const Continuation<int, Effects>& k) {
    Effects effects = k(1);
    for (const auto& one : k(2)) effects.push_back(one);
    return effects;
  };
  const Comp<int, Effects> none = [](const Continuation<int, Effects>&) { return Effects{"nothing"}; };
  CHECK(applied(noting("function", twice), each) == Effects{"function", "2", "function", "4"});
  CHECK(applied(noting("function", twice), none) == Effects{"nothing"});

  Continuation<int, Effects> kept;
  const Comp<int, Effects> later = [&](const Continuation<int, Effects>& k) {
    kept = k;
    return Effects{};
  };
  CHECK(applied(noting("function", twice), later).empty());
  CHECK(kept(5) == Effects{"function", "10"});
}

TEST_CASE("as a term of the language it has the same normal forms") {
  const std::string on = "(\\k. k(on))", block = "(\\k. k(block4))", same = "(\\x. x)";
  CHECK(normal(on, block, same) == "on(block4)");
  CHECK(normal(on, block, "put(block1)") == "put(block1, on(block4))");
  CHECK(normal("(" + std::string(cps_apply) + "((\\k. k(put)), " + block + "))", "(\\k. k(on(block1)))", same) ==
        "put(block4, on(block1))");
  // one that calls its continuation twice, never, and one that leaves a lambda around it
  CHECK(normal(on, "(\\k. append(k(block1), k(block4)))", "(\\x. [x])") == "[on(block1), on(block4)]");
  CHECK(normal(on, "(\\k. [])", "(\\x. [x])") == "[]");
  CHECK(normal("(\\k. k(put(block4)))", "(\\k x. k(on(x)))", same) == "\\x. put(block4, on(x))");
  CHECK(value_of(cps_apply) == "\\m n k. n(\\b. m(\\a. k(a(b))))");
}

}  // namespace continua
