// The first line of a session's run logs.
#include <filesystem>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/learning/learning_file.h"
#include "continua/machine_file/machine_parameters.h"
#include "continua/replay/log/run_record.h"
#include "continua/replay/recorder/recorder.h"
#include "continua/replay/session/scene_voxemes.h"
#include "continua/replay/session/session_parts.h"
#include "continua/replay/session/version.h"
#include "continua/voxml/catalogue.h"

namespace continua {
namespace {

// The header of a run that these parts answer from its beginning.
Json fields_of(const LoadedSession& loaded, const EngineParts& parts) {
  const Machine& machine = *parts.machine;
  const Language& language = *parts.language;
  RunHeader header;
  header.continua_version = program_version();
  header.trace_name = std::filesystem::path(loaded.trace.name).filename().string();
  if (!loaded.options.live) header.trace_digest = loaded.trace.digest;
  header.seed = parts.seed;
  header.choice = text(parts.choice);
  for (const auto& [step, transition] : parts.forced) header.forced[step] = machine.transitions[transition].id;
  if (parts.choice == Choice::explore) header.most_branches = loaded.most_branches();
  header.world = loaded.options.physics ? "physics" : "kinematic";
  header.perspective = text(parts.perspective);
  if (loaded.options.variant != Variant::free) header.variant = text(loaded.options.variant);
  if (!machine.parameters.empty()) header.parameters = parameter_values(machine);
  header.fingerprint = fingerprint();
  header.machine_name = machine.name;
  header.machine_digest = digest(machine.document);
  header.machine_document = Json::parse(machine.document);
  if (!machine.phrases.empty()) {
    header.phrases_name = machine.phrases;
    header.phrases_digest = digest(machine.phrase_document);
    header.phrases_document = Json::parse(machine.phrase_document);
  }
  if (!(loaded.learned == Learned())) header.learned = Json::parse(print_learned(loaded.learned));
  header.graph = graph_of(machine);
  if (language.lexicon) {
    header.lexicon_name = machine.lexicon;
    header.lexicon_digest = language.lexicon->digest;
  }
  header.knowledge = parts.knowledge;
  header.voxemes_digest = language.voxemes->digest();
  header.scene_name = std::filesystem::path(loaded.scene.path()).stem().string();
  header.scene_digest = digest(loaded.scene.text());
  header.scene_mjcf = loaded.scene.text();
  header.scene_description = loaded.scene.description();
  header.without_voxeme = objects_without_voxeme(loaded.scene, *language.voxemes);
  return run_fields(header);
}

}  // namespace

Json header_of(const LoadedSession& loaded) {
  Json fields = fields_of(loaded, loaded.parts);
  if (!loaded.what_if) return fields;
  const auto& what_if = *loaded.what_if;
  Json changed{{"from", what_if.from.seconds()}};
  if (what_if.trace) changed["trace"] = {{"name", what_if.trace->first}, {"digest", what_if.trace->second}};
  const Json then = fields_of(loaded, what_if.parts);
  for (const auto& [key, value] : then.items())
    if (key != "scene" && value != fields[key]) changed[key] = value;
  fields["what_if"] = std::move(changed);
  return fields;
}

}  // namespace continua
