#include "continua/replay/check/file_kinds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <filesystem>

#include "continua/core/located_json.h"
#include "continua/facts/world_facts.h"
#include "continua/knowledge_files/based_machine.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/language_loading.h"
#include "continua/machine_file/jflap.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/machine_file/phrase_file.h"
#include "continua/replay/annotation/tier_map.h"
#include "continua/replay/inspector/run_notes.h"
#include "continua/replay/log/kept_documents.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_integrity.h"
#include "continua/replay/media/media_file.h"
#include "continua/replay/media/media_peaks.h"
#include "continua/replay/noise/noise.h"
#include "continua/replay/recogniser/hand_forms.h"
#include "continua/replay/session/live_setup.h"
#include "continua/replay/session/scene_voxemes.h"
#include "continua/replay/trace/session_import.h"
#include "continua/replay/trace/trace_file.h"
#include "continua/simulation/arm_check.h"
#include "continua/simulation/physics.h"
#include "continua/simulation/scene.h"
#include "continua/simulation/world_pace.h"
#include "continua/term/raising_file.h"
#include "continua/voxml/catalogue.h"

namespace continua {
namespace {

constexpr std::string_view notes_ending = ".notes.json";

// The first line that is not blank, as JSON; null if it is no JSON.
Json first_line(std::string_view text) {
  text = without_byte_order_mark(text);
  const auto from = text.find_first_not_of(" \t\r\n");
  if (from == std::string_view::npos) return {};
  const auto json = LocatedJson::parse(text.substr(from, text.find('\n', from) - from), "");
  return json && json->root().is_object() ? json->root() : Json();
}

bool begins_with_kind(std::string_view text, const char* kind) {
  const Json json = first_line(text);
  const auto found = json.find("kind");
  return found != json.end() && *found == kind;
}

FileCheck check_trace(std::string_view text, const std::string& path) {
  const auto reading = read_whole_trace(text, path);
  FileCheck check{reading.problems, {}, "trace, " + counted(reading.trace.events.size(), "event")};
  for (const auto& note : reading.trace.notes) check.notes.push_back(sentence_of(reading.trace, note));
  const auto folder = std::filesystem::path(path).parent_path().string();
  // Corpora are passed on without their films: a recording that is missing is no fault of the trace.
  for (const auto& one : media_in(reading.trace.header.json))
    if (const auto found = find_media(one.file, folder, folder); !found)
      check.notes.push_back(fmt::format("{}: the recording {} {}", path, in_quotes(one.file), found.error().sentence));
  return check;
}

FileCheck check_run(std::string_view, const std::string& path) {
  const auto text = read_run_log(path);
  if (!text) return {{text.error()}, {}, ""};
  auto problems = integrity_problems(*text, path);
  const auto run = RunIndex::open(path);
  if (!run) problems.push_back(run.error());
  if (!problems.empty()) return {std::move(problems), {}, ""};
  FileCheck check{{}, {}, "run log, " + counted(run->size(), "record")};
  if (!run->trouble().empty()) check.notes.push_back(path + ": " + run->trouble());
  return check;
}

FileCheck check_kept_document(std::string_view text, const std::string& path) {
  if (auto problem = kept_document_problem(text, path)) return {{*std::move(problem)}, {}, ""};
  return {{}, {}, "document of run logs"};
}

bool is_notes_file(std::string_view, const std::string& path) { return path.ends_with(notes_ending); }

// Notes on records of the run in the same folder, if there is one.
FileCheck check_notes(std::string_view text, const std::string& path) {
  std::error_code unknown;
  std::optional<std::size_t> records;
  for (const auto* ending : {".run.jsonl", ".run.jsonl.gz"})
    if (const auto log = path.substr(0, path.size() - notes_ending.size()) + ending;
        std::filesystem::is_regular_file(log, unknown))
      if (const auto run = RunIndex::open(log)) records = run->size();
  FileCheck check{notes_problems(text, path, records), {}, ""};
  if (!check.problems.empty()) return check;
  const auto notes = LocatedJson::parse(text, path)->root()["notes"].size();
  check.summary = counted(notes, "note") + (records ? "" : ", on a run that is not beside it");
  return check;
}

FileCheck check_session(std::string_view text, const std::string& path) {
  const auto trace = import_session_text(text, path);
  if (!trace) return {{trace.error()}, {}, ""};
  FileCheck check{{}, {}, "session log, " + counted(trace->events.size(), "row")};
  for (const auto& note : trace->notes) check.notes.push_back(sentence_of(*trace, note));
  return check;
}

FileCheck check_machine_file(std::string_view text, const std::string& path) {
  const auto data = find_data_paths();
  const auto phrases = data ? phrases_folder(*data) : "";
  const auto rules = data ? load_raising(*data) : RaisingRules();
  const auto raising = rules ? *rules : RaisingRules();
  const auto based = data ? based_machine(std::string(text), path, *data)
                          : Result<std::optional<BasedMachine>>(std::optional<BasedMachine>());
  if (!based) return {{based.error()}, {}, "", exit_impossible};
  if (*based) text = (*based)->text;
  const auto machine = parse_machine(text, path, WorldFacts::signature(), phrases, "", raising);
  if (!machine) {
    auto problems = check_machine(text, path, WorldFacts::signature(), phrases, "", raising);
    for (auto& problem : problems)
      if (*based) problem = (*based)->told(problem, path);
    return {std::move(problems), {}, "", exit_impossible};
  }
  return {{},
          {},
          fmt::format("machine, {}, {}", counted(machine->states.size(), "state"),
                      counted(machine->transitions.size(), "transition"))};
}

bool is_lexicon_file(std::string_view, const std::string& path) {
  const auto folder = std::filesystem::absolute(path).lexically_normal().parent_path();
  return path.ends_with(".json") && folder.parent_path().filename() == "lexicon";
}

// The files of a lexicon belong together: all are read, and the problems of this one are told.
FileCheck check_lexicon_file(std::string_view, const std::string& path) {
  const auto name = std::filesystem::path(path).filename().string();
  const auto data = find_data_paths();
  const auto known = data ? (data->knowledge / "lexicon").string() : std::string();
  FileCheck check{{}, {}, "file of a lexicon"};
  for (auto& problem : check_lexicon(std::filesystem::absolute(path).parent_path().string(), names_of_terms(), known)) {
    const auto place = problem.where.find("/" + name + ":");
    if (place == std::string::npos) continue;
    problem.where = path + problem.where.substr(place + 1 + name.size());
    check.problems.push_back(std::move(problem));
  }
  return check;
}

// Whether a machine can speak by this phrase file: the machine names the file, or it names another language.
bool says_phrases(const Json& machine, const std::string& phrases, bool is_language) {
  if (!machine.is_object()) return false;
  const auto named = machine.value("phrases", Json());
  return named == phrases || (is_language && named.is_string() && machine.contains("lexicon"));
}

// Terms of phrases are terms of the machines that use them: those of the knowledge folder that the file is in.
FileCheck check_phrase_file(std::string_view text, const std::string& path) {
  namespace fs = std::filesystem;
  const auto document = LocatedJson::parse(text, path);
  if (!document) return {{document.error()}, {}, ""};
  FileCheck check{phrase_problems(*document), {}, ""};
  if (!check.problems.empty()) return check;
  const auto folder = fs::path(path).parent_path();
  std::vector<fs::path> machines;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(fs::absolute(folder).parent_path() / "machines", none))
    if (file.path().extension() == ".json") machines.push_back(file.path());
  std::sort(machines.begin(), machines.end());
  const auto name = fs::path(path).stem().string();
  const bool is_language = is_folder(fs::absolute(folder).parent_path() / "lexicon" / name);
  std::size_t users = 0;
  for (const auto& file : machines) {
    const auto machine = LocatedJson::read(file.string());
    if (!machine || !says_phrases(machine->root(), name, is_language)) continue;
    ++users;
    const auto of_machine = read_file(file.string());
    for (auto& problem :
         check_machine(*of_machine, file.string(), WorldFacts::signature(), folder.string(), is_language ? name : ""))
      if (problem.where.starts_with(fs::path(path).lexically_normal().string() + ":"))
        check.problems.push_back(std::move(problem));
  }
  check.summary = counted(document->root()["say"].size(), "phrase") + ", read with " + counted(users, "machine");
  return check;
}

bool is_gesture_file(std::string_view, const std::string& path) {
  const auto file = std::filesystem::absolute(path).lexically_normal();
  return path.ends_with(".json") && file.parent_path().filename() == "gestures";
}

// Meanings are terms of the lexicon that the file names, of the knowledge folder that the file is in.
FileCheck check_gesture_file(std::string_view text, const std::string& path) {
  const auto gestures = read_gestures(text, path);
  if (!gestures) return {check_gestures(text, path), {}, ""};
  std::shared_ptr<const Lexicon> lexicon;
  if (!gestures->lexicon.empty()) {
    DataPaths data;
    data.knowledge = std::filesystem::absolute(path).lexically_normal().parent_path().parent_path();
    auto named = load_named_lexicon(data, gestures->lexicon, path);
    if (!named) return {{named.error()}, {}, ""};
    lexicon = *std::move(named);
  }
  return {check_meanings(*gestures, lexicon),
          {},
          fmt::format("{}, {}", counted(gestures->entries.size(), "gesture"), counted(gestures->examples, "example"))};
}

FileCheck check_raising(std::string_view text, const std::string& path) {
  const auto rules = parse_raising(text, path, names_of_terms());
  if (!rules) return {{rules.error()}, {}, ""};
  return {{}, {}, counted(rules->size(), "raising rule")};
}

FileCheck check_jflap(std::string_view text, const std::string& path) {
  const auto machine = machine_of_jflap(text, path);
  if (!machine) return {{machine.error()}, {}, ""};
  return check_machine_file(compact(*machine), path);
}

FileCheck check_voxeme(std::string_view text, const std::string& path) {
  const auto read = read_voxeme(text, path);
  if (!read) return {{read.error()}, {}, ""};
  FileCheck check{{}, {}, fmt::format("voxeme, the {} {}", name_of(read->voxeme.entity), read->voxeme.predicate)};
  for (const auto& note : read->notes) check.notes.push_back(note.text());
  return check;
}

FileCheck check_scene(std::string_view, const std::string& path) {
  const auto scene = load_scene(path);
  if (!scene) return {{scene.error()}, {}, ""};
  FileCheck check;
  std::vector<std::string> names;
  for (const auto& object : scene->objects()) names.push_back(object.name);
  const Vec3 table_m = scene->table().max - scene->table().min;
  check.summary = fmt::format("scene, {}{}{}, a table of {:.2f} m x {:.2f} m", counted(names.size(), "object"),
                              names.empty() ? "" : ": ", fmt::join(names, ", "), table_m.x(), table_m.y());
  for (auto& guess : guesses_about_avatar(*scene)) check.notes.push_back(std::move(guess));
  if (const auto slow = check_pace(*scene)) {
    check.notes.push_back(slow->text() + "; only the kinematic world can be used");
  } else if (const auto physics = Physics::create(*scene)) {
    check.summary += fmt::format(", an arm of {}", counted((*physics)->arm().joints.size(), "hinge"));
    for (const auto& note : arm_notes(*scene)) check.notes.push_back(path + ": " + note);
  } else {
    check.summary += ", no arm";
    check.notes.push_back(physics.error().text() + "; only the kinematic world can be used");
  }
  if (const auto data = find_data_paths()) {
    const auto voxemes = read_catalogue((data->knowledge / "voxemes").string());
    if (const auto warning = warning_of_voxemes(*scene, voxemes.catalogue, data->knowledge.string()))
      check.notes.push_back(warning->text());
  }
  return check;
}

// Of the knowledge folder that it is in.
FileCheck check_live_file(std::string_view text, const std::string& path) {
  const auto data = find_data_paths(std::filesystem::absolute(path).lexically_normal().parent_path().string());
  if (!data) return {{data.error()}, {}, ""};
  return {check_live_setup(text, path, *data), {}, "what live sessions begin with"};
}

bool is_json_with(std::string_view text, const std::string& path, const char* key) {
  return path.ends_with(".json") && text.find(fmt::format("\"{}\"", key)) != text.npos &&
         text.find("\"transitions\"") == text.npos;
}

FileCheck check_tier_map(std::string_view text, const std::string& path) {
  return {tier_map_problems(text, path), {}, "map of tiers"};
}

FileCheck check_tier_names(std::string_view text, const std::string& path) {
  return {tier_names_problems(text, path), {}, "words in the names of tiers"};
}

// Names of tables are those of the knowledge folder that the file is in.
FileCheck check_noise(std::string_view, const std::string& path) {
  const auto file = std::filesystem::absolute(path).lexically_normal();
  const auto noise = read_noise(path, file.parent_path().parent_path());
  if (!noise) return {{noise.error()}, {}, ""};
  return {{}, {}, "noise of recognisers"};
}

FileCheck check_confusions(std::string_view, const std::string& path) {
  const auto confusions = read_confusions(path);
  if (!confusions) return {{confusions.error()}, {}, ""};
  return {{}, {}, "confusions of " + counted(confusions->rows.size(), "word")};
}

FileCheck check_peaks(std::string_view text, const std::string& path) {
  return {peaks_problems(text, path), {}, "peaks of a recording"};
}

FileCheck check_hand_forms(std::string_view text, const std::string& path) {
  return {hand_form_problems(text, path), {}, "forms of a hand"};
}

bool begins_with(std::string_view text, std::string_view beginning) {
  const auto from = text.find_first_not_of(" \t\r\n");
  return from != std::string_view::npos && text.substr(from).starts_with(beginning);
}

struct FileKind {
  bool (*recognises)(std::string_view text, const std::string& path);
  FileCheck (*check)(std::string_view text, const std::string& path);
};

// The first that recognises a file checks it.
constexpr std::array file_kinds = {
    FileKind{[](std::string_view, const std::string& path) { return is_kept_document(path); }, check_kept_document},
    FileKind{[](std::string_view text, const std::string& path) { return is_jflap(text, path); }, check_jflap},
    FileKind{[](std::string_view text, const std::string&) { return begins_with_kind(text, "trace"); }, check_trace},
    FileKind{[](std::string_view text, const std::string&) { return begins_with_kind(text, "run"); }, check_run},
    FileKind{is_notes_file, check_notes},
    FileKind{[](std::string_view, const std::string& path) { return path.ends_with(peaks_ending); }, check_peaks},
    FileKind{is_lexicon_file, check_lexicon_file},
    FileKind{is_gesture_file, check_gesture_file},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "tier_names"); }, check_tier_names},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "phrases"); }, check_phrase_file},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "buttons"); }, check_live_file},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "raising"); }, check_raising},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "tiers"); }, check_tier_map},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "noise"); }, check_noise},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "hand_forms"); }, check_hand_forms},
    FileKind{[](auto text, const auto& path) { return is_json_with(text, path, "confusions"); }, check_confusions},
    FileKind{[](std::string_view text, const std::string& path) {
               return path.ends_with(".json") || (begins_with(text, "{") && text.find("\"machine\"") != text.npos &&
                                                  text.find("\"transitions\"") != text.npos);
             },
             check_machine_file},
    FileKind{[](std::string_view text, const std::string&) { return looks_like_voxeme(text); }, check_voxeme},
    FileKind{[](std::string_view text, const std::string&) { return begins_with(text, "<"); }, check_scene},
    FileKind{[](std::string_view text, const std::string&) { return looks_like_session(text); }, check_session},
};

}  // namespace

FileCheck check_file(std::string_view text, const std::string& path) {
  for (const auto& kind : file_kinds)
    if (kind.recognises(text, path)) return kind.check(text, path);
  // Most of the project's files are traces or logs: their reader's sentence is the best answer.
  auto check = check_trace(text, path);
  check.problems.resize(1);
  check.problems.front().sentence = "none of the project's files: " + check.problems.front().sentence;
  return check;
}

}  // namespace continua
