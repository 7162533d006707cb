#include "continua/replay/explain/explain_origin.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "continua/replay/explain/explain_term.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/term/written_term.h"

namespace continua {
namespace {

constexpr int deepest = 8;  // how often “it” goes back to another “it”

using Found = std::optional<Json>;

std::string string_of(const Json& value) { return value.is_string() ? value.get<std::string>() : compact(value); }

// Whether the list has the value, or all that the value lists.
bool lists(const Json& list, const std::string& value) {
  if (!list.is_array()) return false;
  const auto has = [&](const std::string& text) { return std::find(list.begin(), list.end(), text) != list.end(); };
  const auto parts = term_parts(value);
  return parts.head.empty() && !parts.elements.empty() ? std::all_of(parts.elements.begin(), parts.elements.end(), has)
                                                       : has(value);
}

Json origin(ExplainScope& scope, const char* kind, std::string text, std::size_t n) {
  const auto input = scope.input_of(n);
  return {{"kind", kind},
          {"text", std::move(text)},
          {"n", n},
          {"input", input ? Json(*input) : Json()},
          {"t", input ? Json(scope.run().entry(*input).t.seconds()) : Json()}};
}

Found found_in_turn(ExplainScope& scope, const std::string& value, std::size_t input, std::size_t at, int depth);

// A way to resolve a phrase, by its name in the log and its name for readers.
struct Way {
  const char* by;
  const char* text;
};
constexpr std::array ways{Way{"focus", "what was talked about"}, Way{"topic", "the noun that was used last"},
                          Way{"pointed", "what was pointed at"}, Way{"presence", "who speaks or listens"}};

// The latest turn before this one that has the value.
Found found_before(ExplainScope& scope, const std::string& value, std::size_t input, int depth) {
  const auto& inputs = scope.inputs();
  for (auto earlier = inputs.rbegin(); earlier != inputs.rend(); ++earlier)
    if (*earlier < input)
      if (auto found = found_in_turn(scope, value, *earlier, input, depth)) return found;
  return std::nullopt;
}

// The pointings that a percept of this turn bound to the words.
Found found_pointing(ExplainScope& scope, const std::string& words, std::size_t input) {
  for (const auto n : scope.of_turn(input, log::Percept::kind.name))
    for (const auto& bound : member_of(scope.record(n), "bound")) {
      if (text_of(bound, "words") != words) continue;
      const auto& deixis = member_of(bound, "deixis");
      std::string hand = text_of(deixis, "hand"),
                  text = hand.empty() ? "a pointing" : "the " + hand + " hand’s pointing";
      if (const auto& from = member_of(deixis, "from"); from.is_number())
        text += fmt::format(" ({})", time_text(from.get<double>()));
      auto found = origin(scope, "pointing", text, n);
      for (const auto other : record_numbers(scope.record(n), "because", n))
        if (other != input && log::is<log::Input>(scope.run().kind(other))) {
          found["input"] = other;
          found["t"] = scope.run().entry(other).t.seconds();
        }
      return found;
    }
  return std::nullopt;
}

// Whether the value, or the gesture of this turn, goes back to a lesson.
Found found_taught(ExplainScope& scope, const std::string& name, std::size_t at) {
  const auto lessons = scope.run().of_kind(log::Learned::kind.name);
  for (auto n = std::lower_bound(lessons.begin(), lessons.end(), at); n != lessons.begin();) {
    const auto& lesson = scope.record(*--n);
    if (text_of(lesson, "name") != name) continue;
    return origin(scope, "taught",
                  fmt::format("taught at {} as {} (#{})", time_text(scope.run().entry(*n).t.seconds()),
                              text_of(lesson, "value"), *n),
                  *n);
  }
  return std::nullopt;
}

// The origin, with the lesson that it goes back to where there is one of this name.
Json with_lesson(ExplainScope& scope, Json found, const std::string& name, std::size_t at) {
  if (name.empty()) return found;
  if (auto taught = found_taught(scope, name, at)) {
    found["text"] = found["text"].get<std::string>() + ", " + (*taught)["text"].get<std::string>();
    found["from"] = *std::move(taught);
  }
  return found;
}

// The name under which the gesture was taught: its own, or that of the exemplar by which it was recognised.
std::string gesture_of(ExplainScope& scope, std::size_t input) {
  for (const auto n : scope.of_turn(input, log::Reading::kind.name))
    if (const auto nearest = text_of(member_of(scope.record(n), "shape"), "nearest"); !nearest.empty()) return nearest;
  return text_of(member_of(scope.record(input), "event"), "name");
}

Json resolved_origin(ExplainScope& scope, const Json& resolved, const std::string& value, std::size_t reading,
                     std::size_t input, int depth) {
  const auto words = text_of(resolved, "words"), by = text_of(resolved, "by");
  auto found =
      origin(scope, words.empty() ? "gesture" : "words",
             (words.empty() ? std::string() : fmt::format("“{}” in ", words)) + told_input(scope, input), reading);
  found["words"] = words;
  found["by"] = by;
  const auto way = way_text(by);
  if (way.empty()) return with_lesson(scope, std::move(found), words.empty() ? gesture_of(scope, input) : "", reading);
  auto from = by == "pointed" ? found_pointing(scope, words, input) : std::nullopt;
  if (!from) from = found_before(scope, value, input, depth + 1);
  auto text = found["text"].get<std::string>() + ", " + way;
  if (from) {
    text += ": " + (*from)["text"].get<std::string>();
    found["from"] = *std::move(from);
  }
  found["text"] = std::move(text);
  return found;
}

// Why the reading has the lambda that binds `name`.
Found found_open(ExplainScope& scope, const Json& reading, const std::string& name, std::size_t n, std::size_t input) {
  const auto binders = term_parts(text_of(reading, "meaning")).binders;
  const auto place = std::find(binders.begin(), binders.end(), name);
  if (place == binders.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(place - binders.begin());
  const auto& missing = member_of(reading, "missing");
  std::string why = "left open";
  if (missing.is_array() && index < missing.size())
    if (const auto told = missing_text(scope.words(), missing[index]); !told.empty()) why += ": " + told;
  return origin(scope, "open", fmt::format("{}, in {}", why, told_input(scope, input)), n);
}

Found found_in_reading(ExplainScope& scope, const std::string& value, std::size_t n, std::size_t input, int depth) {
  const Json& reading = scope.record(n);
  if (member_of(reading, "taken") == false) return std::nullopt;
  const auto& resolved = member_of(reading, "resolved");
  if (resolved.is_array())
    for (const auto& one : resolved)
      if (text_of(one, "value") == value) return resolved_origin(scope, one, value, n, input, depth);
  if (resolved.is_array())
    for (const auto& one : resolved)
      if (const auto& referents = member_of(one, "referents"); lists(referents, value) && referents.size() > 1)
        return origin(scope, "choice",
                      fmt::format("{}, which “{}” in {} may mean", alternatives_text(scope.words().each(referents)),
                                  text_of(one, "words"), told_input(scope, input)),
                      n);
  if (auto open = found_open(scope, reading, value, n, input)) return open;
  if (const auto& entries = member_of(reading, "entries"); entries.is_array())
    for (const bool exactly : {true, false})
      for (const auto& entry : entries) {
        const auto term = text_of(entry, "term");
        if (!is_of_reading(entry, reading)) continue;
        if (exactly ? term != value : !mentions(term, value)) continue;
        auto found =
            origin(scope, "words", fmt::format("“{}” in {}", text_of(entry, "words"), told_input(scope, input)), n);
        found["words"] = text_of(entry, "words");
        return with_lesson(scope, std::move(found), value, n);
      }
  if (mentions(text_of(reading, "reading"), value) || text_of(reading, "meaning") == value) {
    const bool spoken = !text_of(reading, "words").empty();
    auto found = origin(scope, spoken ? "words" : "gesture", told_input(scope, input), n);
    return with_lesson(scope, std::move(found), spoken ? value : gesture_of(scope, input), n);
  }
  if (lists(member_of(reading, "referents"), value))
    return origin(scope, "pointing", fmt::format("among what {} can mean", told_input(scope, input)), n);
  return std::nullopt;
}

// Whether the value is this place of the table, as a term has it.
bool is_place(const std::string& value, const Json& place) {
  return place.is_array() && place.size() == 2 &&
         value == fmt::format("<{}, {}, 0>", compact(place[0]), compact(place[1]));
}

// The words, or the finger alone, that showed the place.
Found found_shown(ExplainScope& scope, const std::string& value, std::size_t input) {
  for (const auto n : scope.of_turn(input, log::Percept::kind.name))
    for (const auto& bound : member_of(scope.record(n), "bound"))
      if (is_place(value, member_of(member_of(bound, "deixis"), "place")))
        return resolved_origin(scope, {{"words", text_of(bound, "words")}, {"by", "pointed"}}, value, n, input, 0);
  if (is_place(value, member_of(member_of(scope.record(input), "event"), "target")))
    return origin(scope, "pointing", told_input(scope, input), input);
  return std::nullopt;
}

Found found_in_turn(ExplainScope& scope, const std::string& value, std::size_t input, std::size_t at, int depth) {
  if (depth > deepest) return std::nullopt;
  const auto readings = scope.of_turn(input, log::Reading::kind.name);
  for (auto n = readings.rbegin(); n != readings.rend(); ++n)
    if (*n <= at)
      if (auto found = found_in_reading(scope, value, *n, input, depth)) return found;
  return found_shown(scope, value, input);
}

// The first register or slot of the turns that had the value, alone or among others.
Found first_kept(ExplainScope& scope, const std::string& value, std::size_t at) {
  for (const auto input : scope.inputs()) {
    if (input > at) break;
    for (const auto n : scope.of_turn(input, log::Memory::kind.name))
      if (n <= at && mentions(text_of(scope.record(n), "value"), value))
        return origin(
            scope, "memory",
            fmt::format("register {} since {}  #{}", text_of(scope.record(n), "register"), told_input(scope, input), n),
            n);
    for (const auto n : scope.of_turn(input, log::Symbol::kind.name)) {
      const auto& slots = member_of(scope.record(n), "slots");
      if (n > at || !slots.is_object()) continue;
      for (const auto& [slot, held] : slots.items())
        if (mentions(string_of(held), value))
          return origin(scope, "slot", fmt::format("slot {} since {}  #{}", slot, told_input(scope, input), n), n);
    }
  }
  return std::nullopt;
}

Found in_a_lesson(ExplainScope& scope, const std::string& value, std::size_t at) {
  for (const auto n : scope.latest(log::Reading::kind.name))
    if (const auto head = term_parts(text_of(scope.record(n), "meaning")).head; n <= at && !head.empty())
      if (auto taught = found_taught(scope, head, at); taught && mentions((*taught)["text"].get<std::string>(), value))
        return taught;
  return std::nullopt;
}

}  // namespace

std::string told_input(ExplainScope& scope, std::size_t input) {
  const auto t = time_text(scope.run().entry(input).t.seconds());
  for (const auto n : scope.of_turn(input, log::Reading::kind.name)) {
    const auto& reading = scope.record(n);
    const auto& alternative = member_of(reading, "alternative");
    if (member_of(reading, "taken") != true || !alternative.is_number_unsigned() || alternative == 0) continue;
    return fmt::format("{} ({}, alternative {})",
                       input_text(scope.words(), scope.record(input), alternative.get<std::size_t>()), t,
                       compact(alternative));
  }
  return fmt::format("{} ({})", input_text(scope.words(), scope.record(input)), t);
}

std::string alternatives_text(const Json& names, std::string_view before_last, std::size_t most) {
  if (!names.is_array()) return string_of(names);
  std::string text;
  const auto told = std::min(names.size(), most);
  for (std::size_t i = 0; i < told; ++i)
    text += std::string(i == 0 ? "" : i + 1 == names.size() ? before_last : ", ") + string_of(names[i]);
  return told == names.size() ? text : text + fmt::format(" … ({} in all)", names.size());
}

std::string missing_text(const RunWords& words, const Json& missing) {
  const auto why = text_of(missing, "why"), said = text_of(missing, "words");
  if (why == "unsaid") return "it was not said";
  if (why == "several")
    return fmt::format("{} may mean {}", said.empty() ? "it" : "“" + said + "”",
                       alternatives_text(words.each(member_of(missing, "choices"))));
  if (why == "none") return said.empty() ? "nothing is meant" : fmt::format("there is no “{}”", said);
  return why;
}

std::string way_text(const std::string& by) {
  const auto way = std::find_if(ways.begin(), ways.end(), [&](const Way& one) { return by == one.by; });
  return way == ways.end() ? "" : way->text;
}

bool is_of_reading(const Json& entry, const Json& reading) {
  const auto& parses = member_of(entry, "parses");
  return !entry.is_object() || entry.contains("category")
             ? !parses.is_array() || std::find(parses.begin(), parses.end(), member_of(reading, "rank")) != parses.end()
             : false;
}

Json origin_of(ExplainScope& scope, const std::string& value, std::size_t at) {
  const auto here = scope.input_of(at);
  if (here)
    if (auto found = found_in_turn(scope, value, *here, at, 0)) return *std::move(found);
  if (auto found = found_before(scope, value, here.value_or(at), 0)) return *std::move(found);
  if (auto found = in_a_lesson(scope, value, at)) return *std::move(found);
  if (auto found = first_kept(scope, value, at)) return *std::move(found);
  if (here) return origin(scope, "machine", "the machine itself, on " + told_input(scope, *here), at);
  return origin(scope, "machine", "the machine itself, without any input", at);
}

}  // namespace continua
