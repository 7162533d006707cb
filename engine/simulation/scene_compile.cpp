#include "continua/simulation/scene_compile.h"

#include <filesystem>

#include <fmt/format.h>

#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/scene.h"
#include "continua/simulation/told_avatar.h"

namespace continua {

namespace {

/// The weld between hand and held object: stiff, so that the object does not lag behind. Empty if the scene has no
/// hand, or a weld of its own.
Result<std::string> missing_weld(const mjModel& model, const std::string& path) {
  const int grip = id_of(model, mjOBJ_SITE, grip_name);
  if (grip < 0 || id_of(model, mjOBJ_EQUALITY, grip_name) >= 0) return std::string();
  const char* hand = mj_id2name(&model, mjOBJ_BODY, model.site_bodyid[grip]);
  if (!hand) return Error{path, fmt::format("the body of site '{}' has no name", grip_name)};
  return fmt::format(
      R"(<equality><weld name="{}" body1="{}" active="false" solref="0.004 1" solimp="0.998 0.9995 0.0002"/></equality>)",
      grip_name, hand);
}

}  // namespace

Result<std::shared_ptr<const mjModel>> compile(const SceneSource& source) {
  const auto directory = std::filesystem::absolute(source.path()).parent_path().string();
  auto compiled = compile_mjcf(source.text(), directory);
  if (const auto* error = std::get_if<CompileError>(&compiled))
    return Error{source.where(error->line), error->sentence};
  return std::shared_ptr<const mjModel>(std::get<ModelOwner>(std::move(compiled)));
}

Result<CompiledScene> compile_scene(const std::string& path) {
  auto source = SceneSource::read(path);
  if (!source) return source.error();
  auto model = compile(*source);
  if (!model) return model.error();
  if (const double step_s = (*model)->opt.timestep; !(step_s >= least_timestep_s && step_s <= most_timestep_s))
    return Error{source->where("option", "timestep"),
                 fmt::format("the time step is {} s; expected {} to {} s", step_s, least_timestep_s, most_timestep_s)};
  auto told = with_told_avatar(*source, **model);
  if (!told) return told.error();
  if (told->source.text() != source->text()) model = compile(told->source);
  if (!model) return model.error();
  const auto weld = missing_weld(**model, path);
  if (!weld) return weld.error();
  if (weld->empty()) return CompiledScene{told->source, *model, told->guesses};
  const auto welded = told->source.with(*weld);
  model = compile(welded);
  if (!model) return model.error();
  return CompiledScene{welded, *model, told->guesses};
}

}  // namespace continua
