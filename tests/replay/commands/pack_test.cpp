// Folders of run logs with their documents beside them.
#include "continua/replay/commands/pack.h"

#include <filesystem>

#include "continua/core/located_json.h"
#include "continua/replay/commands/export.h"
#include "continua/replay/commands/replay.h"
#include "continua/replay/log/log_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const std::string trace = R"({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"}
{"t":1,"kind":"speech","text":"Take the knife."}
{"t":3,"kind":"end"}
)";

std::map<std::string, std::string> files_in(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& file : fs::recursive_directory_iterator(folder))
    if (file.is_regular_file())
      files[file.path().lexically_relative(folder).string()] = read_file(file.path().string()).value();
  return files;
}

// Replays of a few traces: whole logs in "whole", the same ones with their documents beside them in "lean".
struct Replayed {
  Replayed() {
    ReplayCommandOptions options;
    for (const auto* name : {"a", "b", "c"}) options.traces.push_back(folder.file(std::string(name) + ".jsonl", trace));
    options.replay.physics = false;
    options.jobs = 3;
    options.output = folder.at("lean/");
    CHECK(run_replay(options) == exit_done);
    options.output = folder.at("whole");
    options.whole = true;
    CHECK(run_replay(options) == exit_done);
  }
  TemporaryFolder folder;
  std::string lean = folder.at("lean"), whole = folder.at("whole");
};

}  // namespace

TEST_CASE("replays into a folder keep their documents once, packing and unpacking lead from one form to the other") {
  const Replayed replayed;
  const auto whole = files_in(replayed.whole), lean = files_in(replayed.lean);
  CHECK(whole.size() == 3);
  CHECK(lean.size() > 3);
  for (const auto& [name, text] : whole) {
    CHECK(lean.at(name).size() * 2 < text.size());
    CHECK(read_run_log(replayed.lean + "/" + name).value() == text);
  }
  CHECK(run_export({{replayed.lean + "/a.run.jsonl"}, "jsonl", replayed.folder.at("x.jsonl")}) == exit_done);
  CHECK(read_file(replayed.folder.at("x.jsonl")).value() == whole.at("a.run.jsonl"));

  CHECK(run_pack({{replayed.lean}, true, std::nullopt}) == exit_done);
  CHECK(files_in(replayed.lean) == whole);
  CHECK_FALSE(fs::exists(replayed.lean + "/documents"));
  CHECK(run_pack({{replayed.whole}, false, std::nullopt}) == exit_done);
  CHECK(files_in(replayed.whole) == lean);
  CHECK(run_pack({{replayed.whole + "/a.run.jsonl"}, true, std::nullopt}) == exit_done);
  CHECK(files_in(replayed.whole).size() == lean.size());
  CHECK(read_file(replayed.whole + "/a.run.jsonl").value() == whole.at("a.run.jsonl"));
}

TEST_CASE("logs packed with gzip are the same logs under other names, unpacking leads back") {
  const Replayed replayed;
  const auto whole = files_in(replayed.whole), lean = files_in(replayed.lean);
  CHECK(run_pack({{replayed.lean}, false, true}) == exit_done);
  const auto packed = files_in(replayed.lean);
  CHECK(packed.size() == lean.size());
  for (const auto& [name, text] : whole) {
    CHECK_FALSE(packed.count(name));
    CHECK(packed.at(name + ".gz").size() < lean.at(name).size());
    CHECK(read_run_log(replayed.lean + "/" + name + ".gz").value() == text);
  }
  CHECK(run_pack({{replayed.lean}, false, true}) == exit_done);
  CHECK(files_in(replayed.lean) == packed);
  CHECK(run_pack({{replayed.whole + "/a.run.jsonl"}, true, true}) == exit_done);
  CHECK(read_run_log(replayed.whole + "/a.run.jsonl.gz").value() == whole.at("a.run.jsonl"));
  CHECK(run_pack({{replayed.lean, replayed.whole}, true, false}) == exit_done);
  CHECK(files_in(replayed.lean) == whole);
  CHECK(files_in(replayed.whole) == whole);

  fs::copy_file(replayed.whole + "/a.run.jsonl", replayed.whole + "/a.run.jsonl.gz");
  CHECK(run_pack({{replayed.whole + "/a.run.jsonl"}, true, true}) == exit_impossible);
  CHECK(files_in(replayed.whole).at("a.run.jsonl") == whole.at("a.run.jsonl"));
}

TEST_CASE("a trace that is over is packed, a replay of it is the replay of the plain one") {
  const TemporaryFolder folder;
  const auto path = folder.file("a.trace.jsonl", trace);
  ReplayCommandOptions options;
  options.replay.physics = false;
  options.traces = {path};
  options.output = folder.at("plain.run.jsonl");
  CHECK(run_replay(options) == exit_done);
  CHECK(run_pack({{path}, false, std::nullopt}) == exit_impossible);
  CHECK(run_pack({{path}, false, true}) == exit_done);
  CHECK_FALSE(fs::exists(path));
  options.traces = {path + ".gz"};
  options.output = folder.at("packed.run.jsonl.gz");
  CHECK(run_replay(options) == exit_done);
  CHECK(read_run_log(options.output).value() == read_run_log(folder.at("plain.run.jsonl")).value());
  CHECK(run_pack({{path + ".gz"}, false, false}) == exit_done);
  CHECK(read_file(path).value() == trace);

  const auto open = folder.file("open.trace.jsonl", trace.substr(0, trace.find("{\"t\":3")));
  CHECK(run_pack({{open}, false, true}) == exit_impossible);
  CHECK(fs::exists(open));
}

TEST_CASE("packing leaves a log alone that may still be written, or that cannot be read") {
  const Replayed replayed;
  const auto all = files_in(replayed.whole).at("a.run.jsonl"), cut = all.substr(0, all.size() - 300);
  replayed.folder.file("whole/a.run.jsonl", cut);
  replayed.folder.file("whole/b.run.jsonl", "hello\n");
  CHECK(run_pack({{replayed.whole}, false, std::nullopt}) == exit_impossible);
  const auto after = files_in(replayed.whole);
  CHECK(after.at("a.run.jsonl") == cut);
  CHECK(after.at("b.run.jsonl") == "hello\n");
  CHECK(after.at("c.run.jsonl") == files_in(replayed.lean).at("c.run.jsonl"));
  CHECK(run_pack({{replayed.folder.at("nothing")}, false, std::nullopt}) == exit_impossible);
  fs::remove_all(replayed.lean + "/documents");
  CHECK(run_pack({{replayed.lean}, true, std::nullopt}) == exit_impossible);
}
