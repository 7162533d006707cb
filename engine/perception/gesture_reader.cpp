// Reads files of gestures (perception/GESTURES.md).

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/document_reader.h"
#include "continua/core/trimmed.h"
#include "continua/perception/gesture.h"

namespace continua {
namespace {

const std::vector<std::string> directions = {"left", "right", "front", "back", "up", "down"};
const std::vector<std::string> phases = {"start", "stop", "stroke"};

// The parts of "a | b", without the spaces around them.
std::vector<std::string> names_of(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at <= text.size();) {
    const auto end = std::min(text.find('|', at), text.size());
    names.emplace_back(trimmed(std::string_view(text).substr(at, end - at), " "));
    at = end + 1;
  }
  return names;
}

// Whether the name survives a round trip: the symbol with this name reads back as the same name.
bool is_name(const std::string& name) {
  InputEvent event;
  event.modality = Modality::gesture;
  event.name = name;
  const bool one_word = name.find_first_of(" \t\r\n") == std::string::npos;
  return one_word && !name.empty() && event_of(symbol_of(event)).name == name && name != "left" && name != "right";
}

// Terms by direction; a term for every direction has the key "".
std::map<std::string, std::string, std::less<>> read_meanings(const Item& item) {
  std::map<std::string, std::string, std::less<>> meanings;
  if (item.is_text()) {
    meanings.emplace("", item.text("a term"));
  } else if (item.exists() && !item.is_object()) {
    item.mismatch("a term, or terms by direction");
  } else {
    for (const auto& [direction, term] : item.members("terms by direction")) {
      if (std::find(directions.begin(), directions.end(), direction) == directions.end())
        term.problem_at_key(fmt::format("found {}, expected {}{}", in_quotes(direction), any_of(directions),
                                        term.nearest(direction, directions)));
      if (term.is_text())
        meanings.emplace(direction, term.text("a term"));
      else
        term.mismatch("a term");
    }
  }
  return meanings;
}

// Reads an entry without its name, because several names may share it.
GestureEntry read_entry(const Item& item) {
  GestureEntry entry;
  entry.where = item.where();
  entry.acts_on = {"start", "stroke"};
  if (const auto about = item.member("about"); about.is_text()) entry.about = about.text("");
  const auto kind = item.required("kind", "the kind of move: δ, ω, α, y, n or another that machines know");
  entry.kind = kind.text("the kind of move: δ, ω, α, y, n or another that machines know");
  if (kind.is_text() && (entry.kind.empty() || entry.kind.find_first_of(" \t\r\n") != std::string::npos))
    kind.mismatch("one word");
  entry.meanings = read_meanings(item.member("means"));
  if (entry.meanings.empty() && (entry.kind == "α" || entry.kind == "ω"))
    item.problem(fmt::format("there is no \"means\"; expected what a gesture of the kind {} says", entry.kind));
  if (const auto first = item.member("before_words"); first.exists()) entry.before_words = first.truth(false);
  if (const auto acts_on = item.member("acts_on"); acts_on.exists()) {
    entry.acts_on.clear();
    for (const auto& phase : acts_on.elements("phases"))
      if (const auto name = phase.one_of(phases)) entry.acts_on.push_back(*name);
  }
  return entry;
}

// Checks the symbol, the kind and the meaning that an example states.
void check_example(const Item& item, const GestureCatalogue& catalogue) {
  if (!item.expect_object("an example", {"gesture", "symbol", "kind", "means", "about"})) return;
  constexpr const char* parts = "hand, name, direction and phase, those that are there";
  const auto gesture = item.required("gesture", parts).text(parts);
  if (gesture.empty()) return;
  const auto event = event_of(name_of(Modality::gesture) + " " + gesture);
  const auto* entry = catalogue.find(event.name);
  const auto check = [&](const char* key, const char* what, const std::string& actual) {
    const auto stated = item.member(key);
    if (!stated.exists()) return;
    const auto expected = stated.json().is_null() ? std::string("null") : stated.text(what);
    if (expected != actual)
      stated.problem(
          fmt::format("{} has the {} {}, not {}", in_quotes(gesture), what, in_quotes(actual), in_quotes(expected)));
  };
  const auto* meaning = entry ? entry->meaning(event.direction) : nullptr;
  check("kind", "kind", entry ? entry->kind : "null");
  check("means", "meaning", meaning ? *meaning : "null");
  check("symbol", "symbol", gesture_symbol(event, entry));
  if (!item.member("kind").exists() && !item.member("means").exists() && !item.member("symbol").exists())
    item.problem("there is none of \"kind\", \"means\" and \"symbol\"; expected one of them");
}

ShapeLimits read_limits(const Item& item) {
  ShapeLimits limits;
  if (!item.expect_object("the limits of shapes", {"about", "farthest", "margin"})) return limits;
  limits.farthest = item.member("farthest").number("a distance", limits.farthest, 0, 2);
  limits.margin = item.member("margin").number("a share", limits.margin, 0, 1);
  return limits;
}

// Reads the document; `reader` collects the problems.
GestureCatalogue read(const LocatedJson& document, DocumentReader& reader) {
  const auto root = reader.root(document);
  GestureCatalogue catalogue;
  catalogue.path = document.name();
  catalogue.name = std::filesystem::path(document.name()).stem().string();
  catalogue.digest = digest(compact(document.root()));
  if (!root.expect_object("a file of gestures", {"about", "lexicon", "shapes", "gestures", "examples"}))
    return catalogue;
  catalogue.lexicon = root.member("lexicon").text("the name of a lexicon");
  if (const auto shapes = root.member("shapes"); shapes.exists()) catalogue.shapes = read_limits(shapes);
  for (const auto& [names, item] :
       root.required("gestures", "gestures by their names").members("gestures by their names")) {
    if (!item.expect_object("a gesture", {"about", "kind", "means", "acts_on", "before_words"})) continue;
    auto entry = read_entry(item);
    for (const auto& name : names_of(names)) {
      entry.name = name;
      if (!is_name(name))
        item.problem_at_key(fmt::format(
            "found the name {}; expected one word that is no hand, or several with '|' between", in_quotes(name)));
      else if (!catalogue.entries.emplace(name, entry).second)
        item.problem_at_key(fmt::format("there is a gesture {} already", in_quotes(name)));
    }
  }
  const auto examples = root.member("examples").elements("examples");
  catalogue.examples = examples.size();
  // If gestures have problems, the examples would only repeat them.
  for (const auto& example : reader.sound() ? examples : std::vector<Item>()) check_example(example, catalogue);
  return catalogue;
}

}  // namespace

Result<GestureCatalogue> read_gestures(std::string_view text, const std::string& path) {
  const auto document = LocatedJson::parse(text, path);
  if (!document) return document.error();
  DocumentReader reader;
  auto catalogue = read(*document, reader);
  if (!reader.sound()) return reader.problems().front();
  return catalogue;
}

std::vector<Error> check_gestures(std::string_view text, const std::string& path) {
  const auto document = LocatedJson::parse(text, path);
  if (!document) return {document.error()};
  DocumentReader reader;
  read(*document, reader);
  return reader.problems();
}

}  // namespace continua
