#include "continua/moves/offer.h"

#include <algorithm>
#include <utility>

#include <fmt/ranges.h>

#include "continua/moves/discourse.h"
#include "continua/moves/inputs.h"
#include "continua/moves/kind.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

double understood_share(const Utterance& utterance) {
  const auto words = static_cast<double>(utterance.words.size());
  const auto lost = static_cast<double>(utterance.unknown.size() + utterance.unused.size() + utterance.repaired.size());
  return words > 0 && !utterance.fragments.empty() ? (words - lost) / words : 1;
}

// Factor of the confidence of words about something that is not there: they are less likely to have been said.
constexpr double share_of_unseen = 0.5;

bool finds_all(const Interpretation& interpretation) {
  return std::none_of(interpretation.gaps.begin(), interpretation.gaps.end(),
                      [](const Gap& gap) { return gap.why == Gap::Why::none; });
}

const ReadSpeech& speech_of(const Offer& offer, const Ensemble& ensemble) {
  return ensemble.percept.readings->alternatives[offer.alternative];
}

void carry(const std::optional<Sign>& sign, Input& input) {
  if (!sign) return;
  input.sign = Term::text(sign->gesture);
  input.sign_at = Term::number(sign->t.seconds());
}

Discourse discourse_of(const Input& input, const Dialogue& now) {
  return discourse_of(now.stepper, now.configuration, input, now.facts);
}

// The inputs that the offer draws on. Taught words and gestures draw on the inputs of their lesson.
std::vector<int> because_of(const Offer& offer, const InputEvent& event, const Discourse& discourse,
                            const Dialogue& now) {
  const Learned& learned = *now.facts.learned;
  auto because = sources(offer.move, offer.input.serial, discourse);
  const auto add = [&](const std::string& name) {
    const auto lesson = now.lessons.find(name);
    if (lesson != now.lessons.end()) because.insert(because.end(), lesson->second.begin(), lesson->second.end());
  };
  if (offer.sign) add(known_gesture(event, now.gestures, learned).lesson);
  if (!offer.move.readings.empty())
    for (const auto& [name, program] : learned.programs)
      if (contains(offer.move.readings[offer.move.chosen].term, Term::constant(name, program.type()))) add(name);
  if (!offer.move.readings.empty())
    for (const auto& [name, condition] : learned.nouns)
      if (contains(offer.move.readings[offer.move.chosen].term, Term::constant(name, condition.type()))) add(name);
  std::sort(because.begin(), because.end());
  because.erase(std::unique(because.begin(), because.end()), because.end());
  return because;
}

// Inputs that made an unsure one sure contribute to all that comes of it.
void add_assured(const Ensemble& ensemble, std::vector<int>& because) {
  const auto& assured = ensemble.percept.assured;
  because.insert(because.end(), assured.begin(), assured.end());
  std::sort(because.begin(), because.end());
  because.erase(std::unique(because.begin(), because.end()), because.end());
}

// Completes the offer after its move is understood.
Offer complete(Offer offer, const InputEvent& event, const Discourse& discourse, const Dialogue& now) {
  carry(offer.move, offer.input);
  offer.input.because = because_of(offer, event, discourse, now);
  offer.applied.clear();
  for (const auto& applying : offer.move.interpretation.applied)
    offer.applied.push_back({applying.application, sources(applying, offer.input.serial, discourse)});
  return offer;
}

// Earlier pointings without words that the fragment's words take.
std::vector<Showing> earlier_showings(const ReadSpeech& speech, std::size_t fragment, const EarlierPointings& earlier) {
  const WordSpan& words = speech.utterance.fragments[fragment].words;
  std::vector<Demonstrative> inside;
  for (const auto& each : speech.demonstratives)
    if (each.words.begin >= words.begin && each.words.end <= words.end) inside.push_back(each);
  return taken_by(inside, earlier);
}

// Whether the pointings of the words, if they have any, were all made before the words began.
bool were_shown_before(const ReadSpeech& speech, const Ensemble& ensemble, const FusionWindow& window) {
  const auto shown = shown_words(speech, ensemble, window);
  return std::all_of(shown.begin(), shown.end(),
                     [&](const ShownWords& each) { return each.pointing.until < speech.event.t; });
}

// The words between the fragment and the one before it in its sentence; null if it is the first there.
Term joining(const Utterance& utterance, std::size_t fragment) {
  if (fragment == 0) return Term::null();
  const auto begin = utterance.fragments[fragment - 1].words.end;
  const auto end = utterance.fragments[fragment].words.begin;
  const bool is_first = std::any_of(utterance.ends.begin(), utterance.ends.end(),
                                    [&](std::size_t each) { return begin <= each && each <= end; });
  if (is_first) return Term::null();
  const auto& words = utterance.words;
  const auto at = [&](std::size_t word) { return words.begin() + static_cast<std::ptrdiff_t>(word); };
  return Term::text(fmt::format("{}", fmt::join(at(begin), at(end), " ")));
}

bool is_quoted(const Utterance& utterance, const WordSpan& words) {
  const auto& quoted = utterance.quoted;
  const auto first = std::lower_bound(quoted.begin(), quoted.end(), words.begin);
  return static_cast<std::size_t>(std::lower_bound(first, quoted.end(), words.end) - first) == words.size();
}

// Carries to the input what surrounds its move in the utterance: the other moves' kinds, the words that join it,
// quotation marks.
void carry_neighbours(const Utterance& utterance, std::size_t fragment, Input& input) {
  const auto& fragments = utterance.fragments;
  const auto kind_at = [&](std::size_t at) { return Term::text(fragments[at].readings.front().move); };
  const auto next = fragment + 1;
  input.next = next < fragments.size() ? kind_at(next) : Term::null();
  input.previous = fragment > 0 ? kind_at(fragment - 1) : Term::null();
  input.joined = joining(utterance, fragment);
  input.quoted = Term::truth(is_quoted(utterance, fragments[fragment].words));
  const auto& ends = utterance.ends;
  const auto end = std::upper_bound(ends.begin(), ends.end(), fragments[fragment].words.begin);
  std::vector<Term> following, later;
  for (auto at = next; at < fragments.size(); ++at)
    (end == ends.end() || fragments[at].words.begin < *end ? following : later).push_back(kind_at(at));
  input.following = Term::list(std::move(following), Type::text_type());
  input.later = Term::list(std::move(later), Type::text_type());
}

// Understands the offer's fragment of the utterance.
Offer understood(Offer offer, const Ensemble& ensemble, const Dialogue& now) {
  const auto& speech = speech_of(offer, ensemble);
  auto discourse = discourse_of(offer.input, now);
  discourse.pieces = ensemble.percept.pieces;
  discourse.context.deixis = now.understanding->deixis();
  for (const auto& [words, pointing] : shown_words(speech, ensemble, now.window)) {
    discourse.context.showings.push_back({words, pointing.place_W, pointing.gesture,
                                          now.understanding->pointing_sd_m(pointing.distance_m), pointing.hand});
    discourse.shown.push_back(pointing.serials);
  }
  // Words with pointings of their own draw on no earlier ones. A pointing before the words is one of the earlier ones.
  auto earlier = earlier_showings(speech, offer.fragment, discourse.earlier);
  if (earlier.size() > discourse.context.showings.size() && were_shown_before(speech, ensemble, now.window)) {
    discourse.context.showings = std::move(earlier);
    discourse.shown.assign(discourse.context.showings.size(), discourse.pointed);
  }
  offer.move = now.understanding->understood(speech.utterance, offer.fragment, discourse.context);
  offer = complete(std::move(offer), speech.event, discourse, now);
  add_assured(ensemble, offer.input.because);
  offer.input.symbol = name_of(Modality::speech) + " " + offer.move.kind;
  carry_neighbours(speech.utterance, offer.fragment, offer.input);
  return offer;
}

Offer heard(const Ensemble& ensemble, std::size_t alternative, const Dialogue& now) {
  Offer offer;
  offer.alternative = alternative;
  const auto& speech = speech_of(offer, ensemble);
  const auto shown = shown_words(speech, ensemble, now.window);
  const bool is_one_of_several = ensemble.percept.readings->alternatives.size() > 1;
  offer.input = to_input(speech.event, ensemble.percept.serial);
  offer.input.now_s = ensemble.at.seconds();
  carry(now.sign, offer.input);
  if (!shown.empty()) {
    offer.input.pointed = point_term(shown.front().pointing.place_W);
    offer.input.pointed_confidence = Term::number(shown.front().pointing.confidence);
  }
  if (is_one_of_several) offer.input.confidence *= understood_share(speech.utterance);
  if (speech.utterance.fragments.empty())
    offer.move = now.understanding->not_understood(speech.utterance);
  else
    offer = understood(std::move(offer), ensemble, now);
  if (is_one_of_several && !finds_all(offer.move.interpretation)) offer.input.confidence *= share_of_unseen;
  return offer;
}

// The meaning of a gesture: as taught, else from the catalogue.
Term said_by(const InputEvent& gesture, const KnownGesture& known, const Dialogue& now) {
  if (known.taught) return *known.taught;
  const auto* entry = known.entry;
  const auto* meaning = entry && entry->acts(gesture.phase) ? entry->meaning(gesture.direction) : nullptr;
  return meaning ? now.understanding->meaning_of(*meaning) : Term::null();
}

// Carries the pointing, things and place, to the input. Returns the application of [[point]] by which it came about;
// nothing at the end of a gesture, or where no document tells that program.
std::optional<Application> point(Offer& offer, const InputEvent& event, const Vec3& place_W, const Context& context,
                                 const Dialogue& now) {
  std::vector<std::string> things;
  for (const auto& each : offer.move.reference.referents) things.push_back(each.object);
  offer.input.pointing = pointing_term(things, place_W);
  const auto* program = now.understanding->deixis();
  if (!program || event.phase == "stop") return std::nullopt;
  return application_of(*program, event.hand, context.pointed_sd_m, place_W, things);
}

Offer seen(const Ensemble& ensemble, std::size_t alternative, const Dialogue& now) {
  const InputEvent event = continua::alternative(ensemble.percept.event, alternative);
  Offer offer;
  offer.alternative = alternative;
  offer.input = to_input(event, ensemble.percept.serial);
  offer.input.symbol = symbol_of(event, now.gestures, *now.facts.learned);
  if (event.modality == Modality::gesture) offer.input.gesture = Term::text(event.name);
  offer.input.now_s = ensemble.at.seconds();
  offer.move.kind = kind_of(event, now.stepper.machine(), now.gestures, *now.facts.learned);
  if (!now.understanding) return offer;
  const auto known = known_gesture(event, now.gestures, *now.facts.learned);
  if (known.taught) offer.sign = Sign{event.name, event.t};
  carry(offer.sign ? offer.sign : now.sign, offer.input);
  auto discourse = discourse_of(offer.input, now);
  std::optional<Application> pointing;
  if (const auto place_W = place_of(event); place_W && offer.move.kind == deixis) {
    discourse.context.pointed_W = *place_W;
    discourse.context.pointed_sd_m = now.understanding->pointing_sd_m(distance_of(event));
    offer.input.pointed = point_term(*place_W);
    offer.input.pointed_confidence = Term::number(event.confidence);
    offer.move.reference = refer_to_pointed(discourse.context);
    pointing = point(offer, event, *place_W, discourse.context, now);
  } else if (const Term says = said_by(event, known, now); !says.is_null()) {
    offer.move = now.understanding->shown(says, offer.move.kind, discourse.context);
  }
  offer.move.shape = known.shape;
  offer = complete(std::move(offer), event, discourse, now);
  add_assured(ensemble, offer.input.because);
  if (pointing) offer.applied.insert(offer.applied.begin(), {*std::move(pointing), {offer.input.serial}});
  return offer;
}

}  // namespace

std::vector<Offer> offers_of(const Ensemble& ensemble, const Dialogue& now) {
  const auto& event = ensemble.percept.event;
  const bool is_heard = now.understanding && event.modality == Modality::speech;
  if (const auto& resumes = ensemble.percept.resumes; resumes && resumes->fragment > 0) {
    Offer offer = heard(ensemble, resumes->alternative, now);
    offer.fragment = resumes->fragment;
    return {understood(std::move(offer), ensemble, now)};
  }
  std::vector<Offer> offers;
  for (std::size_t k = 0; k <= event.alternatives.size(); ++k)
    offers.push_back(is_heard ? heard(ensemble, k, now) : seen(ensemble, k, now));
  return offers;
}

std::optional<Offer> next_offer(const Offer& taken, const Ensemble& ensemble, const Dialogue& now) {
  if (!now.understanding || ensemble.percept.event.modality != Modality::speech) return std::nullopt;
  const auto& speech = speech_of(taken, ensemble);
  if (taken.fragment + 1 >= speech.utterance.fragments.size()) return std::nullopt;
  Offer offer = taken;
  ++offer.fragment;
  return understood(std::move(offer), ensemble, now);
}

}  // namespace continua
