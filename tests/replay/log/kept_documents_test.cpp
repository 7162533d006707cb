// Documents of run logs that are kept once beside them.
#include "continua/replay/log/kept_documents.h"

#include <filesystem>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/replay/diff/run_diff.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_log_file.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const Json large(std::vector<std::string>(100, "as good as any"));

Json header() {
  return {{"kind", "run"},
          {"n", 0},
          {"t", 0},
          {"version", 1},
          {"machine", {{"name", "m"}, {"digest", "0"}, {"document", {{"states", large}}}}},
          {"phrases", nullptr},
          {"knowledge", {{"file", large}}},
          {"graph", {{"states", {"few"}}}},
          {"scene", {{"name", "s"}, {"mjcf", "<mujoco>" + std::string(900, '"')}, {"geoms", large}}},
          {"what_if", {{"from", 1}, {"machine", {{"name", "other"}, {"document", {{"edges", large}}}}}}}};
}

std::string log_of(const Json& first, std::size_t bytes = 0) {
  std::string text = compact(first) + "\n";
  for (int n = 1; n < 20 || text.size() < bytes; ++n)
    text += compact({{"kind", "problem"}, {"n", n}, {"t", n}, {"text", std::string(60, 'x')}}) + "\n";
  return text;
}

// A log whose documents are kept beside it.
struct Lean {
  explicit Lean(std::string text = log_of(header())) : whole(std::move(text)) { write(path); }
  void write(const std::string& to) const {
    RunLogFile file(to, documents);
    file.stream() << whole;
    REQUIRE(!file.commit());
  }
  std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(documents)) files.push_back(file.path());
    return files;
  }
  std::string problem() const {
    const auto read = read_run_log(path);
    REQUIRE(!read.ok());
    CHECK(RunIndex::open(path).error().text() == read.error().text());
    return read.error().text();
  }

  TemporaryFolder folder;
  std::string whole, path = folder.at("a.run.jsonl"), documents = folder.at("documents");
};

Json first_of(const std::string& path) { return Json::parse(first_line(path).value()); }

}  // namespace

TEST_CASE("a log with its documents beside it is read as the whole log") {
  const Lean lean;
  CHECK(read_run_log(lean.path).value() == lean.whole);
  CHECK(fs::file_size(lean.path) * 2 < lean.whole.size());

  const auto first = first_of(lean.path);
  const auto of = [](const Json& value) { return Json{{"kept", digest(compact(value))}}; };
  CHECK(first["machine"] == Json{{"name", "m"}, {"digest", "0"}, {"document", of(header()["machine"]["document"])}});
  CHECK(first["what_if"]["machine"]["document"] == of(header()["what_if"]["machine"]["document"]));
  CHECK(first["knowledge"] == of(header()["knowledge"]));
  CHECK(first["scene"]["mjcf"] == of(header()["scene"]["mjcf"]));
  CHECK(first["scene"]["geoms"] == of(large));
  CHECK(first["graph"] == header()["graph"]);
  CHECK(lean.kept().size() == 5);
  for (const auto& file : lean.kept()) CHECK(is_kept_document(file.string()));

  SECTION("written in pieces of any length") {
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, lean.whole.find('\n') + 1}) {
      RunLogFile file(lean.path, lean.documents);
      for (std::size_t at = 0; at < lean.whole.size(); at += size) file.stream() << lean.whole.substr(at, size);
      REQUIRE(!file.commit());
      CHECK(read_run_log(lean.path).value() == lean.whole);
    }
  }
  SECTION("read in pieces of any length from anywhere") {
    const auto source = source_of_log(lean.path).value();
    std::string piece(300, ' ');
    for (std::size_t from = 0; from < lean.whole.size() + 100; from += 37) {
      const auto got = source->read(from, piece.data(), piece.size());
      const auto expected = from < lean.whole.size() ? lean.whole.substr(from, piece.size()) : "";
      REQUIRE(piece.substr(0, static_cast<std::size_t>(got)) == expected);
    }
  }
  SECTION("and made whole again") {
    REQUIRE(!rewrite_run_log(lean.path, lean.path));
    CHECK(read_file(lean.path).value() == lean.whole);
  }
}

TEST_CASE("documents are found in the nearest folder upwards, also from behind a link") {
  const Lean lean;
  fs::create_directories(lean.folder.at("deep/er/documents"));
  const auto deep = lean.folder.at("deep/er/b.run.jsonl");
  fs::copy(lean.path, deep);
  CHECK(read_run_log(deep).value() == lean.whole);
  const TemporaryFolder elsewhere;
  fs::create_symlink(deep, elsewhere.at("link.run.jsonl"));
  CHECK(read_run_log(elsewhere.at("link.run.jsonl")).value() == lean.whole);
}

TEST_CASE("a document that is missing, or is another, is an error that says which and where") {
  const Lean lean;
  const auto file = lean.documents + "/" + digest(compact(header()["knowledge"])) + ".json";
  const auto text = read_file(file).value();
  SECTION("missing") {
    fs::remove(file);
    const auto problem = lean.problem();
    CHECK_THAT(problem,
               Contains(lean.path + ":1: `knowledge` is kept in a file of its own, and there is no documents/" +
                        fs::path(file).filename().string() + " in " + fs::canonical(lean.folder.path()).string() +
                        " or in a folder above it"));
    CHECK_THAT(problem, Contains("--to jsonl"));
  }
  SECTION("another") {
    lean.folder.file(fs::relative(file, lean.folder.path()).string(), text + " ");
    CHECK_THAT(lean.problem(), Contains("is not the document that it was: its digest is " + digest(text + " ")));
    CHECK(kept_document_problem(text, file) == std::nullopt);
  }
}

TEST_CASE("a log cannot name a file to be read") {
  const Lean lean;
  const std::string outside = "../../../../../../etc/passwd/./.", upper(32, 'A'), shorter(31, 'a');
  for (const auto& name : {outside, upper, shorter, std::string()}) {
    auto first = first_of(lean.path);
    first["knowledge"]["kept"] = name;
    lean.folder.file("a.run.jsonl", log_of(first));
    CHECK_THAT(lean.problem(), Contains("`knowledge` is kept as '" + name + "'; expected a digest"));
  }
}

TEST_CASE("only what stands for a document is taken for one") {
  const Lean lean;
  const Json kept{{"kept", std::string(32, 'a')}};
  for (const auto* const place :
       {"/learned", "/machine/name", "/scene/name", "/machine/document/kept", "/knowledge/file", "/parameters/graph",
        "/graph/graph", "/what_if/what_if/graph", "/what_if/from", "/document"}) {
    auto first = header();
    first[Json::json_pointer(place)] = kept;
    const Lean other(log_of(first));
    INFO(place);
    CHECK(read_run_log(other.path).value() == other.whole);
  }
  for (const Json& value : {Json{{"kept", 7}}, Json{{"kept", std::string(32, 'a')}, {"states", 1}}, Json{"kept"}}) {
    auto first = header();
    first["graph"] = value;
    const Lean other(log_of(first));
    INFO(value);
    CHECK(read_run_log(other.path).value() == other.whole);
  }
}

TEST_CASE("a log that is cut short is read as far as the whole one would be") {
  const Lean lean;
  const auto text = read_file(lean.path).value();
  const auto head = first_line(lean.path)->size(), longer = lean.whole.find('\n') - head;
  for (std::size_t size = 0; size < text.size(); size += 23) {
    lean.folder.file("a.run.jsonl", text.substr(0, size));
    const auto run = RunIndex::open(lean.path);
    INFO(size);
    CHECK(run.ok() == (size >= head));
    if (!run) continue;
    const auto expected = RunIndex::of_text(lean.whole.substr(0, size + longer), lean.path).value();
    CHECK(run->size() == expected.size());
    CHECK(run->trouble() == expected.trouble());
    CHECK(run->bytes() == expected.bytes());
    CHECK(*run->line(0) == *expected.line(0));
  }
}

TEST_CASE("a log that goes on is read on") {
  const Lean lean;
  const auto text = read_file(lean.path).value();
  lean.folder.file("a.run.jsonl", text.substr(0, text.size() / 2));
  const auto half = RunIndex::open(lean.path).value();
  lean.folder.file("a.run.jsonl", text);
  const auto grown = RunIndex::grown(half).value();
  CHECK(grown.size() == 20);
  CHECK(&grown.header() == &half.header());  // not read again: with its documents it is the largest record
  CHECK(*grown.line(19) == *RunIndex::of_text(lean.whole, "a")->line(19));
}

TEST_CASE("the index of a long log fits it with its documents") {
  const Lean lean(log_of(header(), std::size_t{9} << 20));
  const auto fresh = RunIndex::open(lean.path).value();
  REQUIRE(fs::exists(lean.path + ".index"));
  const auto again = RunIndex::open(lean.path).value();
  CHECK(again.bytes() == lean.whole.size());
  CHECK(again.bytes() == fresh.bytes());
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, fresh.size() - 1}) {
    CHECK(again.entry(n).offset == fresh.entry(n).offset);
    CHECK(*again.line(n) == *fresh.line(n));
  }
  // An index does not stand in for a document.
  fs::remove_all(lean.documents);
  CHECK(!RunIndex::open(lean.path).ok());
}

TEST_CASE("a worked example is the same run with its documents beside it") {
  const auto path = source_dir() + "/traces/paper/correction.run.jsonl";
  const Lean lean(read_run_log(path).value());
  CHECK(fs::file_size(lean.path) * 2 < lean.whole.size());
  const auto diff = diff_runs(RunIndex::open(path).value(), RunIndex::open(lean.path).value()).value();
  CHECK(diff.sameness == RunDiff::Sameness::same);
}

TEST_CASE("documents that no log refers to are removed") {
  const Lean lean;
  auto other = header();
  other["knowledge"]["file"].push_back("one more");
  const Lean of_other(log_of(other));
  fs::create_directories(lean.folder.at("below"));
  REQUIRE(!rewrite_run_log(of_other.path, lean.folder.at("below/b.run.jsonl"), lean.documents));
  const auto kept = fs::path(lean.documents) / "notes.txt";
  lean.folder.file("documents/notes.txt", "not a document");
  CHECK(lean.kept().size() == 7);
  CHECK(remove_unused_documents(lean.documents).value() == 0);
  fs::remove(lean.folder.at("below/b.run.jsonl"));
  CHECK(remove_unused_documents(lean.documents).value() == 1);
  CHECK(read_run_log(lean.path).value() == lean.whole);
  fs::remove(lean.path);
  CHECK(remove_unused_documents(lean.documents).value() == 5);
  CHECK(lean.kept() == std::vector{kept});
}

TEST_CASE("a folder is for documents where nothing else is in it") {
  const TemporaryFolder folder;
  const auto log = folder.at("a/b/c.run.jsonl");
  fs::create_directories(folder.at("a/b"));
  folder.file("documents/thesis.odt", "");
  CHECK(documents_above(log) == std::nullopt);
  fs::create_directories(folder.at("a/documents"));
  CHECK(documents_above(log) == fs::canonical(folder.at("a/documents")).string());
  folder.file("a/documents/" + std::string(32, 'a') + ".json", "{}");
  CHECK(documents_above(log).has_value());
}
