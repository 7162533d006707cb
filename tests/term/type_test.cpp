#include "continua/term/type.h"

#include "continua/term/unify.h"
#include "support/catch.h"

namespace continua {
namespace {

std::string read_type(std::string_view text) {
  const auto type = Type::parse(text, {"gesture"});
  return type ? type->text() : type.error().text();
}

Type type(std::string_view text) { return Type::parse(text).value(); }

}  // namespace

TEST_CASE("types are read and printed") {
  CHECK(read_type("e") == "e");
  CHECK(read_type(" entity->location ") == "e -> loc");
  CHECK(read_type("e -> (loc -> t)") == "e -> loc -> t");
  CHECK(read_type("(e -> loc) -> t") == "(e -> loc) -> t");
  CHECK(read_type("(e->loc)* -> num**") == "(e -> loc)* -> num**");
  CHECK(read_type("'a* -> ('a -> 'b3) -> 'b3") == "'a* -> ('a -> 'b3) -> 'b3");
  CHECK(read_type("gesture*") == "gesture*");
}

TEST_CASE("a dot type has two halves, is read and printed, and goes with no half of it alone") {
  CHECK(read_type("e*•loc") == "e* • loc");
  CHECK(read_type("e -> loc -> e* • loc") == "e -> loc -> e* • loc");
  CHECK(read_type("(e • loc)*") == "(e • loc)*");
  CHECK(read_type("(e -> t) • ('a • 'b)") == "(e -> t) • ('a • 'b)");
  CHECK(read_type("e •") == "column 6: the type ends here, expected a type");
  CHECK(type("e* • loc") == Type::pointing());
  CHECK(type("e* • loc").first() == type("e*"));
  CHECK(type("e* • loc").second() == type("loc"));
  CHECK(consistent(type("e* • loc"), type("term • region")));
  CHECK_FALSE(consistent(type("e* • loc"), type("loc")));
  CHECK_FALSE(consistent(type("e* • loc"), type("e* -> loc")));
  CHECK(result_type(type("'a • 'b -> 'b • 'a"), type("e • loc")) == type("loc • e"));
}

TEST_CASE("what is no type is said where it stands") {
  CHECK(read_type("") == "column 1: the type ends here, expected a type");
  CHECK(read_type("e ->") == "column 5: the type ends here, expected a type");
  CHECK(read_type("(e -> loc") == "column 10: the type ends here, expected ')'");
  CHECK(read_type("e loc") == "column 3: found 'l', expected the end of the type");
  CHECK(read_type("e -> locatoin") == "column 6: unknown type 'locatoin' (did you mean 'location'?)");
  CHECK(read_type("'1") == "column 2: found '1', expected a letter: a type variable is 'a, 'b, …");
  CHECK(read_type(std::string(1000, '(')) == "column 66: the type is nested deeper than 64");
  CHECK(read_type("e" + std::string(1000, '*')) == "column 68: the type is nested deeper than 64");
}

TEST_CASE("the dynamic type goes with everything") {
  CHECK(consistent(type("term"), type("e -> t")));
  CHECK(consistent(type("e -> term"), type("e -> loc*")));
  CHECK(consistent(type("term*"), type("loc*")));
  CHECK_FALSE(consistent(type("term*"), type("loc")));
  CHECK(consistent(type("region* -> t"), type("loc* -> t")));
  CHECK(consistent(type("loc"), type("region")));
  CHECK_FALSE(consistent(type("e"), type("region")));
  CHECK_FALSE(type("loc") == type("region"));
  CHECK_FALSE(consistent(type("e -> t"), type("loc -> t")));
}

TEST_CASE("unification learns what it can and nothing from the dynamic type") {
  Unifier unifier;
  const Type head = unifier.instance(type("'a* -> 'a"));
  CHECK(unifier.unify(head.from(), type("loc*")));
  CHECK(unifier.resolved(head.to()) == type("loc"));

  const Type other = unifier.instance(type("'a* -> 'a"));
  CHECK(unifier.unify(other.from(), type("term")));
  CHECK(unifier.resolved(other) == type("term* -> term"));
  CHECK(unifier.unify(other.to(), type("num")));

  const Type unknown = unifier.fresh();
  CHECK_FALSE(unifier.unify(unknown, Type::list(unknown)));
  CHECK_FALSE(unifier.unify(type("e -> t"), type("loc -> t")));
}

TEST_CASE("applying a polymorphic function gives the type its argument decides") {
  CHECK(result_type(type("'a* -> 'a"), type("loc*")) == type("loc"));
  CHECK(result_type(type("'a -> 'b -> 'a"), type("e")) == type("term -> e"));
  CHECK(result_type(type("term"), type("e")) == type("term"));
  CHECK(result_type(type("e -> t"), type("term")) == type("t"));
  CHECK(result_type(type("loc -> t"), type("region")) == type("t"));
  CHECK_FALSE(result_type(type("e"), type("e")));
  CHECK_FALSE(result_type(type("e -> t"), type("loc")));
  CHECK_FALSE(result_type(type("'a* -> 'a"), type("loc")));
  CHECK_FALSE(result_type(type("('a -> 'a) -> t"), type("e -> loc")));
}

}  // namespace continua
