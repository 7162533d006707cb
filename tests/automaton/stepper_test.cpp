#include "continua/automaton/stepper.h"

#include <map>
#include <set>

#include "support/machines.h"

using namespace continua;

namespace {

// The disambiguation loop of the paper's figure: one state for any number of options.
const std::string disambiguation = R"json({
  "machine": 1, "name": "disambiguation", "start": "InterpDeixis", "accept": ["Confirmed"],
  "slots": { "options": "num*", "held": { "type": "num", "persists": true } },
  "transitions": [
    { "id": "offer",   "from": "InterpDeixis", "on": "point", "to": "DisambTarget", "push_each": { "options": "reverse(suffixes([1, 2, 3]))" } },
    { "id": "hold",    "from": "InterpDeixis", "on": "hold",  "to": "InterpDeixis", "push": { "held": "7" } },
    { "id": "next",    "from": "DisambTarget", "on": "no",  "when": "size(options) > 1", "to": "DisambTarget", "pop": 1 },
    { "id": "give_up", "from": "DisambTarget", "on": "no",  "when": "size(options) = 1", "to": "InterpDeixis", "flush": {} },
    { "id": "drop",    "from": "DisambTarget", "on": "drop", "to": "InterpDeixis", "flush": { "held": null } },
    { "id": "agree",   "from": "DisambTarget", "on": "yes", "to": "Confirmed", "do": [ { "act": "head(options)" }, { "say": "Option {head(options)}." } ] } ] })json";

}  // namespace

TEST_CASE("one state disambiguates between any number of options") {
  Player player(disambiguation);
  player.feed("point");
  CHECK(player.state() == "DisambTarget");
  CHECK(player.depth() == 4);
  CHECK(player.slot("options") == "[1, 2, 3]");
  player.feed("no");
  CHECK(player.fired() == "next");
  CHECK(player.slot("options") == "[2, 3]");
  player.feed("no, no");
  CHECK(player.fired() == "give_up");
  CHECK(player.state() == "InterpDeixis");
  CHECK(player.slot("options") == "[]");
}

TEST_CASE("yes acts on the option and says so") {
  Player player(disambiguation);
  player.feed("point, no, yes");
  REQUIRE(player.all<Acted>().size() == 1);
  CHECK(print(player.all<Acted>()[0].term) == "2");
  CHECK(player.all<Said>()[0].text == "Option 2.");
}

TEST_CASE("a refused transition tells the first part of its condition that failed, and the value it saw") {
  Player player(disambiguation);
  player.feed("point, no");
  const auto fired = player.all<Fired>().at(0);
  REQUIRE(fired.refused.size() == 1);
  CHECK(fired.refused[0].reason == "not size(options) = 1: size(options) is 3");
}

TEST_CASE("of a conjunction, the part that fails is told, through definitions") {
  Player player(
      R"json({"machine":1,"name":"m","start":"A","slots":{"n":"num","m":"num"},"define":{"both":"n = 1 and m = 2"},"transitions":[
    {"id":"set","from":"A","on":"set","to":"A","push":{"n":"1","m":"3"}},
    {"id":"go","from":"A","on":"go","when":"both","to":"B"}]})json");
  CHECK(player.feed("go").all<RefusedInput>().at(0).refused.at(0).reason == "both: not n = 1: n is null");
  CHECK(player.feed("set, go").all<RefusedInput>().at(0).refused.at(0).reason == "both: not m = 2: m is 3");
}

TEST_CASE("an input that nothing takes is refused and changes nothing") {
  Player player(disambiguation);
  player.feed("point");
  const auto before = player.configuration();
  player.feed("maybe");
  REQUIRE(player.all<RefusedInput>().size() == 1);
  CHECK(player.all<RefusedInput>()[0].reason == "no transition from DisambTarget takes 'maybe'");
  CHECK(before.same_as(player.configuration()));
}

TEST_CASE("flush keeps what persists, unless it is cleared too") {
  CHECK(Player(disambiguation).feed("hold, point, no, no, no").slot("held") == "7");
  CHECK(Player(disambiguation).feed("hold, point, drop").slot("held") == "null");
  CHECK(Player(disambiguation).feed("hold, point, drop").depth() == 1);
}

TEST_CASE(
    "several applicable transitions: likeliest takes the heaviest, ties by file order, unique refuses, sample draws") {
  const std::string two = R"({"machine":1,"name":"m","start":"A","transitions":[
    {"id":"light","from":"A","on":"x","to":"B","weight":1},
    {"id":"heavy","from":"A","on":"x","to":"C","weight":3},
    {"id":"equal","from":"A","on":"x","to":"D","weight":3}]})";
  CHECK(Player(two).feed("x").fired() == "heavy");
  Player unique(two, Choice::unique);
  unique.feed("x");
  CHECK(unique.state() == "A");
  CHECK(unique.all<RefusedInput>().at(0).reason == "more than one transition applies: light, heavy, equal");
  int light = 0;
  for (std::uint64_t seed = 0; seed < 700; ++seed) {
    Player sample(two, Choice::sample, seed);
    light += sample.feed("x").fired() == "light";
    REQUIRE(sample.all<Fired>().at(0).draw.has_value());
  }
  CHECK(light > 60);  // a seventh of 700 is 100
  CHECK(light < 140);
}

TEST_CASE("pop_until goes back to the previous entry of a state, and is flush where it was never entered") {
  const std::string text =
      R"({"machine":1,"name":"m","start":"S","states":{"S":{},"A":{},"B":{},"C":{}},"slots":{"n":"num"},"transitions":[
    {"id":"a","from":"*","on":"a","to":"A","push":{"n":"1"}},
    {"id":"b","from":"*","on":"b","to":"B","push":{"n":"2"}},
    {"id":"again","from":"*","on":"again","to":"A","push":{"n":"3"}},
    {"id":"back","from":"*","on":"back","to":"C","pop_until":"A"}]})";
  Player known(text);
  known.feed("a, b, b, back");
  CHECK(known.depth() == 2);
  CHECK(known.slot("n") == "1");
  Player entered_twice(text);
  entered_twice.feed("b, a, b, again, back");
  CHECK(entered_twice.slot("n") == "1");  // as at the entry before the present one
  CHECK(entered_twice.depth() == 3);
  Player never(text);
  never.feed("b, b, back");
  CHECK(never.depth() == 1);
  CHECK(never.slot("n") == "null");
}

TEST_CASE("pop takes the top off, and the bottom symbol stays, however often it is popped") {
  const std::string text = R"({"machine":1,"name":"m","start":"A","slots":{"n":"num"},"transitions":[
    {"id":"+","from":"A","on":"+","to":"A","push":{"n":"7"}},{"id":"-","from":"A","on":"-","to":"A","pop":1},
    {"id":"3","from":"A","on":"3","to":"A","pop":3}]})";
  CHECK(Player(text).feed("+, +, -").depth() == 2);
  CHECK(Player(text).feed("+, -").depth() == 1);
  CHECK(Player(text).feed("+, -").slot("n") == "null");
  CHECK(Player(text).feed("+, 3, 3").depth() == 1);
}

TEST_CASE("a rewrite replaces the top, then ε-transitions are tried, an empty list exposes what is below") {
  const std::string text =
      R"json({"machine":1,"name":"m","start":"A","epsilon":"after_rewrite","slots":{"n":"num","m":"num"},
    "states":{"A":{},"C":{},"B":{"enter":[{"when":"n = 1","rewrite":{"n":"n + 1"}},{"say":"never said"}]},"E":{"enter":[{"rewrite_each":{"n":"[]"}}]}},
    "transitions":[
    {"id":"b","from":"A","on":"b","to":"B","push":{"n":"1","m":"5"}},
    {"id":"on","from":"B","on":null,"when":"n = 2","to":"C"},
    {"id":"e","from":"A","on":"e","to":"E","push":{"n":"9"}},
    {"id":"stay","from":"A","on":"stay","to":"A"},
    {"id":"not_yet","from":"A","on":null,"to":"C"}]})json";
  Player player(text);
  CHECK(player.feed("stay").state() == "A");  // no rewrite, no ε-transition
  player.feed("b");
  CHECK(player.fired() == "b on");
  CHECK(player.slot("n") == "2");
  CHECK(player.slot("m") == "5");
  CHECK(player.depth() == 2);
  CHECK(player.all<Said>().empty());
  Player empty(text);
  CHECK(empty.feed("e").depth() == 1);
  CHECK(empty.slot("n") == "null");
}

TEST_CASE(
    "where the machine says so, a slot that a rewrite leaves null shows the symbol below, unless it was cleared") {
  const auto text = [](const char* rewrite) {
    return std::string(
               R"({"machine":1,"name":"m","start":"A","rewrite_below":true,"epsilon":"after_rewrite","slots":{"n":"num","m":"num"},"transitions":[
      {"id":"a","from":"A","on":"a","to":"A","push":{"n":"1","m":"2"}},
      {"id":"b","from":"A","on":"b","to":"A","push":{"n":null,"m":null}},
      {"id":"c","from":"A","on":"c","to":"A","rewrite":)") +
           rewrite + "}]}";
  };
  CHECK(Player(text(R"({"m":"3"})")).feed("a, b, c").slot("n") == "1");
  CHECK(Player(text(R"({"m":"3","n":null})")).feed("a, b, c").slot("n") == "null");
  CHECK(Player(text(R"json({"m":"head([])"})json")).feed("a, b, c").slot("m") == "2");
}

TEST_CASE("a gate that does not hold leads elsewhere, with its own operation") {
  Player player(R"json({"machine":1,"name":"m","start":"A","slots":{"n":"num"},
    "beliefs":{"concepts":{"p":{"word":"pointing"}},"evidence":[{"inputs":["p"],"concepts":["p"],"levels":[0.5,1]}],"overheard":0.8},
    "states":{"A":{},"B":{"gate":{"when":"certainty(input) > 0.5","else":"Ask","push":{"n":"4"}},"enter":[{"say":"in B"}]},"Ask":{"enter":[{"say":"Are you pointing?"}]}},
    "transitions":[{"id":"b","from":"A","on":"p","to":"B","push":{"n":"1"},"do":[{"act":"1"}]},{"id":"again","from":"Ask","on":"p","to":"B"}]})json");
  player.beliefs().raise("p");
  player.feed("p");
  CHECK(player.state() == "Ask");
  CHECK(player.slot("n") == "4");
  CHECK(player.all<Acted>().empty());
  CHECK_FALSE(player.all<Fired>().at(0).gates.at(0).passed);
  player.beliefs().overhear("Are you Pointing?");
  player.feed("p");
  CHECK(player.state() == "B");
}

TEST_CASE("an ε-cycle that changes nothing is told with its path, one that grows ends") {
  Player still(
      R"({"machine":1,"name":"m","start":"S","transitions":[{"id":"in","from":"S","on":"x","to":"A"},{"id":"ab","from":"A","on":null,"to":"B"},{"id":"ba","from":"B","on":null,"to":"A"}]})");
  still.feed("x");
  REQUIRE(still.all<Trouble>().size() == 1);
  CHECK(still.all<Trouble>()[0].message == "an ε-cycle that changes nothing: ab, ba");
  Player growing(
      R"({"machine":1,"name":"m","start":"S","slots":{"n":"num"},"transitions":[{"id":"in","from":"S","on":"x","to":"A"},{"id":"grow","from":"A","on":null,"to":"A","push":{}}]})");
  growing.feed("x");
  CHECK(growing.all<Trouble>().size() == 1);
  const auto countdown = [](int from) {
    Player player(fmt::format(
        R"({{"machine":1,"name":"m","start":"S","slots":{{"n":"num"}},"transitions":[{{"id":"in","from":"S","on":"x","to":"A","push":{{"n":"{}"}}}},{{"id":"less","from":"A","on":null,"when":"n > 0","to":"A","rewrite":{{"n":"n - 1"}}}}]}})",
        from));
    return player.feed("x").all<Trouble>().size();
  };
  CHECK(countdown(most_epsilon_steps) == 0);
  CHECK(countdown(most_epsilon_steps + 1) == 1);
}

TEST_CASE("time goes on during the ε-transitions that an input brings about, the input itself is used up") {
  Player player(
      R"json({"machine":1,"name":"m","start":"A","memory":{"since":{"type":"num"},"seen":{"type":"text"}},"transitions":[
    {"id":"in","from":"A","on":"x","to":"B"},
    {"id":"on","from":"B","on":null,"to":"C","do":[{"remember":{"since":"now","seen":"if(input = null, 'nothing', input)"}}]}]})json");
  player.feed("x");
  CHECK(print(player.configuration().memory->at(0).value) == "0");
  CHECK(print(player.configuration().memory->at(1).value) == "'nothing'");
}

TEST_CASE("a continuation that is filled later names the symbol that it was read from, which names its input") {
  Player player(
      R"json({"machine":1,"name":"m","start":"A","programs":{"put":"num -> num -> t"},"slots":{"action":"term","goal":"num"},"transitions":[
    {"id":"open","from":"A","on":"put","to":"A","push":{"action":"\\x. put(x, 3)"}},
    {"id":"other","from":"A","on":"other","to":"A"},
    {"id":"fill","from":"A","on":"this","to":"B","push":{"action":"fill(action, x(target))"}}]})json");
  player.feed("put");
  CHECK(player.all<MadeSymbol>().at(0).because == std::vector<int>{1});
  player.feed("other, this");
  const auto applied = player.all<Applied>();
  REQUIRE(applied.size() == 1);
  CHECK(print(applied[0].application.function) == "\\x. put(x, 3)");
  CHECK(print(applied[0].application.result) == "put(3, 3)");
  CHECK(applied[0].because == std::vector<int>{source_of_symbol(1), 3});
  CHECK(player.slot("action") == "put(3, 3)");
}

TEST_CASE("the sources of a value do not grow with the session, and lead to all inputs behind it") {
  Player player(
      R"json({"machine":1,"name":"m","start":"A","slots":{"s":"num"},"memory":{"all":{"type":"num*"}},"transitions":[
    {"id":"more","from":"A","on":"x","to":"A","rewrite":{"s":"size(all)"},"do":[{"remember":{"all":"append(all, [s])"}}]}]})json");
  std::map<int, std::vector<int>> behind;
  for (int i = 0; i < 50; ++i) {
    player.feed("x");
    for (const auto& made : player.all<MadeSymbol>()) behind[source_of_symbol(made.id)] = made.because;
    for (const auto& one : player.all<Remembered>()) behind[source_of_write(one.number)] = one.because;
  }
  std::set<int> found;
  std::vector<int> open = {player.configuration().memory->at(0).source};
  while (!open.empty()) {
    const int source = open.back();
    open.pop_back();
    if (!found.insert(source).second || source > 0) continue;
    CHECK(behind.at(source).size() <= 3);
    open.insert(open.end(), behind.at(source).begin(), behind.at(source).end());
  }
  for (int serial = 1; serial <= 50; ++serial) CHECK(found.contains(serial));
}

TEST_CASE("a register that is given the value that it has came of that, without a record") {
  Player player(R"json({"machine":1,"name":"m","start":"A","memory":{"r":{"type":"num"}},"transitions":[
    {"id":"set","from":"A","on":"x","to":"A","do":[{"remember":{"r":"1"}}]}]})json");
  player.feed("x, x, x");
  CHECK(player.all<Remembered>().empty());
  CHECK(player.configuration().memory->at(0).because == std::vector<int>{3});
  CHECK(player.configuration().memory->at(0).source == 0);
}

TEST_CASE("registers are remembered beside the stack, all at once") {
  Player player(R"({"machine":1,"name":"m","start":"A","memory":{"a":{"type":"num","initial":"1"},"b":{"type":"num"}},
    "transitions":[{"id":"s","from":"A","on":"x","to":"A","do":[{"remember":{"a":"a + 1","b":"a"}}]}]})");
  player.feed("x, x");
  CHECK(print(player.configuration().memory->at(0).value) == "3");
  CHECK(print(player.configuration().memory->at(1).value) == "2");
}

TEST_CASE("wordings put a term into words by its shape") {
  Player player(
      R"json({"machine":1,"name":"m","start":"A","programs":{"put":"num -> num -> t","on":"num -> num"},"slots":{"a":"t"},
    "wordings":[{"of":"\\x. put(x, x)","say":"put {x} on itself"},{"of":"\\x y. put(x, on(y))","when":"x > 1","say":"put {x} on {y}"}],
    "states":{"A":{"enter":[{"say":"Should I {wording(a)}?"}]}},
    "transitions":[{"id":"1","from":"A","on":"one","to":"A","push":{"a":"put(2, on(3))"}},{"id":"2","from":"A","on":"two","to":"A","push":{"a":"put(2, 2)"}},
      {"id":"3","from":"A","on":"three","to":"A","push":{"a":"put(1, on(3))"}}]})json");
  CHECK(player.feed("one").all<Said>().at(0).text == "Should I put 2 on 3?");
  CHECK(player.feed("two").all<Said>().at(0).text == "Should I put 2 on itself?");
  CHECK(player.feed("three").all<Said>().empty());
}

TEST_CASE("what is of another type than its slot or register leaves it empty, and is told") {
  Player player(R"json({"machine":1,"name":"m","start":"A","slots":{"any":"term","n":"num","list":"num*"},
    "memory":{"r":{"type":"num"}},"transitions":[
    {"id":"take","from":"A","on":"take","to":"A","push":{"any":"'a text'"}},
    {"id":"fit","from":"A","on":"fit","to":"A","push":{"n":"any","list":"any"},"do":[{"remember":{"r":"any"}}]}]})json");
  player.feed("take, fit");
  CHECK(player.slot("n") == "null");
  CHECK(player.slot("list") == "[]");
  const auto troubles = player.all<Trouble>();
  REQUIRE(troubles.size() == 3);
  CHECK(troubles[0].message == "'a text' is no num, and n takes no other: it is left empty");
}

TEST_CASE("a content of another type is raised to that of its slot or register, and the raising is an application") {
  const RaisingRules raising = {
      {.name = "number_to_text",
       .from = Type::number(),
       .to = Type::text_type(),
       .when = parse_term("\\n. n > 0", {}, Type::parse("num -> t").value()).value(),
       .by = parse_term("\\n. text(n)", term_signature(), Type::parse("num -> text").value()).value()}};
  Player player(R"json({"machine":1,"name":"m","start":"A","slots":{"any":"term","word":"text","all":"text*"},
    "memory":{"r":{"type":"text"}},"transitions":[
    {"id":"take","from":"A","on":"take","to":"A","push":{"word":"1 + 1","any":"[3, 4]"}},
    {"id":"list","from":"A","on":"list","to":"A","push":{"all":"any"},"do":[{"remember":{"r":"5"}}]},
    {"id":"none","from":"A","on":"none","to":"A","push":{"word":"0 - 1"}}]})json",
                raising);
  player.feed("take");
  CHECK(player.slot("word") == "'2'");
  const auto applied = player.all<Applied>();
  REQUIRE(applied.size() == 1);
  CHECK(applied[0].application.rule == "number_to_text");
  CHECK(print(applied[0].application.argument) == "2");
  CHECK(applied[0].because == std::vector<int>{1});
  player.feed("list");
  CHECK(player.slot("all") == "['3', '4']");
  CHECK(print(player.configuration().memory->at(0).value) == "'5'");
  player.feed("none");
  CHECK(player.slot("word") == "null");
  CHECK(player.all<Trouble>().size() == 1);
}

TEST_CASE("FLUSH and pop_until set the registers to their first values that the machine declares for them") {
  Player player(R"json({"machine":1,"name":"m","start":"A","slots":{"s":"num"},
    "memory":{"both":{"type":"num","initial":"1","cleared_by":["flush","pop_until"]},
              "popped":{"type":"text","cleared_by":["pop_until"]},"kept":{"type":"num"}},"transitions":[
    {"id":"set","from":"A","on":"set","to":"A","push":{"s":"1"},
      "do":[{"remember":{"both":"7","popped":"'x'","kept":"3"}}]},
    {"id":"flush","from":"A","on":"flush","to":"A","flush":{}},
    {"id":"back","from":"A","on":"back","to":"A","pop_until":"A"},
    {"id":"told","from":"A","on":"told","to":"A","flush":{},"do":[{"remember":{"both":"both + 1"}}]}]})json");
  const auto registers = [&] {
    std::string all;
    for (const auto& each : *player.configuration().memory) all += print(each.value) + " ";
    return all;
  };
  player.feed("set, flush");
  CHECK(registers() == "1 'x' 3 ");
  CHECK(player.all<Remembered>().size() == 1);
  player.feed("flush");
  CHECK(player.all<Remembered>().empty());
  player.feed("set, back");
  CHECK(registers() == "1 null 3 ");
  player.feed("set, told");
  CHECK(registers() == "2 'x' 3 ");
}

TEST_CASE("to act on a list is to act on each of its programs") {
  Player player(R"json({"machine":1,"name":"m","start":"A","programs":{"go":"num -> t"},"transitions":[
    {"id":"go","from":"A","on":"go","to":"A","do":[{"act":"map([1, 2], go)"}]}]})json");
  player.feed("go");
  REQUIRE(player.all<Acted>().size() == 2);
  CHECK(print(player.all<Acted>()[1].term) == "go(2)");
}

TEST_CASE("of several inputs one is taken, by its confidence and the weight of what takes it") {
  const std::string text = R"json({"machine":1,"name":"m","start":"A","slots":{"at":"loc"},"transitions":[
    {"id":"light","from":"A","on":"x","to":"B","weight":1},
    {"id":"heavy","from":"A","on":"x","to":"C","weight":2},
    {"id":"y","from":"A","on":"y","to":"D","weight":4,"push":{"at":"target"}},
    {"id":"never","from":"A","on":"w","when":"at != null","to":"B"}]})json";
  struct Case {
    Choice choice;
    const char* offered;
    const char* fired;
    std::size_t taken;
  };
  const Case cases[] = {{Choice::likeliest, "x 0.5, y 0.2", "heavy", 0},  {Choice::likeliest, "x 0.3, y 0.5", "y", 1},
                        {Choice::likeliest, "x 0.5, y 0.25", "heavy", 0},  // a tie
                        {Choice::likeliest, "y 0.25, x 0.5", "y", 0},     {Choice::likeliest, "x 0, y 0.1", "y", 1},
                        {Choice::likeliest, "z 1, y 0.1, y 0.2", "y", 2}, {Choice::unique, "y 0.2, z 1, y 0.3", "y", 2},
                        {Choice::unique, "y 0.9, x 0.1", "", 0},          {Choice::unique, "y 0.9, x 0", "y", 0},
                        {Choice::likeliest, "w 0.5, z 0.5, x 0", "", 0}};
  for (const auto& [choice, offered, fired, taken] : cases) {
    Player player(text, choice);
    player.offer(std::string(offered));
    CAPTURE(offered);
    CHECK(player.fired() == fired);
    if (*fired) CHECK(player.taken() == taken);
  }
  Player player(text);
  player.offer("x 0.5, y 0.5, w 1");
  const auto fired = player.all<Fired>().at(0);
  REQUIRE(fired.candidates.size() == 3);
  CHECK(fired.candidates[2].alternative == 1);
  CHECK(fired.candidates[2].weight == 2);
  CHECK(fired.probability == Approx(2 / 3.5));
  CHECK(fired.refused.at(0).alternative == 2);
  CHECK(fired.input == "y");
  CHECK(player.slot("at") == "<2, 0, 0>");  // the content of the input that was taken

  Player none(text);
  CHECK(none.offer("w 0.5, z 0.5, x 0").all<RefusedInput>().at(0).reason ==
        "'w': no transition's condition holds; 'z': no transition from A takes 'z'; 'x': its confidence is 0");
  Player unique(text, Choice::unique);
  CHECK(unique.offer("y 0.9, x 0.1").all<RefusedInput>().at(0).reason ==
        "'y': y applies, but another input is not unique; 'x': more than one transition applies: light, heavy");
}

TEST_CASE("a draw is over all inputs") {
  const std::string text = R"({"machine":1,"name":"m","start":"A","transitions":[
    {"id":"x","from":"A","on":"x","to":"B"},{"id":"y","from":"A","on":"y","to":"B","weight":3}]})";
  int x = 0;
  for (std::uint64_t seed = 0; seed < 700; ++seed)
    x += Player(text, Choice::sample, seed).offer("x 0.5, y 1").fired() == "x";
  CHECK(x > 60);  // a seventh of 700 is 100
  CHECK(x < 140);
}
