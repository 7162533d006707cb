// Outputs of recognisers, in the forms that their documentation gives, as events.
#include "continua/replay/recogniser/recogniser_output.h"

#include <filesystem>

#include "continua/core/replaced_file.h"
#include "continua/replay/recogniser/recogniser_import.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

std::string told(const Result<std::vector<Json>>& events) {
  if (!events) return events.error().text();
  std::string text;
  for (const auto& event : *events) text += compact(event) + "\n";
  return text;
}

Result<std::vector<Json>> read_as(const char* format, std::string_view text, const std::string& name) {
  return read_output(*recogniser_format(format), text, {name});
}

TEST_CASE("Whisper's segments are speech with words") {
  CHECK(
      told(read_as("whisper",
                   R"({"text":" Put the cup there.","language":"en","segments":[{"id":0,"start":1.0,"end":2.5,
    "text":" Put the cup there.","words":[{"word":" Put","start":1.0,"end":1.2,"probability":0.5},
    {"word":" the","start":1.2,"end":1.3,"probability":1.0}]},{"id":1,"start":3,"end":4,"text":" [BLANK_AUDIO]"}]})",
                   "w.json")) ==
      R"({"t":1.0,"kind":"speech","text":"Put the cup there.","until":2.5,"words":[{"text":"Put","t":1.0},{"text":"the","t":1.2}],"confidence":0.75})"
      "\n");
  CHECK(
      told(read_as("whisper", R"({"transcription":[{"offsets":{"from":500,"to":1500},"text":" Stop it",
    "tokens":[{"text":"[_BEG_]","offsets":{"from":500,"to":500},"p":1},{"text":" St","offsets":{"from":500,"to":700},"p":0.5},
    {"text":"op","offsets":{"from":700,"to":900},"p":0.9},{"text":" it","offsets":{"from":900,"to":1500},"p":0.5}]}]})",
                   "w.json")) ==
      R"({"t":0.5,"kind":"speech","text":"Stop it","until":1.5,"words":[{"text":"Stop","t":0.5},{"text":"it","t":0.9}],"confidence":0.5})"
      "\n");
  CHECK(told(read_as("whisper", "\n{\"a\":1}", "w.json")) ==
        "w.json:2: expected 'segments' (whisper, verbose JSON) or 'transcription' (whisper.cpp -oj)");
}

TEST_CASE("Vosk's results are speech, and its alternatives an n-best list") {
  CHECK(
      told(read_as("vosk", R"({"partial":"put"}
{
  "result" : [{ "conf" : 0.5, "end" : 1.5, "start" : 1.0, "word" : "put" }, { "conf" : 1.0, "end" : 2.0, "start" : 1.5, "word" : "it" }],
  "text" : "put it"
}
{"text" : ""}
{"alternatives":[{"confidence":200.0,"result":[{"end":4,"start":3,"word":"yes"}],"text":" yes"},{"confidence":50.0,"text":" yet"}]})",
                   "v.json")) ==
      R"({"t":1.0,"kind":"speech","text":"put it","until":2.0,"words":[{"text":"put","t":1.0},{"text":"it","t":1.5}],"confidence":0.75})"
      "\n"
      R"({"t":3.0,"kind":"speech","text":"yes","until":4.0,"words":[{"text":"yes","t":3.0}],"alternatives":[{"text":"yes","confidence":1.0},{"text":"yet","confidence":0.25}]})"
      "\n");
  CHECK(told(read_as("vosk", "{}", "v.json")) ==
        "v.json:1: expected 'text', 'alternatives' or 'partial', as Vosk's Result() has them");
}

TEST_CASE("PocketSphinx's timed words are speech") {
  CHECK(
      told(read_as("pocketsphinx",
                   "put the cup\n<s> 0.000 0.090 1.000000\nput(2) 0.100 0.350 0.500000\nthe 0.360 0.500 1.0\n"
                   "<sil> 0.510 0.600 0.9\n[NOISE] 0.6 0.7 0.9\ncup 0.700 1.050 0.750\n</s> 1.060 1.200 1.0\n",
                   "p.txt")) ==
      R"({"t":0.1,"kind":"speech","text":"put the cup","until":1.05,"words":[{"text":"put","t":0.1},{"text":"the","t":0.36},{"text":"cup","t":0.7}],"confidence":0.75})"
      "\n");
  CHECK(told(read_as("pocketsphinx", "\nhello\n", "p.txt")) ==
        "p.txt:2: expected times, as -time yes gives them; found an event without");
}

TEST_CASE("Words without a time are no speech of a recording, but those that may change are passed over") {
  CHECK(told(read_as("vosk", "{\"partial\":\"yes\"}\n{\"text\":\"yes\"}", "v.json")) ==
        "v.json:2: expected times, as SetWords(True) gives them; found an event without");
}

TEST_CASE("MediaPipe's frames are gestures that start and stop, without flicker") {
  std::string frames;
  for (int ms = 0; ms <= 1000; ms += 50) {
    const bool flicker = ms == 400;
    const auto* name = ms < 200 || ms > 800 ? "None" : flicker ? "Victory" : "Thumb_Up";
    frames += fmt::format(R"({{"timestamp_ms":{},"gestures":[[{{"categoryName":"{}","score":0.8}}]],)"
                          R"("handedness":[[{{"categoryName":"Right","score":0.9}}]],)"
                          R"("worldLandmarks":[[{{"x":1,"y":1,"z":1}},{{"x":1.5,"y":1,"z":0.5}}]]}})"
                          "\n",
                          ms, name);
  }
  CHECK(
      told(read_as("mediapipe", frames, "m.jsonl")) ==
      R"({"t":0.2,"kind":"gesture","name":"thumb_up","hand":"right","phase":"start","confidence":0.8,"features":[0.0,0.0,0.0,0.5,0.0,-0.5]})"
      "\n"
      R"({"t":0.8,"kind":"gesture","name":"thumb_up","hand":"right","phase":"stop","confidence":0.8})"
      "\n");
}

TEST_CASE("EMMA's interpretations are speech or gestures") {
  CHECK(
      told(read_as("emma", R"(<?xml version="1.0"?>
<emma:emma version="1.0" xmlns:emma="http://www.w3.org/2003/04/emma">
<emma:one-of emma:medium="acoustic" emma:mode="voice" emma:start="2000" emma:end="3500">
<emma:interpretation id="i1" emma:confidence="0.75" emma:tokens="flights to Boston"/>
<emma:interpretation id="i2" emma:confidence="0.5" emma:tokens="flights to Austin"/></emma:one-of>
<emma:interpretation id="g" emma:medium="visual" emma:mode="gesture" emma:start="2500"><emma:literal>point</emma:literal></emma:interpretation>
</emma:emma>)",
                   "e.xml")) ==
      R"({"t":2.0,"kind":"speech","until":3.5,"alternatives":[{"text":"flights to Boston","confidence":0.75},{"text":"flights to Austin","confidence":0.5}]})"
      "\n"
      R"({"t":2.5,"kind":"gesture","name":"point"})"
      "\n");
  CHECK(told(read_as("emma", "<emma:emma>\n<emma:interpretation tokens='hi'/></emma:emma>", "e.xml")) ==
        "e.xml:1: expected times, by emma:start, in milliseconds; found an event without");
  CHECK(told(read_as("emma", "<a/>", "e.xml")) == "e.xml:1: expected <emma:emma>, the root of an EMMA document");
}

TEST_CASE("Messages of ROS4HRI are speech and gestures, words that may change are not final") {
  CHECK(told(read_as(
            "ros4hri",
            R"({"header":{"stamp":{"sec":10,"nanosec":500000000}},"incremental":"put","final":"","confidence":0.0}
{"header":{"stamp":{"sec":11,"nanosec":0}},"incremental":"","final":"put it","confidence":0.5}
{"header":{"stamp":{"secs":12,"nsecs":0}},"gesture":6})",
            "r.jsonl")) == R"({"t":10.5,"kind":"speech","text":"put","final":false})"
                           "\n"
                           R"({"t":11.0,"kind":"speech","text":"put it","confidence":0.5})"
                           "\n"
                           R"({"t":12.0,"kind":"gesture","name":"waving"})"
                           "\n");
}

TEST_CASE("Several recognisers make one trace, from the first event on") {
  const auto folder = std::filesystem::path(binary_dir()) / "recogniser_test";
  std::filesystem::create_directories(folder);
  const auto speech = (folder / "s.xml").string(), ros = (folder / "r.jsonl").string();
  REQUIRE_FALSE(
      replace_file(speech, R"(<emma><interpretation mode="voice" start="1700000001000" tokens="hi"/></emma>)"));
  REQUIRE_FALSE(replace_file(ros, R"({"header":{"stamp":{"sec":1700000000,"nanosec":0}},"gesture":6})"));
  const auto trace = trace_of_recognisers({speech, ros}, {"emma", "ros4hri"});
  REQUIRE(trace);
  CHECK(write_event(trace->events.at(0)) == R"({"t":0.0,"kind":"gesture","name":"waving"})");
  CHECK(write_event(trace->events.at(1)) == R"({"t":1.0,"kind":"speech","text":"hi"})");
  CHECK(trace_of_recognisers({speech, ros, ros}, {"emma", "ros4hri"}).error().text() ==
        "--from: found 2 formats for 3 files; expected one, or one for each");
}

}  // namespace
}  // namespace continua
