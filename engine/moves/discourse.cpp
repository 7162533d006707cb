#include "continua/moves/discourse.h"

#include <algorithm>
#include <set>

namespace continua {
namespace {

// The names in a list, each once, in the order of first occurrence.
std::vector<std::string> names(const Term& list) {
  std::vector<std::string> names;
  if (list.kind() != Term::Kind::list) return names;
  for (const auto& each : list.elements())
    if (each.kind() == Term::Kind::constant && std::find(names.begin(), names.end(), each.name()) == names.end())
      names.push_back(each.name());
  return names;
}

// The places in a list: the middle of each.
std::vector<Vec3> places(const Term& list) {
  std::vector<Vec3> places;
  if (list.kind() != Term::Kind::list) return places;
  for (const auto& each : list.elements()) {
    if (each.kind() != Term::Kind::place) continue;
    const Place& place = each.place_value();
    places.push_back((Vec3(place.min[0], place.min[1], place.min[2]) + Vec3(place.max[0], place.max[1], place.max[2])) /
                     2);
  }
  return places;
}

void add(std::set<int>& because, const std::vector<int>& serials) { because.insert(serials.begin(), serials.end()); }

void add(std::set<int>& because, Resolution::By by, const Discourse& discourse) {
  if (by == Resolution::By::focus) add(because, discourse.focus);
  if (by == Resolution::By::topic) add(because, discourse.topic);
}

}  // namespace

Discourse discourse_of(const Stepper& stepper, const Configuration& configuration, const Input& input,
                       const Facts& facts) {
  Discourse discourse;
  discourse.context.facts = facts;
  const auto& terms = stepper.machine().context;
  const auto value = [&](const std::optional<Term>& term, std::vector<int>& because) {
    if (!term) return Term::null();
    auto cell = stepper.value(*term, configuration, input, facts);
    because = std::move(cell.because);
    return cell.value;
  };
  discourse.context.focus = names(value(terms.focus, discourse.focus));
  discourse.context.among = names(value(terms.among, discourse.among));
  discourse.context.handled = names(value(terms.handled, discourse.handled));
  if (const auto topics = value(terms.topic, discourse.topic); topics.kind() == Term::Kind::list)
    discourse.context.topics = topics.elements();
  std::vector<int> of_things, of_places;
  discourse.earlier = {places(value(terms.shown_things, of_things)), places(value(terms.shown_places, of_places))};
  discourse.pointed = std::move(of_things);
  discourse.pointed.insert(discourse.pointed.end(), of_places.begin(), of_places.end());
  return discourse;
}

std::vector<int> sources(const Move& move, int serial, const Discourse& discourse) {
  std::set<int> because = {serial};
  add(because, discourse.pieces);
  for (const auto& resolution : move.interpretation.resolutions) {
    add(because, resolution.by, discourse);
    if (resolution.showing) add(because, discourse.shown[*resolution.showing]);
  }
  if (!discourse.context.among.empty()) add(because, discourse.among);
  return {because.begin(), because.end()};
}

std::vector<int> sources(const Applying& applying, int serial, const Discourse& discourse) {
  std::set<int> because = {serial};
  add(because, discourse.pieces);
  for (const auto by : applying.by) {
    add(because, by, discourse);
    if (by == Resolution::By::pointed)
      for (const auto& serials : discourse.shown) add(because, serials);
  }
  return {because.begin(), because.end()};
}

}  // namespace continua
