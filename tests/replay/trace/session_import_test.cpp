#include "continua/replay/trace/session_import.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "continua/replay/trace/session_notation.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

Trace imported(const std::string& log) {
  auto trace = import_session_text(log, "logs/s.txt");
  INFO((trace ? "" : trace.error().text()));
  REQUIRE(trace);
  return std::move(trace).value();
}

// The lines of the trace that this content of this channel becomes, without time and row.
std::string event_of(const std::string& channel, const std::string& content) {
  const auto trace = imported("1\t" + channel + "\t" + content + "\t1\n");
  auto json = trace.events.at(0).json;
  json.erase("t");
  json.erase("row");
  return compact(json);
}

std::vector<std::string> notes_of(const std::string& log) {
  const auto trace = imported(log);
  std::vector<std::string> notes;
  for (const auto& note : trace.notes) notes.push_back(sentence_of(trace, note));
  return notes;
}

using Notes = std::vector<std::string>;

}  // namespace

TEST_CASE("a session becomes a trace in its order and at its times") {
  const auto trace = imported(
      "1\tHG\tengage start\t5.45347\n"
      "2\tAS\t\"Hello.\"\t5.45347\n"
      "3\tHP\tr,-0.49,-0.01\t12.20005\n"
      "4\tHS\tYES\t900.1\n");
  CHECK(trace.notes.empty());
  CHECK(
      write_trace(trace) ==
      R"({"kind":"trace","version":1,"scene":"staircase","machine":"diana2018","seed":0,"perspective":"human","source":"s.txt"})"
      "\n"
      R"({"t":5.45347,"kind":"gesture","row":1,"name":"engage","phase":"start"})"
      "\n"
      R"({"t":5.45347,"kind":"observed","row":2,"channel":"speech","content":"Hello."})"
      "\n"
      R"({"t":12.20005,"kind":"pointing","row":3,"hand":"right","target":[-0.330024,0.10399]})"
      "\n"
      R"({"t":900.1,"kind":"speech","row":4,"text":"YES"})"
      "\n");
  CHECK(trace.events[3].line == 5);
  CHECK(read_trace_text(write_trace(trace), "t"));
}

TEST_CASE("a log tells by its name when it was recorded") {
  const auto [name, recorded] = GENERATE(table<std::string, std::string>({
      {"PilotStudy1-2018-02-05-135317.txt", "2018-02-05T13:53:17"},
      {"logs/2017-01-01-000000/Study12-2018-02-08-101811-nonstandard.txt", "2018-02-08T10:18:11"},
      {"2018-02-05-135317", "2018-02-05T13:53:17"},
      {"Study-2018-13-05-135317.txt", ""},
      {"Study-2018-02-05-135360.txt", "2018-02-05T13:53:60"},
      {"Study-2018-02-05-245317.txt", ""},
      {"Study-2018-02-05.txt", ""},
      {"s.txt", ""},
  }));
  const auto trace = import_session_text("1\tHS\tYES\t1\n", name);
  REQUIRE(trace);
  CHECK(trace->header.recorded == recorded);
  CHECK(read_trace_text(write_trace(*trace), "t").value().header.recorded == recorded);
}

TEST_CASE("gestures are taken apart") {
  const auto [content, event] = GENERATE(table<std::string, std::string>({
      {"right point high,-1.37,-1.88",
       R"({"kind":"gesture","name":"point","hand":"right","phase":"start","target":[-0.92272,0.353298]})"},
      {"left point stop", R"({"kind":"gesture","name":"point","hand":"left","phase":"stop"})"},
      {"left point low,0,0.77",
       R"({"kind":"gesture","name":"point","hand":"left","phase":"start","target":[0.0,0.0],"confidence":0.3})"},
      {"grab move up high", R"({"kind":"gesture","name":"grab_move","direction":"up","phase":"start"})"},
      {"push back low", R"({"kind":"gesture","name":"push","direction":"back","phase":"start","confidence":0.3})"},
      {"count one high", R"({"kind":"gesture","name":"count_one","phase":"start"})"},
      {"posack high", R"({"kind":"gesture","name":"posack","phase":"start"})"},
      {"grab stop", R"({"kind":"gesture","name":"grab","phase":"stop"})"},
      {"engage start", R"({"kind":"gesture","name":"engage","phase":"start"})"},
      {"servo left start", R"({"kind":"gesture","name":"servo","direction":"left","phase":"start"})"},
      {"teaching succeeded 2", R"({"kind":"gesture","name":"teaching_succeeded_2"})"},
      {"left", R"({"kind":"gesture","name":"left"})"},
      {"  grab   high ", R"({"kind":"gesture","name":"grab","phase":"start"})"},
  }));
  CHECK(event_of("HG", content) == event);
}

TEST_CASE("what the other agent did is observed, in our notation and frame") {
  const auto [channel, content, ours] = GENERATE(table<std::string, std::string, std::string>({
      {"AS", "\"Sorry, I don't know what you mean.\"", "Sorry, I don't know what you mean."},
      {"AS", "no marks", "no marks"},
      {"AG", "look_at(<1.060792; 0.743948; -0.246642>)", "look_at(<-0.424317, 0.098657, 0.0012>)"},
      {"AG", "reach(<0; 0.743948; 0.1>)", "reach(<0, -0.04, 0.0012>)"},
      {"AG", "point(rHand,<-0.25; 0.74; -2.5E-02>)", "point(rHand, <0.1, 0.01, -0.000379>)"},
      {"AG", "RARM_THUMBS_UP", "RARM_THUMBS_UP"},
      {"AA", "put(block4,on(block1))", "put(block4, on(block1))"},
      {"AA", "put(block4,<-0.5219768; 0.743948; 0.236643>)", "put(block4, <0.208791, -0.094657, 0.0012>)"},
      {"AA", "G push right high", "'gesture push right start'"},
      {"AA", "put(block4,<1; 2>)", "put(block4, <1; 2>)"},
      {"AA", "put(block4,<1; 2", "put(block4, <1; 2"},
  }));
  CHECK(std::get<Observed>(imported("1\t" + channel + "\t" + content + "\t1\n").events.at(0).what).content == ours);
}

TEST_CASE("the frame is turned, moved and scaled") {
  // The nearest and the farthest corner of VoxSim's table, and its surface.
  CHECK(point_from_voxsim(-1.241, 0.740948, 0.292).isApprox(Vec3(0.4964, -0.1168, 0)));
  CHECK(point_from_voxsim(1.238, 1.740948, -0.292).isApprox(Vec3(-0.4952, 0.1168, 0.4)));
  CHECK(table_point_of_sample(0, 0.77) == Vec3::Zero());
  CHECK_FALSE(std::signbit(table_point_of_sample(0, 0.77).y()));
  // A sample and the coordinates that the avatar's gesture at it had.
  const Vec3 looked_at = point_from_voxsim(1.060792, 0.743948, -0.246642);
  CHECK((table_point_of_sample(-0.63, 0.03) - looked_at).head<2>().norm() < 1e-6);
}

TEST_CASE("wild samples are kept") {
  CHECK(event_of("HP", "l,20000.5,-18.80") == R"({"kind":"pointing","hand":"left","target":[13470.70632,2.609072]})");
}

TEST_CASE("rows that cannot be used are left out with a note") {
  const std::string good = "9\tHS\tYES\t9\n";
  const auto [row, note] = GENERATE(table<std::string, std::string>({
      {"8\tHS\t1",
       "logs/s.txt:1: skipped: 3 columns in '8\\x09HS\\x091'; expected index, channel, content and seconds, "
       "separated by tabs"},
      {"8\tHS\ta\tb\t1",
       "logs/s.txt:1: skipped: 5 columns in '8\\x09HS\\x09a\\x09b\\x091'; expected index, channel, content "
       "and seconds, separated by tabs"},
      {"junk",
       "logs/s.txt:1: skipped: 1 column in 'junk'; expected index, channel, content and seconds, separated by tabs"},
      {"8\tXX\ta\t1", "logs/s.txt:1: skipped: the channel is 'XX'; expected HG, HS, HP, AS, AG or AA"},
      {"8\tHS\ta\tsoon", "logs/s.txt:1: skipped: the time is 'soon'; expected seconds"},
      {"8\tHS\ta\tnan", "logs/s.txt:1: skipped: the time is 'nan'; expected seconds"},
      {"8\tHS\ta\t-1", "logs/s.txt:1: skipped: the time is '-1'; expected seconds"},
      {"8\tHS\ta\t1,5", "logs/s.txt:1: skipped: the time is '1,5'; expected seconds"},
      {"8\tHP\tr,1\t1", "logs/s.txt:1: skipped: the pointing sample is 'r,1'; expected 'l,x,y' or 'r,x,y'"},
      {"8\tHP\tx,1,1\t1", "logs/s.txt:1: skipped: the pointing sample is 'x,1,1'; expected 'l,x,y' or 'r,x,y'"},
      {"8\tHP\tr,1,inf\t1", "logs/s.txt:1: skipped: the pointing sample is 'r,1,inf'; expected 'l,x,y' or 'r,x,y'"},
      {"8\tHG\t ,1,2\t1", "logs/s.txt:1: skipped: the gesture is ' ,1,2'; expected its name"},
      {"8\tHS\t\t1", "logs/s.txt:1: skipped: speech without words"},
  }));
  const auto trace = imported(row + "\n" + good);
  CHECK(trace.events.size() == 1);
  CHECK(trace.events[0].row == 2U);
  REQUIRE(trace.notes.size() == 2);
  CHECK(sentence_of(trace, trace.notes[0]) == note);
  CHECK(trace.notes[1].sentence == "the log begins at index 9");
}

TEST_CASE("odd rows are kept with a note") {
  CHECK(notes_of("1\tHG\tright point high,a,b\t1\n") ==
        Notes{"logs/s.txt:1: the point of 'right point high,a,b' is left out; expected two numbers"});
  CHECK(notes_of("x\tHS\tYES\t1\n") == Notes{"logs/s.txt:1: the index is 'x'; expected a whole number"});
  CHECK(notes_of("1\tHS\tYES\t1\n6\tHS\tNO\t2\n") == Notes{"logs/s.txt:2: the index goes from 1 to 6"});
  CHECK(notes_of("1\tHS\tY\xff\t1\n") == Notes{"logs/s.txt:1: bytes that are not UTF-8 were replaced in 'Y\\xff'"});
}

TEST_CASE("a last row that was cut short takes the time of the one before") {
  const auto trace = imported("1\tHS\tYES\t41.25\n2\tHP\tr,0,0\t4");
  REQUIRE(trace.events.size() == 2);
  CHECK(trace.events[1].t == trace.events[0].t);
  CHECK(std::get<InputEvent>(trace.events[1].what).t == trace.events[0].t);
  REQUIRE(trace.notes.size() == 1);
  CHECK(trace.notes[0].line == 2);
  CHECK(trace.notes[0].sentence == "the last row is cut short: the time is 4 after 41.25; the latter is used");
  CHECK(notes_of("1\tHS\tYES\t41.25\n2\tHP\tr,0,0\t4\n") ==
        Notes{"logs/s.txt:2: the clock goes back: the time is 4 after 41.25; the latter is used"});
  CHECK(read_trace_text(write_trace(trace), "t"));
}

TEST_CASE("a byte order mark, carriage returns and blank lines make no difference") {
  CHECK(write_trace(imported("\xEF\xBB\xBF"
                             "1\tHS\tYES\t1\r\n2\tHS\tNO\t2\r\n")) ==
        write_trace(imported("1\tHS\tYES\t1\n2\tHS\tNO\t2\n")));
  CHECK(imported("1\tHS\tYES\t1\n\n\n2\tHS\tNO\t2").events.at(1).row == 4U);
}

TEST_CASE("a file without a usable row is an error") {
  const std::string empty =
      "s.txt:1: the file is empty; expected index, channel, content and seconds, separated by tabs";
  CHECK(import_session_text("", "s.txt").error().text() == empty);
  CHECK(import_session_text("\n\n", "s.txt").error().text() == empty);
  CHECK(import_session_text("\n{}\n", "s.txt").error().text() ==
        "s.txt:2: no row can be used; the first is skipped: 1 column in '{}'; expected index, channel, content and "
        "seconds, separated by tabs");
  CHECK_FALSE(import_session_text(std::string(100'000, '\0'), "s.txt"));
  CHECK(import_session("/nowhere/s.txt").error().sentence == "there is no such file; expected a readable file");
}

TEST_CASE("session logs are told from other files") {
  CHECK(looks_like_session("1\tHG\tengage start\t5.4\n"));
  CHECK(
      looks_like_session("\xEF\xBB\xBF"
                         "1\tHG\tengage start\t5.4\r\n"));
  CHECK_FALSE(looks_like_session("{\"kind\":\"trace\"}\n"));
  CHECK_FALSE(looks_like_session("a\tb\tc\td\n"));
  CHECK_FALSE(looks_like_session(""));
}

TEST_CASE("the pilot study's logs are imported whole") {
  const std::filesystem::path folder = std::filesystem::path(source_dir()) / "../shared/data/pilot2018";
  if (!std::filesystem::is_directory(folder)) {
    std::cout << "skipped: " << folder.lexically_normal().string() << " is not here\n";
    return;
  }
  std::size_t logs = 0;
  std::map<std::string, std::size_t> rows, events;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".txt") continue;
    ++logs;
    const auto log = read_file(entry.path().string()).value();
    for (std::size_t at = 0; at < log.size(); at = log.find('\n', at) + 1) {
      const auto tab = log.find('\t', at);
      ++rows[log.substr(tab + 1, 2)];
      if (log.find('\n', at) == std::string::npos) break;
    }
    const auto trace = import_session_text(log, entry.path().string());
    REQUIRE(trace);
    CHECK(write_trace(*read_trace_text(write_trace(*trace), "t")) == write_trace(*trace));
    for (const auto& event : trace->events) {
      if (const auto* input = std::get_if<InputEvent>(&event.what)) {
        const std::map<Modality, std::string> channels = {
            {Modality::speech, "HS"}, {Modality::gesture, "HG"}, {Modality::pointing, "HP"}};
        ++events[channels.at(input->modality)];
      } else {
        const std::map<std::string, std::string> channels = {{"speech", "AS"}, {"gesture", "AG"}, {"action", "AA"}};
        ++events[channels.at(std::get<Observed>(event.what).channel)];
      }
    }
  }
  CHECK(logs > 0);
  CHECK(events == rows);
}
