#include "fuzz/targets.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
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
#include "fuzz/index_target.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t longest_seed = 32768;
constexpr std::size_t longest_word = 40, most_fuzz_words = 400;

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
  if (run) read_whole(*run);
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

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void count_words(std::string_view text, std::map<std::string, std::size_t, std::less<>>& times) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = std::find_if(at, text.end(), in_word);
    at = std::find_if_not(begin, text.end(), in_word);
    const std::string_view word(begin, at);
    const bool letters = !word.empty() && std::isalpha(static_cast<unsigned char>(word.front()));
    if (letters && word.size() > 1 && word.size() <= longest_word) ++times[std::string(word)];
  }
}

}  // namespace

const std::vector<FuzzTarget>& fuzz_targets() {
  static const std::vector<FuzzTarget> targets = {
      {"trace", read_file_of<trace>, "traces", ".trace.jsonl"},
      {"run", read_run, "traces", ".run.jsonl", nullptr, "replay/log/RECORDS.md"},
      {"index", read_index, "tests", ".index", index_seeds},
      {"machine", read_file_of<machine>, "engine/knowledge/machines", ".json", nullptr,
       "engine/automaton/machine.schema.json"},
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
  auto seeds = target.made ? target.made() : std::vector<std::string>();
  for (const auto& path : files) seeds.push_back(content_of(path));
  return seeds;
}

std::vector<std::string> fuzz_words(const FuzzTarget& target) {
  std::map<std::string, std::size_t, std::less<>> times;
  if (!target.schema.empty()) count_words(content_of(fs::path(source_dir()) / target.schema), times);
  for (const auto& seed : fuzz_seeds(target)) count_words(seed, times);
  std::vector<std::string> words;
  for (const auto& [word, _] : times) words.push_back(word);
  std::stable_sort(words.begin(), words.end(),
                   [&](const auto& a, const auto& b) { return times.find(a)->second > times.find(b)->second; });
  words.resize(std::min(words.size(), most_fuzz_words));
  return words;
}

}  // namespace continua
