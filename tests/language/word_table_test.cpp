#include "continua/language/word_table.h"

#include <algorithm>
#include <map>

#include <rapidcheck.h>

#include "continua/language/spellings.h"
#include "support/catch.h"

using continua::spellings;
using continua::WordTable;

namespace {

// An entry that is known again by its cost.
continua::WordEntry entry(double cost) { return {{}, cost, {}}; }

std::vector<double> costs(const WordTable& table, const std::string& words) {
  std::vector<double> all;
  for (const auto* found : table.find(words)) all.push_back(*found->skip);
  return all;
}

// Keys of the words a, b and c, with groups and parts that may be left out.
std::string random_key(int depth) {
  std::string key;
  const auto parts = *rc::gen::inRange(1, 4);
  for (int i = 0; i < parts; ++i) {
    const auto kind = depth == 0 ? 0 : *rc::gen::inRange(0, 4);
    if (i > 0) key += *rc::gen::inRange(0, 3) == 0 ? " | " : " ";
    const auto word = std::string(1, *rc::gen::element('a', 'b', 'c'));
    key += kind < 2 ? word : kind == 2 ? "(" + random_key(depth - 1) + ")" : "[" + random_key(depth - 1) + "]";
  }
  return key;
}

}  // namespace

TEST_CASE("a table of words finds what its keys stand for, and nothing else") {
  WordTable table;
  CHECK(table.most_words() == 1);
  REQUIRE(table.add("(can|could) you [please]", entry(1)));
  REQUIRE(table.add("you", entry(2)));
  REQUIRE(table.add("could you", entry(3)));
  CHECK(costs(table, "can you") == std::vector<double>{1});
  CHECK(costs(table, "could you please") == std::vector<double>{1});
  CHECK(costs(table, "could you") == std::vector<double>{1, 3});
  CHECK(costs(table, "you") == std::vector<double>{2});
  for (const auto* words : {"can", "please", "can you please please", "you can", "would you", "", "can  you", " you"}) {
    CAPTURE(words);
    CHECK(costs(table, words).empty());
  }
  CHECK(table.texts() == std::set<std::string>{"can you", "can you please", "could you", "could you please", "you"});
  CHECK(table.most_words() == 3);
  CHECK(table.parts().contains("please"));
  CHECK_FALSE(table.parts().contains("would"));
}

TEST_CASE("a key that stands for no words, or that cannot be taken apart, leaves a table of words as it was") {
  for (const std::string key : {"", "[a]", "a|", "[a] [b]", "(a", "a]"}) {
    CAPTURE(key);
    WordTable table;
    CHECK_FALSE(table.add(key, entry(1)));
    CHECK(table.texts().empty());
    CHECK(costs(table, "a").empty());
    REQUIRE(table.add("a b", entry(2)));
    CHECK(costs(table, "a b") == std::vector<double>{2});
  }
}

TEST_CASE("a table of words knows the texts that its keys are short for") {
  CHECK(rc::check("texts() are the spellings of all keys", [] {
    WordTable table;
    std::map<std::string, std::vector<double>> expected;
    for (int number = 0; number < 3; ++number) {
      const auto key = random_key(2);
      const auto all = spellings(key);
      const std::set<std::string> texts(all.begin(), all.end());
      RC_ASSERT(table.add(key, entry(number)) == !texts.contains(""));
      if (texts.contains("")) continue;
      for (const auto& text : texts) expected[text].push_back(number);
    }
    std::set<std::string> texts;
    for (const auto& [text, numbers] : expected) {
      texts.insert(text);
      RC_ASSERT(costs(table, text) == numbers);
      RC_ASSERT(static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')) < table.most_words());
    }
    RC_ASSERT(table.texts() == texts);
  }));
}
