#include "continua/language/anaphora.h"

#include "continua/language/parser.h"
#include "continua/term/substitution.h"
#include "language/english.h"
#include "support/catch.h"

using namespace continua;

namespace {

void check_bound(const std::string& said, const std::string& meant) {
  INFO(said);
  const auto utterance = read(said, english_words());
  REQUIRE(utterance.fragments.size() == 1);
  const auto bound = with_antecedents(utterance.fragments[0].readings.front(), english()->operators);
  INFO(print(bound.term));
  CHECK(bound.term == parse_term(meant, english_words().names()).value());
  for (const auto& phrase : bound.phrases) {
    INFO(print(phrase.term));
    CHECK(contains(bound.term, phrase.term));
  }
}

}  // namespace

TEST_CASE("it, inside of a noun phrase, is the noun phrase before it") {
  const auto [said, meant] = GENERATE(table<std::string, std::string>({
      {"take the cup right of the knife and behind it",
       "grasp(the(\\x. cup(x) and located(x, right(the(\\y. knife(y)))) and located(x, behind(the(\\z. knife(z))))))"},
      {"grab the plate and the block behind it",
       "grasp(each([the(\\x. plate(x)), the(\\x. block(x) and located(x, behind(the(\\y. plate(y)))))]))"},
      {"grab the plate , the cup and the block behind it",  // the last of them
       "grasp(each([the(\\x. plate(x)), the(\\x. cup(x)), "
       "the(\\x. block(x) and located(x, behind(the(\\y. cup(y)))))]))"},
      {"is the cup left of the block behind it",
       "whether(located_roughly(the(\\x. cup(x)), left(the(\\x. block(x) and located(x, behind(the(\\y. cup(y))))))))"},
      // of another clause
      {"if the plate is empty put the knife on it",
       "if_now(whether_is(the(\\x. plate(x)), not some(scene, \\y. located(y, in(the(\\x. plate(x)))) or located(y, "
       "on(the(\\x. plate(x)))))), put(the(\\x. knife(x)), on(the(\\x. plate(x)))))"},
      {"if the cup is left of the plate lift it",
       "if_now(whether_at(the(\\x. cup(x)), located_roughly(the(\\x. cup(x)), left(the(\\x. plate(x))))), "
       "lift(the(\\x. "
       "cup(x))))"},
      // left to the focus
      {"take the cup behind it", "grasp(the(\\x. cup(x) and located(x, behind(it))))"},
      {"put the knife in front of it", "put(the(\\x. knife(x)), in_front(it))"},
      {"put it left of the plate", "put(it, left(the(\\x. plate(x))))"},
      {"take the cup right of the knife", "grasp(the(\\x. cup(x) and located(x, right(the(\\y. knife(y))))))"},
      {"put it on the plate left of it", "put(it, on(the(\\x. plate(x) and located(x, left(it)))))"},
  }));
  check_bound(said, meant);
}

TEST_CASE("other, after a thing of the same kind in the same sentence, is not that one") {
  const auto [said, meant] = GENERATE(table<std::string, std::string>({
      {"put the white cup next to the other cup",
       "put(the(\\x. white(x) and cup(x)), beside(the(\\x. x != the(\\y. white(y) and cup(y)) and cup(x))))"},
      {"put the red block on the left on the other one",
       "put(the(\\x. red(x) and leftmost(\\y. block(y), x)), "
       "on(the(\\x. x != the(\\y. red(y) and leftmost(\\z. block(z), y)) and one(x))))"},
      // of whatever kind: none of the things before
      {"put the red block on the green block and the other one on the plate",
       "[put(the(\\x. red(x) and block(x)), on(the(\\x. green(x) and block(x)))), put(the(\\x. x != the(\\y. red(y) "
       "and block(y)) and x != the(\\y. green(y) and block(y)) and one(x)), on(the(\\x. plate(x))))]"},
      // of the thing of which all is said that is said here
      {"put the red block on the green block and the other red block on the cup",
       "[put(the(\\x. red(x) and block(x)), on(the(\\x. green(x) and block(x)))), put(the(\\x. x != the(\\x. red(x) "
       "and "
       "block(x)) and red(x) and block(x)), on(the(\\x. cup(x))))]"},
      // left to the focus: which one "a" means is known once the first command has been read
      {"put a red block on the green block and the other red block on the cup",
       "[put(a(\\x. red(x) and block(x)), on(the(\\x. green(x) and block(x)))), put(the(\\x. other(x) and red(x) and "
       "block(x)), on(the(\\x. cup(x))))]"},
      // of another clause
      {"if the plate is empty put the knife on it",
       "if_now(whether_is(the(\\x. plate(x)), not some(scene, \\y. located(y, in(the(\\x. plate(x)))) or located(y, "
       "on(the(\\x. plate(x)))))), put(the(\\x. knife(x)), on(the(\\x. plate(x)))))"},
      // left to the focus
      {"put the knife in the other cup", "put(the(\\x. knife(x)), in(the(\\x. other(x) and cup(x))))"},
      {"put the other cup on the other cup", "put(the(\\x. other(x) and cup(x)), on(the(\\x. other(x) and cup(x))))"},
      {"put the red block on the other other block",
       "put(the(\\x. red(x) and block(x)), on(the(\\x. other(x) and other(x) and block(x))))"},
      {"put the other cup next to the white cup",
       "put(the(\\x. other(x) and cup(x)), beside(the(\\x. white(x) and cup(x))))"},
  }));
  check_bound(said, meant);
}
