// A worked example in a folder of its own, in which one thing can be edited: its trace, machine, words or scene.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/session/session.h"
#include "continua/replay/session/shelf.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

namespace continua {

class EditedExample {
 public:
  explicit EditedExample(const std::filesystem::path& trace) {
    namespace fs = std::filesystem;
    std::istringstream text(*read_file(trace.string()));
    for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
    header()["machine"] = header().value("machine", std::string("interaction"));
    const auto known = fs::path(source_dir()) / "engine/knowledge";
    machine =
        Json::parse(*read_file((known / "machines" / (header()["machine"].get<std::string>() + ".json")).string()));
  }

  Json& header() { return lines.front(); }

  /// Places in `lines` of the human's events.
  std::vector<std::size_t> inputs() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < lines.size(); ++i)
      if (const auto& kind = lines[i]["kind"]; kind == "speech" || kind == "gesture" || kind == "pointing")
        found.push_back(i);
    return found;
  }

  /// The log of its run in the kinematic world.
  RunIndex run() const {
    const TemporaryFolder folder;
    folder.file("machine.json", machine.dump());
    auto trace = lines;
    trace.front()["machine"] = folder.at("machine.json");
    std::stable_sort(trace.begin() + 1, trace.end(),
                     [](const Json& a, const Json& b) { return a["t"].get<double>() < b["t"].get<double>(); });
    std::string text;
    for (const auto& line : trace) text += compact(line) + "\n";
    ReplayOptions options;
    options.physics = false;
    if (lexicon)
      options.knowledge = knowledge_with(*lexicon, folder);
    else
      options.shelf = shelf();
    auto session = Session::load(folder.file("example.trace.jsonl", text), options);
    if (!session) FAIL(session.error().text());
    std::ostringstream log;
    session->run(log);
    auto index = RunIndex::of_text(log.str(), "example.run.jsonl");
    if (!index) FAIL(index.error().text());
    return *std::move(index);
  }

  std::vector<Json> lines;  ///< of the trace
  Json machine;
  /// A file of the lexicon and its new content.
  struct LexiconFile {
    std::string name;
    Json content;
  };
  std::optional<LexiconFile> lexicon;

 private:
  // The program's own knowledge, read once. No folder gets the name of an earlier one, so neither does a machine's
  // file.
  static const std::shared_ptr<Shelf>& shelf() {
    static const auto shared = std::make_shared<Shelf>();
    return shared;
  }

  // The program's knowledge with another content of one file.
  static std::string knowledge_with(const LexiconFile& file, const TemporaryFolder& folder) {
    namespace fs = std::filesystem;
    const auto from = fs::path(source_dir()) / "engine/knowledge", to = fs::path(folder.at("knowledge"));
    fs::create_directories(to / "lexicon/english");
    for (const auto& part : fs::directory_iterator(from))
      if (part.path().filename() != "lexicon") fs::create_symlink(part.path(), to / part.path().filename());
    for (const auto& part : fs::directory_iterator(from / "lexicon/english"))
      if (part.path().filename() != file.name)
        fs::create_symlink(part.path(), to / "lexicon/english" / part.path().filename());
    folder.file("knowledge/lexicon/english/" + file.name, file.content.dump());
    return to.string();
  }
};

}  // namespace continua
