#include "continua/replay/diff/run_cause.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "continua/replay/diff/run_diff_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_words.h"
#include "continua/term/written_term.h"

namespace continua {
namespace {

// The evidence for the cause: the first difference, and the transitions that it belongs to.
struct Pivot {
  RunDifference::Kind kind = RunDifference::Kind::happened;
  Json a, b;                        ///< its first records; null: none
  Json transition_a, transition_b;  ///< the first in it or after it; null: none
  Json reading_a, reading_b;
  std::vector<Json> senses_a, senses_b;  ///< of the words of the input behind it
  bool by_gesture = false;               ///< the input behind it is no speech
  std::string text_a, text_b;            ///< of all that it is about, to look names up in
};

// How much the first difference speaks for a part of the runs as its cause; the order decides. A part that the
// difference names speaks loudest, then one of the kind that makes such differences, then one that might have an
// effect, and last one that is known to have none here.
namespace rank {
constexpr int forced_here = 99;         // only one run was made to take the transition
constexpr int sense_of_words = 97;      // a word of the input has another sense
constexpr int other_draw = 96;          // the same candidates, another random number
constexpr int names_it = 95;            // the transition that fired, or the phrase that was said
constexpr int makes_its_kind = 90;      // phrases of the utterance, gestures of the avatar, the choice made
constexpr int state_reached = 85;       // the state that the transition leads to; also a raising rule of an application
constexpr int transition_weighed = 80;  // a transition that was a candidate or refused
constexpr int named_in_text = 72;       // any other part of the machine that the records name
constexpr int object_in_text = 65;      // an object of the scene that the records name
constexpr int guides_readings = 60;     // context, fusion and programs of a reading; the world, of an act or a time
constexpr int viewpoint = 58;           // sides are seen from it
constexpr int voxeme_of_act = 55;
constexpr int lexicon_of_reading = 50, raising_of_reading = 45;
constexpr int scene = 40, learned = 35, machine = 30;
constexpr int world = 28, choice = 27, perspective = 26, lexicon = 25, gestures = 24, voxemes = 22;
constexpr int machine_of_reading = 20, raising = 20, phrases = 15;
constexpr int other_of_act = 5, other = 2, seed = 1;
}  // namespace rank

class Inquiry {
 public:
  Inquiry(const RunIndex& a, const RunIndex& b, RunDiff& diff) : a_(a), b_(b), diff_(diff) {}

  Outcome find() {
    if (diff_.differences.empty()) {
      nothing_differs();
      return std::nullopt;
    }
    if (auto problem = look()) return problem;
    const auto& first = diff_.differences[diff_.first];
    if (const auto* run = cut_short(first))
      diff_.cause = {
          "cut short", "", Json(), Json(),
          fmt::format("the log of {} is cut short after record {}", run == &a_ ? "A" : "B", run->size() - 1)};
    else if (first.input)
      diff_.cause = input_cause(a_, b_, first);
    else if (const auto* given = likeliest())
      diff_.cause = {given->kind, given->what, given->a, given->b, told(*given)};
    else
      without_givens();
    tell_values();
    diff_.sentence = sentence_of(a_, b_, diff_, pivot_.transition_a, pivot_.transition_b);
    return std::nullopt;
  }

 private:
  // The run whose log ends before the first difference, without having come to its end.
  const RunIndex* cut_short(const RunDifference& first) const {
    const auto cut = [&](const RunIndex& run, const std::vector<std::size_t>& records) {
      return records.empty() && !run.complete() && run.entry(run.size() - 1).t <= first.t;
    };
    if (cut(a_, first.a)) return &a_;
    return cut(b_, first.b) ? &b_ : nullptr;
  }

  void nothing_differs() {
    diff_.sentence = "The runs are the same.";
    if (diff_.givens.empty()) return;
    const auto& given = diff_.givens.front();
    diff_.cause = {given.kind, given.what, given.a, given.b, told(given)};
    diff_.sentence =
        fmt::format("All that happened is the same. The runs are made of different parts, without effect: {}: {}{}.",
                    given.kind, told(given), others(diff_.givens.size() - 1));
  }

  static std::string others(std::size_t count) { return count == 0 ? "" : fmt::format(", and {} more", count); }

  Outcome look() {
    const auto& first = diff_.differences[diff_.first];
    pivot_.kind = first.kind;
    if (auto problem =
            look_at(a_, first.a, pivot_.a, pivot_.transition_a, pivot_.reading_a, pivot_.senses_a, pivot_.text_a))
      return problem;
    return look_at(b_, first.b, pivot_.b, pivot_.transition_b, pivot_.reading_b, pivot_.senses_b, pivot_.text_b);
  }

  // A symbol is written before the transition that makes it; a rewrite by a state's entry, after.
  Outcome look_at(const RunIndex& run, const std::vector<std::size_t>& records, Json& one, Json& transition,
                  Json& reading, std::vector<Json>& senses, std::string& text) {
    if (records.empty()) return std::nullopt;
    auto first = run.record(records.front());
    if (!first) return first.error();
    one = *first;
    std::optional<std::size_t> at, read;
    for (const auto n : records) {
      if (!at && log::is<log::Transition>(run.kind(n))) at = n;
      if (!read && log::is<log::Reading>(run.kind(n))) read = n;
    }
    const auto cause_of = [&](std::string_view kind) {
      auto cause = run.cause(records.front());
      while (cause && run.kind(*cause) != kind) cause = run.cause(*cause);
      return cause;
    };
    if (!at && log::is<log::Symbol>(run.kind(records.front()))) {
      for (auto n = records.front() + 1; n < run.size() && run.entry(n).cause == run.entry(records.front()).cause; ++n)
        if (log::is<log::Transition>(run.kind(n))) {
          at = n;
          break;
        }
    } else if (!at && !log::is<log::Reading>(run.kind(records.front())) &&
               !log::is<log::Percept>(run.kind(records.front()))) {
      at = cause_of(log::Transition::kind.name);
    }
    if (!read) read = cause_of(log::Reading::kind.name);
    for (const auto& [n, into] : {std::pair(at, &transition), std::pair(read, &reading)}) {
      if (!n) continue;
      auto record = run.record(*n);
      if (!record) return record.error();
      *into = *std::move(record);
    }
    if (const auto input = cause_of(log::Input::kind.name)) {
      const auto record = run.record(*input);
      if (!record) return record.error();
      pivot_.by_gesture = text_of(member_of(*record, "event"), "kind") != "speech";
      if (auto problem = add_senses(run, *input, senses)) return problem;
    }
    text = compact(one) + compact(transition) + compact(reading);
    return std::nullopt;
  }

  // Of all that was read in an input.
  static Outcome add_senses(const RunIndex& run, std::size_t input, std::vector<Json>& senses) {
    for (const auto n : run.of_kind(log::Reading::kind.name)) {
      auto cause = run.cause(n);
      while (cause && *cause > input) cause = run.cause(*cause);
      if (cause != input) continue;
      const auto reading = run.record(n);
      if (!reading) return reading.error();
      const auto& entries = member_of(*reading, "entries");
      if (!entries.is_array()) continue;
      for (auto entry : entries) {
        if (!entry.is_object()) continue;
        entry.erase("parses");
        senses.push_back(std::move(entry));
      }
    }
    return std::nullopt;
  }

  const GivenDifference* likeliest() {
    const GivenDifference* best = nullptr;
    int most = 0;
    for (const auto& given : diff_.givens)
      if (const int speaks = relevance(given); speaks > most) {
        best = &given;
        most = speaks;
      }
    if (best && best->kind == "lexicon") {
      if (const auto words = differing_sense()) {
        word_ = *words;
        return &word_;
      }
    }
    return best;
  }

  static std::set<std::string> ids_of(const Json& transition, const char* list) {
    std::set<std::string> ids;
    if (const auto& all = member_of(transition, list); all.is_array())
      for (const auto& one : all) ids.insert(text_of(one, "id"));
    return ids;
  }

  // Its rank as the cause of the first difference.
  int relevance(const GivenDifference& given) {
    const auto& kind = given.kind;
    const auto at_first = first_kind();
    const bool reading = log::is<log::Reading>(at_first) || log::is<log::Percept>(at_first);
    if (kind == "machine") return relevance_of_machine(given, reading);
    if (kind == "phrases")
      return log::is<log::Utterance>(at_first) ? (says(given) ? rank::names_it : rank::makes_its_kind) : rank::phrases;
    if (kind == "lexicon")
      return differing_sense() ? rank::sense_of_words : reading ? rank::lexicon_of_reading : rank::lexicon;
    if (kind == "gestures") return reading && pivot_.by_gesture ? rank::makes_its_kind : rank::gestures;
    if (kind == "raising")
      return log::is<log::Application>(at_first) ? rank::state_reached
             : reading                           ? rank::raising_of_reading
                                                 : rank::raising;
    if (kind == "voxemes") return log::is<log::Act>(at_first) || is_act() ? rank::voxeme_of_act : rank::voxemes;
    if (kind == "scene")
      return mentions(pivot_.text_a + " " + pivot_.text_b, given.name) ? rank::object_in_text : rank::scene;
    if (kind == "learned") return rank::learned;
    if (kind == "choice") return relevance_of_choice(given);
    if (kind == "world")
      return is_act() || pivot_.kind == RunDifference::Kind::timing ? rank::guides_readings : rank::world;
    if (kind == "perspective") return reading ? rank::viewpoint : rank::perspective;
    return is_act() ? rank::other_of_act : rank::other;
  }

  bool is_act() const {
    return pivot_.kind == RunDifference::Kind::outcome || pivot_.kind == RunDifference::Kind::poses;
  }

  std::string first_kind() const { return text_of(pivot_.a.is_null() ? pivot_.b : pivot_.a, "kind"); }

  int relevance_of_machine(const GivenDifference& given, bool reading) const {
    if (reading)
      return given.what.starts_with("context") || given.what.starts_with("fusion") || given.what.starts_with("program")
                 ? rank::guides_readings
                 : rank::machine_of_reading;
    const auto &a = pivot_.transition_a, &b = pivot_.transition_b;
    const auto of_transition = given.what.starts_with("transition");
    if (of_transition && (given.name == text_of(a, "id") || given.name == text_of(b, "id"))) return rank::names_it;
    if (given.what.starts_with("state") && (given.name == text_of(a, "to") || given.name == text_of(b, "to")))
      return rank::state_reached;
    if (of_transition)
      for (const char* list : {"candidates", "refused"})
        for (const auto* one : {&a, &b})
          if (ids_of(*one, list).contains(given.name)) return rank::transition_weighed;
    return mentions(pivot_.text_a + " " + pivot_.text_b, given.name) ? rank::named_in_text : rank::machine;
  }

  int relevance_of_choice(const GivenDifference& given) const {
    const auto &a = pivot_.transition_a, &b = pivot_.transition_b;
    if (given.what == "forced")
      return member_of(a, "forced") != member_of(b, "forced") ? rank::forced_here : rank::choice;
    const bool same_choice = ids_of(a, "candidates") == ids_of(b, "candidates") && !a.is_null();
    if (given.what == "seed") {
      const auto &one = member_of(a, "draw"), &other = member_of(b, "draw");
      return same_choice && one.is_number() && other.is_number() && one != other ? rank::other_draw : rank::seed;
    }
    return same_choice ? rank::makes_its_kind : rank::choice;
  }

  bool says(const GivenDifference& given) const {
    const auto said_in = [](const Json& phrase, const Json& utterance) {
      const auto said = text_of(utterance, "text");
      return !said.empty() &&
             phrase.dump(-1, ' ', false, Json::error_handler_t::replace).find(said) != std::string::npos;
    };
    return said_in(given.a, pivot_.a) || said_in(given.b, pivot_.b);
  }

  // A sense of the words of the same input that only one run has, or has otherwise: best one of words that the other
  // run has in no sense, then one that has another term or cost there.
  std::optional<GivenDifference> differing_sense() const {
    const auto only_a = lacking(pivot_.senses_a, pivot_.senses_b), only_b = lacking(pivot_.senses_b, pivot_.senses_a);
    const auto sense_of = [](const std::vector<Json>& senses, const Json& sense, bool of_category) -> const Json* {
      const auto found = std::find_if(senses.begin(), senses.end(), [&](const Json& one) {
        return text_of(one, "words") == text_of(sense, "words") &&
               (!of_category || text_of(one, "category") == text_of(sense, "category"));
      });
      return found == senses.end() ? nullptr : &*found;
    };
    const auto named = [](const Json& a, const Json& b) {
      const auto words = text_of(a.is_null() ? b : a, "words");
      return GivenDifference{"lexicon", words, a, b, words};
    };
    for (const auto& sense : only_a)
      if (!sense_of(pivot_.senses_b, sense, false)) return named(sense, Json());
    for (const auto& sense : only_b)
      if (!sense_of(pivot_.senses_a, sense, false)) return named(Json(), sense);
    for (const auto& sense : only_a)
      if (const auto* other = sense_of(only_b, sense, true)) return named(sense, *other);
    if (!only_a.empty()) return named(only_a.front(), Json());
    if (!only_b.empty()) return named(Json(), only_b.front());
    return std::nullopt;
  }

  static std::vector<Json> lacking(const std::vector<Json>& senses, const std::vector<Json>& other) {
    std::vector<Json> found;
    for (const auto& sense : senses)
      if (std::find(other.begin(), other.end(), sense) == other.end()) found.push_back(sense);
    return found;
  }

  // The same parts, and another result.
  void without_givens() {
    if (pivot_.kind == RunDifference::Kind::poses)
      diff_.cause = {"physics only", "", Json(), Json(),
                     "nothing that the runs were made of differs, only where bodies are"};
    else if (pivot_.kind == RunDifference::Kind::timing)
      diff_.cause = {"timing only", "", Json(), Json(),
                     "nothing that the runs were made of differs, only when things happened"};
    else if (const auto value = refusing_value())
      diff_.cause = *value;
    else
      diff_.cause.sentence = "nothing that the runs were made of differs, as far as the logs tell";
  }

  // Why a transition of one run was refused in the other.
  static std::string reason_for(const Json& transition, const std::string& id) {
    if (const auto& refused = member_of(transition, "refused"); refused.is_array())
      for (const auto& one : refused)
        if (text_of(one, "id") == id) return text_of(one, "reason");
    return {};
  }

  std::optional<RootCause> refusing_value() const {
    const auto id_a = text_of(pivot_.transition_a, "id"), id_b = text_of(pivot_.transition_b, "id");
    for (const auto& [id, in, other] :
         {std::tuple(id_a, &pivot_.transition_b, "B"), std::tuple(id_b, &pivot_.transition_a, "A")})
      if (const auto reason = reason_for(*in, id); !reason.empty())
        return RootCause{"condition value", fmt::format("transition '{}'", id), Json(), Json(),
                         fmt::format("'{}' does not apply in {}: {}", id, other, reason)};
    return std::nullopt;
  }

  void tell_values() {
    if (const auto value = refusing_value(); value && value->sentence != diff_.cause.sentence)
      diff_.evidence.push_back(value->sentence);
    tell_referents();
    const auto &a = pivot_.transition_a, &b = pivot_.transition_b;
    if (member_of(a, "draw") != member_of(b, "draw"))
      diff_.evidence.push_back(
          fmt::format("the draw is {} in A, {} in B", compact(member_of(a, "draw")), compact(member_of(b, "draw"))));
  }

  // Objects that the same noun phrase may mean in one run and not in the other.
  void tell_referents() {
    const auto &a = member_of(pivot_.reading_a, "resolved"), &b = member_of(pivot_.reading_b, "resolved");
    if (!a.is_array() || !b.is_array()) return;
    for (const auto& one : a)
      for (const auto& other : b) {
        if (text_of(one, "phrase") != text_of(other, "phrase")) continue;
        tell_ruled_out(one, other, "B");
        tell_ruled_out(other, one, "A");
      }
  }

  void tell_ruled_out(const Json& one, const Json& other, const char* where) {
    const auto &referents = member_of(one, "referents"), &ruled_out = member_of(other, "ruled_out");
    if (!referents.is_array() || !ruled_out.is_array()) return;
    for (const auto& each : ruled_out)
      if (std::find(referents.begin(), referents.end(), member_of(each, "object")) != referents.end())
        diff_.evidence.push_back(fmt::format("{} is ruled out for “{}” in {}: {}",
                                             words_.thing(text_of(each, "object")), text_of(other, "words"), where,
                                             words_.reason(text_of(each, "reason"), text_of(each, "object"))));
  }

  const RunIndex &a_, &b_;
  RunDiff& diff_;
  Pivot pivot_;
  const RunWords words_{a_};
  GivenDifference word_;
};

}  // namespace

Outcome find_cause(const RunIndex& a, const RunIndex& b, RunDiff& diff) { return Inquiry(a, b, diff).find(); }

}  // namespace continua
