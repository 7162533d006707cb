#include "fuzz/targets.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "continua/core/located_json.h"
#include "continua/facts/world_facts.h"
#include "continua/knowledge_files/language_loading.h"
#include "continua/language/parser.h"
#include "continua/learning/learning_file.h"
#include "continua/replay/annotation/eaf.h"
#include "continua/replay/annotation/textgrid.h"
#include "continua/replay/check/check_report.h"
#include "continua/replay/check/file_kinds.h"
#include "continua/replay/live/live_events.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/mcap/mcap_import.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "continua/replay/server/http_head.h"
#include "continua/term/term_text.h"
#include "continua/term/written_term.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t longest_seed = 32768;

// As `validate` reads a file of that name.
void read_as(const char* name, std::string_view bytes) {
  static const TemporaryFolder folder;
  (void)check_file(bytes, folder.file(name, std::string(bytes)));
}

template <const char* name>
void read_file_of(std::string_view bytes) {
  read_as(name, bytes);
}

constexpr char trace[] = "x.trace.jsonl", notes[] = "x.notes.json", machine[] = "machines/x.json",
               gestures[] = "gestures/x.json", phrases[] = "phrases/x.json", raising[] = "raising.json",
               lexicon[] = "lexicon/x/x.json", xml[] = "x.xml", jflap[] = "x.jff", session[] = "x.txt";

void read_run(std::string_view bytes) {
  const auto run = RunIndex::of_text(std::string(bytes), "x.run.jsonl");
  if (!run) return;
  for (std::size_t n = 0; n < run->size(); ++n) (void)run->record(n);
  for (const auto& mark : run->stack_marks()) (void)run->snapshot(mark.top);
}

void read_request(std::string_view bytes) {
  HeadScan scan;
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 3) (void)scan.look(bytes.substr(0, size));
  (void)read_head(bytes);
}

void read_events(std::string_view bytes) {
  if (const auto events = events_in(bytes); events && !events->empty())
    for (const auto timing : {LiveTiming::wall, LiveTiming::events}) (void)timed_events(*events, timing, SimTime{}, 2);
}

void read_term(std::string_view bytes) {
  static const Signature names = names_of_terms();
  (void)parse_term(bytes, names);
  (void)read_written_term(bytes);
}

void read_sentence(std::string_view bytes) {
  static const Vocabulary words(
      std::make_shared<const Lexicon>(
          load_lexicon(source_dir() + "/engine/knowledge/lexicon/english", WorldFacts::signature()).value()),
      WorldSnapshot());
  (void)read(bytes.substr(0, 400), words);
}

void read_annotations(std::string_view bytes) {
  (void)read_eaf(bytes, "x.eaf");
  (void)read_textgrid(bytes, "x.TextGrid");
}

void read_recogniser(std::string_view bytes) {
  for (const auto& format : recogniser_formats())
    (void)read_output(format, bytes, {.name = "x", .knowledge = source_dir() + "/engine/knowledge"});
}

void read_mcap(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  (void)trace_of_mcap(in, "x.mcap", "world");
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::recursive_directory_iterator(folder, none))
    if (entry.is_regular_file() && entry.file_size() <= longest_seed && entry.path().string().ends_with(ending))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

const std::vector<FuzzTarget>& fuzz_targets() {
  static const std::vector<FuzzTarget> targets = {
      {"trace", read_file_of<trace>, "traces", ".trace.jsonl"},
      {"run", read_run, "traces", ".run.jsonl"},
      {"machine", read_file_of<machine>, "engine/knowledge/machines", ".json"},
      {"gestures", read_file_of<gestures>, "engine/knowledge/gestures", ".json"},
      {"phrases", read_file_of<phrases>, "engine/knowledge/phrases", ".json"},
      {"raising", read_file_of<raising>, "engine/knowledge", "raising.json"},
      {"lexicon", read_file_of<lexicon>, "engine/knowledge/lexicon", ".json"},
      {"voxeme", read_file_of<xml>, "engine/knowledge/voxemes", ".xml"},
      {"scene", read_file_of<xml>, "mjcf", ".xml"},
      {"jflap", read_file_of<jflap>, "tests", ".jff"},
      {"session", read_file_of<session>, "tests", ".txt"},
      {"notes", read_file_of<notes>, "tests", ".notes.json"},
      {"report", [](std::string_view bytes) { (void)read_report(bytes, "x"); }, "tests", ".report.json"},
      {"learned", [](std::string_view bytes) { (void)parse_learned(bytes, "x", names_of_terms()); }, "tests",
       ".learned.json"},
      {"request", read_request, "tests", ".http"},
      {"events", read_events, "traces/talk", ".trace.jsonl"},
      {"term", read_term, "tests", ".term"},
      {"sentence", read_sentence, "tests", ".words"},
      {"annotations", read_annotations, "examples/corpus", ".eaf"},
      {"recogniser", read_recogniser, "examples", ".json"},
      {"mcap", read_mcap, "tests", ".mcap"},
  };
  return targets;
}

const FuzzTarget* fuzz_target(std::string_view name) {
  for (const auto& target : fuzz_targets())
    if (target.name == name) return &target;
  return nullptr;
}

std::vector<std::string> fuzz_seeds(const FuzzTarget& target) {
  const fs::path source = source_dir();
  auto files = files_in(source / target.folder, target.ending);
  for (auto& row : files_in(source / "tests/corpus" / target.name, "")) files.push_back(std::move(row));
  std::vector<std::string> seeds;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

}  // namespace continua
