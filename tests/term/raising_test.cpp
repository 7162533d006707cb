#include "continua/term/raising.h"
#include "support/folders.h"

#include "continua/term/raising_file.h"
#include "read_terms.h"

namespace continua {
namespace {

const Signature& names() {
  static const Signature all = [] {
    Signature names = test_names();
    const auto add = [&](const char* name, const char* type) { names.emplace(name, Type::parse(type).value()); };
    for (const char* object : {"cup", "knife", "plate"}) add(object, "e");
    add("v", "loc");
    add("in", "e -> loc");
    add("at", "e -> loc");
    add("grasp", "e -> t");
    add("between", "e -> e -> loc");
    add("sweep", "region -> t");
    add("put_anywhere", "e -> term -> t");
    add("true_of", "((e -> t) -> t) -> t");
    add("affords", "e -> text -> t");
    return names;
  }();
  return all;
}

// A cup holds things, a plate carries them; other things have no known affordances.
const Rules& facts() {
  static const Rules rules = {{"affords", {2, [](auto a, Evaluation&) {
                                             const auto &object = a[0].name(), &what = a[1].text_value();
                                             if (object == "cup") return Term::truth(what == "in");
                                             return object == "plate" ? Term::truth(what == "on") : Term::null();
                                           }}}};
  return rules;
}

const RaisingRules& shipped() {
  static const RaisingRules rules = load_raising(source_dir() + "/engine/knowledge/raising.json", names()).value();
  return rules;
}

// "value" or "value by rule" of a text, the rule being that of its last application.
std::string filled(const std::string& text) {
  const RuleTable table({&term_rules(), &facts()}, &shipped());
  Evaluation evaluation(table, nullptr);
  const auto value = print(evaluation.value(read(text, names())));
  const bool any = !evaluation.applications.empty() && !evaluation.applications.back().rule.empty();
  return any ? value + " by " + evaluation.applications.back().rule : value;
}

std::string error_in(const std::string& text) {
  const auto rules = parse_raising(text, "raising.json", names());
  return rules ? "read" : rules.error().text();
}

}  // namespace

TEST_CASE("an argument of another type is raised to the one that is missing") {
  CHECK(filled("fill(\\v. put(knife, v), cup)") == "put(knife, in(cup)) by object_to_place_in");
  CHECK(filled("fill(\\v. put(knife, v), plate)") == "put(knife, on(plate)) by object_to_place_on");
  CHECK(filled("fill(put(knife), block1)") == "put(knife, at(block1)) by object_to_place_at");
  CHECK(filled("fill(\\b. put(b, v), grasp(cup))") == "put(cup, v) by event_to_theme");
  CHECK(filled("fill(grasp, put(cup, on(plate)))") == "grasp(cup) by event_to_theme");
  CHECK(filled("fill(true_of, cup)") == "true_of(\\p. p(cup)) by object_to_properties");
  CHECK(filled("fill(sweep, <0.1, 0, 0>)") == "sweep(box(<0, -0.1, 0>, <0.2, 0.1, 0>)) by point_to_region");
}

TEST_CASE("what fits is not raised") {
  CHECK(filled("fill(\\b. put(b, v), cup)") == "put(cup, v)");
  CHECK(filled("fill(sweep, box(<0, 0, 0>, <1, 1, 0>))") == "sweep(box(<0, 0, 0>, <1, 1, 0>))");
  CHECK(filled("fill(sweep, v)") == "sweep(v)");
  // The paper's figure: objects and a place fill the same command, which takes either.
  CHECK(filled("map([(\\x: term. x)(block1), (\\x: term. x)(block4), (\\x: term. x)(<0.1, 0, 0>)], "
               "fill(\\w. put_anywhere(cup, w)))") ==
        "[put_anywhere(cup, block1), put_anywhere(cup, block4), put_anywhere(cup, <0.1, 0, 0>)]");
}

TEST_CASE("what no rule raises gives null") {
  CHECK(filled("fill(grasp, <0, 0, 0>)") == "null");
  CHECK(filled("fill(put(knife), 3)") == "null");
  CHECK(filled("fill(grasp, true)") == "null");      // no event: no theme
  CHECK(filled("fill(grasp, sweep(v))") == "null");  // its theme is no object
  CHECK(filled("fill(grasp, \\b. put(b, v))") == "null");
  const RuleTable without({&term_rules()});
  Evaluation evaluation(without, nullptr);
  CHECK(evaluation.value(read("fill(put(knife), cup)", names())).is_null());
  CHECK(evaluation.applications.empty());
}

TEST_CASE("an application keeps the argument as it was given") {
  const RuleTable table({&term_rules(), &facts()}, &shipped());
  Evaluation evaluation(table, nullptr);
  evaluation.value(read("fill(put(knife), cup)", names()));
  REQUIRE(evaluation.applications.size() == 1);
  CHECK(evaluation.applications[0].function.type().text() == "loc -> t");
  CHECK(evaluation.applications[0].argument.type().text() == "e");
}

TEST_CASE("the first rule counts whose types fit, whose condition holds and which gives something that fits") {
  const auto rules = parse_raising(R"({ "raising": 1, "rules": [
    { "name": "never", "from": "e", "to": "loc", "when": "\\x. false", "by": "on" },
    { "name": "unknown", "from": "e", "to": "loc", "when": "\\x. null", "by": "on" },
    { "name": "nothing", "from": "e", "to": "loc", "by": "\\x. null" },
    { "name": "other type", "from": "num", "to": "loc", "by": "\\n. <n, n, n>" },
    { "name": "first", "from": "e", "to": "loc", "by": "at" },
    { "name": "second", "from": "e", "to": "loc", "by": "in" } ] })",
                                   "raising.json", names());
  REQUIRE(rules.ok());
  const RuleTable table({&term_rules()});
  Evaluation evaluation(table, nullptr);
  const auto place = raised(read("cup", names()), Type::location(), *rules, evaluation);
  REQUIRE(place.has_value());
  CHECK(place->rule == "first");
  CHECK(print(place->term) == "at(cup)");
  CHECK_FALSE(raised(read("cup", names()), Type::number(), *rules, evaluation).has_value());
}

TEST_CASE("what is wrong in a file of rules is said where it stands") {
  const auto rule = [](const std::string& members) {
    return error_in("{ \"raising\": 1, \"rules\": [\n{ \"name\": \"r\", " + members + " } ] }");
  };
  CHECK(error_in("") == "raising.json:1:1: the file is empty; expected a JSON document");
  CHECK(error_in("[]") == "raising.json:1:1: found a list, expected raising rules, an object");
  CHECK(error_in("{ \"raising\": 2, \"rules\": [] }") ==
        "raising.json:1:14: found 2, expected 1, the version of the format");
  CHECK(error_in("{ \"raising\": 1 }") == "raising.json:1:1: there is no \"rules\"; expected the rules, a list");
  CHECK(error_in("{ \"raising\": 1, \"rules\": 3 }") == "raising.json:1:26: found 3, expected the rules, a list");
  CHECK(error_in("{ \"raising\": 1, \"rule\": [], \"rules\": [] }") ==
        "raising.json:1:17: unknown key 'rule' of raising rules (did you mean 'rules'?)");
  CHECK(error_in("{ \"raising\": 1, \"programs\": { \"up\": \"e -> lok\" }, \"rules\": [] }") ==
        "raising.json:1:43: unknown type 'lok' (did you mean 'loc'?)");
  CHECK(error_in("{ \"raising\": 1, \"programs\": { \"in\": \"e -> e\" }, \"rules\": [] }") ==
        "raising.json:1:37: 'in' is known already, with the type e -> loc");
  CHECK(rule("\"from\": \"e\", \"to\": \"loc\", \"by\": \"on\"") == "read");
  CHECK(rule("\"from\": \"e\", \"to\": \"loc\"") ==
        "raising.json:2:1: there is no \"by\"; expected the function that raises, a term");
  CHECK(rule("\"from\": \"e\", \"to\": \"loc\", \"by\": \"grasp\"") ==
        "raising.json:2:49: found a function from e to t, expected a function from e to loc");
  CHECK(rule("\"from\": \"e\", \"to\": \"loc\", \"by\": \"on\", \"when\": \"\\\\x. x\"") ==
        "raising.json:2:63: found a function from e to e, expected a function from e to t");
  CHECK(rule("\"from\": \"e\", \"to\": \"loc\", \"by\": 3") == "raising.json:2:48: found 3, expected a term, a string");
  CHECK(error_in(R"({ "raising": 1, "rules": [
{ "name": "r", "from": "e", "to": "loc", "by": "on" },
{ "name": "r", "from": "e", "to": "loc", "by": "in" } ] })") == "raising.json:3:11: 'r' is another rule's name");
}

}  // namespace continua
