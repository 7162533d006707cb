#include "continua/language/prospects.h"

#include <algorithm>

#include "continua/core/words.h"
#include "language/english.h"

namespace continua {
namespace {

// The categories of the senses of the word with this number that can have a part in the sentence.
std::vector<std::string> kept(const std::string& sentence, std::size_t number) {
  std::vector<PlacedSense> senses;
  std::size_t at = 0;
  for (const auto& word : words_of(sentence)) {
    for (const auto* sense : Vocabulary::senses(english_words().entries(word.text)))
      senses.push_back({{at, at + 1}, sense});
    ++at;
  }
  const auto alive = with_prospects(senses, *english());
  std::vector<std::string> categories;
  for (std::size_t i = 0; i < senses.size(); ++i)
    if (alive[i] && senses[i].words.begin == number) categories.push_back(senses[i].sense->category.text());
  return categories;
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

TEST_CASE("a sense that needs what no word makes has no prospects") {
  CHECK(contains(kept("turn the cup twenty degrees", 0), "S/*ANGLE/*NP"));
  CHECK_FALSE(contains(kept("turn the cup", 0), "S/*ANGLE/*NP"));
  CHECK(contains(kept("turn the cup", 0), "S/NP"));
}

TEST_CASE("a sense that makes what no word takes has no prospects") {
  CHECK(contains(kept("turn the cup twenty degrees", 3), "NUM"));
  CHECK_FALSE(contains(kept("take the twenty", 2), "NUM"));
}

TEST_CASE("what a command may lack is no obstacle") { CHECK(contains(kept("put", 0), "S/PP/NP")); }

}  // namespace
}  // namespace continua
