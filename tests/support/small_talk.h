// A few words and the world they are said about, to try reference without a lexicon.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "continua/facts/world_facts.h"
#include "continua/language/reference.h"
#include "support/catch.h"

namespace continua {

/// A thing on the table, or higher by `bottom`.
inline ObjectState thing(const std::string& name, const std::string& type, const std::string& color, const Vec3& size_m,
                         double x, double y, double bottom = 0) {
  ObjectState object;
  object.name = name;
  object.attributes["type"] = type;
  if (!color.empty()) object.attributes["color"] = color;
  object.half_extents_m = size_m / 2;
  object.p_WO = on_grid({x, y, bottom + size_m.z() / 2});
  return object;
}

class SmallTalk {
 public:
  explicit SmallTalk(Perspective perspective = Perspective::human)
      : facts_(perspective), rules_({&term_rules(), &facts_.rules()}) {
    world.table = {{-0.6, -0.4, 0}, {0.6, 0.4, 0}};
    context.facts.world = &world;
    names_ = term_signature();
    names_.insert(WorldFacts::signature().begin(), WorldFacts::signature().end());
    const auto declare = [this](std::initializer_list<const char*> names, const char* type) {
      for (const auto* each : names) names_.emplace(each, Type::parse(type).value());
    };
    declare({"left", "right", "in_front", "behind", "on", "in", "at", "near", "beside", "touching", "under"},
            "e -> loc");
    declare({"between"}, "e -> e -> loc");
    declare({"the", "a", "this", "that", "another"}, "(e -> t) -> e");
    declare({"those", "all"}, "(e -> t) -> e*");
    declare({"it", "you", "me", "avatar", "human"}, "e");
    declare({"there"}, "loc");
    declare({"one", "other"}, "e -> t");
    declare({"leftmost"}, "(e -> t) -> e -> t");
    declare({"compared"}, "e*");
    operators_.compared = "compared";
    operators_.determiners = {{"the", {.definite = true}},
                              {"a", {}},
                              {"this", {.definite = true, .deictic = true}},
                              {"that", {.definite = true, .deictic = true}},
                              {"another", {.other = true}},
                              {"those", {.definite = true, .many = true, .deictic = true}},
                              {"all", {.many = true}}};
    using Source = Proform::Source;
    operators_.proforms = {{"it", {Source::focus}},    {"there", {Source::pointed}}, {"one", {Source::topic}},
                           {"other", {Source::other}}, {"you", {Source::avatar}},    {"me", {Source::human}}};
    for (const auto* type : {"block", "plate", "cup", "knife"}) define(type, "type", type);
    for (const auto* color : {"red", "green", "purple", "blue", "white"}) define(color, "color", color);
    definitions_.emplace("compared", read("scene"));
    definitions_.emplace(
        "leftmost", read("\\n x. n(x) and every(filter(compared, n), \\y. offset(y, 'left') <= offset(x, 'left'))"));
  }
  SmallTalk(const SmallTalk&) = delete;

  Term read(const std::string& text) {
    for (const auto& each : world.objects) names_.emplace(each.name, Type::entity());
    auto term = parse_term(text, names_);
    if (!term) FAIL(text << ": " << term.error().text());
    return *term;
  }

  /// For a noun phrase, "the(\x. red(x) and block(x))".
  Reference refer(const std::string& phrase) { return refer(read(phrase)); }
  Reference refer(const Term& phrase) {
    const auto [determiner, arguments] = phrase.spine();
    return continua::refer(arguments.at(0), operators_.determiners.at(determiner.name()), context, meanings());
  }

  Meanings meanings() {
    const auto lookup = [this](Name name) {
      const auto found = definitions_.find(name.text());
      return found == definitions_.end() ? nullptr : &found->second;
    };
    return {&rules_, lookup, &operators_};
  }

  WorldSnapshot world;
  Context context;

 private:
  void define(const std::string& word, const std::string& attribute, const std::string& value) {
    names_.emplace(word, Type::parse("e -> t").value());
    definitions_.emplace(word, read("\\x. attribute(x, '" + attribute + "') = '" + value + "'"));
  }

  WorldFacts facts_;
  RuleTable rules_;
  Signature names_;
  std::map<std::string, Term> definitions_;
  Operators operators_;
};

/// "red_block green_block"
inline std::string names_of(const Reference& reference) {
  std::string names;
  for (const auto& each : reference.referents) names += (names.empty() ? "" : " ") + each.object;
  return names;
}

}  // namespace continua
