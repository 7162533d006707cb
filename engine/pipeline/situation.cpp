#include "pipeline/situation.h"

#include <set>

namespace continua {
namespace {

std::vector<std::string> names(const Term& list) {
  std::vector<std::string> names;
  if (list.kind() != Term::Kind::list) return names;
  for (const auto& each : list.elements())
    if (each.kind() == Term::Kind::constant) names.push_back(each.name());
  return names;
}

void add(std::set<int>& because, Resolution::By by, const Situation& situation) {
  const auto* from = by == Resolution::By::focus     ? &situation.focus
                     : by == Resolution::By::pointed ? &situation.pointed
                     : by == Resolution::By::topic   ? &situation.topic
                                                     : nullptr;
  if (from) because.insert(from->begin(), from->end());
}

}  // namespace

Situation situation_of(Stepper& stepper, const Configuration& configuration, const Input& input, const Beliefs& beliefs,
                       const WorldSnapshot& world) {
  Situation situation;
  situation.context.world = &world;
  const auto& terms = stepper.machine().context;
  const auto value = [&](const std::optional<Term>& term, std::vector<int>& because) {
    if (!term) return Term::null();
    auto cell = stepper.value(*term, configuration, input, beliefs);
    because = std::move(cell.because);
    return cell.value;
  };
  situation.context.focus = names(value(terms.focus, situation.focus));
  situation.context.among = names(value(terms.among, situation.among));
  situation.context.topic = value(terms.topic, situation.topic);
  return situation;
}

std::vector<int> sources(const Move& move, int serial, const Situation& situation) {
  std::set<int> because = {serial};
  for (const auto& resolution : move.interpretation.resolutions) add(because, resolution.by, situation);
  if (!situation.context.among.empty()) because.insert(situation.among.begin(), situation.among.end());
  if (move.kind == deixis) because.insert(situation.pointed.begin(), situation.pointed.end());
  return {because.begin(), because.end()};
}

std::vector<int> sources(const Applying& applying, int serial, const Situation& situation) {
  std::set<int> because = {serial};
  for (const auto by : applying.by) add(because, by, situation);
  return {because.begin(), because.end()};
}

}  // namespace continua
