// An ensemble as moves: what was said or shown, with the pointings that go with it, and each alternative of an n-best
// list as an input of its own.
#include <algorithm>
#include <utility>

#include "continua/perception/speech_times.h"
#include "continua/pipeline/inputs.h"
#include "continua/pipeline/pipeline.h"
#include "continua/term/substitution.h"

namespace continua {

/// One alternative of what was said or shown, as far as it is understood.
struct Pipeline::Heard {
  InputEvent event;
  Utterance utterance;
  std::vector<Showing> showings;
  std::vector<std::vector<int>> shown;  ///< serials of each showing
  Discourse discourse;
  Move move;
  Input input;
  std::vector<int> because;  ///< serials of what it draws on, its own among them
};

namespace {

double understood_share(const Utterance& utterance) {
  const auto words = static_cast<double>(utterance.words.size());
  const auto lost = static_cast<double>(utterance.unknown.size() + utterance.unused.size());
  return words > 0 && !utterance.fragments.empty() ? (words - lost) / words : 1;
}

bool is_on(const Box& table, const Vec3& p_W) {
  return p_W.x() >= table.min.x() && p_W.x() <= table.max.x() && p_W.y() >= table.min.y() && p_W.y() <= table.max.y();
}

// What speaks of something that is not there is less likely to have been said.
constexpr double share_of_unseen = 0.5;

bool finds_all(const Interpretation& interpretation) {
  return std::none_of(interpretation.gaps.begin(), interpretation.gaps.end(),
                      [](const Gap& gap) { return gap.why == Gap::Why::none; });
}

std::size_t alternatives_of(const InputEvent& event) { return event.alternatives.size() + 1; }

}  // namespace

std::vector<Taker> Pipeline::takers(const Utterance& utterance, const InputEvent& event) const {
  const auto times = word_times(event, utterance.words);
  std::vector<Taker> takers;
  for (const auto& [words, needs] : understanding_->demonstratives(utterance))
    takers.push_back({times[words.begin].from, times[words.end - 1].until, needs});
  return takers;
}

// The pointings that came with the words, on these words: another alternative has others, and so may the same text once
// something was learned.
std::vector<std::pair<WordSpan, Deixis>> Pipeline::shown(const Ensemble& ensemble, const InputEvent& event,
                                                         const Utterance& utterance) const {
  std::vector<Deixis> pointings;
  for (const auto& one : ensemble.bound)
    if (one) pointings.push_back(*one);
  const auto demonstratives = understanding_->demonstratives(utterance);
  const auto assigned = assign(takers(utterance, event), pointings, window_);
  std::vector<std::pair<WordSpan, Deixis>> shown;
  for (std::size_t i = 0; i < assigned.size(); ++i)
    if (assigned[i]) shown.emplace_back(demonstratives[i].words, pointings[*assigned[i]]);
  return shown;
}

std::vector<Bound> Pipeline::bound(const Ensemble& ensemble) const {
  std::vector<Bound> all;
  const auto& event = ensemble.percept.event;
  if (!understanding_ || event.modality != Modality::speech) return all;
  const auto utterance = understanding_->read(event.text);
  for (auto& [span, pointing] : shown(ensemble, event, utterance))
    all.push_back({{utterance.words.begin() + static_cast<std::ptrdiff_t>(span.begin),
                    utterance.words.begin() + static_cast<std::ptrdiff_t>(span.end)},
                   std::move(pointing)});
  return all;
}

Pipeline::Heard Pipeline::heard(const EngineState& state, const Ensemble& ensemble, std::size_t alternative,
                                const WorldSnapshot& world) {
  Heard heard;
  heard.event = continua::alternative(ensemble.percept.event, alternative);
  heard.utterance = understanding_->read(heard.event.text);
  for (const auto& [words, pointing] : shown(ensemble, heard.event, heard.utterance)) {
    heard.showings.push_back({words, pointing.place_W});
    heard.shown.push_back(pointing.serials);
  }
  heard.input = to_input(heard.event, ensemble.percept.serial);
  heard.input.now_s = ensemble.at.seconds();
  if (!heard.showings.empty()) heard.input.pointed = point_term(heard.showings.front().place_W);
  if (alternatives_of(ensemble.percept.event) > 1) heard.input.confidence *= understood_share(heard.utterance);
  if (heard.utterance.fragments.empty())
    heard.move = understanding_->not_understood(heard.utterance);
  else
    understand(heard, 0, state, world);
  if (alternatives_of(ensemble.percept.event) > 1 && !finds_all(heard.move.interpretation))
    heard.input.confidence *= share_of_unseen;
  return heard;
}

void Pipeline::understand(Heard& heard, std::size_t fragment, const EngineState& state, const WorldSnapshot& world) {
  heard.discourse = discourse_now(state, heard.input, world);
  heard.discourse.context.showings = heard.showings;
  heard.discourse.shown = heard.shown;
  heard.move = understanding_->understood(heard.utterance, fragment, heard.discourse.context);
  carry(heard.move, heard.input);
  heard.because = because_of(heard, state);
  heard.input.because = heard.because;
  heard.input.symbol = text(Modality::speech) + " " + heard.move.kind;
  const auto& fragments = heard.utterance.fragments;
  heard.input.next =
      fragment + 1 < fragments.size() ? Term::text(fragments[fragment + 1].readings.front().move) : Term::null();
}

// Words and gestures that were taught draw on what was said then.
std::vector<int> Pipeline::because_of(const Heard& heard, const EngineState& state) const {
  auto because = sources(heard.move, heard.input.serial, heard.discourse);
  const auto add = [&](const std::string& name) {
    const auto lesson = state.lessons.find(name);
    if (lesson != state.lessons.end()) because.insert(because.end(), lesson->second.begin(), lesson->second.end());
  };
  if (heard.event.modality == Modality::gesture && state.learned.gestures.contains(heard.event.name))
    add(heard.event.name);
  if (!heard.move.readings.empty())
    for (const auto& [name, program] : state.learned.programs)
      if (contains(heard.move.readings[heard.move.chosen].term, Term::constant(name, program.type()))) add(name);
  std::sort(because.begin(), because.end());
  because.erase(std::unique(because.begin(), because.end()), because.end());
  return because;
}

Pipeline::Heard Pipeline::seen(const EngineState& state, const Ensemble& ensemble, std::size_t alternative,
                               const WorldSnapshot& world) {
  Heard seen;
  seen.event = continua::alternative(ensemble.percept.event, alternative);
  seen.input = to_input(seen.event, ensemble.percept.serial);
  seen.input.symbol = symbol(seen.event, state.learned);
  if (seen.event.modality == Modality::gesture) seen.input.gesture = Term::text(seen.event.name);
  seen.input.now_s = ensemble.at.seconds();
  seen.move.kind = kind_of(seen.event, state.learned);
  if (!understanding_) return seen;
  seen.discourse = discourse_now(state, seen.input, world);
  if (const auto place_W = place_of(seen.event); place_W && seen.move.kind == deixis) {
    seen.discourse.context.pointed_W = *place_W;
    seen.input.pointed = point_term(*place_W);
    seen.move.reference = refer_to_pointed(seen.discourse.context);
  } else if (const Term says = said_by(seen.event, state.learned); !says.is_null()) {
    seen.move = understanding_->shown(says, seen.move.kind, seen.discourse.context);
  }
  carry(seen.move, seen.input);
  seen.because = because_of(seen, state);
  seen.input.because = seen.because;
  return seen;
}

// What a gesture says: what was taught, else what the catalogue has.
Term Pipeline::said_by(const InputEvent& gesture, const Learned& learned) const {
  if (gesture.modality != Modality::gesture || !language_->gestures) return Term::null();
  const auto taught = learned.gestures.find(gesture.name);
  if (taught != learned.gestures.end()) return gesture.phase == "stop" ? Term::null() : taught->second;
  const auto* entry = language_->gestures->find(gesture.name);
  const auto* meaning = entry && entry->acts(gesture.phase) ? entry->meaning(gesture.direction) : nullptr;
  return meaning ? understanding_->meaning_of(*meaning) : Term::null();
}

// Each move of an utterance is understood in what the ones before it have left.
void Pipeline::hear(EngineState& state, const Ensemble& ensemble, const WorldSnapshot& world,
                    std::vector<EngineEvent>& events) {
  std::vector<Heard> heard;
  for (std::size_t k = 0; k < alternatives_of(ensemble.percept.event); ++k)
    heard.push_back(this->heard(state, ensemble, k, world));
  Heard& taken = heard[offer_all(state, heard, events)];
  for (std::size_t fragment = 1; fragment < taken.utterance.fragments.size(); ++fragment) {
    understand(taken, fragment, state, world);
    std::vector<Heard> one = {taken};
    offer_all(state, one, events);
  }
}

void Pipeline::see(EngineState& state, const Ensemble& ensemble, const WorldSnapshot& world,
                   std::vector<EngineEvent>& events) {
  std::vector<Heard> seen;
  for (std::size_t k = 0; k < alternatives_of(ensemble.percept.event); ++k)
    seen.push_back(this->seen(state, ensemble, k, world));
  offer_all(state, seen, events);
}

// That the human points at something else than before is a move, though none that machines are offered.
void Pipeline::follow(EngineState& state, const InputEvent& sample, int serial, const WorldSnapshot& world,
                      std::vector<EngineEvent>& events) {
  const auto place_W = place_of(sample);
  if (!place_W || !is_on(world.table, *place_W)) return;
  if (state.pointed && sample.t < state.pointed->t) return;
  const auto before = std::exchange(state.pointed, Pointed{*place_W, sample.t, ""});
  auto discourse = discourse_now(state, to_input(sample, serial), world);
  discourse.context.pointed_W = *place_W;
  Move move;
  move.kind = deixis;
  move.reference = refer_to_pointed(discourse.context);
  if (!move.reference.referents.empty()) state.pointed->object = move.reference.referents.front().object;
  if (before && before->object == state.pointed->object && (sample.t - before->t).seconds() <= window_.before_s) return;
  events.push_back(Understood{move, {serial}, {}, 1, true});
}

// Tells of all alternatives, the one that was taken last, and then of what came of it.
std::size_t Pipeline::offer_all(EngineState& state, std::vector<Heard>& heard, std::vector<EngineEvent>& events) {
  std::vector<Input> inputs;
  for (const auto& each : heard) inputs.push_back(each.input);
  std::vector<EngineEvent> after;
  const auto taken = offer(state, inputs, after);
  const auto tell = [&](std::size_t k) {
    const auto& each = heard[k];
    if (each.move.kind.empty() && each.move.words.empty()) return;
    const auto alternative = heard.size() > 1 ? std::optional(k) : std::nullopt;
    events.push_back(Understood{each.move, each.because, alternative, each.input.confidence, k == taken});
    if (k != taken) return;
    for (const auto& applying : each.move.interpretation.applied)
      events.push_back(StepEvent(Applied{applying.application, sources(applying, each.input.serial, each.discourse)}));
  };
  for (std::size_t k = 0; k < heard.size(); ++k)
    if (k != taken) tell(k);
  tell(taken);
  events.insert(events.end(), std::make_move_iterator(after.begin()), std::make_move_iterator(after.end()));
  return taken;
}

}  // namespace continua
