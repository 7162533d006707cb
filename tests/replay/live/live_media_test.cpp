// Recordings of a live session: parts in order, beside the trace, and named by it in the end.
#include "continua/replay/live/live_media.h"

#include <filesystem>

#include "continua/replay/trace/trace_file.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

namespace continua {
namespace {

const std::string begin = "\x1A\x45\xDF\xA3 begin";

std::string told(LiveMedia& media, const std::string& source, std::uint64_t part, std::string_view bytes,
                 const std::string& type = "video/webm;codecs=vp8", std::uint64_t take = 0) {
  const auto problem = media.add({source, type, take, part, SimTime::from_seconds(2.5), bytes});
  return problem ? problem->sentence : "";
}

}  // namespace

TEST_CASE("Parts of a recording come in order, each once") {
  const ScratchFolder folder;
  folder.write("talk.camera.webm", "older");
  LiveMedia media(folder.path() + "/talk.trace.jsonl");
  CHECK(told(media, "camera", 0, begin).empty());
  CHECK(told(media, "camera", 1, " more").empty());
  CHECK(told(media, "camera", 1, " more").empty());
  CHECK(told(media, "camera", 3, " late") == "found part 3 of the recording; expected part 2");
  CHECK(told(media, "microphone", 0, begin, "audio/webm").empty());
  CHECK(told(media, "camera", 0, begin, "video/webm", 1).empty());
  CHECK(told(media, "camera", 0, begin, "video/webm", 1).empty());
  CHECK(read_file(folder.path() + "/talk.camera.webm").value() == "older");
  CHECK(read_file(folder.path() + "/talk.camera-2.webm").value() == begin + " more");
  const auto files = media.finish();
  REQUIRE(files.size() == 3);
  CHECK(files[0].file == "talk.camera-2.webm");
  CHECK(files[0].offset_s == -2.5);
  CHECK(files[1].file == "talk.microphone.webm");
  CHECK(files[1].kind == "audio");
  CHECK(files[2].file == "talk.camera-3.webm");
  CHECK(told(media, "camera", 1, "x") == "the session has ended");
}

TEST_CASE("Other sources, other types and other bytes are refused and leave no file") {
  const ScratchFolder folder;
  LiveMedia media(folder.path() + "/talk.trace.jsonl");
  CHECK(told(media, "../camera", 0, begin) == "found the source '../camera'; expected camera or microphone");
  CHECK_FALSE(told(media, "camera", 0, begin, "text/html").empty());
  CHECK_FALSE(told(media, "camera", 0, "<html>").empty());
  CHECK_FALSE(told(media, "camera", 1, begin).empty());
  CHECK(std::filesystem::is_empty(folder.path()));
  CHECK(media.finish().empty());
}

TEST_CASE("The header of the trace names the recordings, and nothing else of it changes") {
  const ScratchFolder folder;
  const std::string header = R"({"kind":"trace","version":1,"scene":"s","machine":"m","seed":0,"mine":7)";
  const std::string rest = "\n{\"t\":1.0,\"kind\":\"speech\",\"text\":\"Hi\"}\n{\"t\":2.0,\"kind\":\"end\"}\n";
  const auto path = folder.write("talk.trace.jsonl", header + "}" + rest);
  CHECK_FALSE(name_media(path, {{"talk.camera.webm", "video", "camera", -1.25}}));
  CHECK(read_file(path).value() ==
        header + R"(,"media":[{"file":"talk.camera.webm","kind":"video","label":"camera","offset":-1.25}]})" + rest);
  CHECK(read_trace(path).ok());
}

}  // namespace continua
