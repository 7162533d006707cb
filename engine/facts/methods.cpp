#include "continua/facts/methods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "continua/facts/affordances.h"
#include "continua/term/rules.h"

namespace continua {
namespace {

using Arguments = std::span<const Term>;

constexpr int most_draws = 1000;
// Where a place is sought: every centimetre, and by how much a relation must hold there.
constexpr double placing_grid_m = 0.01, least_margin_m = 0.004;

Point point_of(const Vec3& p_W) { return {p_W.x(), p_W.y(), p_W.z()}; }
Term point(const Vec3& p_W) { return Term::point(p_W.x(), p_W.y(), p_W.z()); }
Term region(const Box& box_W) { return Term::place({point_of(box_W.min), point_of(box_W.max), true}); }

Box box_of(const Place& place) {
  return {{place.min[0], place.min[1], place.min[2]}, {place.max[0], place.max[1], place.max[2]}};
}

// By how much `other` rests on more than `share` of the top of `box`, in metres; it does where this is above 0.
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

// Does a box that stands on the table meet an object other than those allowed?
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

}  // namespace

Methods::Methods(Perspective perspective, const Catalogue* voxemes) : perspective_(perspective), voxemes_(voxemes) {
  add_rules();
}

const Signature& Methods::signature() {
  static const Signature signature = Methods(Perspective::human).add_rules();
  return signature;
}

const ObjectState* Methods::object(const Term& entity) const {
  return world_ && entity.kind() == Term::Kind::constant ? world_->find(entity.name()) : nullptr;
}

Term Methods::scene() const {
  if (!world_) return Term::null();
  std::vector<Term> objects;
  for (const auto& each : world_->objects) objects.push_back(Term::entity(each.name));
  return Term::list(std::move(objects), Type::entity());
}

Term Methods::position(const Term& entity) const {
  if (const auto* found = object(entity)) return point(found->p_WO);
  const auto who = world_ && entity.kind() == Term::Kind::constant ? participant_named(entity.name()) : std::nullopt;
  return who ? point(Landmark::participant(*who, world_->table).bounds_W.center()) : Term::null();
}

Term Methods::closest(const Term& entity, const Term& place) const {
  const auto* found = object(entity);
  if (!found) return Term::null();
  const Box bounds = found->bounds_W();
  const Vec3 p_W = box_of(place.place_value()).center();
  return point(p_W.cwiseMax(bounds.min).cwiseMin(bounds.max));
}

Term Methods::clear(const Term& entity, double share, Evaluation& evaluation) const {
  const auto* found = object(entity);
  if (!found) return Term::null();
  const Box bounds = found->bounds_W();
  bool clear = true;
  for (const auto& other : world_->objects) {
    if (&other == found) continue;
    const double by = resting(other.bounds_W(), bounds, share);
    evaluation.note_margin(std::abs(by));
    clear = clear && by <= 0;
  }
  return Term::truth(clear);
}

Term Methods::fits(const Term& entity, const Term& place, const Term& except, Evaluation& evaluation) const {
  const auto* found = object(entity);
  if (!found) return Term::null();
  std::vector<const ObjectState*> allowed = {found};
  for (const auto& each : except.elements()) allowed.push_back(object(each));
  const Vec3 p_W = box_of(place.place_value()).center();
  return Term::truth(is_free(standing_at(p_W.x(), p_W.y(), *found, *world_), *world_, allowed, evaluation));
}

Term Methods::free_place(const Term& entity, const Term& place, Evaluation& evaluation) const {
  const auto* found = object(entity);
  if (!found || !random_) return Term::null();
  const Box region_W = box_of(place.place_value());
  const Vec3 size = region_W.max - region_W.min;
  for (int draw = 0; draw < most_draws && evaluation.spend(1); ++draw) {
    const double x = region_W.min.x() + random_->uniform() * size.x();
    const double y = region_W.min.y() + random_->uniform() * size.y();
    if (is_free(standing_at(x, y, *found, *world_), *world_, {found}, evaluation))
      return Term::point(x, y, region_W.center().z());
  }
  return Term::null();
}

std::optional<Landmark> Methods::landmark(const Term& term) const {
  if (term.kind() == Term::Kind::place) return Landmark::place(box_of(term.place_value()));
  if (term.kind() != Term::Kind::constant) return std::nullopt;
  return Landmark::named(term.name(), *world_);
}

// `place` is a point or region, or a relation to landmarks: left(plate), between(block1, <0, 0, 0>).
std::optional<Methods::Where> Methods::where(const Term& place) const {
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

Term Methods::located(const Term& entity, const Term& place, Sides sides, Evaluation& evaluation) const {
  const auto* found = object(entity);
  const auto at = where(place);
  if (!found || !at) return Term::null();
  const double by = holds_by(at->relation, *found, at->landmarks, world_->table, perspective_, sides);
  evaluation.note_margin(std::abs(by));
  return Term::truth(by > 0);
}

// They face each other: what is left of a thing for one is right of it for the other.
Term Methods::as_seen_by(const Term& who, const Term& place) const {
  const auto at = where(place);
  const auto viewer = who.kind() == Term::Kind::constant ? participant_named(who.name()) : std::nullopt;
  if (!at || !viewer) return Term::null();
  if (!is_side(at->relation) || at->landmarks.front().who || *viewer == perspective_) return place;
  const auto [head, arguments] = place.spine();
  return Term::apply(Term::constant(name_of(opposite(at->relation)), head.type()), arguments[0]);
}

// The nearest point to the middle between the landmarks, on a grid of the table, where it would be at both places; the
// sides as exact as they can be.
Term Methods::common_place(const Term& entity, const Term& first, const Term& second, Evaluation& evaluation) const {
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
        if (distance >= nearest || !evaluation.spend(1)) continue;
        const Box box = standing_at(x, y, *found, *world_);
        there.p_WO = found->p_WO + box.center() - found->bounds_W().center();
        const auto holds = [&](const Where& at) {
          return holds_by(at.relation, there, at.landmarks, table, perspective_, sides) >= least_margin_m;
        };
        const bool on_table = inside_table(box, table);
        if (!on_table || !holds(*a) || !holds(*b) || !is_free(box, *world_, {found}, evaluation)) continue;
        best = on_grid(Vec3(x, y, table.max.z()));
        nearest = distance;
      }
    if (best) return point(*best);
  }
  return Term::null();
}

Term Methods::offset(const ObjectState& object, const std::string& side) const {
  const auto named = relation_named(side);
  if (!named || !is_side(*named)) return Term::null();
  return Term::number(on_grid((object.p_WO - world_->table.center()).dot(side_W(*named, perspective_))));
}

Term Methods::meaning_of(const std::string& name, Evaluation& evaluation) const {
  if (!learned_) return Term::null();
  if (const auto gesture = learned_->gestures.find(name); gesture != learned_->gestures.end())
    return evaluation.value(gesture->second);
  const auto program = learned_->programs.find(name);
  return program == learned_->programs.end() ? Term::null() : evaluation.value(program->second.acts);
}

Term Methods::affordance(const ObjectState& object, const std::string& what) const {
  const auto afforded = voxemes_ ? affords(object, *voxemes_, what) : std::nullopt;
  return afforded ? Term::truth(*afforded) : Term::null();
}

Term Methods::obstacle(const Term& program) const {
  if (!world_ || !voxemes_) return Term::null();
  const auto code = continua::obstacle(program, *world_, *voxemes_);
  return code == ReasonCode::none ? Term::null() : Term::text(name_of(code));
}

Signature Methods::add_rules() {
  // A function of one object that is in the world.
  const auto of_object = [this](auto compute) {
    return [this, compute](Arguments a, Evaluation&) {
      const auto* found = object(a[0]);
      return found ? compute(*found, a) : Term::null();
    };
  };
  const auto attribute = [](const ObjectState& object, Arguments a) {
    const auto found = object.attributes.find(a[1].text_value());
    return found == object.attributes.end() ? Term::null() : Term::text(found->second);
  };
  const auto held = [this](Arguments, Evaluation&) {
    return world_ && world_->find(world_->held) ? Term::entity(world_->held) : Term::null();
  };
  const auto learned = [this](Arguments a, Evaluation&) {
    return Term::truth(learned_ && learned_->knows(a[0].text_value()));
  };
  rules_.clear();
  Signature signature;
  add_functions(
      {
          {"scene", "e*", [this](Arguments, Evaluation&) { return scene(); }},
          {"table", "loc", [this](Arguments, Evaluation&) { return world_ ? region(world_->table) : Term::null(); }},
          {"held", "e", held},
          {"position", "e -> loc", [this](Arguments a, Evaluation&) { return position(a[0]); }},
          {"bounds", "e -> loc", of_object([](const ObjectState& o, Arguments) { return region(o.bounds_W()); })},
          {"attribute", "e -> text -> text", of_object(attribute)},
          {"volume", "e -> num",
           of_object([](const ObjectState& o, Arguments) { return Term::number(8 * o.half_extents_m.prod()); })},
          {"closest", "e -> loc -> loc", [this](Arguments a, Evaluation&) { return closest(a[0], a[1]); }},
          {"offset", "e -> text -> num",
           of_object([this](const ObjectState& o, Arguments a) { return offset(o, a[1].text_value()); })},
          {"affords", "e -> text -> t",
           of_object([this](const ObjectState& o, Arguments a) { return affordance(o, a[1].text_value()); })},
          {"clear", "e -> num -> t",
           [this](Arguments a, Evaluation& e) { return clear(a[0], a[1].number_value(), e); }},
          {"fits", "e -> loc -> e* -> t", [this](Arguments a, Evaluation& e) { return fits(a[0], a[1], a[2], e); }},
          {"free_place", "e -> loc -> loc", [this](Arguments a, Evaluation& e) { return free_place(a[0], a[1], e); }},
          {"learned", "text -> t", learned},
          {"meaning_of", "text -> term",
           [this](Arguments a, Evaluation& e) { return meaning_of(a[0].text_value(), e); }},
      },
      rules_, signature);
  // A place or program may be a term that is no literal, left(plate), so these are no functions of add_functions.
  for (const auto& [name, sides] : {std::pair("located", Sides::exact), std::pair("located_roughly", Sides::rough),
                                    std::pair("located_loosely", Sides::loose)}) {
    signature.emplace(name, Type::parse("e -> loc -> t").value());
    rules_[name] = {2, [this, sides = sides](Arguments a, Evaluation& e) { return located(a[0], a[1], sides, e); }};
  }
  signature.emplace("common_place", Type::parse("e -> loc -> loc -> loc").value());
  rules_["common_place"] = {3, [this](Arguments a, Evaluation& e) { return common_place(a[0], a[1], a[2], e); }};
  signature.emplace("as_seen_by", Type::parse("e -> loc -> loc").value());
  rules_["as_seen_by"] = {2, [this](Arguments a, Evaluation&) { return as_seen_by(a[0], a[1]); }};
  signature.emplace("obstacle", Type::parse("t -> text").value());
  rules_["obstacle"] = {1, [this](Arguments a, Evaluation&) { return obstacle(a[0]); }};
  return signature;
}

}  // namespace continua
