// Differences of two runs and of two traces.
#include <filesystem>

#include "continua/replay/commands/diff.h"
#include "continua/replay/diff/run_diff.h"
#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/experiment/trace_diff.h"
#include "continua/replay/log/log_file.h"
#include "replay/diff/edited_example.h"
#include "replay/inspector/inspector_log.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const auto traces = fs::path(source_dir()) / "traces";

RunIndex index_of(const std::string& log) {
  auto index = RunIndex::of_text(log, "log");
  if (!index) FAIL(index.error().text());
  return *std::move(index);
}

RunDiff diff_of(const RunIndex& a, const RunIndex& b) {
  auto diff = diff_runs(a, b);
  if (!diff) FAIL(diff.error().text());
  return *std::move(diff);
}

RunDiff diff_of(const LogBuilder& a, const LogBuilder& b) { return diff_of(index_of(a.text()), index_of(b.text())); }

LogBuilder begun(const Json& more = Json::object()) {
  LogBuilder log;
  Json header{{"version", 1}, {"trace", {{"name", "t"}}}, {"machine", {{"name", "m"}}}, {"world", "physics"}};
  header.update(more);
  log.add("run", 0, header);
  return log;
}

Json speech(const std::string& text) {
  return {{"line", 2}, {"event", {{"kind", "speech"}, {"text", text}}}, {"symbol", "x"}};
}

Json pose(double x) { return {{"bodies", {{"cup", {x, 0, 0, 1, 0, 0, 0}}}}}; }

Trace trace_of(const std::string& text) {
  auto trace = read_trace_text("{\"kind\":\"trace\",\"version\":1,\"scene\":\"s\"}\n" + text, "t");
  if (!trace) FAIL(trace.error().text());
  return *std::move(trace);
}

}  // namespace

TEST_CASE("a run is the same as itself, and as what was written of it in another place") {
  int runs = 0;
  for (const auto& file : fs::recursive_directory_iterator(traces)) {
    if (!file.path().string().ends_with(".run.jsonl")) continue;
    ++runs;
    const auto run = RunIndex::open(file.path().string());
    REQUIRE(run.ok());
    const auto diff = diff_of(*run, *run);
    INFO(file.path());
    CHECK(diff.sameness == RunDiff::Sameness::same);
    CHECK(diff.cause.kind == "none");
    CHECK(diff.inputs_common == diff.inputs_a);
    CHECK(diff.pairs.size() >= std::min(diff.inputs_a, most_pairs));
    for (const auto& [n, m] : diff.pairs) CHECK(n == m);
  }
  CHECK(runs >= 30);
}

TEST_CASE("any two runs can be held against each other, and differ both ways round") {
  std::vector<RunIndex> runs;
  const auto is_kinematic = [](const std::string& path) {
    return path.ends_with(".run.jsonl") && path.find(".physics.") == std::string::npos;
  };
  for (const auto& file : fs::directory_iterator(traces / "paper"))
    if (is_kinematic(file.path().string())) runs.push_back(*RunIndex::open(file.path().string()));
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    const auto diff = diff_of(runs[i], runs[i + 1]), back = diff_of(runs[i + 1], runs[i]);
    INFO(runs[i].path() << " " << runs[i + 1].path());
    CHECK(!is_same(diff));
    CHECK(!is_same(back));
    CHECK(diff.sentence.find('\n') == std::string::npos);
    CHECK(diff_json(runs[i], runs[i + 1], diff)["count"] == diff.count);
    for (std::size_t k = 0; k < diff.pairs.size(); ++k) {
      CHECK((diff.pairs[k].first < runs[i].size() && diff.pairs[k].second < runs[i + 1].size()));
      if (k > 0)
        CHECK((diff.pairs[k - 1].first < diff.pairs[k].first && diff.pairs[k - 1].second < diff.pairs[k].second));
    }
  }
}

TEST_CASE("ids, running numbers and lines of the trace do not count") {
  auto a = begun(), b = begun();
  a.add("input", 1, speech("go"));
  auto moved = speech("go");
  moved["line"] = 7;
  b.add("pose", 0.5, pose(0.1));
  b.add("input", 1, moved);
  for (auto* log : {&a, &b}) {
    const int shift = log == &a ? 0 : 1;
    log->add("symbol", 1, {{"id", 4 + shift}, {"below", nullptr}, {"slots", {{"x", "cup"}}}}, 1 + shift);
    log->add("transition", 1, transition_fields("go", "A", "B", 4 + shift, 1), 1 + shift);
    log->add("act", 1, {{"act", 1 + shift}, {"program", "grasp(cup)"}, {"status", "asked"}}, 3 + shift);
  }
  a.add("pose", 2, pose(0.1));
  CHECK(diff_of(a, b).sentence == "The runs are the same.");
}

TEST_CASE("an input that one run has more is one difference with all that it brought about") {
  auto a = begun(), b = begun();
  for (auto* log : {&a, &b}) {
    int n = 1;
    for (const char* text : {"one", "two", "three"}) {
      if (log == &b && std::string(text) == "two") {
        log->add("input", 1.5, speech("inserted"));
        log->add("transition", 1.5, transition_fields("stay", "B", "B", 0, 0), n);
        n += 2;
      }
      log->add("input", n, speech(text));
      log->add("transition", n, transition_fields(text, "A", "B", 0, 0), n);
      n += 2;
    }
  }
  const auto diff = diff_of(a, b);
  REQUIRE(diff.differences.front().input);
  CHECK(diff.differences.front().b.size() == 2);
  CHECK(diff.cause.sentence == "“inserted” (speech at 0:01.5) is only in B");
  for (std::size_t i = 1; i < diff.differences.size(); ++i)
    CHECK(diff.differences[i].input->kind == EventChange::Kind::moved);
}

TEST_CASE("bodies may be elsewhere by the tolerance") {
  auto a = begun(), b = begun();
  a.add("pose", 1, pose(0.1));
  b.add("pose", 1, pose(0.1004));
  CHECK(is_same(diff_of(a, b)));
  const auto one = index_of(a.text()), other = index_of(b.text());
  const auto strict = diff_runs(one, other, {1e-4});
  REQUIRE(strict.ok());
  CHECK(strict->cause.kind == "physics only");
  CHECK(strict->farthest == "cup");
  CHECK(strict->largest_distance_m == Approx(0.0004));
}

TEST_CASE("what an act came to counts, whenever it did") {
  auto a = begun(), b = begun();
  for (auto* log : {&a, &b}) {
    log->add("input", 1, speech("go"));
    log->add("act", 1, {{"act", 1}, {"program", "grasp(cup)"}, {"status", "asked"}}, 1);
  }
  a.add("act", 2, {{"act", 1}, {"program", "grasp(cup)"}, {"status", "done"}}, 2);
  b.add("act", 3, {{"act", 1}, {"program", "grasp(cup)"}, {"status", "missed"}}, 2);
  const auto diff = diff_of(a, b);
  REQUIRE(diff.count == 1);
  CHECK(diff.differences[0].kind == RunDifference::Kind::outcome);
  CHECK(diff.sentence.find("“takes cup” is done in A, missed in B") != std::string::npos);
}

TEST_CASE("the value that refused a transition is told where nothing else differs") {
  auto a = begun(), b = begun();
  auto taken = transition_fields("ask", "A", "B", 0, 0), refused = transition_fields("act", "A", "C", 0, 0);
  taken["refused"] = Json::array();
  refused["refused"] = {{{"id", "ask"}, {"reason", "not size(seen) > 1: size(seen) is 1"}}};
  a.add("input", 1, speech("go"));
  b.add("input", 1, speech("go"));
  a.add("transition", 1, taken, 1);
  b.add("transition", 1, refused, 1);
  const auto diff = diff_of(a, b);
  CHECK(diff.cause.kind == "condition value");
  CHECK(diff.cause.sentence == "'ask' does not apply in B: not size(seen) > 1: size(seen) is 1");
}

TEST_CASE("runs with hardly an input in common are called unrelated") {
  auto a = begun(), b = begun();
  for (int i = 0; i < 40; ++i) {
    a.add("input", i, speech("a" + std::to_string(i)));
    b.add("input", i, speech("b" + std::to_string(i)));
  }
  const auto diff = diff_of(a, b);
  CHECK(diff.sameness == RunDiff::Sameness::unrelated);
  CHECK(diff.sentence.find("unrelated") != std::string::npos);
}

TEST_CASE("logs with members of any kind are held against each other without a crash") {
  const auto good = index_of(small_log().text());
  for (const char* member : {"\"scene\":5", "\"machine\":[1]", "\"phrases\":\"x\"", "\"knowledge\":7", "\"seed\":{}"}) {
    const auto odd =
        index_of(std::string("{\"kind\":\"run\",\"n\":0,\"t\":0,\"version\":1,") + member + "}\n" +
                 "{\"kind\":\"transition\",\"n\":1,\"t\":0,\"refused\":3,\"stack\":\"x\",\"candidates\":{}}\n" +
                 "{\"kind\":\"reading\",\"n\":2,\"t\":0,\"resolved\":[1],\"entries\":[2]}\n" +
                 "{\"kind\":\"pose\",\"n\":3,\"t\":0,\"bodies\":[1,2]}\n" +
                 "{\"kind\":\"input\",\"n\":4,\"t\":0,\"line\":1,\"event\":\"x\"}\n");
    for (const auto& [a, b] : {std::pair(&good, &odd), std::pair(&odd, &good)}) {
      const auto diff = diff_of(*a, *b);
      CHECK(!diff_text(*a, *b, diff).empty());
      CHECK(!diff_markdown(*a, *b, diff).empty());
    }
  }
}

TEST_CASE("two traces are held against each other event by event") {
  struct Row {
    const char *a, *b, *told;
  };
  const std::string put = R"({"t":1,"kind":"speech","text":"Put it there."})",
                    yes = R"({"t":2,"kind":"speech","text":"yes"})";
  for (const auto& [a, b, told] : {
           Row{R"({"t":2,"kind":"speech","text":"yes"})", R"({"t":2.5,"kind":"speech","text":"yes"})",
               "“yes” (speech) comes at 0:02 in A, at 0:02.5 in B."},
           Row{R"({"t":2,"kind":"speech","text":"the big cup"})", R"({"t":2,"kind":"speech","text":"the small cup"})",
               "at 0:02 A has “the big cup”, B “the small cup” (big → small)."},
           Row{R"({"t":2,"kind":"gesture","name":"point","confidence":0.9})",
               R"({"t":2,"kind":"gesture","name":"point"})",
               "gesture “points” at 0:02: confidence 0.9 in A, none in B."},
           Row{R"({"t":2,"kind":"speech","text":"yes"})", "", "“yes” (speech at 0:02) is left out in B."},
           Row{"", R"({"t":2,"kind":"expect","state":"Ask"})",
               "the expectation (the state Ask) (expect at 0:02) is only in B."},
           Row{"", "", "The traces are the same."},
       }) {
    const auto diff = diff_traces(trace_of(put + "\n" + a), trace_of(put + "\n" + b));
    CHECK(diff.sentence == told);
    CHECK(diff.same == (std::string(told) == "The traces are the same."));
    CHECK(trace_diff_json(diff)["changes"].size() == diff.changes.size());
  }
}

TEST_CASE("the command's status is that of the answer") {
  const TemporaryFolder folder;
  const auto one = (traces / "paper/never_mind.run.jsonl").string(),
             other = (traces / "paper/one_breath.run.jsonl").string();
  const auto trace = (traces / "paper/never_mind.trace.jsonl").string();
  const auto status = [&](const std::string& a, const std::string& b) {
    DiffCommandOptions options;
    options.a = a;
    options.b = b;
    options.most = 0;
    return run_diff_command(options);
  };
  CHECK(status(one, one) == exit_done);
  CHECK(status(one, other) == exit_no);
  CHECK(status(trace, trace) == exit_done);
  CHECK(status(one, trace) == exit_impossible);
  CHECK(status(one, folder.at("none.run.jsonl")) == exit_impossible);
  CHECK(status(one, folder.file("x.txt", "hello\n")) == exit_impossible);
}

TEST_CASE("of a run that was changed in mid-run the change is named") {
  auto a = begun(), b = begun({{"what_if", {{"from", 1.0}, {"seed", 7}}}});
  a.add("input", 2, speech("go"));
  b.add("input", 2, speech("go"));
  a.add("utterance", 2, {{"text", "Yes."}}, 1);
  b.add("utterance", 2, {{"text", "No."}}, 1);
  const auto diff = diff_of(a, b);
  CHECK(diff.cause.kind == "choice");
  CHECK(diff.cause.what == "seed");
}

TEST_CASE("a log that is cut short is told from a run that went otherwise") {
  const auto text = *read_run_log((traces / "paper/never_mind.run.jsonl").string());
  const auto whole = index_of(text);
  for (const std::size_t line : {40u, 60u, 90u}) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < line; ++i) end = text.find('\n', end) + 1;
    const auto diff = diff_of(whole, index_of(text.substr(0, end)));
    INFO(diff.sentence);
    CHECK(diff.cause.kind == "cut short");
    CHECK(diff.sentence.find("the log of B is cut short after record " + std::to_string(line - 1)) !=
          std::string::npos);
  }
}

TEST_CASE("a draw that only one run made comes of the policy, two draws of the seed") {
  struct Row {
    Json draw_a, draw_b;
    const char *choice, *what;
  };
  for (const auto& [draw_a, draw_b, choice, what] :
       {Row{nullptr, 0.3, "sample", "choice"}, Row{0.7, 0.3, "likeliest", "seed"}}) {
    auto a = begun({{"choice", "likeliest"}, {"seed", 0}}), b = begun({{"choice", choice}, {"seed", 5}});
    auto drawn_a = transition_fields("ask", "A", "B", 0, 0), drawn_b = drawn_a;
    drawn_a["draw"] = draw_a;
    drawn_b["draw"] = draw_b;
    a.add("input", 1, speech("go"));
    b.add("input", 1, speech("go"));
    a.add("transition", 1, drawn_a, 1);
    b.add("transition", 1, drawn_b, 1);
    CHECK(diff_of(a, b).cause.what == what);
  }
}
