// A trace without faults that can be read again and again, without being held.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The next event of a reading, in order of t; nothing at the end. Errors: the file has changed since it was opened.
using NextEvent = std::function<Result<std::optional<TraceEvent>>()>;

class TraceSource {
 public:
  /// Reads the file once to its end. A file that can be read only once, such as a pipe, is held as text. Errors: the
  /// first problem of the trace.
  static Result<TraceSource> open(const std::string& path);

  const TraceHead& head() const { return head_; }
  /// The number of events.
  std::size_t size() const { return survey_.size; }
  /// Whether anything was observed of another avatar.
  bool observes() const { return survey_.observes; }
  /// Whether all observations come at the instants of inputs, as from a system that answers at once. If so, all
  /// consequences of an input are there at its instant; else they may come until the next input that is no sample.
  bool answers_at_once() const { return survey_.at_once; }

  /// A reading of its own, from the first event on.
  NextEvent read() const { return read_(); }
  /// All events. Errors: the file has changed since it was opened.
  Result<std::vector<TraceEvent>> events() const;

  /// This trace until an instant, and the events of another one from then on.
  Result<TraceSource> with(const TraceSource& edited, SimTime from) const;

 private:
  struct Survey {
    std::size_t size = 0;
    bool observes = false, at_once = true;
    std::optional<SimTime> input;  // the latest
    void see(const TraceEvent& event);
  };

  TraceSource(TraceHead head, std::function<NextEvent()> read) : head_(std::move(head)), read_(std::move(read)) {}

  TraceHead head_;
  std::function<NextEvent()> read_;
  Survey survey_;
};

/// A reading of events that are held elsewhere and outlive it.
NextEvent reading_of(const std::vector<TraceEvent>& events);

}  // namespace continua
