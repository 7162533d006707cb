#include "perception/gesture_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/digest.h"

namespace continua {
namespace {

constexpr std::size_t most_problems = 1000;

const std::vector<std::string> directions = {"left", "right", "front", "back", "up", "down"};
const std::vector<std::string> phases = {"start", "stop", "stroke"};

std::string found(const Json& json) {
  if (json.is_string()) return in_quotes(json.get<std::string>());
  return json.is_array() ? "a list" : json.is_object() ? "an object" : compact(json);
}

std::string listed(const std::vector<std::string>& words) {
  return fmt::format("{} or {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

std::string below(const std::string& pointer, const std::string& key) {
  std::string escaped;
  for (const char c : key) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return pointer + "/" + escaped;
}

// What stands between the bars of "a | b", without spaces around.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= text.size();) {
    const auto end = std::min(text.find('|', at), text.size());
    const auto part = text.substr(at, end - at);
    const auto from = part.find_first_not_of(' ');
    names.push_back(from == std::string::npos ? "" : part.substr(from, part.find_last_not_of(' ') + 1 - from));
    at = end + 1;
  }
  return names;
}

// Such a name is read back from a symbol as it is.
bool is_name(const std::string& name) {
  InputEvent event;
  event.modality = Modality::gesture;
  event.name = name;
  const bool one_word = name.find_first_of(" \t\r\n") == std::string::npos;
  return one_word && !name.empty() && event_of(symbol_of(event)).name == name && name != "left" && name != "right";
}

}  // namespace

GestureCatalogue GestureReader::read() {
  const Json& root = document_.root();
  for (const auto& [place, key] : document_.duplicates())
    problem(place, fmt::format("the key {} a second time in this object", in_quotes(key)));
  catalogue_.path = document_.name();
  catalogue_.name = std::filesystem::path(document_.name()).stem().string();
  catalogue_.digest = digest(compact(root));
  if (!expect_object("", root, "a file of gestures", {"about", "gestures", "examples"})) return std::move(catalogue_);
  if (root.contains("about")) text_of("", root, "about", "what the file holds");
  if (!root.contains("gestures"))
    problem(document_.place(""), "there is no \"gestures\"; expected gestures by their names");
  else if (expect_object("/gestures", root["gestures"], "gestures by their names", {}))
    for (const auto& [names, entry] : root["gestures"].items()) read_entry(names, below("/gestures", names), entry);
  if (!root.contains("examples")) return std::move(catalogue_);
  const Json& examples = root["examples"];
  if (!examples.is_array()) mismatch("/examples", examples, "examples, a list");
  if (examples.is_array() && problems_.empty())
    for (std::size_t i = 0; i < examples.size(); ++i) read_example(below("/examples", std::to_string(i)), examples[i]);
  return std::move(catalogue_);
}

void GestureReader::read_entry(const std::string& names, const std::string& pointer, const Json& json) {
  GestureEntry entry;
  entry.where = document_.where(pointer);
  entry.acts_on = {"start", "stroke"};
  if (!expect_object(pointer, json, "a gesture", {"about", "kind", "means", "acts_on"})) return;
  if (json.contains("about")) entry.about = text_of(pointer, json, "about", "what it looks like");
  entry.kind = text_of(pointer, json, "kind", "the kind of move: δ, ω, α, y, n or another that machines know");
  if (json.contains("kind") && json["kind"].is_string() &&
      (entry.kind.empty() || entry.kind.find_first_of(" \t\r\n") != std::string::npos))
    mismatch(pointer + "/kind", json["kind"], "one word");
  if (json.contains("means")) read_meanings(entry, pointer + "/means", json["means"]);
  if (entry.meanings.empty() && (entry.kind == "α" || entry.kind == "ω"))
    problem(document_.place(pointer),
            fmt::format("there is no \"means\"; expected what a gesture of the kind {} says", entry.kind));
  if (json.contains("acts_on")) entry.acts_on = phases_of(pointer + "/acts_on", json["acts_on"]);
  for (const auto& name : names_in(names)) {
    entry.name = name;
    if (!is_name(name))
      problem(document_.key_place(pointer),
              fmt::format("found the name {}; expected one word that is no hand, or several with '|' between",
                          in_quotes(name)));
    else if (!catalogue_.entries.emplace(name, entry).second)
      problem(document_.key_place(pointer), fmt::format("there is a gesture {} already", in_quotes(name)));
  }
}

void GestureReader::read_meanings(GestureEntry& entry, const std::string& pointer, const Json& json) {
  if (json.is_string()) {
    entry.meanings.emplace("", json.get<std::string>());
    return;
  }
  if (!json.is_object()) return mismatch(pointer, json, "a term, or terms by direction");
  for (const auto& [direction, term] : json.items()) {
    expect_one_of(below(pointer, direction), direction, directions);
    if (term.is_string())
      entry.meanings.emplace(direction, term.get<std::string>());
    else
      mismatch(below(pointer, direction), term, "a term");
  }
}

std::vector<std::string> GestureReader::phases_of(const std::string& pointer, const Json& json) {
  if (!json.is_array()) return mismatch(pointer, json, "phases, a list"), std::vector<std::string>{};
  std::vector<std::string> acting;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto at = below(pointer, std::to_string(i));
    if (!json[i].is_string()) {
      mismatch(at, json[i], listed(phases));
      continue;
    }
    acting.push_back(json[i].get<std::string>());
    expect_one_of(at, acting.back(), phases);
  }
  return acting;
}

void GestureReader::read_example(const std::string& pointer, const Json& json) {
  if (!expect_object(pointer, json, "an example", {"gesture", "symbol", "kind", "means", "about"})) return;
  const auto gesture = text_of(pointer, json, "gesture", "hand, name, direction and phase, those that are there");
  if (gesture.empty()) return;
  const auto event = event_of(text(Modality::gesture) + " " + gesture);
  const auto* entry = catalogue_.find(event.name);
  const auto check = [&](const char* key, const char* what, const std::string& actual) {
    if (!json.contains(key)) return;
    const auto expected = json[key].is_null() ? std::string("null") : text_of(pointer, json, key, what);
    if (expected != actual)
      problem(document_.place(below(pointer, key)), fmt::format("{} has the {} {}, not {}", in_quotes(gesture), what,
                                                                in_quotes(actual), in_quotes(expected)));
  };
  const auto* meaning = entry ? entry->meaning(event.direction) : nullptr;
  check("kind", "kind", entry ? entry->kind : "null");
  check("means", "meaning", meaning ? *meaning : "null");
  check("symbol", "symbol", gesture_symbol(event, entry));
  if (!json.contains("kind") && !json.contains("means") && !json.contains("symbol"))
    problem(document_.place(pointer), "there is none of \"kind\", \"means\" and \"symbol\"; expected one of them");
}

bool GestureReader::expect_object(const std::string& pointer, const Json& json, const char* what,
                                  const std::vector<std::string>& keys) {
  if (!json.is_object()) return mismatch(pointer, json, fmt::format("{}, an object", what)), false;
  for (const auto& [key, value] : json.items())
    if (!keys.empty() && std::find(keys.begin(), keys.end(), key) == keys.end())
      problem(document_.key_place(below(pointer, key)),
              fmt::format("unknown key {} of {}{}", in_quotes(key), what, did_you_mean(key, keys)));
  return true;
}

std::string GestureReader::text_of(const std::string& pointer, const Json& json, const std::string& key,
                                   const char* what) {
  if (!json.contains(key))
    problem(document_.place(pointer), fmt::format("there is no \"{}\"; expected {}", key, what));
  else if (!json[key].is_string())
    mismatch(below(pointer, key), json[key], fmt::format("{}, a string", what));
  else
    return json[key].get<std::string>();
  return {};
}

void GestureReader::expect_one_of(const std::string& pointer, const std::string& found,
                                  const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), found) == known.end())
    problem(document_.key_place(pointer),
            fmt::format("found {}, expected {}{}", in_quotes(found), listed(known), did_you_mean(found, known)));
}

void GestureReader::mismatch(const std::string& pointer, const Json& json, const std::string& expected) {
  problem(document_.place(pointer), fmt::format("found {}, expected {}", found(json), expected));
}

void GestureReader::problem(TextPlace place, std::string sentence) {
  if (problems_.size() < most_problems) problems_.push_back({place, std::move(sentence)});
}

std::vector<Error> GestureReader::problems() {
  std::stable_sort(problems_.begin(), problems_.end(),
                   [](const Problem& a, const Problem& b) { return a.place < b.place; });
  std::vector<Error> errors;
  for (const auto& [place, sentence] : problems_) errors.push_back(document_.error(place, sentence));
  return errors;
}

}  // namespace continua
