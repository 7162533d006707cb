#include "continua/moves/known_words.h"

#include "language/english.h"

using namespace continua;

namespace {

Learned lessons(const char* name) {
  const Term act = Term::apply(Term::constant("lift", Type::parse("e -> t").value()), Term::entity("knife"));
  Learned learned;
  learned.learn_program(name, composed({act}).value());
  return learned;
}

}  // namespace

TEST_CASE("the name of a program is a word while the program is known") {
  const KnownWords words = known_words(english(), {});
  CHECK(words.all == words.untaught);
  CHECK_FALSE(words.all->means("hoist"));

  const KnownWords taught = with_taught(words, lessons("hoist"));
  CHECK(taught.all->means("hoist"));
  CHECK(taught.untaught == words.untaught);
  CHECK_FALSE(words.all->means("hoist"));

  const KnownWords another = with_taught(taught, lessons("heave"));
  CHECK(another.all->means("heave"));
  CHECK_FALSE(another.all->means("hoist"));
  CHECK_FALSE(with_taught(taught, {}).all->means("hoist"));
}

TEST_CASE("the same lessons leave the vocabulary as it is") {
  const KnownWords taught = with_taught(known_words(english(), {}), lessons("hoist"));
  CHECK(with_taught(taught, lessons("hoist")).all == taught.all);
}

TEST_CASE("a machine without a lexicon knows no words, whatever is taught") {
  CHECK_FALSE(with_taught({}, lessons("hoist")).all);
}
