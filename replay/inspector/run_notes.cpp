#include "continua/replay/inspector/run_notes.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/gzip_name.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_text = 10000, longest_id = 100;

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

// A note, or a sentence about JSON that is no note.
Result<RunNote> note_in(const Json& json, std::optional<std::size_t> records) {
  const auto& id = member_of(json, "id");
  const auto& text = member_of(json, "text");
  if (!id.is_string() || !text.is_string() || !member_of(json, "n").is_number_unsigned())
    return Error{"", R"(expected {"id": TEXT, "n": NUMBER, "to": NUMBER or null, "text": TEXT})"};
  RunNote note{id.get<std::string>(), json["n"].get<std::size_t>(), {}, text.get<std::string>()};
  const auto &id_letters = letters(note.id), text_letters = letters(note.text);
  if (id_letters < 1 || id_letters > longest_id)
    return Error{"", fmt::format("its id has {} letters; expected 1 to {}", id_letters, longest_id)};
  if (text_letters < 1 || text_letters > longest_text)
    return Error{"", fmt::format("its text has {} letters; expected 1 to {}", text_letters, longest_text)};
  if (const auto& to = member_of(json, "to"); !to.is_null()) {
    if (!to.is_number_unsigned() || to.get<std::size_t>() < note.n)
      return Error{"", fmt::format("'to' is {}; expected a record from n on, or null", compact(to))};
    note.to = to.get<std::size_t>();
  }
  if (records && note.to.value_or(note.n) >= *records)
    return Error{
        "", fmt::format("it is on record {}; the run has records 0 to {}", note.to.value_or(note.n), *records - 1)};
  return note;
}

// Calls `wrong` with the place of a note, from 1, and its fault; 0 for all of them.
template <class Wrong>
std::vector<RunNote> read_all(const Json& json, std::optional<std::size_t> records, Wrong wrong) {
  std::vector<RunNote> notes;
  const auto& list = member_of(json, "notes");
  if (!list.is_array()) {
    wrong(0, R"(expected {"notes": [...]})");
    return notes;
  }
  if (list.size() > most_notes) {
    wrong(0, fmt::format("found {} notes; expected at most {}", list.size(), most_notes));
    return notes;
  }
  std::set<std::string> ids;
  for (std::size_t i = 0; i < list.size(); ++i) {
    auto note = note_in(list[i], records);
    if (!note)
      wrong(i + 1, note.error().sentence);
    else if (!ids.insert(note->id).second)
      wrong(i + 1, fmt::format("its id {} is another's too", in_quotes(note->id)));
    else
      notes.push_back(*std::move(note));
  }
  return notes;
}

std::string sentence_of(std::size_t place, const std::string& what) {
  return place == 0 ? what : fmt::format("note {}: {}", place, what);
}

Json note_json(const RunNote& note) {
  return {{"id", note.id}, {"n", note.n}, {"to", note.to ? Json(*note.to) : Json()}, {"text", note.text}};
}

// One note a line, for those who compare versions of the file.
std::string file_text(const std::vector<RunNote>& notes) {
  std::string text = "{\"notes\": [";
  for (std::size_t i = 0; i < notes.size(); ++i) text += (i == 0 ? "\n" : ",\n") + compact(note_json(notes[i]));
  return text + "\n]}\n";
}

bool there_is(const std::string& path) {
  std::error_code unknown;
  return fs::symlink_status(path, unknown).type() != fs::file_type::not_found;
}

}  // namespace

std::string notes_path(const std::string& run_path) {
  std::string name(without_gzip_ending(run_path));
  for (const std::string_view end : {".run.jsonl", ".jsonl"})
    if (name.ends_with(end)) {
      name.resize(name.size() - end.size());
      break;
    }
  return name + ".notes.json";
}

Result<std::vector<RunNote>> notes_in(const Json& json, std::optional<std::size_t> records) {
  Outcome first;
  auto notes = read_all(json, records, [&](std::size_t place, const std::string& what) {
    if (!first) first = Error{"", sentence_of(place, what)};
  });
  if (first) return *first;
  return notes;
}

std::vector<Error> notes_problems(std::string_view text, const std::string& name, std::optional<std::size_t> records) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return {document.error()};
  std::vector<Error> problems;
  for (const auto& [place, key] : document->duplicates())
    problems.push_back(document->error(place, fmt::format("the key {} a second time in this object", in_quotes(key))));
  read_all(document->root(), records, [&](std::size_t place, const std::string& what) {
    problems.push_back(document->error(place == 0 ? "" : fmt::format("/notes/{}", place - 1), what));
  });
  return problems;
}

Json notes_json(const RunNotes& notes) {
  Json list = Json::array();
  for (const auto& note : notes.notes) list.push_back(note_json(note));
  return {{"notes", std::move(list)}, {"version", notes.version}};
}

Result<RunNotes> read_notes(const std::string& path) {
  if (!there_is(path)) return RunNotes();
  const auto text = read_file(path);
  if (!text) return text.error();
  auto problems = notes_problems(*text, path, std::nullopt);
  if (!problems.empty()) return problems.front();
  const auto document = LocatedJson::parse(*text, path);
  return RunNotes{notes_in(document->root(), std::nullopt).value(), digest(*text)};
}

NotesKept keep_notes(const std::string& path, const std::vector<RunNote>& notes, const std::string& version) {
  const auto known = read_notes(path);
  if (!known) return {NotesKept::How::broken, known.error().text() + "; it is left as it is", ""};
  if (known->version != version)
    return {NotesKept::How::changed_meanwhile,
            "somebody else has written notes meanwhile; expected the version of "
            "those that were read",
            ""};
  const auto text = file_text(notes);
  if (const auto problem = replace_file(path, text, ReplacedFile::Links::replace))
    return {NotesKept::How::not_writable, problem->text(), ""};
  return {NotesKept::How::kept, "", digest(text)};
}

}  // namespace continua
