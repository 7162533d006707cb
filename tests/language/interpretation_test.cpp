#include "continua/language/interpretation.h"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/term/raising_file.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

ObjectState thing(const std::string& name, std::map<std::string, std::string> attributes, double x, double y) {
  ObjectState object;
  object.name = name;
  object.attributes = std::move(attributes);
  object.half_extents_m = {0.03, 0.03, 0.03};
  object.p_WO = {x, y, 0.03};
  return object;
}

WorldSnapshot table_with_things() {
  WorldSnapshot world;
  world.objects = {thing("plate", {{"type", "plate"}, {"affords", "on"}}, -0.3, 0),
                   thing("knife", {{"type", "knife"}}, 0.3, 0.2),
                   thing("cup1", {{"type", "cup"}, {"color", "blue"}, {"affords", "in"}}, 0.3, -0.2),
                   thing("cup2", {{"type", "cup"}, {"color", "red"}, {"affords", "in"}}, 0, -0.2),
                   thing("block1", {{"type", "block"}, {"color", "red"}}, 0, 0.2),
                   thing("block2", {{"type", "block"}, {"color", "red"}}, -0.3, 0.2),
                   thing("block3", {{"type", "block"}, {"color", "green"}}, 0.15, 0.2)};
  return world;
}

Signature names_of_readings() {
  Signature names = term_signature();
  const auto add = [&](const char* type, std::initializer_list<const char*> all) {
    for (const char* name : all) names.emplace(name, Type::parse(type).value());
  };
  add("(e -> t) -> e", {"the", "a", "that", "another"});
  add("(e -> t) -> e*", {"those", "all", "two", "the_two"});
  add("e", {"it", "this", "you", "me", "plate", "knife"});
  add("e*", {"them"});
  add("loc", {"there"});
  add("term", {"whatever"});
  add("e -> t", {"one", "plate_", "knife_", "cup", "block", "red", "green", "blue", "grasp", "lift", "what"});
  add("(e -> t) -> t", {"which"});
  add("e -> loc", {"on", "in", "at", "beside"});
  add("e -> e -> loc", {"between"});
  add("e -> loc -> t", {"put", "near"});
  add("e -> text -> text", {"attribute"});
  add("e -> text -> t", {"affords"});
  add("t", {"stop"});
  return names;
}

Operators words_with_context() {
  Operators words;
  const auto definite = [](bool many, bool deictic, int count) {
    Determiner determiner;
    determiner.definite = true;
    determiner.many = many;
    determiner.deictic = deictic;
    determiner.count = count;
    return determiner;
  };
  words.determiners = {{"the", definite(false, false, 0)},    {"that", definite(false, true, 0)},
                       {"those", definite(true, true, 0)},    {"all", definite(true, false, 0)},
                       {"the_two", definite(true, false, 2)}, {"a", Determiner()}};
  words.determiners["two"].count = 2;
  words.determiners["another"].other = true;
  using Source = Proform::Source;
  words.proforms = {{"it", {Source::focus}},     {"them", {Source::focus}}, {"there", {Source::pointed}},
                    {"this", {Source::pointed}}, {"one", {Source::topic}},  {"you", {Source::avatar}},
                    {"me", {Source::human}}};
  return words;
}

// A small world, and the language for utterances in it.
struct Scene {
  WorldSnapshot world = table_with_things();
  Signature names = names_of_readings();
  Operators operators = words_with_context();
  std::map<std::string, Term> definitions;
  Rules facts;
  RaisingRules raising = load_raising(source_dir() + "/engine/knowledge/raising.json", names).value();
  Context context;

  Scene() {
    context.facts.world = &world;
    for (const char* type : {"cup", "block"}) define(type, fmt::format("\\x. attribute(x, 'type') = '{}'", type));
    define("plate_", "\\x. attribute(x, 'type') = 'plate'");
    define("knife_", "\\x. attribute(x, 'type') = 'knife'");
    for (const char* color : {"red", "green", "blue"})
      define(color, fmt::format("\\x. attribute(x, 'color') = '{}'", color));
    facts["attribute"] = {2, [this](auto a, Evaluation&) {
                            const auto* object = world.find(a[0].name());
                            if (!object) return Term::null();
                            const auto found = object->attributes.find(a[1].text_value());
                            return found == object->attributes.end() ? Term::null() : Term::text(found->second);
                          }};
    facts["affords"] = {2, [this](auto a, Evaluation&) {
                          const auto* object = world.find(a[0].name());
                          return Term::truth(object && object->attributes.contains("affords") &&
                                             object->attributes.at("affords") == a[1].text_value());
                        }};
    facts["near"] = {2, [this](auto a, Evaluation&) {
                       const auto *one = world.find(a[0].name()), *other = world.find(a[1].argument().name());
                       return Term::truth(one && other && (one->p_WO - other->p_WO).norm() < 0.2);
                     }};
  }

  void define(const std::string& name, const std::string& text) {
    definitions.emplace(name, parse_term(text, names).value());
  }

  Term read(const std::string& text) const {
    INFO(text);
    const auto term = parse_term(text, names);
    if (!term) FAIL(term.error().text());
    return *term;
  }

  Interpretation interpreted(const Reading& reading, const std::vector<std::string>& words = {}) const {
    const RuleTable rules({&term_rules(), &facts});
    const Meanings meanings{&rules,
                            [this](Name name) {
                              const auto found = definitions.find(name.text());
                              return found == definitions.end() ? nullptr : &found->second;
                            },
                            &operators};
    return interpret(reading, words, context, meanings, raising);
  }
  Interpretation interpreted(const std::string& text) const {
    Reading reading;
    reading.term = read(text);
    return interpreted(reading);
  }
};

const char* const reasons[] = {"unsaid", "several", "none"};
const char* const sources[] = {"words", "focus", "pointed", "topic", "presence"};

// "several e [cup1, cup2] 'cup'"
std::string text_of(const Gap& gap) {
  std::string text = fmt::format("{} {}", reasons[static_cast<int>(gap.why)], gap.type.text());
  if (!gap.choices.empty()) text += fmt::format(" [{}]", fmt::join(gap.choices, ", "));
  if (!gap.words.empty()) text += fmt::format(" '{}'", gap.words);
  return text;
}

// "\x. grasp(x) | several e [cup1, cup2]"
std::string meaning_of(const Interpretation& interpretation) {
  std::string text = print(interpretation.meaning);
  for (const auto& gap : interpretation.gaps) text += " | " + text_of(gap);
  return text;
}

// "on @ plate = on(plate)", with the rule, and the inputs that it draws on.
std::vector<std::string> applied(const Interpretation& interpretation) {
  std::vector<std::string> texts;
  for (const auto& [application, by] : interpretation.applied) {
    std::vector<std::string> names;
    for (const auto each : by) names.emplace_back(sources[static_cast<int>(each)]);
    texts.push_back(fmt::format("{} @ {} = {}{}{}", print(application.function), print(application.argument),
                                print(application.result), application.rule.empty() ? "" : " by " + application.rule,
                                names.empty() ? "" : fmt::format(" ({})", fmt::join(names, ", "))));
  }
  return texts;
}

std::string resolutions(const Interpretation& interpretation) {
  std::vector<std::string> texts;
  for (const auto& each : interpretation.resolutions)
    texts.push_back(
        fmt::format("{} = {} by {}", print(each.phrase), print(each.value), sources[static_cast<int>(each.by)]));
  return fmt::to_string(fmt::join(texts, "; "));
}

}  // namespace

TEST_CASE("noun phrases give what they mean to the rest of the sentence") {
  const Scene scene;
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"put(the(\\x. knife_(x)), in(the(\\x. blue(x) and cup(x))))", "put(knife, in(cup1))"},
      {"in(the(\\x. blue(x) and cup(x)))", "in(cup1)"},
      {"the(\\x. plate_(x))", "plate"},
      {"the(plate_)", "plate"},
      {"what(the(\\x. cup(x) and red(x)))", "what(cup2)"},
      {"stop", "stop"},
      {"put(plate, at(plate))", "put(plate, at(plate))"},
      {"grasp(the(\\x. block(x) and near(x, beside(the(\\y. block(y) and green(y))))))", "grasp(block1)"},
      {"put(you, beside(me))", "put(avatar, beside(human))"},
      // open ones: the reading's own, under any names
      {"\\v. put(the(\\x. knife_(x)), v)", "\\v. put(knife, v) | unsaid loc"},
      {"\\b v. put(b, v)", "\\b v. put(b, v) | unsaid e | unsaid loc"},
      {"put", "\\x v. put(x, v) | unsaid e | unsaid loc"},
      {"\\plate. put(plate, on(the(plate_)))", "\\plate'. put(plate', on(plate)) | unsaid e"},
      // none, several
      {"the(\\x. plate_(x) and blue(x))", "\\x. x | none e"},
      {"the(\\x. cup(x))", "\\x. x | several e [cup1, cup2]"},
      {"grasp(the(\\x. cup(x)))", "\\x. grasp(x) | several e [cup1, cup2]"},
      {"grasp(a(\\x. cup(x)))", "grasp(cup1)"},
      {"grasp(a(\\x. cup(x) and green(x)))", "\\x. grasp(x) | none e"},
      // the destination is found before the theme, and both before the gaps of the reading
      {"put(the(\\x. cup(x)), on(the(\\x. block(x) and red(x))))",
       "\\x' x. put(x', on(x)) | several e [cup1, cup2] | several e [block1, block2]"},
      {"\\v. put(the(\\x. cup(x)), v)", "\\x v. put(x, v) | several e [cup1, cup2] | unsaid loc"},
      // a noun without determiner is any
      {"cup", "\\x. x | several e [cup1, cup2]"},
      {"\\x. cup(x) and blue(x)", "cup1"},
      {"\\x. cup(x) and green(x)", "\\x. x | none e"},
      {"grasp", "\\x. grasp(x) | unsaid e"},
      // phrases inside of lambdas
      {"which(\\x. block(x) and near(x, beside(the(\\y. plate_(y)))))",
       "which(\\x. block(x) and near(x, beside(plate)))"},
      {"which(\\x. near(x, beside(the(\\y. near(y, beside(x))))))",
       "which(\\x. near(x, beside(the(\\y. near(y, beside(x))))))"},
  };
  for (const auto& [reading, meaning] : rows) {
    INFO(reading);
    CHECK(meaning_of(scene.interpreted(reading)) == meaning);
  }
}

TEST_CASE("pro-forms mean what is talked about, shown or present, or nothing yet") {
  Scene scene;
  CHECK(meaning_of(scene.interpreted("put(it, there)")) == "\\x v. put(x, v) | unsaid e | unsaid loc");
  CHECK(meaning_of(scene.interpreted("put(it, beside(it))")) == "\\x. put(x, beside(x)) | unsaid e");
  CHECK(meaning_of(scene.interpreted("them")) == "\\x. x | unsaid e*");
  scene.context.focus = {"cup1", "knife"};
  CHECK(meaning_of(scene.interpreted("put(it, there)")) == "\\v. put(cup1, v) | unsaid loc");
  CHECK(meaning_of(scene.interpreted("them")) == "[cup1, knife]");
  CHECK(meaning_of(scene.interpreted("grasp(another(\\x. cup(x)))")) == "grasp(cup2)");
  scene.context.pointed_W = Vec3(0.1, 0.2, 0);
  const auto both = scene.interpreted("put(it, there)");
  CHECK(meaning_of(both) == "put(cup1, <0.1, 0.2, 0>)");
  CHECK(resolutions(both) == "there = <0.1, 0.2, 0> by pointed; it = cup1 by focus");
  scene.context.pointed_W = Vec3(0.3, -0.2, 0);
  CHECK(meaning_of(scene.interpreted("grasp(this)")) == "grasp(cup1)");
}

TEST_CASE("a deictic determiner, and a noun alone, count pointing, others do not") {
  Scene scene;
  scene.context.pointed_W = Vec3(0.3, -0.2, 0);
  for (const auto* text : {"that(\\x. cup(x))", "cup", "in(that(cup))"}) {
    INFO(text);
    const auto one = scene.interpreted(text);
    CHECK(one.gaps.empty());
    REQUIRE(one.resolutions.size() == 1);
    CHECK(print(one.resolutions[0].value) == "cup1");
    CHECK(one.resolutions[0].by == Resolution::By::pointed);
  }
  CHECK(meaning_of(scene.interpreted("the(\\x. cup(x))")) == "\\x. x | several e [cup1, cup2]");
}

TEST_CASE("one is the first of the nouns used last that has such a thing, or anything") {
  Scene scene;
  CHECK(meaning_of(scene.interpreted("the(\\x. green(x) and one(x))")) == "block3");
  CHECK(meaning_of(scene.interpreted("the(\\x. red(x) and one(x))")) == "\\x. x | several e [cup2, block1, block2]");
  scene.context.topics = {scene.read("\\x. cup(x)")};
  const auto red_cup = scene.interpreted("the(\\x. red(x) and one(x))");
  CHECK(meaning_of(red_cup) == "cup2");
  CHECK(red_cup.resolutions[0].reference.ruled_out.back().reason == "not red(block3)");
  CHECK(meaning_of(scene.interpreted("one")) == "\\x. x | several e [cup1, cup2]");
  scene.context.topics = {scene.read("\\x. knife_(x)"), scene.read("\\x. cup(x)")};
  CHECK(meaning_of(scene.interpreted("the(\\x. red(x) and one(x))")) == "cup2");
  CHECK(meaning_of(scene.interpreted("the(\\x. one(x))")) == "knife");
  scene.context.pointed_W = Vec3(0.3, -0.2, 0);  // at cup1
  CHECK(meaning_of(scene.interpreted("that(\\x. one(x))")) == "cup1");
  scene.context.topics = {scene.read("\\x. knife_(x)")};
  CHECK(meaning_of(scene.interpreted("that(\\x. one(x))")) == "cup1");
  scene.context.pointed_W.reset();
  CHECK(meaning_of(scene.interpreted("the(\\x. green(x) and one(x))")) == "block3");  // there is no green knife
  // the left one is one of several
  scene.context.topics = {scene.read("\\x. plate_(x)"), scene.read("\\x. knife_(x) or cup(x)")};
  CHECK(meaning_of(scene.interpreted("the(\\x. contains(filter([knife, plate], \\y. one(y)), x))")) == "knife");
  scene.context.topics = {scene.read("\\x. knife_(x) and green(x)")};
  CHECK(meaning_of(scene.interpreted("the(\\x. one(x))")) == "\\x. x | none e");
  scene.context.among = {"block1", "block3"};
  CHECK(meaning_of(scene.interpreted("the(\\x. red(x) and one(x))")) == "block1");
}

TEST_CASE("an answer may name something that was not asked about") {
  Scene scene;
  scene.context.among = {"block1", "block2"};
  CHECK(meaning_of(scene.interpreted("the(\\x. block(x))")) == "\\x. x | several e [block1, block2]");
  CHECK(meaning_of(scene.interpreted("grasp(the(plate_))")) == "grasp(plate)");
}

TEST_CASE("that, with nothing pointed at, is what is talked about, or open") {
  Scene scene;
  CHECK(meaning_of(scene.interpreted("grasp(that(\\x. true))")) == "\\x. grasp(x) | unsaid e");
  CHECK(meaning_of(scene.interpreted("grasp(each(those(\\x. true)))")) == "\\x. grasp(x) | unsaid e");
  scene.context.focus = {"cup2"};
  CHECK(meaning_of(scene.interpreted("grasp(that(\\x. true))")) == "grasp(cup2)");
}

TEST_CASE("several objects are a list, or a command for each") {
  Scene scene;
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"all(\\x. block(x))", "[block1, block2, block3]"},
      {"grasp(each(all(\\x. block(x) and red(x))))", "[grasp(block1), grasp(block2)]"},
      {"put(each(all(\\x. block(x) and red(x))), on(the(plate_)))", "[put(block1, on(plate)), put(block2, on(plate))]"},
      {"put(each(all(cup)), on(each(the_two(\\x. block(x) and red(x)))))",
       "[put(cup1, on(block1)), put(cup2, on(block1)), put(cup1, on(block2)), put(cup2, on(block2))]"},
      {"put(the(cup), on(each(all(\\x. block(x) and red(x)))))",
       "\\x. [put(x, on(block1)), put(x, on(block2))] | several e [cup1, cup2]"},
      {"\\v. put(each(all(cup)), v)", "\\v. [put(cup1, v), put(cup2, v)] | unsaid loc"},
      {"grasp(each([the(knife_), the(plate_)]))", "[grasp(knife), grasp(plate)]"},
      {"two(block)", "[block1, block2]"},
      {"the_two(block)", "\\x. x | several e* [block1, block2, block3]"},
      {"two(plate_)", "\\x. x | none e*"},
      {"grasp(each(two(plate_)))", "\\x. grasp(x) | none e"},
      {"each(all(cup))", "[cup1, cup2]"},
  };
  for (const auto& [reading, meaning] : rows) {
    INFO(reading);
    CHECK(meaning_of(scene.interpreted(reading)) == meaning);
  }
}

TEST_CASE("any one is rather one that the command does not name otherwise") {
  Scene scene;
  scene.context.focus = {"block1"};
  CHECK(meaning_of(scene.interpreted("grasp(a(block))")) == "grasp(block1)");
  CHECK(meaning_of(scene.interpreted("put(a(block), on(it))")) == "put(block2, on(block1))");
  CHECK(meaning_of(scene.interpreted("[grasp(it), grasp(a(block))]")) == "[grasp(block1), grasp(block1)]");
}

TEST_CASE("what a command speaks of is in focus for the next") {
  Scene scene;
  scene.context.focus = {"block1"};
  CHECK(meaning_of(scene.interpreted("[grasp(the(knife_)), put(it, on(the(plate_))), lift(it)]")) ==
        "[grasp(knife), put(knife, on(plate)), lift(knife)]");
  CHECK(meaning_of(scene.interpreted("put(it, on(the(plate_)))")) == "put(block1, on(plate))");
}

TEST_CASE("every application is kept, the argument's before the function's, with what it draws on") {
  Scene scene;
  scene.context.focus = {"knife"};
  CHECK(applied(scene.interpreted("put(it, in(the(\\x. blue(x) and cup(x))))")) ==
        std::vector<std::string>{"in @ cup1 = in(cup1) (words)", "put @ knife = put(knife) (focus)",
                                 "put(knife) @ in(cup1) = put(knife, in(cup1)) (focus, words)"});
  CHECK(applied(scene.interpreted("grasp(each(all(cup)))")) ==
        std::vector<std::string>{"grasp @ cup1 = grasp(cup1) (words)", "grasp @ cup2 = grasp(cup2) (words)"});
  CHECK(applied(scene.interpreted("grasp(the(cup))")) == std::vector<std::string>{"grasp @ x = grasp(x)"});
  CHECK(resolutions(scene.interpreted("put(the(cup), on(you))")) ==
        "you = avatar by presence; the(cup) = null by words");
}

TEST_CASE("an argument of another type is raised") {
  Scene scene;
  scene.names.insert_or_assign("it", Type::term());
  scene.context.focus = {"cup1"};
  const auto raised_it = scene.interpreted("put(plate, it)");
  CHECK(meaning_of(raised_it) == "put(plate, in(cup1))");
  CHECK(applied(raised_it).back() == "put(plate) @ cup1 = put(plate, in(cup1)) by object_to_place_in (focus)");
  CHECK(meaning_of(scene.interpreted("which(it)")) == "null");
}

TEST_CASE("gaps and resolutions tell the words") {
  const Scene scene;
  Reading reading;
  reading.term = scene.read("grasp(the(\\x. blue(x) and plate_(x)))");
  reading.phrases = {{reading.term.argument(), {1, 4}}, {reading.term.argument().argument(), {2, 4}}};
  const std::vector<std::string> words = {"grasp", "the", "blue", "plate"};
  const auto one = scene.interpreted(reading, words);
  CHECK(meaning_of(one) == "\\x. grasp(x) | none e 'blue plate'");
  CHECK(one.resolutions[0].words == "the blue plate");
  reading.phrases[0].words = {7, 9};  // not of this utterance
  CHECK(scene.interpreted(reading, words).resolutions[0].words.empty());
}

TEST_CASE("several objects that the words name once are the same ones wherever the reading has them") {
  const Scene scene;
  Reading reading;
  reading.term = scene.read("put(each(all(\\x. block(x) and red(x))), on(each(all(\\x. block(x) and red(x)))))");
  reading.phrases = {{scene.read("all(\\x. block(x) and red(x))"), {1, 4}}};
  CHECK(meaning_of(scene.interpreted(reading, {"stack", "the", "red", "blocks"})) ==
        "[put(block1, on(block1)), put(block2, on(block2))]");
}

TEST_CASE("a reading that finds something is preferred") {
  const Scene scene;
  const auto none = scene.interpreted("the(\\x. cup(x) and green(x))"), several = scene.interpreted("the(cup)");
  CHECK(preferred({none, several}) == 1);
  CHECK(preferred({several, none}) == 0);
  CHECK(preferred({none, none}) == 0);
  CHECK(preferred({}) == 0);
  auto loose = several, rough = several;
  loose.resolutions.front().reference.sides = Sides::loose;
  rough.resolutions.front().reference.sides = Sides::rough;
  CHECK(preferred({none, loose, rough, several}) == 3);
  CHECK(preferred({loose, rough, rough}) == 1);
  CHECK(preferred({none, loose}) == 1);
}

TEST_CASE("a list that a reading uses in two places stands for each of its things in both") {
  const Scene scene;
  const std::string both = "each([plate, knife])";
  CHECK(meaning_of(scene.interpreted("put(" + both + ", beside(" + both + "))")) ==
        "[put(plate, beside(plate)), put(knife, beside(knife))]");
}

TEST_CASE("what is too much is not interpreted, and ends") {
  Scene scene;
  std::string text = "plate";
  for (int i = 0; i < 20; ++i) text = "the(\\x. near(x, beside(" + text + ")))";
  scene.interpreted("grasp(" + text + ")");
  Reading reading;
  reading.term = scene.read("plate");
  const Term same = scene.read("\\y: e. y");
  for (int i = 0; i < 240; ++i) reading.term = Term::apply(same, reading.term);
  CHECK(scene.interpreted(reading).meaning == scene.read("plate"));
  for (int i = 0; i < 240; ++i) reading.term = Term::apply(same, reading.term);
  CHECK(scene.interpreted(reading).meaning.is_null());
  reading.term = Term::bound(0, Type::entity());
  CHECK(scene.interpreted(reading).meaning.is_null());
  // as many commands as there are triples
  for (int i = 0; i < 20; ++i) scene.world.objects.push_back(thing("more" + std::to_string(i), {}, 0, 0));
  const auto many =
      scene.interpreted("put(each(all(\\x. true)), between(each(all(\\x. true and true)), each(all(\\x. not false))))");
  CHECK(many.gaps.size() == 2);
  CHECK(many.meaning.size() < 5000);
}

}  // namespace continua
