#include "continua/language/scope.h"

#include "continua/language/parser.h"
#include "language/english.h"
#include "support/catch.h"

using namespace continua;

namespace {

Reading read_alone(const std::string& said) {
  INFO(said);
  const auto utterance = read(said, english_words());
  REQUIRE(utterance.fragments.size() == 1);
  return utterance.fragments[0].readings.front();
}

}  // namespace

TEST_CASE("an indefinite under a prohibition means each of its kind") {
  const auto [said, meant] = GENERATE(table<std::string, std::string>({
      {"never take a block", "forbid(grasp(each(all(\\x. block(x)))))"},
      {"never put the knife on a plate", "forbid(put(the(\\x. knife(x)), on(each(all(\\x. plate(x))))))"},
      // conditions inside a noun phrase stay
      {"never take a block on a plate", "forbid(grasp(each(all(\\x. block(x) and located(x, on(a(\\y. plate(y))))))))"},
      // what is asked for, and what is definite, stays
      {"take a block", "grasp(a(\\x. block(x)))"},
      {"never take the block", "forbid(grasp(the(\\x. block(x))))"},
  }));
  const auto scoped = in_scope(read_alone(said), english_words());
  INFO(print(scoped.term));
  CHECK(scoped.term == parse_term(meant, english_words().names()).value());
}

TEST_CASE("the phrases of a reading change with its term") {
  const auto scoped = in_scope(read_alone("never take a block"), english_words());
  REQUIRE(scoped.phrases.size() >= 1);
  CHECK(print(scoped.phrases.front().term) == "all(\\x. block(x))");
}
