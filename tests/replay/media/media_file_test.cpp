// Recordings that a trace names: where they are found, and that nothing else is.
#include "continua/replay/media/media_file.h"

#include <filesystem>

#include "continua/replay/check/file_kinds.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

std::string found(const std::string& file, const std::string& folder, const std::string& within) {
  const auto path = find_media(file, folder, within);
  return path ? fs::path(*path).filename().string() : path.error().sentence;
}

}  // namespace

TEST_CASE("The header's recordings have a kind, their own or that of their name") {
  const auto media = media_in(Json::parse(R"({"media":[{"file":"a.webm"},{"file":"b.WAV","offset":-1.5,"label":"table"},
      {"file":"c.webm","kind":"audio"},{"file":"d.txt"},{"label":"no file"},7]})"));
  REQUIRE(media.size() == 4);
  CHECK(media[0].kind == "video");
  CHECK(media[1].kind == "audio");
  CHECK(media[1].offset_s == -1.5);
  CHECK(media[1].label == "table");
  CHECK(media[2].kind == "audio");
  CHECK(media[3].kind.empty());
  CHECK(media_in(Json::parse(R"({"media":"a.webm"})")).empty());
}

TEST_CASE("A recording is found beside the trace, and never outside of the folder") {
  ScratchFolder scratch;
  const fs::path root = scratch.path();
  fs::create_directories(root / "served/talks");
  for (const auto* name : {"secret.mp4", "served/all.mp4", "served/talks/own.mp4", "served/talks/notes.txt"})
    scratch.write(name, "x");
  fs::create_symlink("../../secret.mp4", root / "served/talks/link.mp4");
  fs::create_symlink("notes.txt", root / "served/talks/words.mp4");
  fs::create_symlink("../..", root / "served/talks/up");
  const auto served = (root / "served").string(), talks = (root / "served/talks").string();

  CHECK(found("own.mp4", talks, talks) == "own.mp4");
  CHECK(found("./x/../own.mp4", talks, talks) == "own.mp4");
  CHECK(found("../all.mp4", talks, served) == "all.mp4");
  const std::string outside = "lies outside of the folder of the trace";
  for (const auto* file : {"../all.mp4", "../../secret.mp4", "/etc/passwd.mp4", "up/secret.mp4", "link.mp4",
                           "../talks/../../secret.mp4", "../talks2/own.mp4"})
    CHECK(found(file, talks, talks) == outside);
  CHECK(found("../../secret.mp4", talks, served) == outside);
  CHECK(found((root / "secret.mp4").string(), talks, served) == outside);
  CHECK(found("none.mp4", talks, talks) == "is not there");
  CHECK(found("words.mp4", talks, talks) == "is a link to something that is no recording");
  for (const auto* file : {"notes.txt", "", ".", "..", "up"})
    CHECK_THAT(found(file, talks, talks), Contains("is not named as a recording is"));
  CHECK_THAT(found(std::string("notes.txt\0.mp4", 14), talks, talks), Contains("is not named as a recording is"));
}

TEST_CASE("A recording that is missing is told, and no fault of the trace") {
  ScratchFolder scratch;
  scratch.write("there.wav", "x");
  const std::string text =
      R"({"kind":"trace","version":1,"scene":"staircase","machine":"diana2018","media":[{"file":"there.wav"},{"file":"gone.webm"},{"file":"../out.webm"}]})"
      "\n";
  const auto path = scratch.write("talk.trace.jsonl", text);
  const auto check = check_file(text, path);
  CHECK(check.problems.empty());
  REQUIRE(check.notes.size() == 2);
  CHECK(check.notes[0] == path + ": the recording 'gone.webm' is not there");
  CHECK_THAT(check.notes[1], Contains("'../out.webm' lies outside of the folder of the trace"));
}

}  // namespace continua
