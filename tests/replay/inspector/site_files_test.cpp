#include "continua/replay/inspector/site_files.h"

#include <filesystem>
#include <map>

#include "continua/replay/log/log_file.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const std::string source = source_dir();

// The folder's files by their paths below it.
std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = read_file(entry.path().string()).value();
  return files;
}

std::string error_of(const SiteRequest& request, const ScratchFolder& folder) {
  const auto written = write_site(request, folder.path() + "/site");
  return written ? "written" : written.error().sentence;
}

}  // namespace

TEST_CASE("runs become a site: page and documents once, a file for each run and each comparison") {
  const ScratchFolder folder;
  const auto whole = read_run_log(source + "/traces/paper/correction.run.jsonl").value();
  for (const char* name : {"a", "b", "c"}) folder.write(std::string(name) + ".run.jsonl", whole);
  folder.write("other.run.jsonl", small_log().text());
  const SiteRequest request{{folder.path()}};
  const auto counts = write_site(request, folder.path() + "/site");
  REQUIRE(counts);
  CHECK(counts->runs == 4);
  CHECK(counts->comparisons == 2);
  const auto files = files_of(folder.path() + "/site");
  for (const char* name : {"index.html", "assets/modules.js", "assets/start.js", "assets/style.css", "assets/icon.svg",
                           "runs.js", "words.js", "schema.js", "runs/a.js", "runs/b.js", "runs/c.js", "runs/other.js",
                           "diffs/a/b.js", "diffs/b/c.js"})
    CHECK(files.count(name) == 1);
  std::size_t documents = 0;
  for (const auto& [name, text] : files) documents += name.starts_with("documents/");
  CHECK(documents >= 5);
  CHECK(documents < 15);
  CHECK(files.at("runs/a.js").size() * 4 < whole.size());
  CHECK(files.at("runs/a.js").starts_with("continua_arrived(\"runs/a\", \"H4sI"));

  REQUIRE(write_site(request, folder.path() + "/again"));
  CHECK((files_of(folder.path() + "/again") == files));
}

TEST_CASE("a site compares the pairs that are given, by path or name") {
  const ScratchFolder folder;
  const auto log = small_log().text();
  const auto a = folder.write("a.run.jsonl", log);
  folder.write("b.run.jsonl", log);
  folder.write("c.run.jsonl", log);
  const auto counts = write_site({{folder.path()}, {{a, "c"}}}, folder.path() + "/site");
  REQUIRE(counts);
  CHECK(counts->comparisons == 1);
  CHECK(fs::exists(folder.path() + "/site/diffs/a/c.js"));
  CHECK_THAT(error_of({{folder.path()}, {{"a", "d"}}}, folder), Contains("is none of the runs of the site"));
}

TEST_CASE("runs that cannot stand in a site are named") {
  const ScratchFolder folder;
  CHECK_THAT(error_of({{folder.path()}}, folder), Contains("has no run logs"));
  folder.write("run.run.jsonl", small_log().text());
  folder.write("RUN.run.jsonl", small_log().text());
  CHECK_THAT(error_of({{folder.path()}}, folder), Contains("only in case"));
  const ScratchFolder other;
  other.write("garbage.run.jsonl", "hello\n");
  CHECK_THAT(error_of({{other.path()}}, other), Contains("not a run log"));
}
