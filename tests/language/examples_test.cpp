// The lexicon's own examples. They are read in replay/knowledge_test.cpp, as those of all lexicons are.
#include <algorithm>
#include <string>
#include <unordered_set>

#include "continua/core/words.h"
#include "continua/language/lexicon.h"
#include "language/english.h"
#include "support/catch.h"

using namespace continua;

namespace {

// All that is said in sentences: every sequence of at most so many words.
class Sequences {
 public:
  explicit Sequences(std::size_t most) : most_(most) {}
  void add(const std::string& sentence) {
    const auto words = words_of(sentence);
    for (std::size_t begin = 0; begin < words.size(); ++begin) {
      std::string sequence;
      for (auto at = begin; at < std::min(begin + most_, words.size()); ++at) {
        sequence += (sequence.empty() ? "" : " ") + words[at].text;
        sequences_.insert(sequence);
      }
    }
  }
  bool has(const std::string& sequence) const { return sequences_.contains(sequence); }

 private:
  std::size_t most_;
  std::unordered_set<std::string> sequences_;
};

}  // namespace

TEST_CASE("every word of the lexicon is in one of its examples") {
  const auto examples = load_examples(*english());
  REQUIRE(examples.ok());
  Sequences all(english()->words.most_words());
  std::size_t count = 0;
  for (const auto& example : *examples)
    for (const auto& sentence : example.say) {
      all.add(sentence);
      ++count;
    }
  CHECK(count > 700);
  for (const auto& words : english()->words.texts())
    if (!all.has(words)) FAIL_CHECK("'" << words << "' is in no example");
}
