#include "continua/replay/session/live_setup.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/log/run_words.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {
namespace {

Json button(const RunWords& words, const InputEvent& gesture, const std::string& about) {
  Json event{{"kind", "gesture"}, {"name", gesture.name}};
  auto label = words.gesture(gesture.name, gesture.direction);
  for (const auto& [key, value] : {std::pair("hand", gesture.hand), std::pair("direction", gesture.direction),
                                   std::pair("phase", gesture.phase)}) {
    if (value.empty()) continue;
    event[key] = value;
    if (value != "stroke" && value != gesture.direction) label += fmt::format(" ({})", value);
  }
  return {{"label", label}, {"about", about}, {"event", std::move(event)}};
}

// The problems of one file, as they are found.
class SetupCheck {
 public:
  SetupCheck(const LocatedJson& document, std::vector<Error>& problems) : document_(document), problems_(problems) {}

  // The object's keys are among these.
  void keys(const std::string& pointer, const Json& object, const std::vector<std::string>& known) {
    for (const auto& [key, value] : object.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        problems_.push_back(document_.error(document_.key_place(pointer + "/" + key),
                                            fmt::format("unknown key {}{}; expected {}", in_quotes(key),
                                                        did_you_mean(key, known), fmt::join(known, ", "))));
  }

  // A text that is not empty; an empty or missing one is a problem, and gives an empty text.
  std::string text(const std::string& pointer, const Json& object, const std::string& key) {
    const auto found = object.find(key);
    if (found != object.end() && found->is_string() && !found->get<std::string>().empty()) return *found;
    problem(found == object.end() ? pointer : pointer + "/" + key, fmt::format("expected a text as '{}'", key));
    return {};
  }

  void button(const std::string& pointer, const Json& button) {
    if (!button.is_object()) return problem(pointer, "expected a button: {\"label\": …, \"key\": …, \"event\": …}");
    keys(pointer, button, {"label", "key", "event"});
    text(pointer, button, "label");
    const auto key = text(pointer, button, "key");
    if (key.size() > 1) problem(pointer + "/key", fmt::format("found {}; expected one letter", in_quotes(key)));
    if (!key.empty() && !keys_.insert(key).second)
      problem(pointer + "/key", fmt::format("the key {} has another button already", in_quotes(key)));
    if (!button.contains("event")) return problem(pointer, "expected an 'event' of a trace, without 't'");
    Json event = button["event"];
    if (event.is_object()) event["t"] = 0;
    if (const auto read = read_event(event, "", 1); !read) problem(pointer + "/event", read.error().sentence);
  }

  void problem(const std::string& pointer, std::string sentence) {
    problems_.push_back(document_.error(pointer, std::move(sentence)));
  }

 private:
  const LocatedJson& document_;
  std::vector<Error>& problems_;
  std::set<std::string> keys_;
};

}  // namespace

std::vector<Error> check_live_setup(std::string_view text, const std::string& path, const DataPaths& data) {
  const auto document = LocatedJson::parse(text, path);
  if (!document) return {document.error()};
  std::vector<Error> problems;
  for (const auto& [place, key] : document->duplicates())
    problems.push_back(document->error(place, fmt::format("the key {} a second time in this object", in_quotes(key))));
  SetupCheck check(*document, problems);
  const Json& root = document->root();
  if (!root.is_object()) return {document->error("", "expected an object with 'scene', 'machine' and 'buttons'")};
  check.keys("", root, {"about", "scene", "machine", "buttons"});
  const auto folder = std::filesystem::path(path).parent_path();
  if (const auto scene = check.text("", root, "scene"); !scene.empty())
    if (const auto found = resolve_scene(scene, data, folder, document->where("/scene")); !found)
      problems.push_back(found.error());
  if (const auto machine = check.text("", root, "machine"); !machine.empty())
    if (const auto found = resolve_machine(machine, data, folder, document->where("/machine")); !found)
      problems.push_back(found.error());
  if (!root.contains("buttons") || !root["buttons"].is_array()) {
    check.problem(root.contains("buttons") ? "/buttons" : "", "expected a list of 'buttons'");
    return problems;
  }
  for (std::size_t i = 0; i < root["buttons"].size(); ++i)
    check.button(fmt::format("/buttons/{}", i), root["buttons"][i]);
  return problems;
}

Result<Json> live_setup(const DataPaths& data) {
  const auto path = (data.knowledge / "live.json").string();
  const auto text = read_file(path);
  if (!text) return text.error();
  if (const auto problems = check_live_setup(*text, path, data); !problems.empty()) return problems.front();
  const Json defaults = Json::parse(without_byte_order_mark(*text));
  Json setup{{"scenes", names_in(data.mjcf / "scenes", ".xml")},
             {"machines", names_in(data.knowledge / "machines", ".json")}};
  for (const char* field : {"scene", "machine", "buttons"}) setup[field] = defaults[field];
  return setup;
}

Json gesture_palette(const Machine& machine, const GestureCatalogue* gestures) {
  Json palette = Json::array();
  const RunWords words{std::string_view()};
  if (gestures) {
    for (const auto& [name, entry] : gestures->entries) {
      InputEvent gesture;
      gesture.name = name;
      gesture.phase = entry.acts_on.empty() || entry.acts("stroke") ? "stroke" : entry.acts_on.front();
      if (entry.meanings.empty() || entry.meanings.contains("")) palette.push_back(button(words, gesture, entry.about));
      for (const auto& [direction, meaning] : entry.meanings) {
        if (direction.empty()) continue;
        gesture.direction = direction;
        palette.push_back(button(words, gesture, entry.about));
      }
    }
    return palette;
  }
  std::set<std::string> symbols;
  for (const auto& transition : machine.transitions)
    if (transition.on) symbols.insert(transition.on->names.begin(), transition.on->names.end());
  for (const auto& symbol : symbols)
    if (const auto event = event_of(symbol); event.modality == Modality::gesture)
      palette.push_back(button(words, event, ""));
  return palette;
}

}  // namespace continua
