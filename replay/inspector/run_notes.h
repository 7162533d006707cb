// People's notes on records of a run: NAME.notes.json next to NAME.run.jsonl, packed or not (RUNLOG.md, Notes).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

struct RunNote {
  std::string id;  ///< the notes' own, 1 to 100 letters, no other's
  std::size_t n = 0;
  std::optional<std::size_t> to = {};  ///< the last record it is on, where it is on several
  std::string text;                    ///< 1 to 10,000 letters
};

struct RunNotes {
  std::vector<RunNote> notes;
  std::string version;  ///< equal as long as nobody has written; empty before the first writing
};

inline constexpr std::size_t most_notes = 10000;

/// The notes' file of a run's log.
std::string notes_path(const std::string& run_path);

/// The notes in the member `notes` of `json`. With `records`, all must be on records of a run with so many. An error
/// names the note.
Result<std::vector<RunNote>> notes_in(const Json& json, std::optional<std::size_t> records);

/// Everything that is wrong with a file of notes; `records` as above.
std::vector<Error> notes_problems(std::string_view text, const std::string& name, std::optional<std::size_t> records);

/// {"notes": [{"id", "n", "to", "text"}], "version"}
Json notes_json(const RunNotes& notes);

/// The notes in the file at `path`; none where there is no file. Errors: the file cannot be read, or has other content.
Result<RunNotes> read_notes(const std::string& path);

/// The outcome of keeping notes.
struct NotesKept {
  enum class How { kept, changed_meanwhile, broken, not_writable };
  How how = How::kept;
  std::string sentence;  ///< unless they were kept
  std::string version;   ///< if they were
};

/// Replaces the file as a whole, if its version is still the one that was read. Not safe to use from several threads.
NotesKept keep_notes(const std::string& path, const std::vector<RunNote>& notes, const std::string& version);

}  // namespace continua
