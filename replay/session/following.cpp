#include "continua/replay/session/following.h"

#include <algorithm>

#include "continua/knowledge_files/language_loading.h"

namespace continua {
namespace {

bool is_act(const AvatarMove& move) { return move.channel == "action"; }

}  // namespace

Following::Following(Variant variant, bool at_once, const WorldSnapshot& world, const Machine& machine,
                     const Catalogue* catalogue, Perspective perspective)
    : variant_(variant),
      at_once_(at_once),
      blanks_(blanks_of(world)),
      names_(names_of_terms()),
      world_(world, catalogue, perspective) {
  names_.insert(machine.programs.begin(), machine.programs.end());
  for (const auto& object : world.objects) names_.emplace(object.name, Type::entity());
}

// Content that is no term, such as raw text that a system logged for an act, becomes a text.
Term Following::term_of(const std::string& content) const {
  const auto term = parse_term(content, names_);
  return term ? *term : Term::text(content);
}

ObservedMoves Following::moves_of(const Episode& episode) const {
  ObservedMoves moves;
  for (const auto& [channel, content, n] : episode.observed) {
    if (channel == "speech") moves.said.push_back(content);
    if (channel == "gesture") moves.gestures.push_back(term_of(content));
    if (channel == "action") moves.acts.push_back(term_of(content));
  }
  return moves;
}

bool Following::end(const Episode& episode, SimTime t) {
  observed_ = moves_of(episode);
  corrected_ = variant_ == Variant::teacher && before_ &&
               agreement(episode.observed, episode.produced, blanks_) < AgreementLevel::lax;
  for (const auto& act : observed_.acts) world_.act(act, t);
  return std::any_of(episode.observed.begin(), episode.observed.end(), is_act) ||
         std::any_of(episode.produced.begin(), episode.produced.end(), is_act);
}

Tick Following::correct(const Pipeline& pipeline, const EngineState& after, const WorldSnapshot& world) const {
  require(corrected_, "what agrees is not corrected");
  return pipeline.corrected(before_->state, after, before_->event, observed_, world);
}

}  // namespace continua
