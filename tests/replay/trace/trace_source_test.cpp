#include "continua/replay/trace/trace_source.h"

#include <cstdio>

#include <fmt/format.h>

#include "continua/core/gzip.h"
#include "continua/core/gzip_blocks.h"
#include "continua/core/located_json.h"
#include "continua/replay/trace/trace_name.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string header = R"({"kind":"trace","version":1,"scene":"s","machine":"m"})";

std::string said(double t, const std::string& text) {
  return fmt::format(R"({{"t":{},"kind":"speech","text":"{}"}})", t, text) + "\n";
}

// A trace file of a test's own.
struct WrittenTrace {
  explicit WrittenTrace(const std::string& events) { write(events); }
  void write(const std::string& events) const { folder.file("t.jsonl", header + "\n" + events); }
  TraceSource source() const { return TraceSource::open(path).value(); }

  TemporaryFolder folder;
  std::string path = folder.at("t.jsonl");
};

// The words of a reading, and whether it came to its end.
std::string words_of(const NextEvent& next) {
  std::string words;
  for (auto event = next();; event = next()) {
    if (!event) return words + "! " + event.error().sentence;
    if (!*event) return words;
    words += std::get<InputEvent>((*event)->what).text + " ";
  }
}

std::string in_blocks(const std::string& text) {
  GzipBlocks blocks;
  auto packed = blocks.add(text);
  return packed + blocks.finish();
}

}  // namespace

TEST_CASE("a trace is read as often as wanted, each time from its first event") {
  const WrittenTrace trace(said(1, "a") + said(2, "b"));
  const auto source = trace.source();
  CHECK(source.size() == 2);
  const auto first = source.read();
  CHECK(std::get<InputEvent>((*first())->what).text == "a");
  CHECK(words_of(source.read()) == "a b ");
  CHECK(words_of(first) == "b ");
  CHECK(source.events()->size() == 2);
}

TEST_CASE("a source has the head of the whole trace") {
  const WrittenTrace trace(R"({"t":1,"kind":"unheard"})"
                           "\n");
  const auto source = trace.source();
  const auto whole = read_trace(trace.path);
  REQUIRE(whole.ok());
  CHECK(source.head().digest == whole->digest);
  CHECK(source.head().name == trace.path);
  CHECK(source.head().notes.size() == whole->notes.size());
}

TEST_CASE("a source has the first problem of its trace") {
  const WrittenTrace trace(said(2, "a") + said(1, "b") + "{\n");
  for (const auto& path : {trace.path, trace.path + "x"})
    CHECK(TraceSource::open(path).error().text() == read_trace(path).error().text());
}

TEST_CASE("a file that changes is noticed") {
  const WrittenTrace trace(said(1, "a") + said(2, "b"));
  const auto source = trace.source();
  const std::string changed = "! has changed since it was opened; expected a file that stays as it is";
  trace.write(said(1, "a") + said(2, "c"));
  CHECK(words_of(source.read()) == "a c " + changed);
  trace.write(said(1, "a") + "{");
  CHECK(words_of(source.read()) == "a " + changed);
  std::remove(trace.path.c_str());
  CHECK(words_of(source.read()) == changed);
  CHECK_FALSE(source.events().ok());
}

TEST_CASE("a packed trace is the trace, and its damage is told at once") {
  const WrittenTrace trace(said(1, "a") + said(2, "b"));
  const auto text = read_file(trace.path).value();
  for (const auto& bytes : {in_blocks(text), gzipped(text)}) {
    const auto path = trace.folder.file("t.jsonl.gz", bytes);
    const auto source = TraceSource::open(path);
    REQUIRE(source.ok());
    CHECK(source->head().digest == trace.source().head().digest);
    CHECK(words_of(source->read()) == "a b ");
    CHECK(words_of(source->read()) == "a b ");
    CHECK(read_trace(path)->events.size() == 2);
    trace.folder.file("t.jsonl.gz", bytes.substr(0, bytes.size() - 9));
    for (const auto& problem : {TraceSource::open(path).error(), read_trace(path).error()})
      CHECK(problem.text().starts_with(path + ": is cut short"));
  }
  CHECK(trace_name("runs/x.trace.jsonl.gz") == "x");
  CHECK(name_in_log("runs/x.trace.jsonl.gz") == "x.trace.jsonl");
}

TEST_CASE("from an instant on the events are those of another trace") {
  const WrittenTrace trace(said(1, "a") + said(2, "b") + said(3, "c"));
  const WrittenTrace other(said(0, "u") + said(2, "v") + said(9, "w"));
  const auto source = trace.source().with(other.source(), SimTime::from_seconds(2));
  REQUIRE(source.ok());
  CHECK(words_of(source->read()) == "a v w ");
  CHECK(source->size() == 3);
  CHECK(source->head().name == trace.path);
}

TEST_CASE("a source knows whether observations come at the instants of inputs") {
  const auto observed = [](double t) {
    return fmt::format(R"({{"t":{},"kind":"observed","channel":"speech","content":"x"}})", t) + "\n";
  };
  const auto with = [](const std::string& events) { return WrittenTrace(events).source(); };
  CHECK_FALSE(with(said(1, "a")).observes());
  CHECK(with(said(1, "a") + observed(1)).observes());
  CHECK(with(said(1, "a") + observed(1)).answers_at_once());
  CHECK_FALSE(with(said(1, "a") + observed(1.5)).answers_at_once());
  CHECK_FALSE(with(observed(0)).answers_at_once());
}
