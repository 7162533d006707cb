// Kinds of records in a few words, where that takes more than a line.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/log/records.h"

namespace continua::log {
namespace {

// A member of an object that the trace or the machine file declares: text as it is, all else as JSON.
std::string text_in(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (found == object.end() || found->is_null()) return {};
  return found->is_string() ? found->get<std::string>() : compact(*found);
}

std::string members_text(const Json& object) {
  std::string out;
  if (!object.is_object()) return out;
  for (const auto& [name, value] : object.items())
    out += (out.empty() ? "" : ", ") + name + " " + (value.is_string() ? value.get<std::string>() : compact(value));
  return out;
}

}  // namespace

std::string Unknown::brief() const { return compact(members); }

std::string Input::brief() const {
  const auto of = text_in(event, "kind");
  const auto part = [this](const char* key) { return text_in(event, key); };
  const auto is_final = event.find("final");
  const bool may_change = is_final != event.end() && *is_final == false;
  if (of == "speech") return fmt::format("“{}”{}", part("text"), may_change ? " (not final)" : "");
  if (of == "gesture") {
    const bool has_shape = part("name").empty() && event.contains("features");
    return joined({part("hand"), has_shape ? "unnamed" : part("name"), part("direction"), part("phase")});
  }
  if (of == "pointing") return joined({"pointing", part("hand"), part("target")});
  if (of == "gaze") return joined({"gaze", part("target")});
  if (of == "observed") return joined({"observed", part("channel"), part("content")});
  return compact(event);
}

// "there: pointed at [0.1,-0.15]", "nothing is pointed at, after 2.05 s"
std::string Percept::brief() const {
  std::string text = joined ? fmt::format("\"{}\"", *joined) : "";
  for (const auto& [words, deixis] : bound)
    text += fmt::format("{}{}: pointed at {}", text.empty() ? "" : ", ", words, compact(Json(deixis.place)));
  if (assured) text += text.empty() ? "it was meant" : ", it was meant";
  if (text.empty()) text = "nothing is pointed at";
  return waited_s == 0 ? text : fmt::format("{}, after {} s", text, number_text(waited_s));
}

// "V put(plate, in_front(avatar))", "N cup or cup_blue", "not understood: glorp"
std::string Reading::brief() const {
  if (!move || move->empty()) return "not understood: " + words.value_or("");
  const auto said = meaning.value_or("");
  if (referents && (said.empty() || *move == "N")) {
    const auto objects = fmt::to_string(fmt::join(*referents, " or "));
    return joined({*move, objects.empty() ? "nothing" : objects});
  }
  return joined({*move, said});
}

std::string Expect::brief() const {
  const auto wanted = members_text(expected);
  return met ? "met: " + wanted : fmt::format("not met: expected {}; found {}", wanted, members_text(found));
}

// "second half or first half"
std::string Branches::brief() const {
  std::string states;
  for (const auto& branch : branches) states += (states.empty() ? "" : " or ") + branch.state;
  return states;
}

// The branch, the kind, and the member that tells most.
std::string Branched::brief() const {
  for (const char* key : {"id", "program", "text", "gesture", "register", "result", "state", "message"})
    if (auto told = text_in(record, key); !told.empty()) return joined({std::to_string(branch), what, told});
  return joined({std::to_string(branch), what});
}

std::string Symbol::brief() const {
  std::string told;
  for (const auto& [slot, value] : slots) told += (told.empty() ? "" : ", ") + slot + " " + value;
  return joined({fmt::format("#{}", id), told});
}

std::string Rewrite::brief() const {
  if (operation.is_string()) return joined({state, operation.get<std::string>()});
  return joined({state, operation.is_object() && !operation.empty() ? operation.begin().key() : std::string()});
}

}  // namespace continua::log
