#include "continua/replay/inspector/page_file.h"

#include <filesystem>
#include <sstream>

#include "continua/replay/inspector/page_parts.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_log_file.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

std::string page_of(const std::string& path) {
  std::ostringstream out;
  const auto problem = write_page(path, out);
  INFO((problem ? problem->text() : ""));
  REQUIRE(!problem);
  return out.str();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a run and the page become one file that names nothing elsewhere") {
  const ScratchFolder folder;
  const auto page = page_of(folder.write("small.run.jsonl", small_log().text()));
  std::size_t modules = 0;
  for (const auto& asset : web_assets()) modules += is_page_module(asset);
  CHECK(count(page, "<script type=\"text/plain\" data-module=") == modules);
  CHECK(count(page, "</script>") == modules + 2);
  CHECK(count(page, "<script") == modules + 2);
  CHECK_THAT(page, Contains("default-src 'none'; script-src 'sha256-"));
  CHECK_THAT(page, !Contains(" src=\"") && !Contains("<link rel=\"stylesheet\""));
  CHECK(page == page_of(folder.path() + "/small.run.jsonl"));
}

TEST_CASE("the page of a run whose documents are kept beside it is that of the whole run") {
  const ScratchFolder folder;
  const auto whole = read_run_log(source_dir() + "/traces/paper/correction.run.jsonl").value();
  const auto path = folder.write("a.run.jsonl", whole);
  const auto written = std::filesystem::last_write_time(path);
  const auto page = page_of(path);
  REQUIRE(!rewrite_run_log(path, path, folder.path() + "/documents"));
  std::filesystem::last_write_time(path, written);
  CHECK(std::filesystem::file_size(path) * 2 < whole.size());
  const bool same = page_of(path) == page;
  CHECK(same);
}

TEST_CASE("a run cut short becomes a page too, as does one with names of all kinds") {
  const ScratchFolder folder;
  const auto text = small_log().text();
  page_of(folder.write("cut.run.jsonl", text.substr(0, text.size() - 40)));
  const auto page = page_of(folder.write("a<b>&\"c\".run.jsonl", text));
  CHECK_THAT(page, Contains("<title>a_b___c_ – Continua</title>"));
}

TEST_CASE("what is no run becomes no page") {
  const ScratchFolder folder;
  for (const auto& path : {folder.write("garbage.run.jsonl", "hello\n"), folder.path() + "/none.run.jsonl"}) {
    std::ostringstream out;
    CHECK(write_page(path, out));
    CHECK(out.str().empty());
  }
}
