#include "continua/replay/recorder/reading_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr double weight_grid = 1e-6;

double on_weight_grid(double weight) { return std::round(weight / weight_grid) * weight_grid + 0.0; }

std::string text(Gap::Why why) {
  switch (why) {
    case Gap::Why::unsaid:
      return "unsaid";
    case Gap::Why::several:
      return "several";
    case Gap::Why::none:
      return "none";
  }
  return "unsaid";
}

std::string text(Resolution::By by) {
  switch (by) {
    case Resolution::By::words:
      return "words";
    case Resolution::By::focus:
      return "focus";
    case Resolution::By::pointed:
      return "pointed";
    case Resolution::By::topic:
      return "topic";
    case Resolution::By::presence:
      return "presence";
  }
  return "words";
}

Json json_of(const Reading& reading) {
  return {{"reading", print(reading.term)},
          {"type", reading.term.type().text()},
          {"category", reading.category},
          {"move", reading.move},
          {"cost", reading.cost}};
}

void add_reference(Json& object, const Reference& reference) {
  Json weights = Json::array(), ruled_out = Json::array();
  for (const auto& referent : reference.referents) weights.push_back(on_weight_grid(referent.weight));
  for (const auto& [name, reason] : reference.ruled_out) ruled_out.push_back({{"object", name}, {"reason", reason}});
  object["weights"] = std::move(weights);
  object["ruled_out"] = std::move(ruled_out);
  if (reference.sides != Sides::exact) object["sides"] = reference.sides == Sides::rough ? "rough" : "loose";
  object["margin"] = std::isfinite(reference.margin) ? Json(reference.margin) : Json(nullptr);
}

std::vector<std::string> names(const Reference& reference) {
  std::vector<std::string> names;
  for (const auto& referent : reference.referents) names.push_back(referent.object);
  return names;
}

Json json_of(const Resolution& resolution) {
  Json object{{"phrase", print(resolution.phrase)},
              {"words", resolution.words},
              {"value", print(resolution.value)},
              {"by", text(resolution.by)}};
  if (!resolution.has_referents()) return object;
  object["referents"] = names(resolution.reference);
  add_reference(object, resolution.reference);
  return object;
}

// The senses that the parses are made of, each once, with the parses that have it where not all do.
Json entries_of(const std::vector<Reading>& parses) {
  std::vector<std::pair<Json, std::vector<std::size_t>>> entries;
  for (std::size_t i = 0; i < parses.size(); ++i)
    for (const auto& sense : parses[i].senses) {
      Json entry{{"words", sense.words}};
      if (!sense.category.empty()) entry["category"] = sense.category;
      if (!sense.category.empty()) entry["term"] = print(sense.term);
      entry["cost"] = sense.cost;
      const auto same = [&](const auto& other) { return other.first == entry; };
      auto known = std::find_if(entries.begin(), entries.end(), same);
      if (known == entries.end()) known = entries.emplace(entries.end(), std::move(entry), std::vector<std::size_t>());
      if (known->second.empty() || known->second.back() != i) known->second.push_back(i);
    }
  Json json = Json::array();
  for (auto& [entry, of] : entries) {
    if (of.size() < parses.size()) entry["parses"] = of;
    json.push_back(std::move(entry));
  }
  return json;
}

Json json_of(const Gap& gap) {
  return {{"type", gap.type.text()}, {"why", text(gap.why)}, {"choices", gap.choices}, {"words", gap.words}};
}

}  // namespace

std::optional<std::vector<std::string>> referents_of(const Move& move) {
  const auto& reference = move.reference;
  const bool has = move.kind == deixis || !reference.referents.empty() || !reference.ruled_out.empty();
  return has ? std::optional(names(move.reference)) : std::nullopt;
}

Json reading_fields(const Move& move, Json because) {
  Json fields{{"move", move.kind.empty() ? Json(nullptr) : Json(move.kind)}};
  if (!move.words.empty()) fields["words"] = fmt::format("{}", fmt::join(move.words, " "));
  if (!move.readings.empty()) {
    const auto& reading = move.readings[move.chosen];
    fields["reading"] = print(reading.term);
    fields["category"] = reading.category;
    fields["meaning"] = print(move.interpretation.meaning);
    fields["type"] = move.interpretation.meaning.type().text();
    Json parses = Json::array(), missing = Json::array(), resolved = Json::array();
    for (const auto& each : move.readings) parses.push_back(json_of(each));
    for (const auto& gap : move.interpretation.gaps) missing.push_back(json_of(gap));
    for (const auto& each : move.interpretation.resolutions) resolved.push_back(json_of(each));
    fields["missing"] = std::move(missing);
    fields["resolved"] = std::move(resolved);
    fields["rank"] = move.chosen;
    fields["parses"] = std::move(parses);
    fields["entries"] = entries_of(move.readings);
    if (!reading.rules.empty()) fields["rules"] = reading.rules;
  }
  if (const auto referents = referents_of(move)) {
    fields["referents"] = *referents;
    if (move.readings.empty()) add_reference(fields, move.reference);
  }
  if (!move.unknown.empty()) fields["unknown"] = move.unknown;
  if (!move.unused.empty()) fields["unused"] = move.unused;
  fields["because"] = std::move(because);
  return fields;
}

}  // namespace continua
