// Words of a lexicon and of a scene, found one after another.
#include "continua/language/vocabulary.h"

#include "language/english.h"
#include "support/catch.h"

using namespace continua;

namespace {

Vocabulary words_of_scene() {
  WorldSnapshot world;
  world.objects = {object_of("a", "type=banana color=light_blue"), object_of("b", "type=very_long_thin_thing")};
  Vocabulary words(english(), world);
  words.learn("shake it all about", "shaking", Type::function(Type::entity(), Type::truth()));
  return words;
}

}  // namespace

TEST_CASE("a walk finds all words that have entries, and is not over before") {
  const auto words = words_of_scene();
  const auto all = words.words();
  for (const std::string text : {"light blue", "very long thin thing", "shake it all about"}) CHECK(all.contains(text));
  for (const auto& text : all) {
    Vocabulary::Walk walk(words);
    std::vector<const WordEntry*> found;
    bool over = false;
    for (const auto word : parts_of_entry(text)) {
      over = over || walk.is_over();
      found = walk.step(word);
    }
    if (over || found.empty()) FAIL_CHECK("'" << text << "' is not found");
  }
}
