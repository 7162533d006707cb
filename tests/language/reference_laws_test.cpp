#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "support/small_talk.h"

namespace continua {
namespace {

void law(const std::string& what, const auto& property) {
  setenv("RC_PARAMS", "seed=1 max_success=200", 0);
  INFO(what);
  CHECK(rc::check(what, property));
}

int pick(int from, int to) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(from, to + 1)); }

// Up to eight things anywhere on the table, some on top of others, in whole millimetres.
void set_any_table(SmallTalk& talk) {
  const char* types[] = {"block", "plate", "cup"};
  const char* colors[] = {"red", "green"};
  const int count = pick(1, 8);
  for (int i = 0; i < count; ++i) {
    const Vec3 size(pick(20, 150) / 1e3, pick(20, 150) / 1e3, pick(10, 100) / 1e3);
    talk.world.objects.push_back(thing("o" + std::to_string(i), types[pick(0, 2)], colors[pick(0, 1)], size,
                                       pick(-400, 400) / 1e3, pick(-300, 300) / 1e3, pick(0, 4) == 0 ? 0.06 : 0));
  }
  if (pick(0, 1) == 0) talk.context.focus = {"o0"};
}

std::string any_noun() { return std::vector<std::string>{"block", "plate", "cup", "red", "green"}[pick(0, 4)]; }

std::vector<std::string> any_conjuncts(const std::string& x, int depth) {
  static const char* relations[] = {"left", "right", "in_front", "behind", "on", "near", "beside", "touching", "under"};
  std::vector<std::string> parts = {any_noun() + "(" + x + ")"};
  const int count = depth > 0 ? pick(0, 2) : 0;
  for (int i = 0; i < count; ++i) {
    const std::string y = x + "'", other = pick(0, 2) == 0 ? "other(" + y + ")" : "true";
    std::string inner = other;
    for (const auto& each : any_conjuncts(y, depth - 1)) inner += " and " + each;
    parts.push_back("located(" + x + ", " + relations[pick(0, 8)] + "(a(\\" + y + ". " + inner + ")))");
  }
  return parts;
}

std::string phrase(const std::vector<std::string>& parts) {
  std::string text = "the(\\x. true";
  for (const auto& each : parts) text += " and " + each;
  return text + ")";
}

std::string sorted_names(const Reference& reference) {
  std::vector<std::string> names;
  for (const auto& each : reference.referents) names.push_back(each.object);
  std::sort(names.begin(), names.end());
  return std::accumulate(names.begin(), names.end(), std::string());
}

}  // namespace

TEST_CASE("laws of reference") {
  law("the order of conditions does not matter", [] {
    SmallTalk talk;
    set_any_table(talk);
    auto parts = any_conjuncts("x", 2);
    const auto before = sorted_names(talk.refer(phrase(parts)));
    std::reverse(parts.begin(), parts.end());
    RC_ASSERT(sorted_names(talk.refer(phrase(parts))) == before);
    RC_CLASSIFY(!before.empty(), "something fits");
  });

  law("another condition never adds a referent in the same sense, nor makes it a stricter one", [] {
    SmallTalk talk;
    set_any_table(talk);
    auto parts = any_conjuncts("x", 1);
    const auto before = talk.refer(phrase(parts));
    const auto more = any_conjuncts("x", 1);
    parts.insert(parts.end(), more.begin(), more.end());
    const auto after = talk.refer(phrase(parts));
    RC_ASSERT(after.referents.empty() || after.sides >= before.sides);
    for (const auto& each : after.referents)
      RC_ASSERT(after.sides != before.sides ||
                std::any_of(before.referents.begin(), before.referents.end(),
                            [&](const Referent& one) { return one.object == each.object; }));
  });

  law("every object is a referent or ruled out, and shares sum to 1", [] {
    SmallTalk talk;
    set_any_table(talk);
    if (pick(0, 1) == 0) talk.context.pointed_W = Vec3(pick(-400, 400) / 1e3, pick(-300, 300) / 1e3, 0);
    const auto reference = talk.refer((pick(0, 1) == 0 ? "that" : "the") + phrase(any_conjuncts("x", 1)).substr(3));
    RC_ASSERT(reference.referents.size() + reference.ruled_out.size() == talk.world.objects.size());
    double sum = 0;
    for (const auto& each : reference.referents) sum += each.weight;
    RC_ASSERT(reference.referents.empty() || std::abs(sum - 1) < 1e-5);
  });

  law("moving everything by less than half the margin changes nothing", [] {
    SmallTalk talk;
    set_any_table(talk);
    const std::string deictic = pick(0, 1) == 0 ? "that" : "the";
    if (pick(0, 1) == 0) talk.context.pointed_W = Vec3(pick(-400, 400) / 1e3, pick(-300, 300) / 1e3, 0);
    const std::string text = deictic + phrase(any_conjuncts("x", 1)).substr(3);
    const auto before = talk.refer(text);
    // A length changes by twice the motion of its ends, and rounding to the grid moves each by up to half a step.
    const double reach = std::min(before.margin, 0.1) / 2 - position_grid_m;
    RC_PRE(reach > position_grid_m);
    const auto moved = [reach](Vec3 p_W) {
      const double angle = pick(0, 63) / 10.0, length = reach * pick(0, 10) / 10;
      return on_grid(Vec3(p_W + length * Vec3(std::cos(angle), std::sin(angle), 0)));
    };
    for (auto& each : talk.world.objects) each.p_WO = moved(each.p_WO);
    if (talk.context.pointed_W) talk.context.pointed_W = moved(*talk.context.pointed_W);
    RC_ASSERT(names_of(talk.refer(text)) == names_of(before));
    RC_CLASSIFY(!before.referents.empty(), "something fits");
  });
}

}  // namespace continua
