// The lexicon's own examples.
#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "continua/core/words.h"
#include "continua/language/lexicon.h"
#include "language/english.h"
#include "support/catch.h"

using namespace continua;

namespace {

// The words of sentences, in their order, and the places of each.
class Sentences {
 public:
  void add(const std::string& sentence) {
    for (const auto& word : words_of(sentence)) {
      places_[word.text].push_back(words_.size());
      words_.push_back(word.text);
    }
    words_.emplace_back();
  }
  /// Whether a sentence has these words, with single spaces between them, one after the other.
  bool has(const std::string& text) const {
    std::istringstream stream(text);
    const std::vector<std::string> wanted{std::istream_iterator<std::string>(stream), {}};
    const auto places = places_.find(wanted.front());
    return places != places_.end() && std::any_of(places->second.begin(), places->second.end(), [&](std::size_t place) {
             return place + wanted.size() <= words_.size() &&
                    std::equal(wanted.begin(), wanted.end(), words_.begin() + static_cast<std::ptrdiff_t>(place));
           });
  }

 private:
  std::vector<std::string> words_;  // an empty one after each sentence
  std::map<std::string, std::vector<std::size_t>> places_;
};

}  // namespace

TEST_CASE("the lexicon's examples are read as they say, and every word is in one") {
  for (const auto& error : check_examples(*english())) FAIL_CHECK(error.text());
  Sentences all;
  std::size_t count = 0;
  for (const auto& example : english()->examples)
    for (const auto& sentence : example.say) {
      all.add(sentence);
      ++count;
    }
  CHECK(count > 700);
  for (const auto& [words, entry] : english()->words) {
    CAPTURE(words);
    CHECK(all.has(words));
  }
}
