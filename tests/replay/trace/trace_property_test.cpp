// Reading a written trace gives it back, for any trace.
#include <rapidcheck.h>

#include <algorithm>

#include "continua/replay/trace/trace_file.h"
#include "support/catch.h"

using namespace continua;

namespace {

// Any bytes are a text to JSON as long as they are UTF-8; quotes, controls and letters beyond ASCII are the risky ones.
std::string any_text() {
  std::string text;
  for (const int pick : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 8))) {
    const char* pieces[] = {"a", "B ", "\"", "\\", "\n", "\x01", "é", "🤖"};
    text += pieces[pick];
  }
  return text;
}

std::string some_text() { return "x" + any_text(); }
double any_length() {
  return *rc::gen::inRange(-2'000'000'000, 2'000'000'000) / 1e6 * *rc::gen::element(1.0, 1e-4, 7.3);
}
double any_confidence() { return *rc::gen::inRange(0, 1001) / 1000.0; }
bool coin() { return *rc::gen::inRange(0, 2) == 1; }
Vec3 any_point() { return {any_length(), any_length(), any_length()}; }
Vec3 any_target() { return {any_length(), any_length(), 0}; }

InputEvent any_input(SimTime t) {
  InputEvent event;
  event.t = t;
  event.modality = *rc::gen::element(Modality::speech, Modality::gesture, Modality::pointing, Modality::gaze);
  event.confidence = any_confidence();
  if (coin()) event.until = t + SimTime{*rc::gen::inRange<std::int64_t>(0, 5'000'000)};
  const bool is_directed = event.modality == Modality::pointing || event.modality == Modality::gaze;
  if (event.modality != Modality::speech) {
    if (event.modality != Modality::gaze) event.hand = *rc::gen::element<std::string>("", "left", "right");
    if (is_directed || coin()) event.target_W = any_target();
  }
  if (is_directed && coin()) event.ray = Ray{any_point(), {1, any_length(), any_length()}};
  if (event.modality == Modality::gesture) {
    event.name = some_text();
    event.direction = any_text();
    event.phase = *rc::gen::element<std::string>("", "start", "stop", "stroke");
  }
  if (event.modality == Modality::speech) {
    event.text = any_text();
    event.final = coin();
    while (coin()) event.words.push_back({any_text(), t + SimTime{*rc::gen::inRange<std::int64_t>(0, 1'000'000)}});
  }
  if (!is_directed)
    while (coin()) event.alternatives.push_back({any_text(), any_confidence()});
  return event;
}

Expectation any_expectation() {
  Expectation expected;
  for (auto* field : {&expected.state, &expected.says, &expected.indicated, &expected.act, &expected.holding})
    if (coin()) *field = coin() ? any_text() : "null";
  if (coin()) expected.referents = {some_text(), any_text()};
  if (coin()) expected.stack_depth = *rc::gen::inRange(0, 1000);
  return expected;
}

Trace any_trace() {
  Trace trace;
  trace.header.scene = any_text();
  trace.header.machine = any_text();
  trace.header.source = any_text();
  trace.header.seed = *rc::gen::arbitrary<std::uint64_t>();
  trace.header.perspective = *rc::gen::element(Perspective::human, Perspective::avatar);
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    ObjectStart start;
    start.removed = coin();
    if (!start.removed) {
      start.yaw_rad = any_length() / 1e6;
      if (coin()) start.position_W = any_point() / 1e6;
    }
    trace.header.objects.emplace_back("object" + std::to_string(i), start);
  }
  SimTime t;
  for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
    t = t + SimTime{*rc::gen::inRange<std::int64_t>(0, 100'000'000)};
    TraceEvent event;
    event.t = t;
    if (coin()) event.row = *rc::gen::inRange<std::size_t>(0, 100'000);
    switch (*rc::gen::inRange(0, 5)) {
      case 0:
        event.what = Observed{*rc::gen::element<std::string>("speech", "gesture", "action"), any_text()};
        break;
      case 1:
        event.what = any_expectation();
        break;
      case 2:
        event.what = Mark{any_text()};
        break;
      default:
        event.what = any_input(t);
    }
    trace.events.push_back(event);
  }
  return trace;
}

void check_same(const InputEvent& a, const InputEvent& b) {
  RC_ASSERT(a.t == b.t);
  RC_ASSERT(a.modality == b.modality);
  RC_ASSERT(a.text == b.text);
  RC_ASSERT(a.name == b.name);
  RC_ASSERT(a.hand == b.hand);
  RC_ASSERT(a.direction == b.direction);
  RC_ASSERT(a.phase == b.phase);
  RC_ASSERT(a.target_W == b.target_W);
  RC_ASSERT(a.ray.has_value() == b.ray.has_value());
  if (a.ray) RC_ASSERT((a.ray->from_W == b.ray->from_W && a.ray->direction_W == b.ray->direction_W));
  RC_ASSERT(a.until == b.until);
  RC_ASSERT(a.confidence == b.confidence);
  RC_ASSERT(a.words.size() == b.words.size());
  for (std::size_t i = 0; i < a.words.size(); ++i)
    RC_ASSERT((a.words[i].text == b.words[i].text && a.words[i].t == b.words[i].t));
  RC_ASSERT(a.alternatives.size() == b.alternatives.size());
  for (std::size_t i = 0; i < a.alternatives.size(); ++i) {
    RC_ASSERT(a.alternatives[i].text == b.alternatives[i].text);
    RC_ASSERT(a.alternatives[i].confidence == b.alternatives[i].confidence);
  }
}

void check_same(const Observed& a, const Observed& b) {
  RC_ASSERT(a.channel == b.channel);
  RC_ASSERT(a.content == b.content);
}

void check_same(const Mark& a, const Mark& b) { RC_ASSERT(a.text == b.text); }

void check_same(const Expectation& a, const Expectation& b) {
  RC_ASSERT(a.state == b.state);
  RC_ASSERT(a.says == b.says);
  RC_ASSERT(a.indicated == b.indicated);
  RC_ASSERT(a.referents == b.referents);
  RC_ASSERT(a.act == b.act);
  RC_ASSERT(a.holding == b.holding);
  RC_ASSERT(a.stack_depth == b.stack_depth);
}

void check_same(const End&, const End&) {}
void check_same(const UnknownKind&, const UnknownKind&) {}

void check_same(const TraceHeader& a, const TraceHeader& b) {
  RC_ASSERT(a.scene == b.scene);
  RC_ASSERT(a.machine == b.machine);
  RC_ASSERT(a.seed == b.seed);
  RC_ASSERT(a.source == b.source);
  RC_ASSERT(a.perspective == b.perspective);
  RC_ASSERT(a.objects.size() == b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    RC_ASSERT(a.objects[i].first == b.objects[i].first);
    RC_ASSERT(a.objects[i].second.removed == b.objects[i].second.removed);
    RC_ASSERT(a.objects[i].second.position_W == b.objects[i].second.position_W);
    RC_ASSERT(a.objects[i].second.yaw_rad == b.objects[i].second.yaw_rad);
  }
}

}  // namespace

TEST_CASE("reading what was written gives the same trace") {
  const bool holds = rc::check("reader after writer is the identity", [] {
    const Trace written = any_trace();
    const std::string lines = write_trace(written);
    const auto read = read_trace_text(lines, "t.jsonl");
    if (!read) RC_FAIL(read.error().text());
    check_same(written.header, read->header);
    RC_ASSERT(written.events.size() == read->events.size());
    for (std::size_t i = 0; i < written.events.size(); ++i) {
      RC_ASSERT(written.events[i].t == read->events[i].t);
      RC_ASSERT(written.events[i].row == read->events[i].row);
      RC_ASSERT(written.events[i].what.index() == read->events[i].what.index());
      std::visit(
          [&](const auto& what) { check_same(what, std::get<std::decay_t<decltype(what)>>(read->events[i].what)); },
          written.events[i].what);
    }
    RC_ASSERT(write_trace(*read) == lines);
  });
  CHECK(holds);
}

TEST_CASE("no bytes stop the reader") {
  const bool holds = rc::check("damaged traces give a trace or errors", [] {
    std::string lines = write_trace(any_trace());
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
      const auto at = *rc::gen::inRange<std::size_t>(0, lines.size());
      switch (*rc::gen::inRange(0, 3)) {
        case 0:
          lines[at] = *rc::gen::arbitrary<char>();
          break;
        case 1:
          lines.erase(at, *rc::gen::inRange<std::size_t>(1, 40));
          break;
        default:
          lines.insert(at, *rc::gen::element<std::string>("{", "]", "\"", "1e999", "null", "\n", "-"));
      }
      if (lines.empty()) lines = " ";
    }
    const auto reading = read_whole_trace(lines, "t.jsonl");
    for (const auto& problem : reading.problems) {
      RC_ASSERT(problem.where.rfind("t.jsonl:", 0) == 0U);
      RC_ASSERT(problem.sentence.find('\n') == std::string::npos);
    }
  });
  CHECK(holds);
}
