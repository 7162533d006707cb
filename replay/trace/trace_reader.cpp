#include "continua/replay/trace/trace_reader.h"

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_header.h"

namespace continua {

TraceReader::TraceReader(std::unique_ptr<std::istream> text, const std::string& name) : text_(std::move(text)) {
  head_.name = name;
  const auto line = next_line();
  auto header = header_from_line(line ? std::optional<std::string_view>(line->text) : std::nullopt, name,
                                 line ? line->number : 1, problems_);
  if (header)
    head_.header = *std::move(header);
  else
    text_.reset();
}

// The next line that is not blank.
std::optional<TraceReader::Line> TraceReader::next_line() {
  Line line;
  while (std::getline(*text_, line.text)) {
    line.number = ++line_;
    line.ends = !text_->eof();
    digest_.add(line.text);
    if (line.ends) digest_.add("\n");
    if (line.number == 1) line.text = without_byte_order_mark(line.text);
    if (!line.text.empty() && line.text.back() == '\r') line.text.pop_back();
    if (line.text.find_first_not_of(" \t") != std::string::npos) return line;
  }
  head_.digest = digest_.text();
  return std::nullopt;
}

std::optional<TraceEvent> TraceReader::next() {
  if (!text_) return std::nullopt;
  while (const auto line = next_line()) {
    auto json = parse_json_line(line->text, head_.name, line->number);
    if (!json) {
      refuse(*line, json.error());
      continue;
    }
    const auto before = problems_.size();
    auto event = event_from_json(std::move(json).value(), head_.name, line->number, problems_, head_.notes);
    if (problems_.size() == before) check_order(event);
    if (problems_.size() > before) continue;
    last_ = Place{event.line, event.t, std::holds_alternative<End>(event.what)};
    return event;
  }
  text_.reset();
  return std::nullopt;
}

// A replay of part of a file would look like one of the whole: a person must judge the loss.
void TraceReader::refuse(const Line& line, const Error& error) {
  if (line.ends) return problems_.push_back(error);
  problems_.push_back({fmt::format("{}:{}", head_.name, line.number),
                       fmt::format("the file is cut short: found {}; expected a whole line, as the {} before it",
                                   in_quotes(line.text), line.number - 1)});
}

// Finds errors of an event's place among those before it.
void TraceReader::check_order(const TraceEvent& event) {
  if (!last_) return;
  const auto refuse = [&](std::string sentence) {
    problems_.push_back({fmt::format("{}:{}", head_.name, event.line), std::move(sentence)});
  };
  if (event.t < last_->t)
    refuse(fmt::format("'t' is {}, before the {} of line {}; expected events in order of time", event.t.seconds(),
                       last_->t.seconds(), last_->line));
  if (last_->is_end) refuse("found an event after 'end'; expected 'end' to be the last");
}

}  // namespace continua
