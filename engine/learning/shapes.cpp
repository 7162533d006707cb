#include "continua/learning/shapes.h"

#include <algorithm>

#include <fmt/format.h>

namespace continua {
namespace {

using Verdict = Recognition::Verdict;

// The exemplar nearest to the shape among gestures of which `counts` is true.
template <class Counts>
std::optional<Likeness> nearest_of(const Shape& shape, const Learned& learned, Counts counts) {
  std::optional<Likeness> nearest;
  for (const auto& [gesture, exemplars] : learned.shapes) {
    if (!counts(gesture)) continue;
    for (const auto& exemplar : exemplars) {
      if (exemplar.size() != shape.size()) continue;
      const double apart = distance(shape, exemplar);
      if (!nearest || apart < nearest->distance) nearest = Likeness{gesture, apart};
    }
  }
  return nearest;
}

bool is_contested(const Likeness& nearest, const Likeness& rival, double margin) {
  return nearest.distance == rival.distance || nearest.distance > (1 - margin) * rival.distance;
}

std::string at_distance(const Likeness& one) {
  return fmt::format("{} at the distance {:.3g}", one.gesture, one.distance);
}

std::string reason_of(const Recognition& found, const Shape& shape, const ShapeLimits& limits) {
  const auto others = found.of_other_length == 0
                          ? std::string()
                          : fmt::format("; {} known shapes of other lengths are not compared", found.of_other_length);
  const auto rival = found.rival ? ", the nearest of another meaning is " + at_distance(*found.rival) : std::string();
  switch (found.verdict) {
    case Verdict::nothing_known:
      return fmt::format("no shape of {} numbers was taught{}", shape.size(), others);
    case Verdict::too_far:
      return fmt::format("unlike all that was taught: the nearest is {}, farther than {}{}",
                         at_distance(*found.nearest), limits.farthest, others);
    case Verdict::contested:
      return fmt::format("like two things that were taught: the nearest is {}{}, and {} % less is needed{}",
                         at_distance(*found.nearest), rival, 100 * limits.margin, others);
    case Verdict::recognised:
    case Verdict::named:
      break;
  }
  return fmt::format("recognised by its shape: the nearest is {}, within {}{}{}", at_distance(*found.nearest),
                     limits.farthest, rival, others);
}

}  // namespace

Recognition recognise(const Shape& shape, const Learned& learned, const ShapeLimits& limits) {
  const auto meaning_of = [&](const std::string& gesture) -> const Term& {
    return learned.gestures.find(gesture)->second;
  };
  const auto is_known = [&](const std::string& gesture) { return learned.gestures.contains(gesture); };
  Recognition found;
  for (const auto& [gesture, exemplars] : learned.shapes)
    for (const auto& exemplar : exemplars) found.of_other_length += exemplar.size() != shape.size();
  found.nearest = nearest_of(shape, learned, is_known);
  if (found.nearest) {
    const auto& meaning = meaning_of(found.nearest->gesture);
    found.rival = nearest_of(shape, learned, [&](const std::string& gesture) {
      return is_known(gesture) && !(meaning_of(gesture) == meaning);
    });
    if (found.nearest->distance > limits.farthest)
      found.verdict = Verdict::too_far;
    else if (found.rival && is_contested(*found.nearest, *found.rival, limits.margin))
      found.verdict = Verdict::contested;
    else
      found.verdict = Verdict::recognised;
  }
  found.reason = reason_of(found, shape, limits);
  return found;
}

Recognition by_name(const std::string& gesture, const Shape& shape, const Learned& learned) {
  Recognition found;
  found.verdict = Verdict::named;
  found.nearest = nearest_of(shape, learned, [&](const std::string& other) { return other == gesture; });
  found.reason = found.nearest ? "known by its name, " + at_distance(*found.nearest) : "known by its name, " + gesture;
  return found;
}

std::vector<std::string> of_one_shape(const std::string& gesture, const Learned& learned, const ShapeLimits& limits) {
  std::vector<std::string> names = {gesture};
  const auto meaning = learned.gestures.find(gesture);
  const auto own = learned.shapes.find(gesture);
  if (meaning == learned.gestures.end() || own == learned.shapes.end()) return names;
  for (const auto& [other, exemplars] : learned.shapes) {
    const auto others = learned.gestures.find(other);
    if (other == gesture || others == learned.gestures.end() || !(others->second == meaning->second)) continue;
    const bool is_like = std::any_of(exemplars.begin(), exemplars.end(), [&](const Shape& shape) {
      return std::any_of(own->second.begin(), own->second.end(), [&](const Shape& each) {
        return each.size() == shape.size() && distance(each, shape) <= limits.farthest;
      });
    });
    if (is_like) names.push_back(other);
  }
  return names;
}

std::string ShownShapes::name_for(const Shape& shape, const Learned& learned,
                                  const std::function<bool(std::string_view)>& is_taken) {
  for (const auto& [gesture, exemplars] : learned.shapes)
    if (std::find(exemplars.begin(), exemplars.end(), shape) != exemplars.end()) return gesture;
  for (const auto& [name, shown] : shown_)
    if (shown == shape) return name;
  std::string name;
  do name = fmt::format("shape_{}", ++named_);
  while (learned.knows(name) || is_taken(name));
  return name;
}

void ShownShapes::add(const std::string& name, const Shape& shape) {
  std::erase_if(shown_, [&](const auto& one) { return one.first == name; });
  shown_.emplace_back(name, shape);
  if (shown_.size() > most) shown_.erase(shown_.begin());
}

Shape ShownShapes::find(std::string_view name) const {
  const auto found = std::find_if(shown_.begin(), shown_.end(), [&](const auto& one) { return one.first == name; });
  return found == shown_.end() ? Shape() : found->second;
}

}  // namespace continua
