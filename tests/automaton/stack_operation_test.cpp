// Corner cases of the operations and of gates: one machine, an operation at the input x, and the stack afterwards.
#include "continua/automaton/stack_operation.h"

#include "support/machines.h"

using namespace continua;

namespace {

struct Row {
  const char* what;
  const char* members;    ///< of the machine, besides those it always has
  const char* operation;  ///< of the transition that takes x, from any state to X
  const char* word;
  const char* after;
};

// a, b, c and d push 1 to 4, and d enters A as a does; A and S enter these states with the stack unchanged; keep pushes
// a persistent value; set rewrites.
std::string machine_text(const Row& row) {
  return std::string(
             R"({"machine":1,"name":"m","start":"S","slots":{"n":"num","held":{"type":"num","persists":true}},)") +
         row.members + R"("transitions":[
    {"id":"x","from":"*","on":"x","to":"X",)" +
         row.operation + R"(},
    {"id":"a","from":"*","on":"a","to":"A","push":{"n":"1"}},
    {"id":"b","from":"*","on":"b","to":"B","push":{"n":"2"}},
    {"id":"c","from":"*","on":"c","to":"C","push":{"n":"3"}},
    {"id":"d","from":"*","on":"d","to":"A","push":{"n":"4"}},
    {"id":"A","from":"*","on":"A","to":"A"},
    {"id":"S","from":"*","on":"S","to":"S"},
    {"id":"keep","from":"*","on":"keep","to":"B","push":{"held":"7"}},
    {"id":"set","from":"*","on":"set","to":"B","rewrite":{"n":"8","held":"9"}},
    {"id":"pop","from":"*","on":"pop","to":"B","pop":1}]})";
}

std::string symbol_text(const Symbol& symbol) {
  const std::string n = print(symbol[0].value), held = print(symbol[1].value);
  return (n == "null" ? "-" : n) + (held == "null" ? "" : "/" + held);
}

// "X: - 1 2/7": the state, and the stack from the bottom; a symbol as its number / its persistent value.
std::string seen(const Player& player) {
  std::string symbols;
  for (Stack stack = player.configuration().stack; !stack.empty(); stack = stack.pop())
    symbols = " " + symbol_text(stack.top()) + symbols;
  return player.state() + ":" + symbols + (player.all<RefusedInput>().empty() ? "" : " refused") +
         (player.all<Trouble>().empty() ? "" : " trouble");
}

void check(const std::vector<Row>& rows) {
  for (const auto& row : rows) {
    CAPTURE(row.what);
    Player player(machine_text(row));
    CHECK(seen(player.feed(row.word)) == row.after);
  }
}

const char* const two_below = R"("rewrite_below":true,)";

}  // namespace

TEST_CASE("pop takes symbols off, but never the last") {
  check({{"at the bottom", "", R"("pop":1)", "x", "X: -"},
         {"a bottom that was rewritten stays too", "", R"("pop":1)", "set, x", "X: 8/9"},
         {"several", "", R"("pop":2)", "a, b, c, x", "X: - 1"},
         {"as many as there are above the last", "", R"("pop":2)", "a, b, x", "X: -"},
         {"more than there are", "", R"("pop":3)", "a, b, x", "X: -"}});
}

TEST_CASE("pop_until goes back to the symbol of the previous entry of a state") {
  const char* until_a = R"("pop_until":"A")";
  check({{"never entered", "", until_a, "b, c, x", "X: -"},
         {"never entered: what persists is kept, as by flush", "", until_a, "b, keep, c, x", "X: -/7"},
         {"entered once", "", until_a, "a, b, c, x", "X: - 1"},
         {"entered once, and nothing pushed since", "", until_a, "a, x", "X: -"},
         {"entered twice: the later counts", "", until_a, "a, b, d, c, x", "X: - 1 2 4"},
         {"entered three times: the latest counts", "", until_a, "d, a, b, A, c, x", "X: - 4 1 2"},
         {"in the state, entered for the first time", "", until_a, "b, a, x", "X: -"},
         {"in the state, entered before", "", until_a, "a, b, d, x", "X: - 1"},
         {"in the state, entered before with the symbol that is on top", "", until_a, "a, b, a, x", "X: - 1 2 1"},
         {"entered at the bottom: what persists is not kept", "", until_a, "A, keep, b, x", "X: -"},
         {"the symbol is gone: down to the last, as it is", "", until_a, "set, a, pop, b, c, x", "X: 8/9"},
         {"an equal symbol counts as the same", "", R"("pop_until":"S")", "a, keep, pop, pop, b, x", "X: -"},
         {"equal in every slot", "", until_a, "keep, a, pop, pop, a, b, x", "X: - 1"}});
}

TEST_CASE("push inherits what it does not mention, and clears what it is told to") {
  check({{"inherits", "", R"("push":{"n":"5"})", "keep, x", "X: - -/7 5/7"},
         {"clears", "", R"("push":{"n":"5","held":null})", "keep, x", "X: - -/7 5"},
         {"a content that is null", "", R"json("push":{"n":"head([])"})json", "a, x", "X: - 1 -"},
         {"contents see the topmost symbol before", "", R"("push":{"n":"held","held":"n"})", "a, keep, x",
          "X: - 1 1/7 7/1"}});
}

TEST_CASE("push_each pushes a symbol for each element") {
  check({{"in order", "", R"("push_each":{"n":"[5, 6]"})", "a, x", "X: - 1 5 6"},
         {"each inherits", "", R"("push_each":{"n":"[5, 6]"})", "keep, x", "X: - -/7 5/7 6/7"},
         {"null clears in each", "", R"("push_each":{"n":"[5, 6]","held":null})", "keep, x", "X: - -/7 5 6"},
         {"an element that is null", "", R"("push_each":{"n":"[5, null]"})", "a, x", "X: - 1 5 -"},
         {"none", "", R"("push_each":{"n":"[]"})", "a, x", "X: - 1"},
         {"two lists", "", R"("push_each":{"n":"[5, 6]","held":"[1, 2]"})", "a, x", "X: - 1 5/1 6/2"},
         {"lists of different length: as many as all have", "", R"("push_each":{"n":"[5, 6]","held":"[1]"})", "a, x",
          "X: - 1 5/1 trouble"},
         {"an empty list and another", "", R"("push_each":{"n":"[]","held":"[1]"})", "a, x", "X: - 1 trouble"}});
}

TEST_CASE("rewrite replaces the topmost symbol") {
  check({{"what is not mentioned stays", "", R"("rewrite":{"n":"5"})", "keep, b, x", "X: - -/7 5/7"},
         {"at the bottom", "", R"("rewrite":{"n":"5"})", "x", "X: 5"},
         {"clears", "", R"("rewrite":{"n":"5","held":null})", "keep, x", "X: - 5"},
         {"null leaves the stack", "", R"("rewrite":null)", "a, x", "X: - 1"}});
}

TEST_CASE("rewrite_each replaces the topmost symbol by one for each element") {
  check({{"the first inherits from what it replaces", "", R"("rewrite_each":{"n":"[5, 6]"})", "keep, b, x",
          "X: - -/7 5/7 6/7"},
         {"none: what is below shows", "", R"("rewrite_each":{"n":"[]"})", "a, b, x", "X: - 1"},
         {"none, at the bottom", "", R"("rewrite_each":{"n":"[]"})", "x", "X: -"},
         {"none, at a bottom that was rewritten: as declared", "", R"("rewrite_each":{"n":"[]"})", "set, x", "X: -"},
         {"at the bottom", "", R"("rewrite_each":{"n":"[5, 6]"})", "set, x", "X: 5/9 6/9"},
         {"lists of different length: as many as all have", "", R"("rewrite_each":{"n":"[5, 6]","held":"[1]"})", "a, x",
          "X: - 5/1 trouble"}});
}

TEST_CASE("rewrite_below shows the symbol below where a rewrite leaves nothing") {
  check({{"null before and after", two_below, R"("rewrite":{"held":"6"})", "a, set, A, x", "X: - 8/6"},
         {"nothing set, something below", two_below, R"json("rewrite":{"n":"head([])"})json", "a, b, x", "X: - 1 1"},
         {"cleared by name", two_below, R"("rewrite":{"n":null})", "a, b, x", "X: - 1 -"},
         {"without it", "", R"json("rewrite":{"n":"head([])"})json", "a, b, x", "X: - 1 -"},
         {"inherited null", two_below, R"("rewrite":{"n":"5"})", "set, keep, pop, x", "X: 5/9"},
         {"at the bottom nothing is below", two_below, R"json("rewrite":{"n":"head([])"})json", "x", "X: -"},
         {"not in a push", two_below, R"json("push":{"n":"head([])"})json", "a, b, x", "X: - 1 2 -"}});
}

TEST_CASE("flush leaves one symbol, which keeps what persists") {
  check({{"keeps what persists", "", R"("flush":{})", "keep, b, x", "X: -/7"},
         {"what the topmost symbol held, not the ones below", "", R"("flush":{})", "keep, set, a, x", "X: -/9"},
         {"clears that too", "", R"("flush":{"held":null})", "keep, b, x", "X: -"},
         {"at the bottom", "", R"("flush":{})", "set, x", "X: -/9"}});
}

TEST_CASE("a gate is tested on the configuration that is left") {
  const char* gate =
      R"("states":{"S":{},"A":{},"B":{},"C":{},"X":{"gate":{"when":"n = 1","else":"E","push":{"n":"6"}}},"E":{}},)";
  const char* plain = R"("states":{"S":{},"A":{},"B":{},"C":{},"X":{"gate":{"when":"n = 1","else":"E"}},"E":{}},)";
  const char* chain =
      R"("states":{"S":{},"A":{},"B":{},"C":{},"X":{"gate":{"when":"n = 1","else":"E","push":{"n":"6"}}},
                                  "E":{"gate":{"when":"n = 2","else":"F","rewrite":{"n":"7"}}},"F":{}},)";
  const char* circle =
      R"("states":{"S":{},"A":{},"B":{},"C":{},"X":{"gate":{"when":"n = 1","else":"E","push":{"n":"6"}}},
                                   "E":{"gate":{"when":"n = 2","else":"X","pop":1}}},)";
  const char* push = R"("push":{"n":"5"})";
  check({{"it holds", gate, push, "a, x", "X: - 1 5"},
         {"it does not hold: its operation instead", gate, push, "b, x", "E: - 2 6"},
         {"without an operation none is done", plain, push, "b, x", "E: - 2"},
         {"the gate of else holds: the operation of the first", chain, push, "b, x", "E: - 2 6"},
         {"nor does the gate of else hold: the operation of the last", chain, push, "c, x", "F: - 7"},
         {"in a circle: nothing changes", circle, push, "c, x", "C: - 3 refused trouble"},
         {"no circle where one of them holds", circle, push, "b, x", "E: - 2 6"}});
}

TEST_CASE("a gate stands before ε-transitions too") {
  const auto after = [](const std::string& gate, const std::string& word) {
    Player player(R"({"machine":1,"name":"m","start":"S","slots":{"n":"num","held":"num"},
      "states":{"S":{},"A":{},"B":{},"X":{"gate":)" +
                  gate + R"(},"E":{"gate":{"when":"n < 3","else":"X"}}},"transitions":[
      {"id":"a","from":"S","on":"a","to":"A","push":{"n":"1"}},
      {"id":"b","from":"S","on":"b","to":"A","push":{"n":"2"}},
      {"id":"c","from":"S","on":"c","to":"A","push":{"n":"3"}},
      {"id":"on","from":"A","on":null,"to":"X","push":{"n":"5"}}]})");
    return seen(player.feed(word));
  };
  const std::string elsewhere = R"({"when":"n = 1","else":"E","push":{"n":"6"}})";
  CHECK(after(elsewhere, "a") == "X: - 1 5");
  CHECK(after(elsewhere, "b") == "E: - 2 6");
  CHECK(after(elsewhere, "c") == "A: - 3 trouble");
}
