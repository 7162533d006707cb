// A trace: the recorded events between the human and the avatar. traces/FORMAT.md describes the file.
//
// Reading is strict where a guess could change the meaning of a replay (types, order, ranges) and tolerant where the
// world is: unknown fields and kinds are kept, a byte order mark and \r\n are accepted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/perception/input_event.h"
#include "continua/world/perspective.h"

namespace continua {

/// The start of a body, in W, in place of the scene's. An absent part is the scene's.
struct ObjectStart {
  bool removed = false;  ///< taken off the table
  std::optional<Vec3> position_W;
  std::optional<double> yaw_rad;  ///< rotation about z
};

struct TraceHeader {
  std::string scene;     ///< a name or a path; empty when the trace does not say
  std::string machine;   ///< a name or a path; empty when the trace does not say
  std::string language;  ///< of speech and phrases, a name in the knowledge folder; empty: the machine's own
  std::uint64_t seed = 0;
  Perspective perspective = Perspective::human;  ///< whose left, right, front and behind the words mean
  std::string recorded;              ///< when, 2018-02-05T13:53:17 by the clock of the place; empty if it is not known
  Json parameters = Json::object();  ///< of the machine: {name: value}
  std::string source;                ///< the file it was imported from; empty if none
  std::vector<std::pair<std::string, ObjectStart>> objects;  ///< in the file's order
  Json json;                                                 ///< the line as read
};

/// A deed of another agent at this point; never an input.
struct Observed {
  static constexpr const char* kind = "observed";
  std::string channel;  ///< "speech", "gesture" or "action"
  std::string content;
};

/// The state of things that must hold at this point of a replay; absent fields are not checked. Where the file has
/// JSON's null, the text is "null": nothing is indicated, said, held or done.
struct Expectation {
  static constexpr const char* kind = "expect";
  std::optional<std::string> state, says, indicated, act, holding;
  std::optional<std::vector<std::string>> referents;
  std::optional<std::int64_t> stack_depth;
};

/// A moment that the experimenter marked: a trial, a condition. Never an input.
struct Mark {
  static constexpr const char* kind = "mark";
  std::string text;
};

/// Lets the clock run on to its time; the last event.
struct End {
  static constexpr const char* kind = "end";
};

/// A kind of event that this version does not know: kept for writing, otherwise to be passed over.
struct UnknownKind {};

struct TraceEvent {
  std::size_t line = 0;            ///< in the trace, counting from 1; 0 when it was not read from one
  SimTime t;                       ///< when it became known; an InputEvent's own time may be earlier
  std::optional<std::size_t> row;  ///< line of the log that it was imported from
  std::variant<InputEvent, Observed, Expectation, Mark, End, UnknownKind> what;
  Json json;  ///< the line as read, or null
};

/// Something worth knowing that did not keep the file from being used.
struct Note {
  std::size_t line = 0;
  std::string sentence;
};

/// A trace but for its events.
struct TraceHead {
  std::string name;    ///< the file's path as given
  std::string digest;  ///< of the file's bytes
  TraceHeader header;
  std::vector<Note> notes;
};

struct Trace : TraceHead {
  std::vector<TraceEvent> events;  ///< in order of t
};

/// Everything that could be read, and everything that is wrong. Without problems the trace is whole.
struct TraceReading {
  Trace trace;
  std::vector<Error> problems;
};

/// Reads the text of a trace called `name` to its end, whatever its faults.
TraceReading read_whole_trace(std::string_view text, const std::string& name);

/// The trace, or the first thing that is wrong with it, placed at "file:line".
Result<Trace> read_trace_text(std::string_view text, const std::string& name);
Result<Trace> read_trace(const std::string& path);

/// One event that stands on its own, as on line `line` of `name`. It has the checks of a trace, without that of its
/// order.
Result<TraceEvent> read_event(const Json& json, const std::string& name, std::size_t line);

/// The lines of a trace file, without their newline. Fields that a kind does not have are taken from `json`, so that
/// unknown fields are written again. Keys have a fixed order.
std::string write_header(const TraceHeader& header);
std::string write_event(const TraceEvent& event);
std::string write_trace(const Trace& trace);

std::string name_of(Perspective perspective);

/// "file:line: sentence".
std::string sentence_of(const TraceHead& trace, const Note& note);

}  // namespace continua
