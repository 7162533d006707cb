#include "continua/facts/world_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "continua/core/random.h"
#include "continua/facts/affordances.h"
#include "continua/facts/formations.h"
#include "continua/learning/learning.h"
#include "continua/term/rules.h"

namespace continua {
namespace {

using Arguments = std::span<const Term>;

constexpr int most_draws = 1000;
// The search for a place: its grid, and the margin by which a relation must hold there.
constexpr double placing_grid_m = 0.01, least_margin_m = 0.004;

Point point_of(const Vec3& p_W) { return {p_W.x(), p_W.y(), p_W.z()}; }
Term point(const Vec3& p_W) { return Term::point(p_W.x(), p_W.y(), p_W.z()); }
Term region(const Box& box_W) { return Term::place({point_of(box_W.min), point_of(box_W.max), true}); }

Box box_of(const Place& place) {
  return {{place.min[0], place.min[1], place.min[2]}, {place.max[0], place.max[1], place.max[2]}};
}

// The margin in metres by which `other` rests on more than `share` of the top of `box`; above 0 if it does.
double resting(const Box& other, const Box& box, double share) {
  const double gap = other.min.z() - box.max.z();
  const double touching = touching_m - std::abs(gap);
  const Vec3 depth = depth_of(other, box);
  const double narrow = std::min(depth.x(), depth.y());
  if (narrow <= 0 || share <= 0) return std::min(touching, narrow);
  const Vec3 size = box.max - box.min;
  const double top = size.x() * size.y();
  return std::min(touching, (depth.x() * depth.y() - share * top) / std::sqrt(top));
}

// Whether a box that stands on the table meets no object except those in `allowed`.
bool is_free(const Box& box, const WorldSnapshot& world, const std::vector<const ObjectState*>& allowed,
             Evaluation& evaluation) {
  bool free = true;
  for (const auto& other : world.objects) {
    if (std::find(allowed.begin(), allowed.end(), &other) != allowed.end()) continue;
    const double overlap = depth_of(box, other.bounds_W()).minCoeff() - touching_m;
    evaluation.note_margin(std::abs(overlap));
    free = free && overlap <= 0;
  }
  return free;
}

Box standing_at(double x, double y, const ObjectState& object, const WorldSnapshot& world) {
  const Box bounds = object.bounds_W();
  const Vec3 size = bounds.max - bounds.min;
  const double floor = world.table.max.z();
  return {{x - size.x() / 2, y - size.y() / 2, floor}, {x + size.x() / 2, y + size.y() / 2, floor + size.z()}};
}

bool inside_table(const Box& box, const Box& table) {
  return box.min.x() >= table.min.x() && box.max.x() <= table.max.x() && box.min.y() >= table.min.y() &&
         box.max.y() <= table.max.y();
}

// A relation to things, or `at` a point or region.
struct Where {
  Relation relation;
  std::vector<Landmark> landmarks;
};

// The world of one evaluation, with the value of each fact.
class View {
 public:
  View(Perspective perspective, const Catalogue* voxemes, Evaluation& evaluation)
      : perspective_(perspective), voxemes_(voxemes), evaluation_(evaluation), world_(evaluation.facts().world) {}

  const ObjectState* object(const Term& entity) const;
  Term scene() const;
  Term table() const { return world_ ? region(world_->table) : Term::null(); }
  Term held() const { return world_ && world_->find(world_->held) ? Term::entity(world_->held) : Term::null(); }
  Term position(const Term& entity) const;
  Term closest(const Term& entity, const Term& place) const;
  Term clear(const Term& entity, double share) const;
  Term fits(const Term& entity, const Term& place, const Term& except) const;
  Term free_place(const Term& entity, const Term& place) const;
  Term as_seen_by(const Term& who, const Term& place) const;
  Term common_place(const Term& entity, const Term& first, const Term& second) const;
  Term located(const Term& entity, const Term& place, Sides sides) const;
  Term affordance(const ObjectState& object, const std::string& what) const;
  Term obstacle(const Term& program) const;
  Term offset(const ObjectState& object, const std::string& side) const;
  Term displaced(const ObjectState& object, const std::string& side, double by_m) const;
  Term is_learned(const std::string& name) const;
  Term meaning_of(const std::string& name) const;

 private:
  std::optional<Landmark> landmark(const Term& term) const;
  std::optional<Where> where(const Term& place) const;

  Perspective perspective_;
  const Catalogue* voxemes_;
  Evaluation& evaluation_;
  const WorldSnapshot* world_;
};

const ObjectState* View::object(const Term& entity) const {
  return world_ && entity.kind() == Term::Kind::constant ? world_->find(entity.name()) : nullptr;
}

Term View::scene() const {
  if (!world_) return Term::null();
  std::vector<Term> objects;
  for (const auto& each : world_->objects) objects.push_back(Term::entity(each.name));
  return Term::list(std::move(objects), Type::entity());
}

Term View::position(const Term& entity) const {
  if (const auto* found = object(entity)) return point(found->p_WO);
  const auto who = world_ && entity.kind() == Term::Kind::constant ? participant_named(entity.name()) : std::nullopt;
  return who ? point(Landmark::participant(*who, world_->table).bounds_W.center()) : Term::null();
}

Term View::closest(const Term& entity, const Term& place) const {
  const auto* found = object(entity);
  if (!found) return Term::null();
  const Box bounds = found->bounds_W();
  const Vec3 p_W = box_of(place.place_value()).center();
  return point(p_W.cwiseMax(bounds.min).cwiseMin(bounds.max));
}

Term View::clear(const Term& entity, double share) const {
  const auto* found = object(entity);
  if (!found) return Term::null();
  const Box bounds = found->bounds_W();
  bool clear = true;
  for (const auto& other : world_->objects) {
    if (&other == found) continue;
    const double by = resting(other.bounds_W(), bounds, share);
    evaluation_.note_margin(std::abs(by));
    clear = clear && by <= 0;
  }
  return Term::truth(clear);
}

Term View::fits(const Term& entity, const Term& place, const Term& except) const {
  const auto* found = object(entity);
  if (!found) return Term::null();
  std::vector<const ObjectState*> allowed = {found};
  for (const auto& each : except.elements()) allowed.push_back(object(each));
  const Vec3 p_W = box_of(place.place_value()).center();
  return Term::truth(is_free(standing_at(p_W.x(), p_W.y(), *found, *world_), *world_, allowed, evaluation_));
}

Term View::free_place(const Term& entity, const Term& place) const {
  const auto* found = object(entity);
  Random* random = evaluation_.facts().random;
  if (!found || !random) return Term::null();
  const Box region_W = box_of(place.place_value());
  const Vec3 size = region_W.max - region_W.min;
  for (int draw = 0; draw < most_draws && evaluation_.spend(1); ++draw) {
    const double x = region_W.min.x() + random->uniform() * size.x();
    const double y = region_W.min.y() + random->uniform() * size.y();
    if (is_free(standing_at(x, y, *found, *world_), *world_, {found}, evaluation_))
      return Term::point(x, y, region_W.center().z());
  }
  return Term::null();
}

std::optional<Landmark> View::landmark(const Term& term) const {
  if (term.kind() == Term::Kind::place) return Landmark::place(box_of(term.place_value()));
  if (term.kind() != Term::Kind::constant) return std::nullopt;
  return Landmark::named(term.name(), *world_);
}

// `place` is a point or region, or a relation to landmarks: left(plate), between(block1, <0, 0, 0>).
std::optional<Where> View::where(const Term& place) const {
  if (!world_) return std::nullopt;
  if (place.kind() == Term::Kind::place) return Where{Relation::at, {Landmark::place(box_of(place.place_value()))}};
  const auto [head, arguments] = place.spine();
  const auto relation = head.kind() == Term::Kind::constant ? relation_named(head.name()) : std::nullopt;
  if (!relation || arguments.size() != landmarks_of(*relation)) return std::nullopt;
  Where where{*relation, {}};
  for (const auto& each : arguments) {
    auto named = landmark(each);
    if (!named) return std::nullopt;
    where.landmarks.push_back(*std::move(named));
  }
  return where;
}

Term View::located(const Term& entity, const Term& place, Sides sides) const {
  const auto* found = object(entity);
  const auto at = where(place);
  if (!found || !at) return Term::null();
  const double by = holds_by(at->relation, *found, at->landmarks, world_->table, perspective_, sides);
  evaluation_.note_margin(std::abs(by));
  return Term::truth(by > 0);
}

// Human and avatar face each other: left of a thing for one is right of it for the other.
Term View::as_seen_by(const Term& who, const Term& place) const {
  const auto at = where(place);
  const auto viewer = who.kind() == Term::Kind::constant ? participant_named(who.name()) : std::nullopt;
  if (!at || !viewer) return Term::null();
  if (!is_side(at->relation) || at->landmarks.front().who || *viewer == perspective_) return place;
  const auto [head, arguments] = place.spine();
  return Term::apply(Term::constant(name_of(opposite(at->relation)), head.type()), arguments[0]);
}

// The point on a grid of the table, nearest to the middle between the landmarks, where the object would be at both
// places. Sides are as exact as possible.
Term View::common_place(const Term& entity, const Term& first, const Term& second) const {
  const auto* found = object(entity);
  const auto a = where(first), b = where(second);
  if (!found || !a || !b) return Term::null();
  const Vec3 middle = (a->landmarks.front().bounds_W.center() + b->landmarks.front().bounds_W.center()) / 2;
  const Box& table = world_->table;
  ObjectState there = *found;
  for (const auto sides : {Sides::exact, Sides::rough, Sides::loose}) {
    std::optional<Vec3> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (double x = table.min.x(); x <= table.max.x(); x += placing_grid_m)
      for (double y = table.min.y(); y <= table.max.y(); y += placing_grid_m) {
        const double distance = std::hypot(x - middle.x(), y - middle.y());
        if (distance >= nearest || !evaluation_.spend(1)) continue;
        const Box box = standing_at(x, y, *found, *world_);
        there.p_WO = found->p_WO + box.center() - found->bounds_W().center();
        const auto holds = [&](const Where& at) {
          return holds_by(at.relation, there, at.landmarks, table, perspective_, sides) >= least_margin_m;
        };
        const bool on_table = inside_table(box, table);
        if (!on_table || !holds(*a) || !holds(*b) || !is_free(box, *world_, {found}, evaluation_)) continue;
        best = on_grid(Vec3(x, y, table.max.z()));
        nearest = distance;
      }
    if (best) return point(*best);
  }
  return Term::null();
}

Term View::offset(const ObjectState& object, const std::string& side) const {
  const auto named = relation_named(side);
  if (!named || !is_side(*named)) return Term::null();
  return Term::number(on_grid((object.p_WO - world_->table.center()).dot(side_W(*named, perspective_))));
}

Term View::displaced(const ObjectState& object, const std::string& side, double by_m) const {
  const auto named = relation_named(side);
  if (!named || !is_side(*named)) return Term::null();
  Vec3 p_W = object.p_WO + by_m * side_W(*named, perspective_);
  p_W.z() = object.bounds_W().min.z();
  return point(on_grid(p_W));
}

Term View::is_learned(const std::string& name) const {
  const auto* learned = evaluation_.facts().learned;
  return Term::truth(learned && learned->knows(name));
}

Term View::meaning_of(const std::string& name) const {
  const auto* learned = evaluation_.facts().learned;
  if (!learned) return Term::null();
  if (const auto gesture = learned->gestures.find(name); gesture != learned->gestures.end())
    return evaluation_.value(gesture->second);
  if (const auto noun = learned->nouns.find(name); noun != learned->nouns.end()) return evaluation_.value(noun->second);
  const auto* program = learned->program_called(name);
  return program ? evaluation_.value(program->acts) : Term::null();
}

Term View::affordance(const ObjectState& object, const std::string& what) const {
  const auto afforded = voxemes_ ? affords(object, *voxemes_, what) : std::nullopt;
  return afforded ? Term::truth(*afforded) : Term::null();
}

Term View::obstacle(const Term& program) const {
  if (!world_ || !voxemes_) return Term::null();
  const auto code = continua::obstacle(program, *world_, *voxemes_);
  return code == ReasonCode::none ? Term::null() : Term::text(name_of(code));
}

// Adds the facts that take places or programs. These may be terms such as left(plate), which are not literals, so
// add_functions() does not fit.
void add_facts_of_terms(const auto& seen, Rules& rules, Signature& signature) {
  for (const auto& [name, sides] : {std::pair("located", Sides::exact), std::pair("located_roughly", Sides::rough),
                                    std::pair("located_loosely", Sides::loose)}) {
    signature.emplace(name, Type::parse("e -> loc -> t").value());
    rules[name] = {2, seen([of = sides](const View& view, Arguments a) { return view.located(a[0], a[1], of); })};
  }
  signature.emplace("common_place", Type::parse("e -> loc -> loc -> loc").value());
  rules["common_place"] = {3, seen([](const View& view, Arguments a) { return view.common_place(a[0], a[1], a[2]); })};
  signature.emplace("as_seen_by", Type::parse("e -> loc -> loc").value());
  rules["as_seen_by"] = {2, seen([](const View& view, Arguments a) { return view.as_seen_by(a[0], a[1]); })};
  signature.emplace("obstacle", Type::parse("t -> text").value());
  rules["obstacle"] = {1, seen([](const View& view, Arguments a) { return view.obstacle(a[0]); })};
}

// The rules for a perspective and for voxemes, with their types.
std::pair<Rules, Signature> facts_of(Perspective perspective, const Catalogue* voxemes) {
  // A function of the view of the evaluation's world.
  const auto seen = [perspective, voxemes](auto compute) {
    return [=](Arguments a, Evaluation& e) { return compute(View(perspective, voxemes, e), a); };
  };
  // A function of one object that is in the world.
  const auto of_object = [seen](auto compute) {
    return seen([compute](const View& view, Arguments a) {
      const auto* found = view.object(a[0]);
      return found ? compute(view, *found, a) : Term::null();
    });
  };
  const auto attribute = [](const View&, const ObjectState& object, Arguments a) {
    const auto found = object.attributes.find(a[1].text_value());
    return found == object.attributes.end() ? Term::null() : Term::text(found->second);
  };
  Rules rules;
  Signature signature;
  add_functions(
      {
          {"scene", "e*", seen([](const View& view, Arguments) { return view.scene(); })},
          {"table", "loc", seen([](const View& view, Arguments) { return view.table(); })},
          {"held", "e", seen([](const View& view, Arguments) { return view.held(); })},
          {"position", "e -> loc", seen([](const View& view, Arguments a) { return view.position(a[0]); })},
          {"bounds", "e -> loc",
           of_object([](const View&, const ObjectState& o, Arguments) { return region(o.bounds_W()); })},
          {"attribute", "e -> text -> text", of_object(attribute)},
          {"volume", "e -> num", of_object([](const View&, const ObjectState& o, Arguments) {
             return Term::number(8 * o.half_extents_m.prod());
           })},
          {"closest", "e -> loc -> loc", seen([](const View& view, Arguments a) { return view.closest(a[0], a[1]); })},
          {"offset", "e -> text -> num", of_object([](const View& view, const ObjectState& o, Arguments a) {
             return view.offset(o, a[1].text_value());
           })},
          {"displaced", "e -> text -> num -> loc", of_object([](const View& view, const ObjectState& o, Arguments a) {
             return view.displaced(o, a[1].text_value(), a[2].number_value());
           })},
          {"affords", "e -> text -> t", of_object([](const View& view, const ObjectState& o, Arguments a) {
             return view.affordance(o, a[1].text_value());
           })},
          {"clear", "e -> num -> t",
           seen([](const View& view, Arguments a) { return view.clear(a[0], a[1].number_value()); })},
          {"fits", "e -> loc -> e* -> t",
           seen([](const View& view, Arguments a) { return view.fits(a[0], a[1], a[2]); })},
          {"free_place", "e -> loc -> loc",
           seen([](const View& view, Arguments a) { return view.free_place(a[0], a[1]); })},
          {"learned", "text -> t",
           seen([](const View& view, Arguments a) { return view.is_learned(a[0].text_value()); })},
          {"meaning_of", "text -> term",
           seen([](const View& view, Arguments a) { return view.meaning_of(a[0].text_value()); })},
      },
      rules, signature);
  add_facts_of_terms(seen, rules, signature);
  add_formation_facts(voxemes, rules, signature);
  return {std::move(rules), std::move(signature)};
}

}  // namespace

WorldFacts::WorldFacts(Perspective perspective, const Catalogue* voxemes)
    : rules_(facts_of(perspective, voxemes).first) {}

const Signature& WorldFacts::signature() {
  static const Signature types = facts_of(Perspective::human, nullptr).second;
  return types;
}

std::optional<bool> is_located(const Term& entity, const Term& place, const WorldSnapshot& world,
                               Perspective perspective) {
  static const RuleTable none({});
  Evaluation evaluation(none, nullptr, {.world = &world});
  const Term located = View(perspective, nullptr, evaluation).located(entity, place, Sides::exact);
  return located.is_null() ? std::nullopt : std::optional(located.is_true());
}

}  // namespace continua
