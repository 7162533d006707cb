// The referring expressions of EMRE, understood in the scenes they were made for.
#include <filesystem>
#include <regex>
#include <sstream>

#include "continua/core/located_json.h"
#include "support/folders.h"
#include "support/small_talk.h"

namespace continua {
namespace {

struct Expression {
  Json json;
  std::string modality, focus;
};

std::vector<Expression> read_expressions() {
  const auto path = std::filesystem::path(source_dir()) / "../shared/data/emre/references.jsonl";
  if (!std::filesystem::exists(path)) return {};
  std::istringstream lines(read_file(path.string()).value());
  std::vector<Expression> expressions;
  for (std::string line; std::getline(lines, line);) {
    Json json = parse_json_line(line, "references.jsonl", expressions.size() + 1).value();
    const std::string modality = json["modality"], focus = json["focus"];
    expressions.push_back({std::move(json), modality, focus});
  }
  return expressions;
}

// VoxSim's metres (x to the avatar's right, z toward the human) in W.
Vec3 in_W(double x, double z) { return on_grid({-0.4 * x, -0.4 * z, 0}); }

using Sizes = std::map<std::string, Vec3>;
const Sizes sizes_of_readme = {{"block", {0.06, 0.06, 0.06}},
                               {"plate", {0.108, 0.108, 0.02}},
                               {"cup", {0.046, 0.046, 0.1}},
                               {"knife", {0.022, 0.128, 0.01}}};
// Larger than they can have been.
const Sizes larger = {{"block", {0.06, 0.06, 0.06}},
                      {"plate", {0.2, 0.2, 0.02}},
                      {"cup", {0.08, 0.08, 0.1}},
                      {"knife", {0.024, 0.2, 0.01}}};

std::string noun(const std::string& color, const std::string& type, const std::string& x) {
  return (color.empty() ? "" : color + "(" + x + ") and ") + type + "(" + x + ")";
}

// "The red block right of the cup and behind the other red block." as a term.
std::string term_of(const std::string& sentence) {
  static const std::regex phrase(R"((the|this|that) (?:(red|green|purple) )?(\w+)(.*))");
  static const std::regex relation(
      R"((right of|left of|in front of|behind|touching)( and touching)? the (other )?(?:(red|green|purple) )?(\w+))");
  static const std::map<std::string, std::string> names = {{"right of", "right"},
                                                           {"left of", "left"},
                                                           {"in front of", "in_front"},
                                                           {"behind", "behind"},
                                                           {"touching", "touching"}};
  std::string text = sentence;
  text[0] = static_cast<char>(text[0] + ('a' - 'A'));
  if (text.back() == '.') text.pop_back();
  std::smatch found;
  REQUIRE(std::regex_match(text, found, phrase));
  std::string term = found[1].str() + "(\\x. " + noun(found[2], found[3], "x");
  const std::string rest = found[4];
  for (std::sregex_iterator each(rest.begin(), rest.end(), relation), end; each != end; ++each) {
    const auto& part = *each;
    const std::string landmark =
        "the(\\y. " + (part[3].matched ? std::string("other(y) and ") : "") + noun(part[4], part[5], "y") + ")";
    term += " and located(x, " + names.at(part[1]) + "(" + landmark + "))";
    if (part[2].matched) term += " and located(x, touching(" + landmark + "))";
  }
  const std::string left_over = std::regex_replace(rest, relation, "");
  REQUIRE(std::regex_match(left_over, std::regex("(?: |,|and)*")));
  return term + ")";
}

struct Understood {
  Reference reference;
  std::string focus, id, words;

  bool among() const {
    return std::any_of(reference.referents.begin(), reference.referents.end(),
                       [this](const Referent& each) { return each.object == focus; });
  }
  bool first() const { return !reference.referents.empty() && reference.referents[0].object == focus; }
  bool single() const { return reference.referents.size() == 1; }
};

Understood understood(const Expression& expression, const Sizes& sizes) {
  SmallTalk talk(Perspective::avatar);
  const Json& json = expression.json;
  for (const auto& each : json["objects"]) {
    const std::string type = each["type"];
    const Vec3 p_W = in_W(each["position"][0], each["position"][2]);
    talk.world.objects.push_back(thing(each["name"], type, each.value("color", ""), sizes.at(type), p_W.x(), p_W.y()));
  }
  if (json.contains("deixis")) talk.context.pointed_W = in_W(json["deixis"][0], json["deixis"][1]);
  const std::string words = json["text"];
  return {words.empty() ? refer_to_pointed(talk.context) : talk.refer(term_of(words)), expression.focus, json["id"],
          words};
}

struct Figures {
  double all = 0, single = 0, among = 0, first = 0, wrong = 0;

  void count(const Understood& one) {
    all += 1;
    single += one.single() && one.first();
    wrong += one.single() && !one.first();
    among += one.among();
    first += one.first();
  }
};

}  // namespace

TEST_CASE("what was said and pointed in EMRE means the object that was meant") {
  const auto expressions = read_expressions();
  if (expressions.empty()) {
    WARN("skipped: ../shared/data/emre is absent");
    return;
  }
  // All of it, both halves of it, scene by scene, and all with other sizes.
  for (const int part : {0, 1, 2, 3}) {
    std::map<std::string, Figures> figures;
    for (const auto& each : expressions) {
      if (part % 3 != 0 && each.json["scene"].get<int>() / 2 % 2 != part - 1) continue;
      const auto one = understood(each, part == 3 ? larger : sizes_of_readme);
      INFO(one.id << " '" << one.words << "' means " << one.focus << ", understood as " << names_of(one.reference));
      CHECK_FALSE((one.single() && !one.first()));
      figures[each.modality].count(one);
    }
    INFO("part " << part);
    for (const auto& [modality, of] : figures) {
      INFO(modality << ": of " << of.all << ", single " << of.single << ", among " << of.among << ", first "
                    << of.first);
      CHECK(of.wrong == 0);
      if (modality == "linguistic") {
        CHECK(of.single >= 0.74 * of.all);
        CHECK(of.among >= 0.98 * of.all);
      } else {
        CHECK(of.first >= (modality == "ensemble" ? 0.99 : part % 3 == 0 ? 0.96 : 0.94) * of.all);
      }
    }
  }
}

}  // namespace continua
