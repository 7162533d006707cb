// Lessons are told in words wherever records are listed.
#include "continua/replay/log/run_brief.h"

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/explain/explain.h"
#include "continua/replay/explain/explain_text.h"
#include "continua/replay/inspector/run_labels.h"
#include "replay/inspector/inspector_log.h"

using namespace continua;

namespace {

// A word is taught and forgotten.
RunIndex run_with_lesson(const std::string& word) {
  auto log = small_log();
  for (const char* kind : {"learned", "forgotten"})
    log.add(kind, 10, {{"of", "word"}, {"name", word}, {"value", "\\x: e. [lift(x)]"}, {"because", Json::array()}});
  auto run = RunIndex::of_text(log.text(), word);
  if (!run) FAIL(run.error().text());
  return *std::move(run);
}

std::size_t first(const RunIndex& run, const char* kind) { return run.of_kind(kind).at(0); }

}  // namespace

TEST_CASE("lists of records tell lessons in words") {
  const auto run = run_with_lesson("hoist");
  for (const char* kind : {"learned", "forgotten"}) {
    const auto n = first(run, kind);
    CHECK(brief(*run.record(n)) == "word hoist = \\x: e. [lift(x)]");
    CHECK(label_of(kind, *run.line(n)) == "word hoist = \\x: e. [lift(x)]");
  }
}

TEST_CASE("an explanation tells lessons in words") {
  const auto run = run_with_lesson("hoist");
  const auto text_of_first = [&](const char* kind) {
    const auto told = explain(run, first(run, kind));
    if (!told) FAIL(told.error().text());
    return explain_text(*told, {});
  };
  CHECK_THAT(text_of_first("learned"), Contains("learns that the word “hoist” means “[lifts …]”"));
  CHECK_THAT(text_of_first("forgotten"), Contains("forgets the word “hoist”"));
}

TEST_CASE("a difference of runs tells lessons in words") {
  const auto a = run_with_lesson("hoist"), b = run_with_lesson("heave");
  const auto diff = diff_runs(a, b);
  if (!diff) FAIL(diff.error().text());
  CHECK_THAT(diff_text(a, b, *diff), Contains("learned word hoist = \\x: e. [lift(x)] in A, word heave"));
}
