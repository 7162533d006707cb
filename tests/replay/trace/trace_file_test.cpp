#include "continua/replay/trace/trace_file.h"

#include <filesystem>

#include "support/catch.h"

using namespace continua;

namespace {

const std::string header = R"({"kind":"trace","version":1,"scene":"table","machine":"diana","seed":0})";

// The answer of read_trace_text to a sound header followed by these lines.
std::string error_of(const std::string& lines) {
  const auto trace = read_trace_text(header + "\n" + lines, "t.jsonl");
  return trace ? "" : trace.error().text();
}

Trace sound(const std::string& text) {
  auto trace = read_trace_text(text, "t.jsonl");
  INFO((trace ? "" : trace.error().text()));
  REQUIRE(trace);
  return std::move(trace).value();
}

const InputEvent& input(const Trace& trace, std::size_t i) { return std::get<InputEvent>(trace.events.at(i).what); }

}  // namespace

TEST_CASE("a trace with every kind is read") {
  const auto trace = sound(
      R"({"kind":"trace","version":1,"scene":"s","machine":"m","language":"german","seed":18446744073709551615,"perspective":"avatar","source":"log.txt","objects":{"cup":{"position":[0.1,0.2,0.05],"yaw":1.5},"knife":null,"plate":{"yaw":0.5}},"note":"x"})"
      "\n"
      R"({"t":1.2,"kind":"speech","text":"Put it there.","until":2.0,"confidence":0.93,"words":[{"text":"Put","t":1.2}],"alternatives":[{"text":"Put in there","confidence":0.05}]})"
      "\n"
      R"({"t":1.2,"kind":"gesture","row":7,"name":"point","hand":"right","phase":"stroke","confidence":0.8,"direction":"left","target":[0.1,-0.2],"until":1.6})"
      "\n\n"
      R"({"t":1.3,"kind":"pointing","hand":"left","target":[20000,-3e4]})"
      "\n"
      R"({"t":1.4,"kind":"pointing","ray":{"from":[0,-0.5,0.4],"direction":[0,1,-1]}})"
      "\n"
      R"#({"t":2,"kind":"observed","channel":"action","content":"grasp(block1)"})#"
      "\n"
      R"#({"t":3,"kind":"expect","state":"Wait","says":"OK.","indicated":null,"referents":["cup"],"act":"put(a, b)","holding":"cup","stack_depth":2})#"
      "\n"
      R"({"t":9,"kind":"end"})");
  CHECK(trace.name == "t.jsonl");
  CHECK(trace.header.scene == "s");
  CHECK(trace.header.machine == "m");
  CHECK(trace.header.seed == UINT64_MAX);
  CHECK(trace.header.language == "german");
  CHECK(trace.header.perspective == Perspective::avatar);
  CHECK(trace.header.source == "log.txt");
  CHECK(trace.header.json["note"] == "x");
  REQUIRE(trace.header.objects.size() == 3);
  CHECK(trace.header.objects[0].first == "cup");
  CHECK(*trace.header.objects[0].second.position_W == Vec3(0.1, 0.2, 0.05));
  CHECK(trace.header.objects[0].second.yaw_rad == 1.5);
  CHECK(trace.header.objects[1].second.removed);
  CHECK_FALSE(trace.header.objects[2].second.position_W);

  REQUIRE(trace.events.size() == 7);
  CHECK(trace.notes.empty());
  CHECK(input(trace, 0).modality == Modality::speech);
  CHECK(input(trace, 0).text == "Put it there.");
  CHECK(input(trace, 0).t.us == 1'200'000);
  CHECK(input(trace, 0).until->us == 2'000'000);
  CHECK(input(trace, 0).confidence == 0.93);
  CHECK(input(trace, 0).words.at(0).text == "Put");
  CHECK(input(trace, 0).words.at(0).t.us == 1'200'000);
  CHECK(input(trace, 0).alternatives.at(0).confidence == 0.05);
  CHECK(trace.events[1].row == 7U);
  CHECK(input(trace, 1).name == "point");
  CHECK(input(trace, 1).hand == "right");
  CHECK(input(trace, 1).phase == "stroke");
  CHECK(input(trace, 1).direction == "left");
  CHECK(*input(trace, 1).target_W == Vec3(0.1, -0.2, 0));
  CHECK(trace.events[2].line == 5);
  CHECK(*input(trace, 2).target_W == Vec3(20000, -30000, 0));
  CHECK(input(trace, 3).ray->direction_W == Vec3(0, 1, -1));
  const auto& observed = std::get<Observed>(trace.events[4].what);
  CHECK(observed.channel == "action");
  CHECK(observed.content == "grasp(block1)");
  const auto& expected = std::get<Expectation>(trace.events[5].what);
  CHECK(expected.state == "Wait");
  CHECK(expected.says == "OK.");
  CHECK(expected.indicated == "null");
  CHECK(expected.referents == std::vector<std::string>{"cup"});
  CHECK(expected.act == "put(a, b)");
  CHECK(expected.holding == "cup");
  CHECK(expected.stack_depth == 2);
  CHECK(std::holds_alternative<End>(trace.events[6].what));
  CHECK(trace.events[6].json == Json::parse(R"({"t":9,"kind":"end"})"));
}

TEST_CASE("a list of alternatives alone counts as its best entry") {
  const auto trace = sound(header + "\n" + R"({"t":1,"kind":"speech","alternatives":[{"text":"a","confidence":0.6}]})" +
                           "\n" + R"({"t":1,"kind":"gesture","alternatives":[{"name":"grab","confidence":0.7}]})");
  CHECK(input(trace, 0).text == "a");
  CHECK(input(trace, 0).confidence == 0.6);
  CHECK(input(trace, 1).name == "grab");
}

TEST_CASE("each entry of an n-best list counts once") {
  const auto list = R"("alternatives":[{"text":"no","confidence":0.3},{"text":"yes","confidence":0.6}])";
  const auto trace =
      sound(header + "\n" + R"({"t":1,"kind":"speech",)" + list + "}\n" + R"({"t":1,"kind":"speech","text":"no",)" +
            list + "}\n" + R"({"t":1,"kind":"speech","text":"no","confidence":0.9,)" + list + "}");
  const std::vector<std::pair<std::string, double>> best = {{"yes", 0.6}, {"no", 0.3}, {"no", 0.9}};
  for (std::size_t i = 0; i < best.size(); ++i) {
    CHECK(input(trace, i).text == best[i].first);
    CHECK(input(trace, i).confidence == best[i].second);
    REQUIRE(input(trace, i).alternatives.size() == 1);
    CHECK(input(trace, i).alternatives[0].text == (best[i].first == "yes" ? "no" : "yes"));
  }
}

TEST_CASE("an n-best list has a limit, which is told with the line") {
  const auto list_of = [](int count) {
    std::string list;
    for (int i = 0; i < count; ++i) list += R"({"text":"b","confidence":0.5},)";
    list.pop_back();
    return R"({"t":1,"kind":"gesture","name":"a","alternatives":[)" + list + "]}\n";
  };
  CHECK(error_of(list_of(100)).empty());
  CHECK(error_of("\n" + list_of(101)) == "t.jsonl:3: 'alternatives' has 101 entries; expected at most 100");
}

TEST_CASE("a first line that is not a trace's is an error that shows one") {
  const std::string wanted =
      R"(; expected the first line of a trace, {"kind":"trace","version":1,"scene":…,"machine":…})";
  const auto error = [](std::string_view text) {
    const auto trace = read_trace_text(text, "t.jsonl");
    return trace ? "" : trace.error().text();
  };
  CHECK(error("") == "t.jsonl:1: the file is empty" + wanted);
  CHECK(error("\n \r\n") == "t.jsonl:1: the file is empty" + wanted);
  CHECK(error(std::string("\x7f\x45LF\0\0\1", 7)) == "t.jsonl:1: found binary data" + wanted);
  CHECK(error("[1,2]\n") == "t.jsonl:1: found '[1,2]'" + wanted);
  CHECK(error("{\"version\":1}\n") == "t.jsonl:1: found an object without 'kind'" + wanted);
  CHECK(error("{\"kind\":\"run\",\"version\":1}\n") == "t.jsonl:1: found kind 'run'" + wanted);
  CHECK(error("{\"kind\":7}\n") == "t.jsonl:1: found kind '7'" + wanted);
  CHECK(error("{\"kind\":\"trace\"}\n") == "t.jsonl:1: found a trace without 'version'" + wanted);
  CHECK(error("{\"kind\":\"trace\",\"version\":2}\n") == "t.jsonl:1: found version 2 of the trace format; expected 1");
  CHECK(error("{\"kind\":\"trace\",\"version\":\"1\"}") ==
        "t.jsonl:1: found version \"1\" of the trace format; expected 1");
  CHECK(error("1\tHG\tengage start\t5.4\n").substr(0, 29) == "t.jsonl:1:3: not valid JSON: ");
}

TEST_CASE("what is wrong with a header is said") {
  const auto error = [](const std::string& fields) {
    const auto trace = read_trace_text(R"({"kind":"trace","version":1,)" + fields + "}", "t.jsonl");
    return trace ? "" : trace.error().text();
  };
  CHECK(error(R"("scene":3)") == "t.jsonl:1: 'scene' of the trace is 3; expected a text");
  CHECK(error(R"("seed":-1)") ==
        "t.jsonl:1: 'seed' of the trace is -1; expected a whole number from 0 to 18446744073709551615");
  CHECK(error(R"("perspective":"humans")") ==
        "t.jsonl:1: 'perspective' of the trace is 'humans'; expected 'human' or 'avatar' (did you mean 'human'?)");
  CHECK(error(R"("objects":[])") ==
        R"(t.jsonl:1: 'objects' of the trace is []; expected an object {NAME: {"position":[x,y,z],"yaw":0}})");
  CHECK(error(R"("objects":{"cup":3})") ==
        R"(t.jsonl:1: 'cup' of 'objects' is 3; expected an object {"position":[x,y,z],"yaw":0} or null)");
  CHECK(error(R"("objects":{"cup":{"positon":[0,0,0]}})") ==
        "t.jsonl:1: object 'cup' has no 'position' or 'yaw'; found 'positon' (did you mean 'position'?)");
  CHECK(error(R"("objects":{"cup":{"position":[0,0]}})") ==
        "t.jsonl:1: 'position' of object 'cup' is [0,0]; expected [x, y, z] in metres, each from -1000 to 1000");
  CHECK(error(R"("objects":{"cup":{"position":[0,0,1e6]}})") ==
        "t.jsonl:1: 'position' of object 'cup' is [0,0,1000000.0]; expected [x, y, z] in metres, each from -1000 to "
        "1000");
}

TEST_CASE("what is wrong with an event is said with its line") {
  const auto [line, sentence] = GENERATE(table<std::string, std::string>({
      {"[]", "t.jsonl:2: found '[]'; expected an event as a JSON object"},
      {R"({"kind":"end"})", "t.jsonl:2: end has no 't'"},
      {R"({"t":1})", "t.jsonl:2: the event has no 'kind'"},
      {R"({"t":1,"knid":"end"})", "t.jsonl:2: the event has no 'kind'; found 'knid' (did you mean 'kind'?)"},
      {R"({"t":1,"kind":3})", "t.jsonl:2: 'kind' of the event is 3; expected a text"},
      {R"({"t":"1","kind":"end"})", "t.jsonl:2: 't' of end is '1'; expected a number from 0 to 1000000000"},
      {R"({"t":-0.5,"kind":"end"})", "t.jsonl:2: 't' of end is -0.5; expected a number from 0 to 1000000000"},
      {R"({"t":1e300,"kind":"end"})", "t.jsonl:2: 't' of end is 1e+300; expected a number from 0 to 1000000000"},
      {R"({"t":null,"kind":"end"})", "t.jsonl:2: 't' of end is null; expected a number from 0 to 1000000000"},
      {R"({"t":1e999,"kind":"end"})", "t.jsonl:2:6: not valid JSON: number overflow parsing '1e999'"},
      {R"({"t":1,"kind":"speech"})", "t.jsonl:2: speech has no 'text' or 'alternatives'"},
      {R"({"t":1,"kind":"speech","txt":"a"})",
       "t.jsonl:2: speech has no 'text' or 'alternatives'; found 'txt' (did you mean 'text'?)"},
      {R"({"t":1,"kind":"speech","text":["a"]})", R"(t.jsonl:2: 'text' of speech is ["a"]; expected a text)"},
      {R"({"t":1,"kind":"speech","text":"a","confidence":1.1})",
       "t.jsonl:2: 'confidence' of speech is 1.1; expected a number from 0 to 1"},
      {R"({"t":1,"kind":"speech","text":"a","until":0.5})",
       "t.jsonl:2: 'until' of speech is 0.5; expected a time that is not before 't'"},
      {R"({"t":3,"kind":"speech","text":"a","happened":2,"until":1.5})",
       "t.jsonl:2: 'until' of speech is 1.5; expected a time that is not before 'happened'"},
      {R"({"t":3,"kind":"pointing","target":[0,0],"happened":3.5})",
       "t.jsonl:2: 'happened' of pointing is 3.5; expected a time that is not after 't', when it became known"},
      {R"({"t":1,"kind":"speech","text":"a","words":["a"]})",
       R"(t.jsonl:2: 'words' of speech is ["a"]; expected an array of objects)"},
      {R"({"t":1,"kind":"speech","text":"a","words":[{"text":"a","t":1},{"text":"b"}]})",
       "t.jsonl:2: words/1 of speech has no 't'"},
      {R"({"t":1,"kind":"gesture"})", "t.jsonl:2: gesture has no 'name' or 'alternatives' or 'features'"},
      {R"({"t":1,"kind":"gesture","features":[]})",
       "t.jsonl:2: 'features' of gesture is []; expected an array of one number or more, each finite"},
      {R"({"t":1,"kind":"gesture","features":[1,"2"]})",
       "t.jsonl:2: 'features' of gesture is [1,\"2\"]; expected an array of one number or more, each finite"},
      {R"({"t":1,"kind":"gesture","name":"a","hand":"rigth"})",
       "t.jsonl:2: 'hand' of gesture is 'rigth'; expected 'left' or 'right' (did you mean 'right'?)"},
      {R"({"t":1,"kind":"gesture","name":"a","phase":"high"})",
       "t.jsonl:2: 'phase' of gesture is 'high'; expected 'start', 'stop' or 'stroke'"},
      {R"({"t":1,"kind":"gesture","name":"a","target":[1,2,3]})",
       "t.jsonl:2: 'target' of gesture is [1,2,3]; expected [x, y] in metres, each from -1000000000 to 1000000000"},
      {R"({"t":1,"kind":"speech","text":"put","final":"no"})",
       "t.jsonl:2: 'final' of speech is 'no'; expected true or false"},
      {R"({"t":1,"kind":"gaze","until":2})", "t.jsonl:2: gaze has no 'target' or 'ray'"},
      {R"({"t":1,"kind":"pointing","hand":"left"})", "t.jsonl:2: pointing has no 'target' or 'ray'"},
      {R"({"t":1,"kind":"pointing","target":[1,null]})",
       "t.jsonl:2: 'target' of pointing is [1,null]; expected [x, y] in metres, each from -1000000000 to 1000000000"},
      {R"({"t":1,"kind":"pointing","ray":[0,0,1]})",
       "t.jsonl:2: 'ray' of pointing is [0,0,1]; expected an object with 'from' and 'direction'"},
      {R"({"t":1,"kind":"pointing","ray":{"from":[0,0,1]}})", "t.jsonl:2: ray of pointing has no 'direction'"},
      {R"({"t":1,"kind":"pointing","ray":{"from":[0,0,1],"direction":[0,0,0]}})",
       "t.jsonl:2: 'direction' of ray of pointing is [0,0,0]; expected a direction that is not zero"},
      {R"({"t":1,"kind":"observed","channel":"voice","content":"a"})",
       "t.jsonl:2: 'channel' of observed is 'voice'; expected 'speech', 'gesture' or 'action'"},
      {R"({"t":1,"kind":"observed","channel":"speech"})", "t.jsonl:2: observed has no 'content'"},
      {R"({"t":1,"kind":"expect","stat":"Wait"})",
       "t.jsonl:2: expect has an unknown field 'stat' (did you mean 'state'?)"},
      {R"({"t":1,"kind":"expect","referents":["a",1]})",
       R"(t.jsonl:2: 'referents' of expect is ["a",1]; expected an array of texts)"},
      {R"({"t":1,"kind":"expect","stack_depth":1.5})",
       "t.jsonl:2: 'stack_depth' of expect is 1.5; expected a whole number from 0 to 1000000"},
      {R"({"t":1,"kind":"end","row":-3})",
       "t.jsonl:2: 'row' of end is -3; expected a whole number from 0 to 1000000000"},
  }));
  CHECK(error_of(line + "\n") == sentence);
}

TEST_CASE("what became known late has a time of its own, which is written again") {
  const auto line = R"({"t":2.5,"kind":"gesture","happened":1.25,"name":"point","until":1.5})";
  const auto trace = sound(header + "\n" + line + "\n");
  CHECK(trace.events[0].t.seconds() == 2.5);
  CHECK(input(trace, 0).t.seconds() == 1.25);
  CHECK(write_event(trace.events[0]) == line);
}

TEST_CASE("events out of order are an error") {
  CHECK(error_of("{\"t\":2,\"kind\":\"end\"}\n{\"t\":3,\"kind\":\"end\"}\n") ==
        "t.jsonl:3: found an event after 'end'; expected 'end' to be the last");
  CHECK(error_of("{\"t\":2,\"kind\":\"speech\",\"text\":\"a\"}\n{\"t\":1.5,\"kind\":\"end\"}\n") ==
        "t.jsonl:3: 't' is 1.5, before the 2 of line 2; expected events in order of time");
}

TEST_CASE("all that is wrong is found, not only the first") {
  const auto reading = read_whole_trace(header +
                                            "\n{\"t\":1}\n{\"t\":2,\"kind\":\"speech\",\"text\":1,\"until\":\"x\"}"
                                            "\nnonsense\n{\"t\":3,\"kind\":\"end\"}\n",
                                        "t.jsonl");
  REQUIRE(reading.problems.size() == 4);
  CHECK(reading.problems[0].where == "t.jsonl:2");
  CHECK(reading.problems[1].where == "t.jsonl:3");
  CHECK(reading.problems[2].where == "t.jsonl:3");
  CHECK(reading.problems[3].where == "t.jsonl:4:2");
  CHECK(reading.trace.events.size() == 1);
}

TEST_CASE("a last line cut short is an error that says what is whole before it") {
  const auto whole = header + "\n" + R"({"t":1,"kind":"speech","text":"a"})";
  const auto trace = read_trace_text(whole + "\n" + R"({"t":2,"kind":"spe)", "t.jsonl");
  REQUIRE_FALSE(trace.ok());
  CHECK(trace.error().text() ==
        "t.jsonl:3: the file is cut short: found '{\"t\":2,\"kind\":\"spe'; expected a whole line, as "
        "the 2 before it");
  // The last newline alone may be missing.
  CHECK(read_trace_text(whole, "t.jsonl").ok());
  // Half a header is no trace.
  CHECK_FALSE(read_trace_text(header.substr(0, 30), "t.jsonl"));
}

TEST_CASE("unknown kinds and fields are kept") {
  const std::string text = header + "\n" + R"({"t":1.0,"kind":"speach","text":"a"})" + "\n" +
                           R"({"t":2.0,"kind":"end","why":{"x":[1]}})" + "\n";
  const auto trace = sound(text);
  REQUIRE(trace.notes.size() == 1);
  CHECK(trace.notes[0].sentence == "unknown kind 'speach' (did you mean 'speech'?): kept and passed over");
  CHECK(std::holds_alternative<UnknownKind>(trace.events[0].what));
  CHECK(write_event(trace.events[0]) == R"({"t":1.0,"kind":"speach","text":"a"})");
  CHECK(write_event(trace.events[1]) == R"({"t":2.0,"kind":"end","why":{"x":[1]}})");
}

TEST_CASE("a byte order mark and carriage returns make no difference") {
  const std::string event = R"({"t":1,"kind":"speech","text":"a"})";
  const auto plain = sound(header + "\n" + event + "\n");
  const auto odd = sound("\xEF\xBB\xBF" + header + "\r\n" + event + "\r\n");
  CHECK(write_trace(plain) == write_trace(odd));
  CHECK(odd.notes.empty());
  CHECK(plain.digest != odd.digest);
}

TEST_CASE("deep nesting is an error") {
  CHECK(error_of(std::string(100'000, '[') + "\n").find("nested deeper than 200 levels") != std::string::npos);
}

TEST_CASE("files that cannot be read are errors that say why") {
  const auto folder = std::filesystem::temp_directory_path().string();
  CHECK(read_trace(folder).error().sentence == "is a folder; expected a readable file");
  CHECK(read_trace(folder + "/continua_none.jsonl").error().sentence ==
        "there is no such file; expected a readable file");
}

TEST_CASE("a hundred thousand lines are no matter") {
  std::string text = header + "\n";
  for (int i = 0; i < 100'000; ++i)
    text +=
        R"({"t":)" + std::to_string(i) + R"(,"kind":"pointing","hand":"right","target":[0.123456,-0.234567]})" + "\n";
  CHECK(sound(text).events.size() == 100'000);
}
