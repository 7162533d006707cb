#include "continua/replay/log/brief_in_words.h"

#include <string_view>

#include <fmt/format.h>

#include "continua/replay/log/expectation_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

// A text in words, quoted where it has any.
void tell(const RunWords& words, Json& value) {
  if (!value.is_string()) return;
  const auto term = value.get<std::string>();
  if (const auto told = words.term(term); told != term) value = "“" + told + "”";
}

void tell(const RunWords& words, Json& object, std::string_view key) {
  if (!object.is_object()) return;
  if (const auto found = object.find(std::string(key)); found != object.end()) tell(words, *found);
}

void tell_each(const RunWords& words, Json& record, std::string_view member) {
  const auto values = record.find(std::string(member));
  if (values == record.end() || !values->is_object()) return;
  for (auto& value : *values) tell(words, value);
}

void tell_referents(const RunWords& words, Json& reading) {
  const auto referents = reading.find(std::string(log::name_of(&log::Reading::referents)));
  if (referents == reading.end() || !referents->is_array()) return;
  for (auto& one : *referents)
    if (one.is_string()) one = words.thing(one.get<std::string>());
}

// "pointing with the right hand at the place 10 cm left of the table's middle"; nothing for other inputs.
std::string place_shown(const RunWords& words, const Json& event) {
  const auto kind = text_of(event, "kind"), hand = text_of(event, "hand");
  const auto& target = member_of(event, "target");
  if ((kind != "pointing" && kind != "gaze") || !target.is_array()) return {};
  const auto spot = words.spot(target);
  return fmt::format("{}{}{}{}", kind, hand.empty() ? "" : " with the " + hand + " hand",
                     spot == compact(target) ? " " : " at the place ", spot);
}

// The places that a percept's words go with, in its text.
std::string with_places(const RunWords& words, const Json& percept, std::string text) {
  const auto& bound = member_of(percept, "bound");
  if (!bound.is_array()) return text;
  for (const auto& one : bound) {
    const auto& place = member_of(member_of(one, "deixis"), "place");
    const auto logged = compact(place), spot = words.spot(place);
    if (const auto at = text.find(logged); spot != logged && at != text.npos)
      text.replace(at, logged.size(), "the place " + spot);
  }
  return text;
}

}  // namespace

std::string input_text(const RunWords& words, const Json& input, std::size_t alternative) {
  const auto& event = member_of(input, "event");
  const auto kind = text_of(event, "kind");
  const bool has_own = member_of(event, kind == "speech" ? "text" : "name").is_string();
  const auto& others = member_of(event, "alternatives");
  if (const auto place = alternative - (has_own ? 1 : 0);
      others.is_array() && !(has_own && alternative == 0) && place < others.size())
    return fmt::format("{}“{}”", kind == "speech" ? "" : kind + " ", text_of(others[place], "text"));
  if (kind == "act")
    return fmt::format("act {}, “{}”, {}", text_of(event, "act"), words.term(text_of(event, "program")),
                       text_of(event, "status"));
  if (auto shown = place_shown(words, event); !shown.empty()) return shown;
  if (kind != "gesture" || !has_own) return kind == "gesture" ? "gesture " + brief(input) : brief(input);
  const auto phase = text_of(event, "phase");
  const bool whole = phase.empty() || phase == "stroke";
  return fmt::format("gesture “{}”{}", words.gesture(text_of(event, "name"), text_of(event, "direction")),
                     whole ? "" : fmt::format(" ({})", phase));
}

std::string brief_in_words(const RunWords& words, const Json& record) {
  const auto kind = text_of(record, "kind");
  if (log::is<log::Input>(kind)) return input_text(words, record);
  if (log::is<log::Expect>(kind)) return expectation_text(words, record);
  if (log::is<log::Percept>(kind)) return with_places(words, record, brief(record));
  auto told = record;
  if (log::is<log::Learned>(kind)) {
    tell(words, told, log::name_of(&log::Learned::value));
    if (text_of(told, "of") == "gesture") told["name"] = words.gesture(text_of(told, "name"), "");
  }
  if (log::is<log::AvatarGesture>(kind)) tell(words, told, log::name_of(&log::AvatarGesture::gesture));
  if (log::is<log::Act>(kind)) tell(words, told, log::name_of(&log::Act::program));
  if (log::is<log::Memory>(kind)) tell(words, told, log::name_of(&log::Memory::value));
  if (log::is<log::Observed>(kind)) tell(words, told, log::name_of(&log::Observed::content));
  if (log::is<log::Symbol>(kind)) tell_each(words, told, log::name_of(&log::Symbol::slots));
  if (log::is<log::Reading>(kind)) {
    tell(words, told, log::name_of(&log::Reading::meaning));
    tell_referents(words, told);
  }
  return brief(told);
}

}  // namespace continua
