#include "continua/replay/log/run_brief.h"

#include <algorithm>

#include <fmt/format.h>

namespace continua {
namespace {

std::string joined(std::initializer_list<std::string> parts, std::string_view between = " ") {
  std::string out;
  for (const auto& part : parts) {
    if (part.empty()) continue;
    if (!out.empty()) out += between;
    out += part;
  }
  return out;
}

// "push{region: R, options: []}" of an operation with its one key.
std::string operation_text(const Json& operation) {
  if (operation.is_string()) return operation.get<std::string>();
  if (!operation.is_object() || operation.empty()) return {};
  return operation.begin().key();
}

std::string input_text(const Json& record) {
  const auto& event = member_of(record, "event");
  const auto kind = text_of(event, "kind");
  if (kind == "speech") return fmt::format("“{}”", text_of(event, "text"));
  if (kind == "gesture")
    return joined(
        {text_of(event, "hand"), text_of(event, "name"), text_of(event, "direction"), text_of(event, "phase")});
  if (kind == "pointing") return joined({"pointing", text_of(event, "hand"), text_of(event, "target")});
  if (kind == "observed") return joined({"observed", text_of(event, "channel"), text_of(event, "content")});
  return compact(event);
}

std::string slots_text(const Json& slots) {
  if (!slots.is_object()) return {};
  std::string out;
  for (const auto& [name, value] : slots.items())
    out += (out.empty() ? "" : ", ") + name + " " + (value.is_string() ? value.get<std::string>() : compact(value));
  return out;
}

std::string expect_text(const Json& record) {
  const bool met = member_of(record, "met").is_boolean() && member_of(record, "met").get<bool>();
  const auto expected = slots_text(member_of(record, "expected")), found = slots_text(member_of(record, "found"));
  return met ? "met: " + expected : fmt::format("not met: expected {}; found {}", expected, found);
}

// "there: pointed at [0.1,-0.15]", "nothing is pointed at, after 2.05 s"
std::string percept_text(const Json& record) {
  std::string text;
  if (const auto& bound = member_of(record, "bound"); bound.is_array())
    for (const auto& one : bound)
      text += fmt::format("{}{}: pointed at {}", text.empty() ? "" : ", ", text_of(one, "words"),
                          text_of(member_of(one, "deixis"), "place"));
  if (text.empty()) text = "nothing is pointed at";
  const auto waited = text_of(record, "waited_s");
  return waited.empty() || waited == "0.0" ? text : fmt::format("{}, after {} s", text, waited);
}

// "V put(plate, in_front(avatar))", "N cup or cup_blue", "not understood: glorp"
std::string reading_text(const Json& record) {
  const auto move = text_of(record, "move");
  if (move.empty()) return "not understood: " + text_of(record, "words");
  const auto& referents = member_of(record, "referents");
  if (text_of(record, "meaning").empty() || move == "N") {
    std::string objects;
    for (const auto& object : referents)
      objects += (objects.empty() ? "" : " or ") + (object.is_string() ? object.get<std::string>() : compact(object));
    if (!objects.empty() || referents.is_array()) return joined({move, objects.empty() ? "nothing" : objects});
  }
  return joined({move, text_of(record, "meaning")});
}

// "second half or first half"
std::string branches_text(const Json& record) {
  std::string states;
  const auto& branches = member_of(record, "branches");
  if (branches.is_array())
    for (const auto& one : branches) states += (states.empty() ? "" : " or ") + text_of(one, "state");
  return states;
}

struct Teller {
  const char* kind;
  std::vector<std::string_view> members;  // that it reads
  std::string_view adds;                  // all that it puts between what these say
  std::string (*tell)(const Json&);
};

const std::vector<Teller> tellers{
    Teller{"run",
           {"trace", "machine"},
           "on",
           [](const Json& r) {
             return joined({text_of(member_of(r, "trace"), "name"), "on", text_of(member_of(r, "machine"), "name")});
           }},
    Teller{"input", {"event"}, "“” pointing observed", input_text},
    Teller{"percept", {"bound", "waited_s"}, ": pointed at, nothing is pointed at, after s", percept_text},
    Teller{"reading", {"move", "words", "meaning", "referents"}, "not understood: nothing or", reading_text},
    Teller{"observed",
           {"channel", "content"},
           "",
           [](const Json& r) {
             return joined({text_of(r, "channel"), text_of(r, "content")});
           }},
    Teller{"belief",
           {"concept", "value", "was"},
           "(was )",
           [](const Json& r) {
             return fmt::format("{} {} (was {})", text_of(r, "concept"), text_of(r, "value"), text_of(r, "was"));
           }},
    Teller{"memory",
           {"register", "value"},
           ":=",
           [](const Json& r) { return fmt::format("{} := {}", text_of(r, "register"), text_of(r, "value")); }},
    Teller{"transition",
           {"from", "to"},
           "→",
           [](const Json& r) { return fmt::format("{} → {}", text_of(r, "from"), text_of(r, "to")); }},
    Teller{"correction",
           {"from", "to"},
           "→",
           [](const Json& r) { return fmt::format("{} → {}", text_of(r, "from"), text_of(r, "to")); }},
    Teller{"symbol",
           {"id", "slots"},
           "# ,",
           [](const Json& r) {
             return joined({fmt::format("#{}", text_of(r, "id")), slots_text(member_of(r, "slots"))});
           }},
    Teller{"branches", {"branches"}, "or", branches_text},
    Teller{"rewrite",
           {"state", "operation"},
           "",
           [](const Json& r) {
             return joined({text_of(r, "state"), operation_text(member_of(r, "operation"))});
           }},
    Teller{"application",
           {"function", "argument", "result"},
           "@ =",
           [](const Json& r) {
             return fmt::format("{} @ {} = {}", text_of(r, "function"), text_of(r, "argument"), text_of(r, "result"));
           }},
    Teller{"utterance", {"text"}, "“”", [](const Json& r) { return fmt::format("“{}”", text_of(r, "text")); }},
    Teller{"gesture", {"gesture"}, "", [](const Json& r) { return text_of(r, "gesture"); }},
    Teller{"act",
           {"status", "program"},
           "",
           [](const Json& r) {
             return joined({text_of(r, "status"), text_of(r, "program")});
           }},
    Teller{"pose",
           {"bodies"},
           "bodies",
           [](const Json& r) { return fmt::format("{} bodies", member_of(r, "bodies").size()); }},
    Teller{"rest",
           {"from", "to"},
           "– s",
           [](const Json& r) { return fmt::format("{} – {} s", text_of(r, "from"), text_of(r, "to")); }},
    Teller{"refusal",
           {"input", "state", "reason"},
           "in :",
           [](const Json& r) {
             return joined({text_of(r, "input"), "in", text_of(r, "state") + ":", text_of(r, "reason")});
           }},
    Teller{"problem",
           {"line", "message"},
           "line :",
           [](const Json& r) { return fmt::format("line {}: {}", text_of(r, "line"), text_of(r, "message")); }},
    Teller{"expect", {"met", "expected", "found"}, "met: not met: expected ; found ,", expect_text},
    Teller{"end", {}, "end of the log", [](const Json&) { return std::string("end of the log"); }},
};

const Teller* teller_of(std::string_view kind) {
  const auto found = std::find_if(tellers.begin(), tellers.end(), [&](const Teller& one) { return one.kind == kind; });
  return found == tellers.end() ? nullptr : &*found;
}

}  // namespace

std::optional<BriefParts> brief_parts(std::string_view kind) {
  const auto* teller = teller_of(kind);
  if (!teller) return std::nullopt;
  return BriefParts{teller->members, teller->adds};
}

const Json& member_of(const Json& object, const char* key) {
  static const Json nothing;
  if (!object.is_object()) return nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

std::string text_of(const Json& object, const char* key) {
  const auto& value = member_of(object, key);
  if (value.is_null()) return {};
  return value.is_string() ? value.get<std::string>() : compact(value);
}

std::string brief(const Json& record) {
  const auto kind = text_of(record, "kind");
  if (const auto* teller = teller_of(kind)) return teller->tell(record);
  Json rest = record;
  for (const char* key : {"kind", "n", "t", "cause"}) rest.erase(key);
  return compact(rest);
}

}  // namespace continua
