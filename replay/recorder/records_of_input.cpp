#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/learning/learning_file.h"
#include "continua/replay/recorder/grid.h"
#include "continua/replay/recorder/record_of.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr double weight_grid = 1e-6;

double on_weight_grid(double weight) { return std::round(weight / weight_grid) * weight_grid + 0.0; }

std::string joined(const std::vector<std::string>& words) { return fmt::to_string(fmt::join(words, " ")); }

std::string name_of(Gap::Why why) {
  constexpr std::array names{"unsaid", "several", "none"};
  return names[static_cast<std::size_t>(why)];
}

std::string name_of(Resolution::By by) {
  constexpr std::array names{"words", "focus", "pointed", "topic", "presence"};
  return names[static_cast<std::size_t>(by)];
}

std::string value_of(Lesson lesson, const Term& value) {
  return lesson == Lesson::word ? print(Program{value}) : print(value);
}

log::Deixis record_of(const Deixis& pointing) {
  log::Deixis record;
  for (const double metres : {pointing.place_W.x(), pointing.place_W.y()})
    record.place.push_back(rounded(metres, pose_steps_per_metre));
  record.from_s = pointing.from.seconds();
  record.until_s = pointing.until.seconds();
  if (!pointing.hand.empty()) record.hand = pointing.hand;
  record.gesture = pointing.gesture;
  record.spread_m = rounded(pointing.spread_m, pose_steps_per_metre);
  record.samples = static_cast<std::int64_t>(pointing.samples);
  record.left_out = static_cast<std::int64_t>(pointing.left_out);
  if (pointing.distance_m) record.distance_m = rounded(*pointing.distance_m, pose_steps_per_metre);
  return record;
}

std::vector<std::string> names_of(const Reference& reference) {
  std::vector<std::string> names;
  for (const auto& referent : reference.referents) names.push_back(referent.object);
  return names;
}

// A pointing's reading and a resolved noun phrase tell a reference by the same members.
template <class WithReference>
void add_reference(const Reference& reference, WithReference& record) {
  auto& weights = record.weights.emplace();
  for (const auto& referent : reference.referents) weights.push_back(on_weight_grid(referent.weight));
  auto& ruled_out = record.ruled_out.emplace();
  for (const auto& [name, reason] : reference.ruled_out) ruled_out.push_back({name, reason});
  if (reference.sides != Sides::exact) record.sides = reference.sides == Sides::rough ? "rough" : "loose";
  auto& margin = record.margin.emplace();
  if (std::isfinite(reference.margin)) margin = log::Margin(reference.margin);
}

log::Resolution record_of(const Resolution& resolution) {
  log::Resolution record;
  record.phrase = print(resolution.phrase);
  record.words = resolution.words;
  record.value = print(resolution.value);
  record.by = name_of(resolution.by);
  if (!resolution.has_referents()) return record;
  record.referents = names_of(resolution.reference);
  add_reference(resolution.reference, record);
  return record;
}

log::Parse record_of(const Reading& reading) {
  return {print(reading.term), reading.term.type().text(), reading.category, reading.move, reading.cost};
}

log::Missing record_of(const Gap& gap) { return {gap.type.text(), name_of(gap.why), gap.choices, gap.words}; }

// The senses that the parses are made of, each once, with the parses that have it where not all do.
std::vector<log::Sense> entries_of(const std::vector<Reading>& parses) {
  std::vector<log::Sense> entries;
  const auto key = [](const log::Sense& sense) {
    return std::tie(sense.words, sense.category, sense.term, sense.cost);
  };
  for (std::size_t i = 0; i < parses.size(); ++i)
    for (const auto& sense : parses[i].senses) {
      log::Sense entry;
      entry.words = sense.words;
      if (!sense.category.empty()) entry.category = sense.category;
      if (!sense.category.empty()) entry.term = print(sense.term);
      entry.cost = sense.cost;
      auto known = std::find_if(entries.begin(), entries.end(),
                                [&](const log::Sense& other) { return key(other) == key(entry); });
      if (known == entries.end()) {
        entry.parses.emplace();
        known = entries.insert(entries.end(), std::move(entry));
      }
      const auto rank = static_cast<std::int64_t>(i);
      if (known->parses->empty() || known->parses->back() != rank) known->parses->push_back(rank);
    }
  for (auto& entry : entries)
    if (entry.parses->size() == parses.size()) entry.parses.reset();
  return entries;
}

log::ShapeMatch record_of(const Recognition& found) {
  constexpr std::array verdicts{"named", "recognised", "too far", "contested", "nothing known"};
  log::ShapeMatch record;
  record.verdict = verdicts[static_cast<std::size_t>(found.verdict)];
  if (found.nearest) record.nearest = found.nearest->gesture, record.distance = found.nearest->distance;
  if (found.rival) record.rival = found.rival->gesture, record.rival_distance = found.rival->distance;
  record.of_other_length = static_cast<std::int64_t>(found.of_other_length);
  record.reason = found.reason;
  return record;
}

void add_words(const Move& move, log::Reading& record) {
  const auto& reading = move.readings[move.chosen];
  const auto& meaning = move.interpretation.meaning;
  record.reading = print(reading.term);
  record.category = reading.category;
  record.meaning = print(meaning);
  record.type = meaning.type().text();
  auto& missing = record.missing.emplace();
  for (const auto& gap : move.interpretation.gaps) missing.push_back(record_of(gap));
  auto& resolved = record.resolved.emplace();
  for (const auto& each : move.interpretation.resolutions) resolved.push_back(record_of(each));
  record.rank = static_cast<std::int64_t>(move.chosen);
  auto& parses = record.parses.emplace();
  for (const auto& each : move.readings) parses.push_back(record_of(each));
  record.entries = entries_of(move.readings);
  if (!reading.rules.empty()) record.rules = reading.rules;
}

}  // namespace

void SourceRecords::add(int source, int record) {
  auto& records = source > 0 ? inputs_ : values_;
  const auto place = static_cast<std::size_t>(std::abs(source));
  if (records.size() <= place) records.resize(place + 1, -1);
  records[place] = record;
}

std::optional<int> SourceRecords::find(int source) const {
  const auto& records = source > 0 ? inputs_ : values_;
  const auto place = static_cast<std::size_t>(std::abs(source));
  return place < records.size() && records[place] >= 0 ? std::optional(records[place]) : std::nullopt;
}

std::vector<std::int64_t> records_of(const std::vector<int>& sources, const SourceRecords& records) {
  std::vector<std::int64_t> found;
  for (const int source : sources)
    if (const auto record = records.find(source)) found.push_back(*record);
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<std::vector<std::string>> referents_of(const Move& move) {
  const auto& reference = move.reference;
  const bool has = move.kind == deixis || !reference.referents.empty() || !reference.ruled_out.empty();
  return has ? std::optional(names_of(reference)) : std::nullopt;
}

log::Percept record_of(const Attended& attended, const SourceRecords& sources) {
  log::Percept record;
  record.waited_s = (attended.at - attended.happened).seconds();
  std::set<int> because = {attended.pieces.begin(), attended.pieces.end()};
  because.insert(attended.serial);
  because.insert(attended.assured.begin(), attended.assured.end());
  if (!attended.pieces.empty()) record.joined = attended.text;
  if (!attended.assured.empty()) record.assured = true;
  for (const auto& [words, pointing] : attended.bound) {
    record.bound.push_back({joined(words), record_of(pointing)});
    because.insert(pointing.serials.begin(), pointing.serials.end());
  }
  record.because = records_of({because.begin(), because.end()}, sources);
  return record;
}

log::Reading record_of(const Understood& understood, const SourceRecords& sources) {
  const auto& move = understood.move;
  log::Reading record;
  if (!move.kind.empty()) record.move = move.kind;
  if (!move.words.empty()) record.words = joined(move.words);
  if (!move.readings.empty()) add_words(move, record);
  record.referents = referents_of(move);
  if (record.referents && move.readings.empty()) add_reference(move.reference, record);
  if (move.shape) record.shape = record_of(*move.shape);
  if (!move.unknown.empty()) record.unknown = move.unknown;
  if (!move.unused.empty()) record.unused = move.unused;
  if (!move.repaired.empty()) record.repaired = move.repaired;
  record.because = records_of(understood.because, sources);
  if (!understood.alternative) return record;
  record.alternative = static_cast<std::int64_t>(*understood.alternative);
  record.confidence = understood.confidence;
  record.taken = understood.taken;
  return record;
}

log::Learned record_of(const Taught& taught, const SourceRecords& sources) {
  return {name_of(taught.of), taught.name, value_of(taught.of, taught.value), records_of(taught.because, sources)};
}

log::Forgotten record_of(const Forgotten& forgotten, const SourceRecords& sources) {
  return {name_of(*forgotten.of), forgotten.name, value_of(*forgotten.of, forgotten.value),
          records_of(forgotten.because, sources)};
}

}  // namespace continua
