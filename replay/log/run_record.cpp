#include "continua/replay/log/run_record.h"

namespace continua {

Json run_fields(const RunHeader& header) {
  Json scene{{"name", header.scene_name}, {"digest", header.scene_digest}, {"mjcf", header.scene_mjcf}};
  for (const auto& [key, value] : header.scene_description.items()) scene[key] = value;
  if (!header.without_voxeme.empty()) scene["without_voxeme"] = header.without_voxeme;
  Json forced = Json::object();
  for (const auto& [step, transition] : header.forced) forced[std::to_string(step)] = transition;
  Json fields{
      {"version", 1},
      {"continua", header.continua_version},
      {"trace",
       {{"name", header.trace_name}, {"digest", header.trace_digest.empty() ? Json() : Json(header.trace_digest)}}},
      {"seed", header.seed},
      {"choice", header.choice},
      {"forced", std::move(forced)},
      {"most_branches", header.most_branches ? Json(header.most_branches) : Json(nullptr)},
      {"world", header.world},
      {"perspective", header.perspective},
      {"fingerprint", header.fingerprint},
      {"machine",
       {{"name", header.machine_name}, {"digest", header.machine_digest}, {"document", header.machine_document}}},
      {"phrases", header.phrases_name.empty() ? Json(nullptr)
                                              : Json{{"name", header.phrases_name},
                                                     {"digest", header.phrases_digest},
                                                     {"document", header.phrases_document}}},
      {"lexicon", header.lexicon_name.empty() ? Json(nullptr)
                                              : Json{{"name", header.lexicon_name}, {"digest", header.lexicon_digest}}},
      {"voxemes", header.voxemes_digest.empty() ? Json(nullptr) : Json{{"digest", header.voxemes_digest}}},
      {"knowledge", header.knowledge},
      {"learned", header.learned},
      {"graph", header.graph},
      {"scene", std::move(scene)}};
  if (!header.parameters.is_null()) fields["parameters"] = header.parameters;
  if (!header.variant.empty()) fields["variant"] = header.variant;
  return fields;
}

}  // namespace continua
