#include "continua/replay/trace/trace_source.h"

#include <cstdio>
#include <fstream>

#include <fmt/format.h>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string header = R"({"kind":"trace","version":1,"scene":"s","machine":"m"})";

std::string said(double t, const std::string& text) {
  return fmt::format(R"({{"t":{},"kind":"speech","text":"{}"}})", t, text) + "\n";
}

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// The words of a reading, and whether it came to its end.
std::string words_of(const NextEvent& next) {
  std::string words;
  for (auto event = next();; event = next()) {
    if (!event) return words + "! " + event.error().sentence;
    if (!*event) return words;
    words += std::get<InputEvent>((*event)->what).text + " ";
  }
}

}  // namespace

TEST_CASE("a trace is read as often as wanted, each time from its first event") {
  const TemporaryFolder folder;
  const auto path = folder.at("t.jsonl");
  write(path, header + "\n" + said(1, "a") + said(2, "b"));
  const auto source = TraceSource::open(path);
  REQUIRE(source.ok());
  CHECK(source->size() == 2);
  const auto first = source->read();
  CHECK(std::get<InputEvent>((*first())->what).text == "a");
  CHECK(words_of(source->read()) == "a b ");
  CHECK(words_of(first) == "b ");
  CHECK(source->events()->size() == 2);
}

TEST_CASE("a source has the head of the whole trace") {
  const TemporaryFolder folder;
  const auto path = folder.at("t.jsonl");
  write(path, header + "\n" + R"({"t":1,"kind":"unheard"})" + "\n");
  const auto source = TraceSource::open(path);
  const auto whole = read_trace(path);
  REQUIRE((source.ok() && whole.ok()));
  CHECK(source->head().digest == whole->digest);
  CHECK(source->head().name == path);
  CHECK(source->head().notes.size() == whole->notes.size());
}

TEST_CASE("a source has the first problem of its trace") {
  const TemporaryFolder folder;
  const auto path = folder.at("t.jsonl");
  write(path, header + "\n" + said(2, "a") + said(1, "b") + "{\n");
  CHECK(TraceSource::open(path).error().text() == read_trace(path).error().text());
  CHECK(TraceSource::open(path + "x").error().text() == read_trace(path + "x").error().text());
}

TEST_CASE("a file that changes is noticed") {
  const TemporaryFolder folder;
  const auto path = folder.at("t.jsonl");
  write(path, header + "\n" + said(1, "a") + said(2, "b"));
  const auto source = TraceSource::open(path);
  REQUIRE(source.ok());
  const std::string changed = "! has changed since it was opened; expected a file that stays as it is";
  write(path, header + "\n" + said(1, "a") + said(2, "c"));
  CHECK(words_of(source->read()) == "a c " + changed);
  write(path, header + "\n" + said(1, "a") + "{");
  CHECK(words_of(source->read()) == "a " + changed);
  std::remove(path.c_str());
  CHECK(words_of(source->read()) == changed);
  CHECK_FALSE(source->events().ok());
}

TEST_CASE("from an instant on the events are those of another trace") {
  const TemporaryFolder folder;
  const auto path = folder.at("a.jsonl"), other = folder.at("b.jsonl");
  write(path, header + "\n" + said(1, "a") + said(2, "b") + said(3, "c"));
  write(other, header + "\n" + said(0, "u") + said(2, "v") + said(9, "w"));
  const auto source = TraceSource::open(path)->with(*TraceSource::open(other), SimTime::from_seconds(2));
  REQUIRE(source.ok());
  CHECK(words_of(source->read()) == "a v w ");
  CHECK(source->size() == 3);
  CHECK(source->head().name == path);
}

TEST_CASE("a source knows whether observations come at the instants of inputs") {
  const TemporaryFolder folder;
  const auto path = folder.at("t.jsonl");
  const auto observed = [](double t) {
    return fmt::format(R"({{"t":{},"kind":"observed","channel":"speech","content":"x"}})", t) + "\n";
  };
  const auto with = [&](const std::string& events) {
    write(path, header + "\n" + events);
    return *TraceSource::open(path);
  };
  CHECK_FALSE(with(said(1, "a")).observes());
  CHECK(with(said(1, "a") + observed(1)).observes());
  CHECK(with(said(1, "a") + observed(1)).answers_at_once());
  CHECK_FALSE(with(said(1, "a") + observed(1.5)).answers_at_once());
  CHECK_FALSE(with(observed(0)).answers_at_once());
}
