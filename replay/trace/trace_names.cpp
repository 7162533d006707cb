#include "continua/replay/trace/trace_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "continua/core/characters.h"
#include "continua/core/document_reader.h"
#include "continua/replay/trace/trace_edit.h"

namespace continua {
namespace {

struct Piece {
  std::string text;
  bool word = false;
};

// Words and all that stands between them, by turns.
std::vector<Piece> pieces_of(const std::string& text) {
  std::vector<Piece> pieces;
  for (const auto& character : characters(text)) {
    const auto kind = kind_of(character);
    const bool word = kind == CharacterKind::letter || kind == CharacterKind::digit || character == "_";
    if (pieces.empty() || pieces.back().word != word) pieces.push_back({"", word});
    pieces.back().text += character;
  }
  return pieces;
}

std::vector<std::string> words_in(const std::string& text, bool fold) {
  std::vector<std::string> words;
  for (const auto& piece : pieces_of(text))
    if (piece.word) words.push_back(fold ? folded(piece.text) : piece.text);
  return words;
}

// The number of pieces from `at` on that are the words of a name; 0 if they are not.
std::size_t pieces_that_are(const std::vector<std::string>& name, const std::vector<Piece>& pieces, std::size_t at,
                            bool fold) {
  std::size_t next = at;
  for (const auto& word : name) {
    if (next > at && next < pieces.size() && !pieces[next].word) ++next;
    if (next >= pieces.size() || (fold ? folded(pieces[next].text) : pieces[next].text) != word) return 0;
    ++next;
  }
  return next - at;
}

// Calls `change` with each text in the value, at any depth, and the name of the member that it is in.
template <class Change>
void change_texts(Json& value, const std::string& member, const Change& change) {
  if (value.is_string())
    value = change(member, value.get<std::string>());
  else if (value.is_object())
    for (auto& [name, part] : value.items()) change_texts(part, name, change);
  else if (value.is_array())
    for (auto& part : value) change_texts(part, member, change);
}

bool is_one_of(const std::string& member, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return member == name; });
}

}  // namespace

std::string with_words_replaced(const std::string& text, const NameTable& names, bool fold) {
  std::vector<std::pair<std::vector<std::string>, std::string>> table;
  for (const auto& [name, replacement] : names) table.emplace_back(words_in(name, fold), replacement);
  // The longest name counts.
  std::stable_sort(table.begin(), table.end(),
                   [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  const auto pieces = pieces_of(text);
  std::string replaced;
  for (std::size_t at = 0; at < pieces.size();) {
    std::size_t taken = 0;
    for (const auto& [name, replacement] : table)
      if (taken == 0 && (taken = pieces_that_are(name, pieces, at, fold)) > 0) replaced += replacement;
    if (taken == 0) replaced += pieces[at].text;
    at += std::max<std::size_t>(taken, 1);
  }
  return replaced;
}

Result<Trace> rename_in_trace(const Trace& trace, const NameTable& names) {
  const auto renamed = [&](const std::string& text) { return with_words_replaced(text, names, false); };
  std::set<std::string> objects;
  for (const auto& [name, start] : trace.header.objects)
    if (!objects.insert(renamed(name)).second)
      return Error{trace.name + ":1", fmt::format("two objects would be called {}", in_quotes(renamed(name)))};
  const auto in_header = [&](Json header) {
    if (const auto found = header.find("objects"); found != header.end()) {
      Json objects_now = Json::object();
      for (const auto& [name, start] : found->items()) objects_now[renamed(name)] = start;
      *found = objects_now;
    }
    return header;
  };
  const auto in_event = [&](Json event) {
    const bool said = event.value("channel", "") == "speech";
    change_texts(event, "", [&](const std::string& member, const std::string& text) {
      const bool name = is_one_of(member, {"name", "act", "indicated", "holding", "referents", "state"});
      return name || (member == "content" && !said) ? renamed(text) : text;
    });
    if (event["kind"] == "gesture" && event.contains("alternatives"))
      change_texts(event["alternatives"], "", [&](const auto&, const auto& text) { return renamed(text); });
    return event;
  };
  return changed_trace(trace, in_event, in_header);
}

Result<Trace> anonymise_trace(const Trace& trace, const NameTable& names) {
  const auto in_header = [](Json header) {
    for (const char* member : {"recorded", "source", "media"}) header.erase(member);
    return header;
  };
  const auto in_event = [&](Json event) {
    event.erase("row");
    change_texts(event, "", [&](const std::string& member, const std::string& text) {
      return is_one_of(member, {"kind", "channel", "hand", "phase", "direction"})
                 ? text
                 : with_words_replaced(text, names, true);
    });
    return event;
  };
  return changed_trace(trace, in_event, in_header);
}

Result<NameTable> read_name_table(const std::string& path) {
  const auto document = LocatedJson::read(path);
  if (!document) return document.error();
  DocumentReader reader;
  NameTable names;
  for (const auto& [name, item] : reader.root(*document).members("an object {NAME: REPLACEMENT}")) {
    if (words_in(name, true).empty()) item.problem_at_key("found a name without letters");
    names.emplace_back(name, item.text("the replacement"));
  }
  if (!reader.sound()) return reader.problems().front();
  return names;
}

}  // namespace continua
