#include "continua/replay/pictures/key_moments.h"

#include <fmt/format.h>
#include <sstream>

#include "continua/replay/pictures/film_clock.h"
#include "continua/replay/pictures/run_motion.h"
#include "continua/replay/pictures/subtitles.h"
#include "replay/export/drawable_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

/// The story of records written as JSON without `n`, one a line.
RunStory story_of(const std::string& lines) {
  const ScratchFolder folder;
  const std::string custom = R"(<custom><text name=\"b3\" data=\"type=block color=black\"/></custom>)";
  auto log = R"({"kind":"run","n":0,"t":0,"version":1,"scene":{"bodies":{"cup":[]},"mjcf":")" + custom + "\"}}\n";
  std::istringstream in(lines);
  int n = 1;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) log += fmt::format("{{\"n\":{},{}}}\n", n++, line);
  const auto run = RunIndex::open(folder.write("a.run.jsonl", log));
  if (!run) FAIL(run.error().text());
  const auto story = read_story(*run);
  if (!story) FAIL(story.error().text());
  return *story;
}

std::string said(double t, double until, const std::string& text) {
  return fmt::format("\"kind\":\"input\",\"t\":{},\"event\":{{\"kind\":\"speech\",\"text\":\"{}\",\"until\":{}}}\n", t,
                     text, until);
}
std::string sample(double t, double x) {
  return fmt::format(
      "\"kind\":\"input\",\"t\":{},\"event\":{{\"kind\":\"pointing\",\"hand\":\"right\",\"target\":[{},0]}}\n", t, x);
}
std::string gesture(double t, const std::string& name, const std::string& more = "") {
  return fmt::format("\"kind\":\"input\",\"t\":{},\"event\":{{\"kind\":\"gesture\",\"name\":\"{}\"{}}}\n", t, name,
                     more);
}
std::string answer(double t, const std::string& text, const std::string& because) {
  return fmt::format("\"kind\":\"utterance\",\"t\":{},\"text\":\"{}\",\"because\":[{}]\n", t, text, because);
}
std::string act(double t, const std::string& program, const std::string& status, const std::string& more = "") {
  return fmt::format("\"kind\":\"act\",\"t\":{},\"act\":1,\"program\":\"{}\",\"status\":\"{}\"{}\n", t, program, status,
                     more);
}
std::string end(double t) { return fmt::format("\"kind\":\"end\",\"t\":{}\n", t); }

/// "2.0 Human: hello | Avatar: yes", a moment a line.
std::string text_of(const std::vector<KeyMoment>& moments) {
  std::string text;
  for (const auto& moment : moments) {
    text += fmt::format("{:.1f}", moment.t.seconds());
    for (std::size_t i = 0; i < moment.happenings.size(); ++i)
      text += fmt::format("{}{}: {}", i == 0 ? " " : " | ", moment.happenings[i].who, moment.happenings[i].text);
    text += "\n";
  }
  return text;
}

std::string text_of(const std::vector<Subtitle>& subtitles) {
  std::string text;
  for (const auto& one : subtitles)
    text += fmt::format("{:.1f}-{:.1f} {} {}\n", one.from.seconds(), one.until.seconds(),
                        one.speaker == Speaker::human ? "H" : "A", one.text);
  return text;
}

SimTime s(double seconds) { return SimTime::from_seconds(seconds); }

}  // namespace

TEST_CASE("key moments are what something came of, answers, and the ends of acts") {
  struct Row {
    const char* what;
    std::string log, moments;
  };
  const std::vector<Row> rows = {
      {"an order and its answer are one moment, when both are over", said(1, 2.2, "go") + answer(2.2, "Okay.", "1"),
       "2.2 Human: go | Avatar: Okay.\n"},
      {"what began first is told first, whatever ended first", said(1, 1.4, "go") + answer(1, "Okay.", "1"),
       "1.4 Human: go | Avatar: Okay.\n"},
      {"nothing came of what was muttered", said(1, 2, "hm") + said(5, 6, "go") + answer(6, "Okay.", "2"),
       "6.0 Human: go | Avatar: Okay.\n"},
      {"a burst of samples counts as one, by its end, if something came of it",
       sample(1, 0) + sample(1.2, 0) + sample(1.4, 0) + sample(8, 0) + answer(3, "This?", "2"),
       "1.4 Human: [pointing]\n3.0 Avatar: This?\n"},
      {"samples within a gesture that points are the gesture's",
       sample(1, 0) + gesture(1.1, "point", ",\"target\":[0,0],\"until\":1.8") + answer(1.8, "This?", "1,2"),
       "1.8 Human: [points] | Avatar: This?\n"},
      {"what is said and shown at a time is told in one line",
       said(1, 2.2, "there") + gesture(1.2, "point", ",\"until\":2.2") + answer(2.2, "Okay.", "1,2"),
       "2.2 Human: there [points] | Avatar: Okay.\n"},
      {"the end of a gesture is none", gesture(1, "wave", ",\"phase\":\"stop\"") + answer(2, "Bye.", "1"),
       "2.0 Avatar: Bye.\n"},
      {"an act that ends, and how; its beginning is none",
       act(1, "put(cup, on(plate))", "asked") + act(1, "put(cup, on(plate))", "started") +
           act(4, "put(cup, on(plate))", "missed", R"(,"result":{"reason":"it slid off"})"),
       "4.0 Act: puts cup on plate: missed, it slid off\n"},
      {"the objects in its reason have their words",
       act(4, "lift(b3)", "blocked", R"(,"result":{"reason":"b3 would fall off the table"})"),
       "4.0 Act: lifts the black block: blocked, the black block would fall off the table\n"},
      {"the end of a step is one where it stands alone",
       act(2, "grasp(cup)", "done", R"(,"step":1,"result":{})") + act(4, "ungrasp(cup)", "done", R"(,"step":3)") +
           act(4, "put(cup, x)", "done"),
       "2.0 Act: takes cup: done\n4.0 Act: puts cup x: done\n"},
      {"a step that needed no doing is none",
       act(2, "grasp(cup)", "done", R"(,"step":1,"result":{"reason":"held already"})"), "9.0\n"},
      {"nothing happened: the end", "", "9.0\n"},
  };
  for (const auto& row : rows) {
    INFO(row.what);
    CHECK(text_of(key_moments(story_of(row.log + end(9)))) == row.moments);
  }
}

TEST_CASE("of too many moments the weightier stay, and of equal ones those that stand apart") {
  const auto story = story_of(act(1, "grasp(cup)", "done", ",\"step\":1") + answer(10, "a", "") + answer(11, "b", "") +
                              answer(15, "c", "") + act(20, "put(cup, x)", "blocked") + answer(21, "d", "") + end(60));
  CHECK(text_of(key_moments(story, 5)) ==
        "10.0 Avatar: a\n11.0 Avatar: b\n15.0 Avatar: c\n20.0 Act: puts cup x: blocked\n21.0 Avatar: d\n");
  CHECK(text_of(key_moments(story, 3)) == "11.0 Avatar: b\n15.0 Avatar: c\n20.0 Act: puts cup x: blocked\n");
  CHECK(text_of(key_moments(story, 1)) == "20.0 Act: puts cup x: blocked\n");
  CHECK(key_moments(story, 0).size() == 1);
}

TEST_CASE("where somebody points, and from when on") {
  const auto story = story_of(
      sample(1, 0.1) + sample(1.2, 0.2) +
      "\"kind\":\"input\",\"t\":3,\"event\":{\"kind\":\"pointing\",\"hand\":\"left\",\"ray\":{\"from\":[0,-1,1],"
      "\"direction\":[0,1,-2]}}\n\"kind\":\"gesture\",\"t\":5,\"gesture\":\"reach(cup)\"\n"
      "\"kind\":\"gesture\",\"t\":6,\"gesture\":\"point(rHand, <0.1, 0.2, 0>)\"\n" +
      gesture(7, "point", ",\"phase\":\"start\",\"target\":[0.3,0]") + gesture(9, "point", ",\"phase\":\"stop\"") +
      sample(10, 0.4) + gesture(10.1, "point", ",\"hand\":\"right\",\"phase\":\"start\",\"target\":[0.5,0]") +
      gesture(11, "point", ",\"hand\":\"right\",\"phase\":\"stop\"") + end(12));
  std::string text;
  for (const auto& one : story.pointings) {
    const Vec3 last = one.samples.back().target_W;
    text +=
        fmt::format("{} {:.1f}-{:.1f} <{}, {}> {}{}\n", one.speaker == Speaker::human ? "H" : "A", one.from.seconds(),
                    one.until.seconds(), last.x(), last.y(), one.on_body, one.samples.back().from_W ? "ray" : "");
  }
  CHECK(text ==
        "H 1.0-1.7 <0.2, 0> \nH 3.0-3.7 <0, -0.5> ray\nA 5.0-6.0 <0, 0> cup\nA 6.0-8.0 <0.1, 0.2> \n"
        "H 7.0-9.0 <0.3, 0> \nH 10.0-11.0 <0.5, 0> \n");
  std::string lines;
  for (const auto& one : story.lines) lines += one.text + "\n";
  CHECK(lines ==
        "[reaches to cup]\n[points at 10 cm right of and 20 cm beyond the table's middle]\n[points]\n[points]\n");
}

TEST_CASE("subtitles stay long enough to be read, and go when the same speaker goes on") {
  const auto story = story_of(said(1, 2, "Put the white cup over there, please.") + answer(2, "Okay.", "1") +
                              said(10, 18, "No") + answer(20, "Which of the cups do you mean?", "3") +
                              answer(20.5, "The blue one?", "3") + gesture(10.5, "wave") + end(30));
  const auto subtitles = subtitles_of(story);
  CHECK(text_of(subtitles) ==
        "1.0-4.2 H Put the white cup over there, please.\n2.0-3.3 A Okay.\n10.0-18.0 H No\n10.5-12.0 H [wave]\n"
        "20.0-20.5 A Which of the cups do you mean?\n20.5-22.3 A The blue one?\n");
  const auto shown = [&](double t) {
    std::string text;
    for (const auto& one : shown_at(subtitles, s(t))) text += one.text + "\n";
    return text;
  };
  CHECK(shown(0.9).empty());
  CHECK(shown(2) == "Put the white cup over there, please.\nOkay.\n");
  CHECK(shown(3.5) == "Put the white cup over there, please.\n");
  CHECK(shown(11) == "No [wave]\n");
  CHECK(shown(20.5) == "The blue one?\n");
}

TEST_CASE("a film shortens waits and nothing else") {
  const FilmClock clock({{s(12), s(13)}, {s(2), s(4)}, {s(5), s(5)}}, s(60), false);
  struct Row {
    double film, run;
    bool jumping;
  };
  // 0 to 5.5 as it is, 5.5 to 11.7 in 0.8 s, to 13.5 as it is, and to the end in 0.8 s.
  const std::vector<Row> rows = {{0, 0, false},      {3, 3, false},      {5.4, 5.4, false}, {5.9, 8.6, true},
                                 {6.3, 11.7, false}, {7.3, 12.7, false}, {8.9, 60, true},   {99, 60, true}};
  for (const auto& row : rows) {
    INFO(row.film);
    CHECK(clock.at(s(row.film)).t.seconds() == Approx(row.run).margin(1e-4));
    CHECK(clock.at(s(row.film)).jumping == row.jumping);
  }
  CHECK(clock.film_end() == s(8.9));
  const FilmClock real({{s(2), s(4)}}, s(60), true);
  CHECK(real.film_end() == s(60));
  CHECK(real.at(s(33)).t == s(33));
  CHECK(FilmClock({}, SimTime{}, false).film_end() == SimTime{});
}

TEST_CASE("bodies go from pose to pose, and stand where the log has none") {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("a.run.jsonl", drawable_log().text()));
  REQUIRE(run.ok());
  const auto motion = RunMotion::read(*run);
  REQUIRE(motion.ok());
  const auto x = [&](double t) { return motion->at(s(t)).at("block1").p_WB.x(); };
  CHECK(x(0) == 0.2);
  CHECK(x(2.3) == 0.2);
  CHECK(x(2.4) == 0.0);
  CHECK(x(2.42) == Approx(-0.1));
  CHECK(x(2.44) == -0.2);
  CHECK(x(19) == -0.2);
  CHECK(motion->at(s(19)).at("table").p_WB.x() == 0);
}
