#include "continua/replay/commands/export_annotations.h"

#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

namespace continua {

TEST_CASE("Annotations link the trace's recordings from the folder that they are written to") {
  const ScratchFolder folder;
  const auto path = folder.write(
      "traces/a.trace.jsonl", R"({"kind":"trace","version":1,"scene":"s","machine":"m","media":[{"file":"film.webm",)"
                              R"("offset":1.5},{"file":"../b.wav"},{"file":"/c.mp4"}]})"
                              "\n");
  const auto linked = [&](const std::string& output) {
    const auto annotations = annotations_of_file(path, {"d.wav"}, output);
    REQUIRE(annotations);
    std::vector<std::string> files;
    for (const auto& one : annotations->media) files.push_back(one.file);
    return files;
  };
  using Files = std::vector<std::string>;
  CHECK(linked("-") == Files{"film.webm", "../b.wav", "/c.mp4", "d.wav"});
  CHECK(linked(folder.path() + "/traces/a.eaf") == Files{"film.webm", "../b.wav", "/c.mp4", "d.wav"});
  CHECK(linked(folder.path() + "/elan/a.eaf") == Files{"../traces/film.webm", "../b.wav", "/c.mp4", "d.wav"});
}

}  // namespace continua
