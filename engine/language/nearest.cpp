#include "continua/language/nearest.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "continua/term/substitution.h"

namespace continua {
namespace {

bool is_about_distance(Relation relation) { return relation == Relation::near || relation == Relation::beside; }

// The landmark's name: that of a thing, or of the only thing that a noun phrase means.
std::optional<std::string> named(const Term& landmark, const Context& context, const Meanings& meanings) {
  if (landmark.kind() == Term::Kind::constant) return landmark.name();
  const auto* determiner = determiner_of(landmark, *meanings.operators);
  if (!determiner || !landmark.closed() || determiner->many || determiner->count > 1) return std::nullopt;
  const auto meant = refer(landmark.argument(), *determiner, context, meanings).referents;
  return meant.size() == 1 ? std::optional(meant.front().object) : std::nullopt;
}

// The only object to which the condition relates its things by distance.
const ObjectState* landmark_of(const Term& condition, const Context& context, const Meanings& meanings) {
  static const Name located("located");
  std::vector<Term> landmarks;
  rewritten(condition, [&](const Term& part) -> std::optional<Term> {
    const auto [head, arguments] = part.spine();
    if (head.kind() != Term::Kind::constant || head.interned_name() != located || arguments.size() != 2)
      return std::nullopt;
    const auto place = arguments[1].spine();
    const auto relation = place.head.kind() == Term::Kind::constant ? relation_named(place.head.name()) : std::nullopt;
    if (relation && is_about_distance(*relation) && place.arguments.size() == 1)
      landmarks.push_back(place.arguments[0]);
    return part;
  });
  if (landmarks.size() != 1) return nullptr;
  const auto name = named(landmarks.front(), context, meanings);
  return name ? context.facts.world->find(*name) : nullptr;
}

}  // namespace

Reference nearest_to_landmark(Reference reference, const Term& condition, const Context& context,
                              const Meanings& meanings) {
  const auto* landmark = reference.referents.size() > 1 ? landmark_of(condition, context, meanings) : nullptr;
  if (!landmark) return reference;
  const auto distance_m = [&](const Referent& each) {
    return (context.facts.world->find(each.object)->p_WO - landmark->p_WO).head<2>().norm();
  };
  auto nearest = reference.referents;
  std::stable_sort(nearest.begin(), nearest.end(),
                   [&](const Referent& a, const Referent& b) { return distance_m(a) < distance_m(b); });
  const double excess_m = distance_m(nearest[0]) - clearly_nearest * distance_m(nearest[1]);
  reference.margin = std::min(reference.margin, std::abs(excess_m));
  if (excess_m > 0) return reference;
  for (std::size_t i = 1; i < nearest.size(); ++i)
    reference.ruled_out.push_back({nearest[i].object, "not the nearest to " + landmark->name});
  nearest.front().weight = 1;
  reference.referents = {nearest.front()};
  return reference;
}

}  // namespace continua
