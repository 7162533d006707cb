// The first line of a session's run logs.
#include <filesystem>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/learning/learning_file.h"
#include "continua/machine_file/machine_parameters.h"
#include "continua/machine_file/machine_settings.h"
#include "continua/replay/log/records.h"
#include "continua/replay/session/scene_voxemes.h"
#include "continua/replay/session/session_parts.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/session/version.h"
#include "continua/replay/trace/trace_name.h"
#include "continua/voxml/catalogue.h"

namespace continua {
namespace {

log::SceneDescription description_of(const Scene& scene, const Catalogue& voxemes) {
  const auto world = scene.description();
  log::SceneDescription told{.name = std::filesystem::path(scene.path()).stem().string(),
                             .digest = digest(scene.text()),
                             .mjcf = scene.text(),
                             .geoms = world.at("geoms"),
                             .bodies = world.at("bodies"),
                             .without_voxeme = {}};
  if (const auto without = objects_without_voxeme(scene, voxemes); !without.empty()) told.without_voxeme = without;
  return told;
}

void add_knowledge(log::Run& header, const EngineParts& parts, Shelf& shelf) {
  const Machine& machine = *parts.machine;
  const Language& language = *parts.language;
  const auto told = shelf.in_header(parts.machine);
  header.machine = {machine.name, told->digest, {machine.document}};
  if (!machine.phrases.empty())
    header.phrases.emplace(log::Document{machine.phrases, told->phrase_digest, {machine.phrase_document}});
  if (language.lexicon)
    header.lexicon.emplace(
        log::NamedFile{std::filesystem::path(machine.lexicon).filename().string(), language.lexicon->digest});
  if (const auto& voxemes = language.voxemes->digest(); !voxemes.empty())
    header.voxemes.emplace(log::VoxemeFiles{voxemes});
  header.knowledge = parts.knowledge;
  header.graph = told->graph;
  if (!machine.parameters.empty()) header.parameters = parameter_values(machine);
}

// The settings that are no parameters are told besides these; those of the trace only if the machine knows them.
void add_settings(log::Run& header, const LoadedSession& loaded, const Machine& machine) {
  Json numbers = Json::object();
  for (const auto* settings : {&loaded.trace.head().header.parameters, &loaded.options.settings})
    for (const auto& [name, value] : settings->items())
      if (name.find('.') != std::string::npos) numbers[name] = value;
  if (numbers.empty()) return;
  for (const auto& name : names_of_settings(machine)) {
    if (!numbers.contains(name)) continue;
    if (!header.parameters) header.parameters = Json::object();
    (*header.parameters)[name] = numbers[name];
  }
}

// The header of a run that these parts answer from its beginning.
log::Run header_of(const LoadedSession& loaded, const EngineParts& parts) {
  log::Run header;
  header.continua = program_version();
  header.trace.name = name_in_log(loaded.trace.head().name);
  if (!loaded.options.live && !loaded.trace.head().digest.empty())
    header.trace.digest.emplace(loaded.trace.head().digest);
  header.seed = parts.seed;
  header.choice = parts.outside ? parts.choice_told : name_of(parts.choice);
  for (const auto& [step, transition] : parts.forced)
    header.forced.emplace_back(std::to_string(step), parts.machine->transitions[transition].id);
  if (parts.choice == Choice::explore) header.most_branches.emplace(loaded.most_branches());
  header.world = loaded.options.physics ? "physics" : "kinematic";
  header.perspective = name_of(parts.perspective);
  header.fingerprint = fingerprint();
  add_knowledge(header, parts, *loaded.options.shelf);
  add_settings(header, loaded, *parts.machine);
  if (!(loaded.learned == Learned())) header.learned = Json::parse(print_learned(loaded.learned));
  header.scene = description_of(loaded.scene, *parts.language->voxemes);
  if (loaded.options.variant != Variant::free) header.variant = name_of(loaded.options.variant);
  return header;
}

}  // namespace

log::Run header_of(const LoadedSession& loaded) {
  auto header = header_of(loaded, loaded.parts);
  if (!loaded.what_if) return header;
  const auto& what_if = *loaded.what_if;
  Json changed{{"from", what_if.from.seconds()}};
  if (what_if.trace) changed["trace"] = {{"name", what_if.trace->first}, {"digest", what_if.trace->second}};
  const Json before = log::members_of(header), then = log::members_of(header_of(loaded, what_if.parts));
  for (const auto& [key, value] : then.items())
    if (key != "scene" && value != before.value(key, Json())) changed[key] = value;
  header.what_if = std::move(changed);
  return header;
}

}  // namespace continua
