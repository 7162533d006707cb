// Annotations of other people's corpora.
#include "continua/replay/annotation/eaf.h"
#include "continua/replay/annotation/textgrid.h"
#include "continua/replay/annotation/tier_import.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

std::string eaf(const std::string& slots, const std::string& tiers) {
  return "<ANNOTATION_DOCUMENT><HEADER TIME_UNITS=\"milliseconds\">\n"
         "<MEDIA_DESCRIPTOR MEDIA_URL=\"file:///a/b%20c.mp4\" MIME_TYPE=\"video/mp4\" TIME_ORIGIN=\"500\"/></HEADER>\n"
         "<TIME_ORDER>" +
         slots + "</TIME_ORDER>\n" + tiers + "</ANNOTATION_DOCUMENT>\n";
}

std::string aligned(const std::string& id, const std::string& from, const std::string& to, const std::string& value) {
  return "<ANNOTATION><ALIGNABLE_ANNOTATION ANNOTATION_ID=\"" + id + "\" TIME_SLOT_REF1=\"" + from +
         "\" TIME_SLOT_REF2=\"" + to + "\"><ANNOTATION_VALUE>" + value +
         "</ANNOTATION_VALUE></ALIGNABLE_ANNOTATION></ANNOTATION>\n";
}

const std::string three_slots = R"(<TIME_SLOT TIME_SLOT_ID="a" TIME_VALUE="1000"/><TIME_SLOT TIME_SLOT_ID="b"/>)"
                                R"(<TIME_SLOT TIME_SLOT_ID="c" TIME_VALUE="2000"/>)";

std::vector<std::string> events_of(const Result<Annotations>& annotations, const std::string& map) {
  if (!annotations) FAIL(annotations.error().text());
  const auto parsed = parse_tier_map(map, "map.json");
  if (!parsed) FAIL(parsed.error().text());
  const auto trace = trace_of_annotations(*annotations, *parsed);
  if (!trace) FAIL(trace.error().text());
  std::vector<std::string> events;
  for (const auto& event : trace->events) {
    Json json = Json::parse(write_event(event));
    json.erase("row");
    events.push_back(compact(json));
  }
  return events;
}

TEST_CASE("Slots without a time and annotations that refer to others get their times") {
  const auto text =
      eaf(three_slots, "<TIER TIER_ID=\"P1\">" + aligned("1", "a", "b", "put it") + aligned("2", "b", "c", "there") +
                           R"(</TIER><TIER TIER_ID="R">
<ANNOTATION><REF_ANNOTATION ANNOTATION_ID="3" ANNOTATION_REF="2"><ANNOTATION_VALUE>nod</ANNOTATION_VALUE></REF_ANNOTATION></ANNOTATION>
<ANNOTATION><REF_ANNOTATION ANNOTATION_ID="4" ANNOTATION_REF="2" PREVIOUS_ANNOTATION="3"><ANNOTATION_VALUE>wave</ANNOTATION_VALUE></REF_ANNOTATION></ANNOTATION>
</TIER>)");
  CHECK(events_of(read_eaf(text, "x.eaf"),
                  R"({"tiers":{"P1":{"kind":"speech"},"R":{"kind":"observed","channel":"gesture"}}})") ==
        std::vector<std::string>{R"({"t":1.0,"kind":"speech","text":"put it","until":1.5})",
                                 R"({"t":1.5,"kind":"speech","text":"there","until":2.0})",
                                 R"({"t":1.5,"kind":"observed","channel":"gesture","content":"nod"})",
                                 R"({"t":1.75,"kind":"observed","channel":"gesture","content":"wave"})"});
}

TEST_CASE("A trace of a corpus names the file, its media and the map's header") {
  const auto annotations =
      read_eaf(eaf(three_slots, "<TIER TIER_ID=\"P1\">" + aligned("1", "a", "c", "hi") + "</TIER>"), "talks/x.eaf");
  REQUIRE(annotations);
  const auto map =
      parse_tier_map(R"({"header":{"scene":"blocks","machine":"m"},"tiers":{"P1":{"kind":"speech"}}})", "m");
  const auto trace = trace_of_annotations(*annotations, *map);
  REQUIRE(trace);
  CHECK(write_header(trace->header) ==
        R"({"kind":"trace","version":1,"scene":"blocks","machine":"m","seed":0,"perspective":"human","source":"x.eaf",)"
        R"("media":[{"file":"/a/b c.mp4","offset":0.5}]})");
}

TEST_CASE("Labels of gestures are read by the map") {
  const auto label = [](const std::string& written, const std::string& use) {
    const auto text = eaf(three_slots, "<TIER TIER_ID=\"G\">" + aligned("1", "a", "c", written) + "</TIER>");
    std::string all;
    for (const auto& event : events_of(read_eaf(text, "x.eaf"), "{\"tiers\":{\"G\":" + use + "}}")) all += event + "\n";
    return all;
  };
  CHECK(label("Left hand push front", R"({"kind":"gesture"})") ==
        "{\"t\":1.0,\"kind\":\"gesture\",\"name\":\"hand_push\",\"hand\":\"left\",\"direction\":\"front\",\"until\":2."
        "0}\n");
  CHECK(label("left", R"({"kind":"gesture"})") == "{\"t\":1.0,\"kind\":\"gesture\",\"name\":\"left\",\"until\":2.0}\n");
  CHECK(label("Zeigen", R"({"kind":"gesture","values":{"Zeigen":"point 0,0.1"},"set":{"hand":"right"}})") ==
        "{\"t\":1.0,\"kind\":\"gesture\",\"name\":\"point\",\"hand\":\"right\",\"target\":[0.0,0.1],\"until\":2.0}\n");
  CHECK(label("push left", R"({"kind":"gesture","value":"direction name","phases":true})") ==
        "{\"t\":1.0,\"kind\":\"gesture\",\"name\":\"push_left\",\"phase\":\"start\"}\n"
        "{\"t\":2.0,\"kind\":\"gesture\",\"name\":\"push_left\",\"phase\":\"stop\"}\n");
  CHECK(label("right 0,-0.5,0.3 0,1,-0.2", R"({"kind":"pointing"})") ==
        "{\"t\":1.0,\"kind\":\"pointing\",\"hand\":\"right\",\"ray\":{\"from\":[0.0,-0.5,0.3],\"direction\":[0.0,1.0,-"
        "0.2]},"
        "\"until\":2.0}\n");
}

TEST_CASE("What cannot be used is left out with a note") {
  const auto text = eaf(three_slots, "<TIER TIER_ID=\"P\">" + aligned("1", "a", "b", "the cup") +
                                         aligned("2", "b", "c", "0,1") + "</TIER>");
  const auto annotations = read_eaf(text, "x.eaf");
  const auto map = parse_tier_map(R"({"tiers":{"P":{"kind":"pointing"}}})", "m");
  const auto trace = trace_of_annotations(*annotations, *map);
  REQUIRE(trace);
  REQUIRE(trace->notes.size() == 1);
  CHECK(sentence_of(*trace, trace->notes[0]) ==
        "x.eaf:4: left out of 'P': found 'the cup'; expected a point x,y of the table, or a ray x,y,z dx,dy,dz");
}

TEST_CASE("Faults of ELAN's files are told with their line") {
  const auto error = [](const std::string& text) { return read_eaf(text, "x.eaf").error().text(); };
  CHECK(error("<a/>") == "x.eaf:1: found <a>; expected <ANNOTATION_DOCUMENT>, the root of ELAN's files");
  CHECK(error("<a").starts_with("x.eaf:1: not valid XML: "));
  CHECK(error(eaf(R"(<TIME_SLOT TIME_SLOT_ID="a" TIME_VALUE="1.5"/>)", "")) ==
        "x.eaf:3: found the time '1.5'; expected whole milliseconds");
  CHECK(error(eaf(three_slots, "<TIER TIER_ID=\"P\">\n" + aligned("1", "a", "z", "") + "</TIER>")) ==
        "x.eaf:5: found TIME_SLOT_REF2 'z'; expected the id of a time slot");
  CHECK(error(eaf(three_slots,
                  "<TIER TIER_ID=\"P\"><ANNOTATION><REF_ANNOTATION ANNOTATION_ID=\"r\" "
                  "ANNOTATION_REF=\"r\"/></ANNOTATION></TIER>")) ==
        "x.eaf:4: found ANNOTATION_REF 'r'; expected the id of an annotation that has a time");
}

TEST_CASE("Praat's short form, points and UTF-16 are read") {
  const std::string text =
      "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\n0\n2\n<exists>\n2\n\"IntervalTier\"\n\"P1 "
      "speech\"\n0\n2\n2\n"
      "0.5\n1\n\"say \"\"hi\"\"\"\n1\n2\n\"\"\n\"TextTier\"\n\"notes\"\n0\n2\n1\n1.5\n\"ö\"\n";
  std::string wide = "\xFF\xFE";
  for (const char c : text) {
    if (c == '\xC3') continue;
    wide += c == '\xB6' ? '\xF6' : c;
    wide += '\0';
  }
  for (const auto& file : {text, wide}) {
    CHECK(is_textgrid(file));
    CHECK(events_of(read_textgrid(file, "x.TextGrid"),
                    R"({"tiers":{"P1 speech":{"kind":"speech"},"notes":{"kind":"mark"}}})") ==
          std::vector<std::string>{R"({"t":0.5,"kind":"speech","text":"say \"hi\"","until":1.0})",
                                   R"({"t":1.5,"kind":"mark","text":"ö"})"});
  }
  CHECK(read_textgrid(text.substr(0, 120), "x.TextGrid").error().text() ==
        "x.TextGrid:16: found the end; expected a number");
}

TEST_CASE("Words make utterances, or belong to those of another tier") {
  const auto grid = [](const std::string& tiers, int count) {
    return "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n0 5 <exists> " + std::to_string(count) + " " +
           tiers;
  };
  const std::string words = R"("IntervalTier" "words" 0 5 4 0 1 "" 1 1.2 "the" 1.2 1.5 "cup" 3 3.5 "stop")";
  CHECK(
      events_of(read_textgrid(grid(words, 1), "x"), R"({"tiers":{"words":{"kind":"words"}}})") ==
      std::vector<std::string>{
          R"({"t":1.0,"kind":"speech","text":"the cup","until":1.5,"words":[{"text":"the","t":1.0},{"text":"cup","t":1.2}]})",
          R"({"t":3.0,"kind":"speech","text":"stop","until":3.5,"words":[{"text":"stop","t":3.0}]})"});
  CHECK(events_of(read_textgrid(grid(words + R"( "IntervalTier" "s" 0 5 1 1 4 "The cup, stop.")", 2), "x"),
                  R"({"tiers":{"words":{"kind":"words"},"s":{"kind":"speech"}}})")
            .size() == 1);
}

TEST_CASE("A map is guessed from the names of tiers") {
  const auto names = parse_tier_names(*read_file(source_dir() + "/engine/knowledge/tier_names.json"), "names");
  REQUIRE(names);
  Annotations annotations;
  for (const auto* name : {"P1_speech", "P1_hand", "Wizard speech", "RobotGesture", "robot_actions", "Eye gaze",
                           "Trial", "phonemes", "wizard words"})
    annotations.tiers.push_back({name});
  CHECK(Json::parse(print(guessed_map(annotations, *names)))["tiers"] == Json::parse(R"({
    "P1_speech":{"kind":"speech"},"P1_hand":{"kind":"gesture"},"Wizard speech":{"kind":"observed","channel":"speech"},
    "RobotGesture":{"kind":"observed","channel":"gesture"},"robot_actions":{"kind":"observed","channel":"action"},
    "Eye gaze":{"kind":"gaze"},"Trial":{"kind":"mark"},"phonemes":null,"wizard words":null})"));
}

TEST_CASE("Faults of a map are told with their place") {
  const auto problems = tier_map_problems(
      R"({"tiers":{"a":{"kind":"speach"},"b":{"kind":"observed"},"c":{"kind":"gesture","value":"hand nam"}}})",
      "m.json");
  REQUIRE(problems.size() == 3);
  CHECK(problems[0].text().find("(did you mean 'speech'?)") != std::string::npos);
  CHECK(problems[1].text().find("expected speech, gesture or action") != std::string::npos);
  CHECK(problems[2].text().find("unknown part 'nam' (did you mean 'name'?)") != std::string::npos);
  const auto map = parse_tier_map(R"({"tiers":{"P":{"kind":"speech"}}})", "m.json");
  Annotations annotations;
  annotations.name = "x.eaf";
  annotations.tiers.push_back({"P1"});
  CHECK(trace_of_annotations(annotations, *map).error().text() ==
        "x.eaf: there is no tier 'P' (did you mean 'P1'?); expected one of the map's names");
}

}  // namespace
}  // namespace continua
