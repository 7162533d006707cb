#include "language/anaphora.h"

#include "language/english.h"
#include "language/parser.h"
#include "support/catch.h"
#include "term/substitution.h"

using namespace continua;

TEST_CASE("it, inside of a noun phrase, is the noun phrase before it") {
  const auto [said, meant] = GENERATE(table<std::string, std::string>({
      {"take the cup right of the knife and behind it",
       "grasp(the(\\x. cup(x) and located(x, right(the(\\y. knife(y)))) and located(x, behind(the(\\z. knife(z))))))"},
      {"grab the plate and the block behind it",
       "grasp(each([the(\\x. plate(x)), the(\\x. block(x) and located(x, behind(the(\\y. plate(y)))))]))"},
      {"is the cup left of the block behind it",
       "whether(located_roughly(the(\\x. cup(x)), left(the(\\x. block(x) and located(x, behind(the(\\y. cup(y))))))))"},
      // what goes by the focus
      {"take the cup behind it", "grasp(the(\\x. cup(x) and located(x, behind(it))))"},
      {"put the knife in front of it", "put(the(\\x. knife(x)), in_front(it))"},
      {"put it left of the plate", "put(it, left(the(\\x. plate(x))))"},
      {"take the cup right of the knife", "grasp(the(\\x. cup(x) and located(x, right(the(\\y. knife(y))))))"},
      {"put it on the plate left of it", "put(it, on(the(\\x. plate(x) and located(x, left(it)))))"},
  }));
  const auto utterance = read(said, english_words());
  REQUIRE(utterance.fragments.size() == 1);
  const auto bound = with_antecedent(utterance.fragments[0].readings.front(), english()->operators);
  INFO(said);
  CHECK(bound.term == parse_term(meant, english_words().names()).value());
  for (const auto& phrase : bound.phrases) {
    INFO(print(phrase.term));
    CHECK(contains(bound.term, phrase.term));
  }
}
