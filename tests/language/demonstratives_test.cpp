// Which parts of an utterance pointing can give content to.
#include "continua/language/demonstratives.h"

#include "continua/language/parser.h"
#include "english.h"
#include "support/catch.h"

using namespace continua;

namespace {

// "that cup!, the plate, there@": things that need pointing with an exclamation mark, places with an @;
// a + for each thing more that may be shown.
std::string takers(const char* text) {
  const auto words = english_words();
  const auto utterance = read(text, words);
  std::string all;
  for (const auto& fragment : utterance.fragments)
    for (const auto& each : demonstratives(fragment.readings.front(), words.operators())) {
      const auto& span = each.words;
      all += all.empty() ? "" : all.back() == '+' && each.more ? "" : ", ";
      if (each.more) {
        all += "+";
        continue;
      }
      for (auto i = span.begin; i < span.end; ++i) all += (i > span.begin ? " " : "") + utterance.words[i];
      all += each.place ? "@" : each.needs ? "!" : "";
    }
  return all;
}

}  // namespace

TEST_CASE("demonstratives need pointing, definite noun phrases and nouns alone can use it") {
  CHECK(takers("put it there") == "it, there@");
  CHECK(takers("put that there") == "that!, there@");
  CHECK(takers("put that on that") == "that!, that!");
  CHECK(takers("put the knife in the blue cup") == "the knife, the blue cup");
  CHECK(takers("cup") == "cup");
  CHECK(takers("in that blue cup") == "that blue cup!");
  CHECK(takers("the cup behind that plate") == "the cup behind, that plate!");
  CHECK(takers("take a cup") == "");
  CHECK(takers("never mind") == "");
  CHECK(takers("no, that one") == "that one!");
  CHECK(takers("take that cup, no, this one") == "that cup!, this one!");
  CHECK(takers("take this, i mean this") == "this!, this!");
  CHECK(takers("take the cup, i mean the plate") == "the plate");
  CHECK(takers("take these two cups") == "these two cups!, these two cups!");
  CHECK(takers("put these there") == "+++++, these!, there@");
}
