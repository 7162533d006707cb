// JFLAP files accept the words they should: known languages, and automata at random against the textbook's.
#include <random>

#include "continua/analysis/acceptance.h"
#include "continua/core/characters.h"
#include "continua/machine_file/jflap.h"
#include "support/jflap_files.h"
#include "support/machines.h"

using namespace continua;

namespace {

Acceptance acceptance_of(const std::string& jff, AcceptBy by) {
  const auto machine = machine_of_jflap(jff, "m.jff");
  if (!machine) FAIL(machine.error().text());
  return Acceptance(machine_of(compact(*machine)), by);
}

bool accepts(Acceptance& acceptance, const std::string& word) {
  const auto verdict = acceptance.accepts(characters(word));
  if (!verdict) FAIL(verdict.error().text());
  return *verdict;
}

// "ε ab" gives "" and "ab".
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find(' ', at), text.size());
    const auto word = text.substr(at, end - at);
    words.push_back(word == "ε" ? "" : word);
    at = end + 1;
  }
  return words;
}

struct Known {
  const char* language;
  classical::Pda pda;
  AcceptBy by;
  const char *accepted, *rejected;
};

constexpr auto final_state = AcceptBy::final_state, empty_stack = AcceptBy::empty_stack;

const std::vector<Known> known = {
    {"a^n b^n",
     {3, 0, {2}, {{0, "a", "", "A", 0}, {0, "", "", "", 1}, {1, "b", "A", "", 1}, {1, "", "Z", "Z", 2}}},
     final_state,
     "ε ab aabb aaaaabbbbb",
     "a b ba abb aab abab c"},
    {"palindromes",
     {2,
      0,
      {1},
      {{0, "a", "", "a", 0},
       {0, "b", "", "b", 0},
       {0, "", "", "", 1},
       {0, "a", "", "", 1},
       {0, "b", "", "", 1},
       {1, "a", "a", "", 1},
       {1, "b", "b", "", 1}}},
     empty_stack,
     "",
     "ε a aa abba ab"},  // Z stays
    {"palindromes, Z popped at the end",
     {3,
      0,
      {2},
      {{0, "a", "", "a", 0},
       {0, "b", "", "b", 0},
       {0, "", "", "", 1},
       {0, "a", "", "", 1},
       {0, "b", "", "", 1},
       {1, "a", "a", "", 1},
       {1, "b", "b", "", 1},
       {1, "", "Z", "", 2}}},
     empty_stack,
     "ε a b aa aba abba abaaba",
     "ab abb aab abab"},
    {"balanced brackets of two kinds",
     {1,
      0,
      {},
      {{0, "(", "", "(", 0}, {0, ")", "(", "", 0}, {0, "<", "", "<", 0}, {0, ">", "<", "", 0}, {0, "", "Z", "", 0}}},
     empty_stack,
     "ε () <> (<>)() <<()><>>",
     "( ) (> (<)> ())"},
    {"the same number of a and b, on an empty stack",
     {1,
      0,
      {},
      {{0, "", "Z", "", 0}, {0, "a", "", "A", 0}, {0, "b", "A", "", 0}, {0, "b", "", "B", 0}, {0, "a", "B", "", 0}}},
     empty_stack,
     "ε ab ba abba bbaa",
     "a b aab"},
    {"a^n b^2n, two symbols at once",
     {2,
      0,
      {},
      {{0, "a", "Z", "AAZ", 0},
       {0, "a", "A", "AAA", 0},
       {0, "", "", "", 1},
       {1, "bb", "AA", "", 1},
       {1, "", "Z", "", 1}}},
     empty_stack,
     "ε abb aabbbb",
     "a ab abbb aabb aabbb"},
    {"several symbols of pop and push: leftmost on top",
     {4, 0, {3}, {{0, "x", "Z", "ABC", 1}, {1, "y", "AB", "D", 2}, {2, "z", "DC", "", 3}}},
     final_state,
     "xyz",
     "x xy xyy yz xyzz"},
    {"popping more than there is",
     {2, 0, {}, {{0, "a", "", "A", 0}, {0, "", "ZZ", "", 1}, {0, "", "AA", "", 0}}},
     empty_stack,
     "",
     "ε a aa aaa"},
    {"nothing popped from an empty stack by a word in parts",
     {2, 0, {1}, {{0, "", "Z", "", 1}, {1, "ab", "", "", 1}}},
     empty_stack,
     "ε ab abab",
     "a aba b"},
    {"λ-moves in a circle",
     {2, 0, {1}, {{0, "", "", "", 0}, {0, "", "", "", 1}, {1, "", "", "", 0}, {1, "a", "", "", 1}}},
     final_state,
     "ε a aaa",
     "b ab"},
    {"λ-moves that push without end",
     {2, 0, {1}, {{0, "", "", "A", 0}, {0, "", "", "", 1}, {1, "a", "A", "", 1}, {1, "", "Z", "", 1}}},
     empty_stack,
     "ε a aa aaaaa",
     "b ab"},
    {"an asterisk is a symbol",
     {2, 0, {1}, {{0, "*", "", "*", 1}, {1, "'", "*", "\\", 1}}},
     final_state,
     "* *'",
     "ε ' a *a **"},
};

// All words over `alphabet` up to this length.
std::vector<std::string> all_words(const std::string& alphabet, std::size_t length) {
  std::vector<std::string> words = {""};
  for (std::size_t i = 0; i < words.size() && words[i].size() < length; ++i)
    for (const char c : alphabet) words.push_back(words[i] + c);
  return words;
}

class RandomPda {
 public:
  explicit RandomPda(unsigned seed) : random_(seed) {}

  classical::Pda draw(bool pushdown) {
    classical::Pda pda;
    pda.states = 1 + below(4);
    pda.start = below(pda.states);
    for (int state = 0; state < pda.states; ++state)
      if (below(3) == 0) pda.accepting.insert(state);
    for (int i = 2 + below(7); i > 0; --i)
      pda.moves.push_back({below(pda.states), symbols("ab", 2), pushdown ? symbols("ZA", 2) : "",
                           pushdown ? symbols("ZA", 2) : "", below(pda.states)});
    return pda;
  }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  // One symbol most often, now and then one more than `most`.
  std::string symbols(const std::string& alphabet, int most) {
    std::string text;
    for (int i = below(3) == 0 ? below(most + 2) : below(2); i > 0; --i) text += alphabet[below(2)];
    return text;
  }

  std::mt19937 random_;
};

void check_against_textbook(bool pushdown, unsigned automata) {
  const auto words = all_words("ab", 5);
  int accepted = 0, rejected = 0;
  for (unsigned seed = 0; seed < automata; ++seed) {
    const auto pda = RandomPda(seed).draw(pushdown);
    const auto jff = jff_of(pda, pushdown);
    CAPTURE(jff);
    auto by_state = acceptance_of(jff, final_state), by_stack = acceptance_of(jff, empty_stack);
    for (const auto& word : words) {
      CAPTURE(word);
      const auto expected = classical::decide(pda, word);
      REQUIRE(accepts(by_state, word) == expected.final_state);
      if (pushdown) REQUIRE(accepts(by_stack, word) == expected.empty_stack);
      ++(expected.final_state ? accepted : rejected);
    }
  }
  CHECK(accepted > 100);  // or the draw is no test
  CHECK(rejected > 100);
}

}  // namespace

TEST_CASE("JFLAP's automata accept their language, and the textbook's do") {
  for (const auto& [language, pda, by, accepted, rejected] : known) {
    CAPTURE(language);
    auto acceptance = acceptance_of(jff_of(pda), by);
    for (const bool expected : {true, false})
      for (const auto& word : words_of(expected ? accepted : rejected)) {
        CAPTURE(word);
        CHECK(accepts(acceptance, word) == expected);
        const auto verdict = classical::decide(pda, word);
        CHECK((by == final_state ? verdict.final_state : verdict.empty_stack) == expected);
      }
  }
}

TEST_CASE("pushdown automata at random accept what the textbook's do") { check_against_textbook(true, 400); }

TEST_CASE("finite automata at random accept what the textbook's do") { check_against_textbook(false, 200); }

TEST_CASE("the word is read in characters") {
  auto acceptance = acceptance_of(jff("fa",
                                      "<state id='0'><initial/></state><state id='1'><final/></state>"
                                      "<transition><from>0</from><to>1</to><read>né</read></transition>"
                                      "<transition><from>1</from><to>1</to><read>[α-ω]</read></transition>"),
                                  final_state);
  CHECK(accepts(acceptance, "né"));
  CHECK(accepts(acceptance, "néλω"));
  CHECK_FALSE(accepts(acceptance, "n\xC3"));
  CHECK_FALSE(accepts(acceptance, "néa"));
}
