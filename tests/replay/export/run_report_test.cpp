// The page that shows why a run is not as it was approved.
#include "continua/replay/export/run_report.h"

#include <pugixml.hpp>

#include "continua/replay/export/run_dialogue.h"
#include "replay/inspector/inspector_log.h"

using namespace continua;

namespace {

RunIndex index_of(const LogBuilder& log) { return RunIndex::of_text(log.text(), "a log").value(); }

std::string told(const std::vector<DialogueLine>& lines) {
  std::string text;
  for (const auto& line : lines) text += line.who + " " + line.how + " " + line.what + "\n";
  return text;
}

std::string page_of(const std::string& now, const std::string& before) {
  const auto run = RunIndex::of_text(now, "now").value(), approved = RunIndex::of_text(before, "before").value();
  const auto diff = diff_runs(approved, run).value();
  return report_page({"a.trace.jsonl", "changed", diff.sentence, &run, &approved, &diff, {"continua replay a"}});
}

std::string replaced(std::string text, const std::string& old, const std::string& with) {
  const auto at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), with);
}

// Well-formed, with a policy, and nothing in it that runs or is loaded.
void check_page(const std::string& page) {
  pugi::xml_document document;
  const auto parsed = document.load_string(page.c_str());
  INFO(parsed.description() << " at " << page.substr(static_cast<std::size_t>(parsed.offset), 80));
  CHECK(parsed);
  CHECK(document.select_node("//meta[@http-equiv='Content-Security-Policy']"));
  for (const char* path : {"//script", "//link", "//iframe", "//@src[not(starts-with(., 'data:image/png;base64,'))]",
                           "//@href", "//@*[starts-with(name(), 'on')]"})
    CHECK_FALSE(document.select_node(path));
  CHECK(page.find("url(") == std::string::npos);
  CHECK(page.find("@import") == std::string::npos);
}

}  // namespace

TEST_CASE("a run is told as a dialogue") {
  CHECK(told(dialogue_of(index_of(small_log()))) ==
        "human says “Put it there.”\n"
        "avatar says “Which block?”\n"
        "human shows “points” (start)\n"
        "avatar does “puts block2 on block1”\n"
        "avatar did not take x in Wait: no transition takes x\n");
  struct Case {
    const char* kind;
    const char* fields;
    const char* line;
  };
  const Case cases[] = {
      {"act", R"({"program": "p", "status": "dropped", "result": {"reason": "it fell"}})",
       "avatar did not p: dropped, it fell\n"},
      {"act", R"({"program": "p", "status": "done"})", ""},
      {"act", R"({"program": "p", "status": "blocked", "step": 2})", ""},
      {"expect", R"({"met": false, "expected": {"state": "A"}, "found": {"state": "B"}})",
       "expectation is not met: the state A, found B\n"},
      {"expect", R"({"met": true})", ""},
      {"input", R"({"event": {"kind": "pointing"}})", ""},
      {"input", R"({"event": 7})", ""},
      {"gesture", R"json({"gesture": "look_at(x)"})json", "avatar shows “looks at x”\n"},
      {"utterance", R"({"text": ["no text"]})", "avatar says “[\"no text\"]”\n"},
      {"act", R"({"status": 3})", "avatar did not : 3\n"},
  };
  for (const auto& [kind, fields, line] : cases) {
    LogBuilder log;
    log.add("run", 0, {{"version", 1}});
    log.add(kind, 1, Json::parse(fields));
    CAPTURE(kind, fields);
    CHECK(told(dialogue_of(index_of(log))) == line);
  }
}

TEST_CASE("refused samples of pointing are not told") {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  const auto sample = log.add("input", 1, {{"event", {{"kind", "pointing"}}}});
  log.add("refusal", 1, {{"state", "A"}}, static_cast<int>(sample));
  const auto speech = log.add("input", 1, {{"event", {{"kind", "speech"}, {"text", "Hm."}}}});
  log.add("refusal", 1, {{"state", "A"}, {"input", "s"}, {"reason", "no"}}, static_cast<int>(speech));
  CHECK(told(dialogue_of(index_of(log))) == "human says “Hm.”\navatar did not take s in A: no\n");
}

TEST_CASE("a page shows both runs and what differs") {
  const auto before = small_log().text(), now = replaced(before, "Which block?", "Which <one>?");
  const auto page = page_of(now, before);
  check_page(page);
  CHECK_THAT(page, Contains("<span class=\"verdict bad\">changed</span>"));
  CHECK_THAT(page, Contains("data-of=\"A, approved\">− <span class=\"who\">avatar</span> says “Which block?”"));
  CHECK_THAT(page, Contains("data-of=\"B, now\">+ <span class=\"who\">avatar</span> says “Which &lt;one&gt;?”"));
  CHECK_THAT(page, Contains("<td class=\"both\"><span class=\"who\">human</span> says “Put it there.”"));
  CHECK_THAT(page, Contains("<svg"));
  CHECK_THAT(page, Contains("AskWhichBlock"));
  CHECK_THAT(page, Contains("<pre>continua replay a\n"));
}

TEST_CASE("the same at another time has both times") {
  const auto log_of = [](double t) {
    LogBuilder log;
    log.add("run", 0, {{"version", 1}});
    log.add("input", t, {{"event", {{"kind", "speech"}, {"text", "Hello."}}}});
    return log.text();
  };
  const auto page = page_of(log_of(3.3), log_of(4.1));
  check_page(page);
  CHECK_THAT(page, Contains("<td>A 0:04.1<br/>B 0:03.3</td><td class=\"both\">"));
  CHECK_THAT(page, Contains("<main>"));
}

TEST_CASE("unmet expectations are a table of what was expected and what was found") {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("expect", 4,
          {{"line", 6},
           {"met", false},
           {"expected", {{"state", "Ready"}, {"act", "put(plate, left(cup))"}, {"says", "Okay."}}},
           {"found", {{"state", "Ready"}, {"act", "put(knife, left(cup))"}, {"says", "null"}}}});
  log.add("expect", 5, {{"line", 7}, {"met", true}, {"expected", {{"state", "Ready"}}}});
  const auto run = index_of(log);
  const auto page = report_page({"a", "broken", "a:6: expected {\"state\":\"Ready\"}", &run, nullptr, nullptr, {}});
  check_page(page);
  CHECK_THAT(page, Contains("<p class=\"cause\">The run does not do what its trace expects.</p>"));
  CHECK_THAT(page, Contains("line 6 of the trace, at 0:04"));
  CHECK(page.find("line 7 of the trace") == std::string::npos);
  CHECK_THAT(page, Contains("<td>the avatar does</td><td class=\"gone\" data-of=\"expected\" title=\"{&quot;act&quot;:"
                            "&quot;put(plate, left(cup))&quot;}\">“puts plate left of cup”</td><td class=\"come\" "
                            "data-of=\"found\" title=\"{&quot;act&quot;:&quot;put(knife, left(cup))&quot;}\">“puts "
                            "knife left of cup”</td>"));
  CHECK_THAT(page, Contains("data-of=\"found\" title=\"{&quot;says&quot;:&quot;null&quot;}\">nothing</td>"));
  CHECK_THAT(page,
             Contains("<td class=\"both\" data-of=\"found\" title=\"{&quot;state&quot;:&quot;Ready&quot;}\">the same"));
  CHECK(page.find("expected {") == std::string::npos);
}

TEST_CASE("both scenes are shown side by side, or why they are not") {
  const auto run = index_of(small_log());
  RunReport report{"a", "changed", "they part", &run, nullptr, nullptr, {}};
  report.worlds = {
      {"Where they part", {{"A: approved, at 0:01", "QUJD"}, {"B: now, at 0:02", "", "no EGL & no display"}}}};
  const auto page = report_page(report);
  check_page(page);
  CHECK_THAT(page, Contains("<h2>The scene</h2>\n<h3>Where they part</h3>"));
  CHECK_THAT(page, Contains("<img alt=\"the scene, A: approved, at 0:01\" src=\"data:image/png;base64,QUJD\"/>"));
  CHECK_THAT(page,
             Contains("<p class=\"no_picture\">No picture: no EGL &amp; no display</p><figcaption>B: now, at 0:02"));
}

TEST_CASE("a page can be made of one run alone") {
  const auto run = index_of(small_log());
  const auto page = report_page({"a & b", "broken", "an \"expectation\" is not met", &run, nullptr, nullptr, {}});
  check_page(page);
  CHECK_THAT(page, Contains("<title>broken: a &amp; b</title>"));
  CHECK_THAT(page, Contains("“Which block?”"));
  CHECK(page.find("Records that differ") == std::string::npos);
}

TEST_CASE("a page can be made of runs without a graph, cut short, and of odd records") {
  LogBuilder odd;
  odd.add("run", 0, {{"version", 1}, {"graph", 7}, {"machine", "m"}, {"trace", Json::array()}});
  odd.add("utterance", 1, {{"text", std::string(5000, 'x') + "<"}});
  odd.add("act", 1, {{"act", "one"}, {"program", Json::array()}, {"status", nullptr}});
  odd.line(R"({"kind":"input","n":3,"t":2,"event":)");
  check_page(page_of(odd.text().substr(0, odd.text().size() - 1), small_log().text()));
}
