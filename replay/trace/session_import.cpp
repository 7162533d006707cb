#include "continua/replay/trace/session_import.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <vector>

#include "continua/core/digest.h"
#include "continua/core/local_time.h"
#include "continua/replay/trace/session_notation.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

constexpr const char* row_wanted = "expected index, channel, content and seconds, separated by tabs";

struct Row {
  std::string_view index, channel, content, seconds;
  std::size_t line = 0;
  bool ends = false;  // with a newline
};

std::optional<Row> split_row(std::string_view text) {
  std::array<std::string_view, 4> columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto tab = text.find('\t');
    const bool last = i + 1 == columns.size();
    if ((tab == std::string_view::npos) != last) return std::nullopt;
    columns[i] = text.substr(0, tab);
    if (!last) text.remove_prefix(tab + 1);
  }
  return Row{columns[0], columns[1], columns[2], columns[3]};
}

std::string without_quotation_marks(std::string_view content) {
  if (content.size() >= 2 && content.front() == '"' && content.back() == '"')
    content = content.substr(1, content.size() - 2);
  return std::string(content);
}

std::optional<std::size_t> index_of(std::string_view text) {
  std::size_t index = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

class SessionReader {
 public:
  explicit SessionReader(Trace& trace) : trace_(trace) {}

  void read(std::string_view line_text, std::size_t line, bool ends) {
    line_ = line;
    auto row = split_row(line_text);
    if (!row) {
      const auto columns = std::count(line_text.begin(), line_text.end(), '\t') + 1;
      return note(fmt::format("skipped: {} column{} in {}; {}", columns, columns == 1 ? "" : "s", in_quotes(line_text),
                              row_wanted));
    }
    row->line = line;
    row->ends = ends;
    const auto seconds = finite_number(row->seconds);
    if (!seconds || *seconds < 0 || *seconds > trace_time_limit_s)
      return note(fmt::format("skipped: the time is {}; expected seconds", in_quotes(row->seconds)));
    const std::string content = readable(row->content);
    auto what = event_of(row->channel, content);
    if (!what) return;
    check_index(row->index);
    TraceEvent event;
    event.t = time_of(*row, SimTime::from_seconds(*seconds));
    event.row = line;
    event.what = std::move(*what);
    if (auto* input = std::get_if<InputEvent>(&event.what)) input->t = event.t;
    event.line = trace_.events.size() + 2;  // the header is line 1
    event.json = json_of(event);
    trace_.events.push_back(std::move(event));
  }

 private:
  using What = decltype(TraceEvent::what);

  void note(std::string sentence) { trace_.notes.push_back({line_, std::move(sentence)}); }

  std::string readable(std::string_view content) {
    auto repaired = Json::parse(compact(Json(std::string(content)))).get<std::string>();
    if (repaired != content) note("bytes that are not UTF-8 were replaced in " + in_quotes(content));
    return repaired;
  }

  std::optional<What> event_of(std::string_view channel, const std::string& content) {
    if (channel == "HS") return speech(content);
    if (channel == "HG") return gesture(content);
    if (channel == "HP") return pointing(content);
    if (channel == "AS") return Observed{"speech", without_quotation_marks(content)};
    if (channel == "AG") return Observed{"gesture", notation_from_voxsim(content)};
    if (channel == "AA") return Observed{"action", notation_from_voxsim(content)};
    note(fmt::format("skipped: the channel is {}; expected HG, HS, HP, AS, AG or AA", in_quotes(channel)));
    return std::nullopt;
  }

  std::optional<What> speech(const std::string& content) {
    if (content.empty()) {
      note("skipped: speech without words");
      return std::nullopt;
    }
    InputEvent event;
    event.modality = Modality::speech;
    event.text = content;
    return event;
  }

  std::optional<What> gesture(const std::string& content) {
    auto imported = gesture_from_voxsim(content);
    if (!imported) {
      note(fmt::format("skipped: the gesture is {}; expected its name", in_quotes(content)));
      return std::nullopt;
    }
    if (imported->point_unread)
      note(fmt::format("the point of {} is left out; expected two numbers", in_quotes(content)));
    return std::move(imported->event);
  }

  std::optional<What> pointing(const std::string& content) {
    auto event = pointing_from_voxsim(content);
    if (!event) {
      note(fmt::format("skipped: the pointing sample is {}; expected 'l,x,y' or 'r,x,y'", in_quotes(content)));
      return std::nullopt;
    }
    return std::move(*event);
  }

  // Rows that are missing from the log matter to whoever wonders why a replay differs from it.
  void check_index(std::string_view text) {
    const auto index = index_of(text);
    if (!index) return note(fmt::format("the index is {}; expected a whole number", in_quotes(text)));
    if (*index != last_index_ + 1)
      note(last_index_ == 0 ? fmt::format("the log begins at index {}", *index)
                            : fmt::format("the index goes from {} to {}", last_index_, *index));
    last_index_ = *index;
  }

  // A program that was killed leaves the first digits of a time ("4" of "41.3"): it is then earlier than the row
  // before, whose time is the best there is. The same keeps the order of a clock that was set back.
  SimTime time_of(const Row& row, SimTime t) {
    if (trace_.events.empty() || t >= trace_.events.back().t) return t;
    const SimTime before = trace_.events.back().t;
    note(fmt::format("{}: the time is {} after {}; the latter is used",
                     row.ends ? "the clock goes back" : "the last row is cut short", t.seconds(), before.seconds()));
    return before;
  }

  Trace& trace_;
  std::size_t line_ = 0;
  std::size_t last_index_ = 0;
};

// The studies' logs are called by when they were begun: NAME-2018-02-05-135317.txt. Empty, if this one is not.
std::string time_in_name(std::string_view name) {
  constexpr std::string_view shape = "dddd-dd-dd-dddddd";
  for (std::size_t at = 0; at + shape.size() <= name.size(); ++at) {
    const auto text = name.substr(at, shape.size());
    if (!std::equal(text.begin(), text.end(), shape.begin(),
                    [](char c, char wanted) { return wanted == 'd' ? c >= '0' && c <= '9' : c == wanted; }))
      continue;
    const auto time =
        fmt::format("{}T{}:{}:{}", text.substr(0, 10), text.substr(11, 2), text.substr(13, 2), text.substr(15));
    if (is_local_time(time)) return time;
  }
  return {};
}

bool is_channel(std::string_view text) {
  constexpr std::array<std::string_view, 6> channels = {"HG", "HS", "HP", "AS", "AG", "AA"};
  return std::find(channels.begin(), channels.end(), text) != channels.end();
}

// Calls `each` with the text, number and completeness of every line that is not empty.
template <class Each>
void for_each_line(std::string_view text, Each each) {
  text = without_byte_order_mark(text);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const auto newline = text.find('\n');
    auto line = text.substr(0, newline);
    const bool ends = newline != std::string_view::npos;
    text.remove_prefix(ends ? newline + 1 : text.size());
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!line.empty()) each(line, number, ends);
  }
}

}  // namespace

Result<Trace> import_session_text(std::string_view text, const std::string& name) {
  Trace trace;
  trace.name = name;
  trace.header.scene = "staircase";
  trace.header.machine = imported_machine;
  trace.header.source = std::filesystem::path(name).filename().string();
  trace.header.recorded = time_in_name(trace.header.source);
  SessionReader reader(trace);
  for_each_line(text, [&](std::string_view line, std::size_t number, bool ends) { reader.read(line, number, ends); });
  if (trace.events.empty()) {
    if (trace.notes.empty()) return Error{name + ":1", fmt::format("the file is empty; {}", row_wanted)};
    const auto& [line, sentence] = trace.notes.front();
    return Error{fmt::format("{}:{}", name, line), "no row can be used; the first is " + sentence};
  }
  trace.digest = digest(write_trace(trace));
  return trace;
}

Result<Trace> import_session(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  return import_session_text(*text, path);
}

bool looks_like_session(std::string_view text) {
  text = without_byte_order_mark(text);
  const auto row = split_row(text.substr(0, text.find('\n')));
  return row && index_of(row->index) && is_channel(row->channel);
}

}  // namespace continua
