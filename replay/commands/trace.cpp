#include "continua/replay/commands/trace.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "continua/core/characters.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/commands/instant_option.h"
#include "continua/replay/commands/moved_paths.h"
#include "continua/replay/commands/objects_at.h"
#include "continua/replay/media/media_file.h"
#include "continua/replay/media/media_peaks.h"
#include "continua/replay/trace/trace_edit.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_names.h"

namespace continua {
namespace {

Result<Trace> cut(const Trace& trace, const TraceCommandOptions& options) {
  const auto from = SimTime::from_seconds(options.from_s);
  const auto to = options.to_s ? std::optional(SimTime::from_seconds(*options.to_s)) : std::nullopt;
  if (to && *to <= from)
    return Error{"--to", fmt::format("found {}, expected a time after --from, {}", *options.to_s, options.from_s)};
  auto piece = cut_trace(trace, from, to);
  if (from == SimTime{}) return piece;
  const auto objects = objects_at(trace.name, from);
  if (!objects) return objects.error();
  for (const auto& [name, start] : *objects) {
    auto& starts = piece.header.objects;
    const auto known =
        std::find_if(starts.begin(), starts.end(), [&moved = name](const auto& each) { return each.first == moved; });
    if (known == starts.end())
      starts.emplace_back(name, start);
    else
      known->second = start;
  }
  return piece;
}

// A kind of events selects these; anything else, the events with this text in a member.
Result<Trace> select(const Trace& trace, const TraceCommandOptions& options) {
  const auto& kinds = event_kinds();
  const auto fits = [&](const Json& event, const std::string& wanted) {
    if (std::find(kinds.begin(), kinds.end(), wanted) != kinds.end()) return event["kind"] == wanted;
    Json members = event;
    for (const char* known : {"t", "kind", "row"}) members.erase(known);
    return event["kind"] == wanted || folded(compact(members)).find(folded(wanted)) != std::string::npos;
  };
  return select_events(trace, [&](const Json& event) {
    const bool any = std::any_of(options.wanted.begin(), options.wanted.end(),
                                 [&](const std::string& wanted) { return fits(event, wanted); });
    return any != options.others;
  });
}

Result<Trace> rename(const Trace& trace, const TraceCommandOptions& options) {
  NameTable names;
  for (const auto& pair : options.names) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == pair.size())
      return Error{"", fmt::format("found the name {}; expected OLD=NEW", in_quotes(pair))};
    names.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
  }
  return rename_in_trace(trace, names);
}

Result<Trace> anonymise(const Trace& trace, const TraceCommandOptions& options) {
  const auto names = read_name_table(options.table);
  if (!names) return names.error();
  const auto nameless = anonymise_trace(trace, *names);
  if (!nameless) return nameless;
  return shift_trace(*nameless, SimTime::from_seconds(options.by_s));
}

Result<Trace> made(const std::vector<Trace>& traces, const TraceCommandOptions& options) {
  if (options.what == "merge") return merge_traces(traces);
  const auto& trace = traces.front();
  if (options.what == "cut") return cut(trace, options);
  if (options.what == "shift") return shift_trace(trace, SimTime::from_seconds(options.by_s));
  if (options.what == "select") return select(trace, options);
  if (options.what == "rename") return rename(trace, options);
  return anonymise(trace, options);
}

// A file of peaks beside each recording.
int write_peaks(const std::string& path) {
  const auto trace = read_trace(path);
  if (!trace) return report(trace.error()), exit_impossible;
  const auto folder = std::filesystem::path(path).parent_path().string();
  int status = exit_done;
  for (const auto& one : media_in(trace->header.json)) {
    const auto recording = find_media(one.file, folder, "/");
    const auto peaks = recording ? work_out_peaks(*recording) : Result<std::string>(recording.error());
    const auto written = peaks ? write_file(*recording + peaks_ending, *peaks + "\n") : Outcome(peaks.error());
    if (written) {
      report(*written);
      status = exit_no;
    } else {
      fmt::print("{} -> {}{}\n", printable_line(one.file), printable_line(one.file), peaks_ending);
    }
  }
  return status;
}

CLI::App& add(CLI::App& command, TraceCommandOptions& options, const std::string& name, const std::string& purpose) {
  auto* sub = command.add_subcommand(name, purpose);
  sub->parse_complete_callback([&options, name] { options.what = name; });
  if (name == "merge")
    sub->add_option("TRACE", options.traces, "traces (.jsonl)")->required();
  else
    sub->add_option("TRACE", options.traces, "a trace (.jsonl)")->required()->expected(1);
  sub->add_option("-o,--output", options.output, "a trace, or '-'");
  return *sub;
}

}  // namespace

int run_trace(const TraceCommandOptions& options) {
  if (options.what == "peaks") return write_peaks(options.traces.front());
  const auto fail = [](const Error& error) {
    report(error);
    return exit_impossible;
  };
  if (const auto problem = not_an_input({options.output}, options.traces)) return fail(*problem);
  std::vector<Trace> traces;
  for (const auto& path : options.traces) {
    auto trace = read_trace(path);
    if (!trace) return fail(trace.error());
    traces.push_back(*std::move(trace));
  }
  auto trace = made(traces, options);
  if (!trace) return fail(trace.error());
  if (const auto problem = write_moved(*trace, options.traces.front(), options.output)) return fail(*problem);
  if (options.output != "-")
    fmt::print("{} -> {}\n", counted(trace->events.size(), "event"), printable_line(options.output));
  return exit_done;
}

void describe_trace(CLI::App& command, TraceCommandOptions& options) {
  command.require_subcommand(1);
  auto& cut = add(command, options, "cut", "The events of a stretch of time, at their own times");
  takes_instants(cut.add_option("--from", options.from_s, "otherwise from the beginning"))->check(CLI::Range(0.0, 1e9));
  takes_instants(cut.add_option("--to", options.to_s, "no longer included; otherwise to the end"));
  cut.footer(
      "Objects begin where they were at that time in a replay in the kinematic world. What was said before is not "
      "known\n"
      "to the piece.\n"
      "Example: continua trace cut talk.trace.jsonl --from 10 --to 30 -o middle.trace.jsonl");
  add(command, options, "merge", "The events of several traces in order of time")
      .footer(
          "The header is the first trace's; the others must have the same scene, machine and parameters.\n"
          "Example: continua trace merge words.trace.jsonl hands.trace.jsonl -o all.trace.jsonl");
  auto& shift = add(command, options, "shift", "All times later, or earlier");
  shift.add_option("--by", options.by_s, "seconds, negative for earlier")->required();
  shift.footer("Example: continua trace shift middle.trace.jsonl --by -10 -o begin.trace.jsonl");
  auto& select = add(command, options, "select", "The events of some kinds, or with some text");
  select.add_option("KIND|TEXT", options.wanted, "a kind of events, or a text, in small or capital letters")
      ->required();
  select.add_flag("--others", options.others, "all other events instead");
  select.footer(
      "Examples: continua trace select talk.trace.jsonl speech gesture -o human.trace.jsonl\n"
      "          continua trace select talk.trace.jsonl --others cup -o rest.trace.jsonl");
  auto& rename = add(command, options, "rename", "Other names for objects and gestures; words that are said stay");
  rename.add_option("OLD=NEW", options.names, "whole names in the header's objects, gestures and terms")->required();
  rename.footer("Example: continua trace rename talk.trace.jsonl cup_blue=mug thumbs_up=posack -o talk2.trace.jsonl");
  auto& anonymise = add(command, options, "anonymise", "Other words for names, other times, no recordings");
  anonymise.add_option("--table", options.table, "a JSON file {NAME: REPLACEMENT}")->required();
  anonymise.add_option("--by", options.by_s, "shift of all times, seconds");
  anonymise.footer(
      "The names are replaced as whole words wherever people's words are. `recorded`, `source`, `media` and `row` are "
      "left\n"
      "out.\n"
      "Example: continua trace anonymise talk.trace.jsonl --table names.json --by 3.5 -o public.trace.jsonl");
  auto* peaks = command.add_subcommand("peaks", "The waveforms of a trace's recordings, kept beside them");
  peaks->parse_complete_callback([&options] { options.what = "peaks"; });
  peaks->add_option("TRACE", options.traces, "a trace (.jsonl)")->required()->expected(1);
  peaks->footer(
      "The timeline of the page then shows them at once, and where there is no ffmpeg.\n"
      "Exit status: 1 if one has no sound or cannot be read.\n"
      "Example: continua trace peaks talk.trace.jsonl");
}

}  // namespace continua
