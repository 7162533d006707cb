// Lessons: actions composed of others, applied to other things, and the file that keeps them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/learning/learning_file.h"
#include "continua/term/evaluate.h"
#include "term/law.h"

using namespace continua;

namespace {

const Signature& names() {
  static const Signature names = [] {
    Signature all = term_signature();
    for (const auto& [name, type] : std::map<std::string, std::string>{{"grasp", "e -> t"},
                                                                       {"lift", "e -> t"},
                                                                       {"put", "e -> loc -> t"},
                                                                       {"reach", "term -> t"},
                                                                       {"turn", "num -> e -> t"},
                                                                       {"stop", "t"},
                                                                       {"on", "e -> loc"},
                                                                       {"near", "loc -> loc"},
                                                                       {"hoist", "e -> t"},
                                                                       {"fetch", "e -> loc -> t"}})
      all.emplace(name, Type::parse(type).value());
    for (const auto* object : {"cup", "knife", "plate", "block", "v"}) all.emplace(object, Type::entity());
    return all;
  }();
  return names;
}

Term term_of(const std::string& text) {
  const auto term = parse_term(text, names());
  if (!term) FAIL(text + ": " + term.error().text());
  return *term;
}

std::vector<Term> terms(const std::string& list) { return term_of(list).elements(); }

std::vector<Term> each_of(const std::vector<std::string>& texts) {
  std::vector<Term> all;
  for (const auto& text : texts) all.push_back(term_of(text));
  return all;
}

std::string text_of(const Result<std::vector<Term>>& acts) {
  if (!acts) return acts.error().sentence;
  std::vector<std::string> texts;
  for (const auto& act : *acts) texts.push_back(print(act));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string composed_text(const std::string& acts) {
  const auto program = composed(terms(acts));
  return program ? print(*program) : program.error().sentence;
}

std::string learned_text(const std::string& text) {
  const auto learned = parse_learned(text, "l.json", names());
  return learned ? print_learned(*learned) : learned.error().text();
}

Learned learned_of(const std::map<std::string, std::string>& programs) {
  Learned learned;
  for (const auto& [name, acts] : programs)
    if (const auto problem = learned.learn_program(name, Program{term_of(acts)})) FAIL(problem->sentence);
  return learned;
}

// A random list of acts on few things and points.
std::vector<Term> random_acts() {
  const auto pick = [](int below) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, below)); };
  const char* things[] = {"cup", "knife", "v"};
  const char* places[] = {"<0.1, 0, 0>", "<0, 0.2, 0>",       "on(plate)",
                          "on(cup)",     "near(<0.1, 0, 0>)", "box(<0, 0, 0>, <1, 1, 0>)"};
  std::vector<Term> acts;
  for (int i = pick(4); i >= 0; --i) {
    const std::string thing = things[pick(3)];
    switch (pick(4)) {
      case 0:
        acts.push_back(term_of(fmt::format("put({}, {})", thing, places[pick(6)])));
        break;
      case 1:
        acts.push_back(term_of(fmt::format("turn(2, {})", thing)));
        break;
      case 2:
        acts.push_back(term_of("stop"));
        break;
      default:
        acts.push_back(term_of(fmt::format("reach({})", thing)));
    }
  }
  return acts;
}

// The arguments of the acts, in the order in which a program takes them, found in the text.
std::vector<Term> things_and_points(const std::vector<Term>& acts) {
  std::vector<Term> found;
  const auto text = text_of(acts);
  std::vector<std::pair<std::size_t, std::string>> order;
  for (const auto& act : acts)
    for (const auto* thing : {"cup", "knife", "v"})
      for (const auto& begin : {"put({}", "turn(2, {}", "reach({}"})
        if (print(act).starts_with(fmt::format(fmt::runtime(begin), thing))) found.push_back(term_of(thing));
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1))
    if (text.substr(at < 4 ? 0 : at - 4, 4) != "box(" && !text.substr(0, at).ends_with("0>, "))
      found.push_back(term_of(text.substr(at, text.find('>', at) - at + 1)));
  std::vector<Term> distinct;
  for (const auto& each : found)
    if (std::find(distinct.begin(), distinct.end(), each) == distinct.end()) distinct.push_back(each);
  return distinct;
}

Result<std::vector<Term>> applied_to(const Program& program, const std::vector<Term>& arguments) {
  std::vector<Application> made;
  return applied(program, arguments, made);
}

Result<std::vector<Term>> acts_of(const Learned& learned, const Term& act) {
  std::vector<Application> made;
  return learned.acts_of(act, made);
}

}  // namespace

TEST_CASE("acts become a program of what they were done to and of the points they name") {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"[grasp(cup), put(cup, <0.1, 0, 0>)]", "\\x: e. \\v: loc. [grasp(x), put(x, v)]"},
      {"[grasp(cup), lift(cup)]", "\\x: e. [grasp(x), lift(x)]"},
      {"[put(knife, on(plate))]", "\\x: e. [put(x, on(plate))]"},
      {"[put(knife, on(plate)), grasp(plate)]", "\\x: e. \\y: e. [put(x, on(y)), grasp(y)]"},
      {"[put(cup, <1, 0, 0>), put(knife, <0, 1, 0>), put(cup, <0, 1, 0>)]",
       "\\x: e. \\y: e. \\v: loc. \\w: loc. [put(x, v), put(y, w), put(x, w)]"},
      {"[put(cup, near(<1, 0, 0>)), put(cup, box(<0, 0, 0>, <1, 0, 0>))]",
       "\\x: e. \\v: loc. [put(x, near(v)), put(x, box(<0, 0, 0>, <1, 0, 0>))]"},
      {"[turn(2, cup), reach(knife), stop]", "\\x: e. \\y: e. [turn(2, x), reach(y), stop]"},
      {"[stop]", "[stop]"},
      {"[hoist(cup), put(cup, on(plate))]", "\\x: e. [hoist(x), put(x, on(plate))]"},
      {"[put(cup, on(v)), put(cup, <1, 0, 0>)]", "\\x: e. \\v1: loc. [put(x, on(v)), put(x, v1)]"},
      {"[]", "nothing was done; expected one act or more"},
      {"[null]", "found null, expected an act that lacks nothing"},
      {"[put(cup)]", "found put(cup), expected an act that lacks nothing"},
      {"[\\y. grasp(y)]", "found \\y. grasp(y), expected an act that lacks nothing"},
      {"[cup]", "found cup, expected an act that lacks nothing"},
      {"[grasp(cup), grasp(knife), grasp(plate), grasp(block)]", "found 4 things acted on, expected at most 3"},
      {"[put(cup, <1, 0, 0>), put(cup, <2, 0, 0>), put(cup, <3, 0, 0>)]", "found 3 points, expected at most 2"},
  };
  for (const auto& [acts, expected] : rows) {
    CAPTURE(acts);
    CHECK(composed_text(acts) == expected);
  }
  CHECK_FALSE(composed(std::vector<Term>(most_acts + 1, term_of("stop"))).ok());
}

TEST_CASE("a program does its acts with other things and places, and with no fewer, more or others") {
  const auto program = composed(terms("[grasp(cup), put(cup, <0.1, 0, 0>)]")).value();
  CHECK(program.type().text() == "e -> loc -> t");
  CHECK(text_of(applied_to(program, each_of({"knife", "on(plate)"}))) == "grasp(knife); put(knife, on(plate))");
  CHECK(text_of(applied_to(program, each_of({"knife"}))) == "found 1 arguments, expected 2");
  CHECK(text_of(applied_to(program, each_of({"knife", "plate"}))) == "found plate, expected an argument of type loc");
  CHECK(text_of(applied_to(program, each_of({"null", "<1, 0, 0>"}))) == "found null, expected an argument of type e");
}

TEST_CASE("laws of composed acts") {
  law("composed, then applied to the same things and points, they are the same acts", [] {
    const auto acts = random_acts();
    const auto program = composed(acts);
    RC_PRE(program.ok());
    const auto again = applied_to(*program, things_and_points(acts));
    RC_ASSERT(text_of(again) == text_of(acts));
  });
  law("what is printed is read as it was", [] {
    Learned learned;
    learned.gestures.emplace("a claw", random_acts().front());
    const auto program = composed(random_acts());
    if (program) learned.programs.emplace("do \"it\"", *program);
    if (program) learned.programs.emplace("put_taught", Program{program->acts, "put"});
    const auto text = print_learned(learned);
    const auto read = parse_learned(text, "l.json", names());
    RC_ASSERT(read.ok());
    RC_ASSERT(*read == learned);
    RC_ASSERT(print_learned(*read) == text);
    for (const auto& [name, one] : read->programs) RC_ASSERT(one.type() == learned.programs.at(name).type());
  });
}

TEST_CASE("programs may use programs, but not in a circle") {
  auto learned =
      learned_of({{"hoist", "\\x: e. [grasp(x), lift(x)]"}, {"fetch", "\\x: e. \\v: loc. [hoist(x), put(x, v)]"}});
  CHECK(text_of(acts_of(learned, term_of("fetch(cup, on(plate))"))) == "grasp(cup); lift(cup); put(cup, on(plate))");
  CHECK(text_of(acts_of(learned, term_of("grasp(cup)"))) == "grasp(cup)");
  CHECK(text_of(acts_of(learned, term_of("fetch(cup)"))) == "found 1 arguments, expected 2 in fetch(cup)");
  const auto before = learned;
  const auto circle = learned.learn_program("hoist", Program{term_of("\\x: e. [fetch(x, <1, 0, 0>)]")});
  REQUIRE(circle);
  CHECK(circle->sentence == "what 'hoist' stands for leads back to itself");
  CHECK(learned.learn_program("hoist", Program{term_of("\\x: e. [hoist(x)]")}));
  CHECK(learned == before);
  CHECK_FALSE(learned.learn_program("hoist", Program{term_of("\\x: e. [lift(x)]")}));
  CHECK(text_of(acts_of(learned, term_of("hoist(cup)"))) == "lift(cup)");
}

TEST_CASE("the applications of taught programs are told, the outer ones first") {
  const auto learned =
      learned_of({{"hoist", "\\x: e. [grasp(x), lift(x)]"}, {"fetch", "\\x: e. \\v: loc. [hoist(x), put(x, v)]"}});
  std::vector<Application> made;
  REQUIRE(learned.acts_of(term_of("fetch(cup, on(plate))"), made).ok());
  std::string told;
  for (const auto& each : made)
    told += fmt::format("{} @ {} = {}\n", print(each.function), print(each.argument), print(each.result));
  CHECK(told ==
        "\\x v. [hoist(x), put(x, v)] @ cup = \\v. [hoist(cup), put(cup, v)]\n"
        "\\v. [hoist(cup), put(cup, v)] @ on(plate) = [hoist(cup), put(cup, on(plate))]\n"
        "\\x. [grasp(x), lift(x)] @ cup = [grasp(cup), lift(cup)]\n");
}

TEST_CASE("an act that comes to very many is refused within a moment") {
  Learned learned;
  learned.programs.emplace("p0", Program{term_of("[stop, stop]")});
  for (int i = 1; i < 60; ++i) {
    const auto other = Term::constant(fmt::format("p{}", i - 1), Type::truth());
    CHECK_FALSE(learned.learn_program(fmt::format("p{}", i), Program{Term::list({other, other}, Type::truth())}));
  }
  CHECK(text_of(acts_of(learned, Term::constant("p59", Type::truth()))) == "p59 comes to more than 1000 acts");
  CHECK(acts_of(learned, Term::constant("p7", Type::truth()))->size() == 256);
}

TEST_CASE("the file of what was learned has one form") {
  const std::string text = R"json({
  "learned": 1,
  "gestures": {
    "claw": {
      "means": "grasp(cup)"
    }
  },
  "programs": {
    "fetch it": {
      "acts": "\\x: e. \\v: loc. [lug(x), put(x, v)]"
    },
    "lug": {
      "acts": "\\x: e. [grasp(x), lift(x)]"
    }
  }
}
)json";
  CHECK(learned_text(text) == text);
  const auto learned = parse_learned(text, "l.json", names()).value();
  CHECK(learned.programs.at("fetch it").type().text() == "e -> loc -> t");
  CHECK(learned.gestures.at("claw").argument().type() == Type::entity());
  // Objects that are nowhere now, and programs before those that they use.
  CHECK(learned_text(R"({"learned":1,"gestures":{"g":{"means":"vase"}}})").find("\"means\": \"vase\"") !=
        std::string::npos);
}

TEST_CASE("what is wrong with a file of what was learned is told with its place") {
  const auto acts = [](const std::string& term) {
    return R"({"learned":1,"programs":{"p":{"acts":")" + term + "\"}}}";
  };
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "l.json:1:1: the file is empty; expected a JSON document"},
      {"[]", "l.json:1:1: found a list, expected what was learned, an object"},
      {"{}", "l.json:1:1: there is no \"learned\"; expected 1, the version of the format"},
      {R"({"learned":2})", "l.json:1:12: found 2, expected 1, the version of the format"},
      {R"({"learned":1,"gesture":{}})",
       "l.json:1:14: unknown key 'gesture' of what was learned (did you mean 'gestures'?)"},
      {R"({"learned":1,"gestures":[]})", "l.json:1:25: found a list, expected gestures, an object"},
      {R"({"learned":1,"gestures":{"g":{}}})", "l.json:1:30: there is no \"means\"; expected a term"},
      {R"({"learned":1,"gestures":{"g":{"means":1}}})", "l.json:1:39: found 1, expected a term, a string"},
      {R"json({"learned":1,"gestures":{"g":{"means":"grasp(1)"}}})json", "l.json:1:46: 'grasp' takes e, found num"},
      {R"({"learned":1,"gestures":{"g":{"means":"null"}}})",
       "l.json:1:39: found null, expected what the gesture means"},
      {R"({"learned":1,"gestures":{"g":{"means":"a"},"g":{"means":"b"}}})",
       "l.json:1:44: the key 'g' a second time in this object"},
      {acts("grasp(cup)"),
       "l.json:1:38: found 'grasp(cup)', expected acts such as \\x: e. \\v: loc. [grasp(x), put(x, v)]"},
      {acts("[]"), "l.json:1:38: found '[]', expected acts such as \\x: e. \\v: loc. [grasp(x), put(x, v)]"},
      {acts("[cup]"), "l.json:1:38: found '[cup]', expected acts such as \\x: e. \\v: loc. [grasp(x), put(x, v)]"},
      {acts("[p]"), "l.json:1:38: what 'p' stands for leads back to itself"},
  };
  for (const auto& [text, expected] : rows) {
    CAPTURE(text);
    CHECK(learned_text(text) == expected);
  }
}

TEST_CASE("taught nouns are written and read back") {
  const std::string text = R"json({
  "learned": 1,
  "gestures": {},
  "programs": {},
  "nouns": {
    "bob": {
      "means": "\\x. x = block1"
    }
  }
}
)json";
  CHECK(learned_text(text) == text);
  CHECK(parse_learned(text, "l.json", names()).value().knows("bob"));
  CHECK(learned_text(R"({"learned":1,"nouns":{"bob":{"means":"block1"}}})") ==
        "l.json:1:38: found 'block1', expected a condition such as \\x. x = block1");
}
