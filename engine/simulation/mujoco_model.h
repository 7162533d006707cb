// Owners of MuJoCo's structures, and its compiler for texts in memory. MuJoCo neither ends the program nor writes its
// log file: errors while compiling come back as values, an error while stepping is a broken invariant of ours.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>

#include <mujoco/mujoco.h>

namespace continua {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelOwner = std::unique_ptr<mjModel, DeleteModel>;
using DataOwner = std::unique_ptr<mjData, DeleteData>;

/// MuJoCo's message about a text that does not compile.
struct CompileError {
  int line = 0;  ///< of the text, from 1; 0 when MuJoCo named none
  std::string sentence;
};

/// Compiles MJCF. Meshes and textures are sought from `asset_directory`.
std::variant<ModelOwner, CompileError> compile_mjcf(const std::string& text, const std::string& asset_directory);

/// Runs `work`, which calls MuJoCo. Returns the sentence of the fatal error that ended `work`, or nothing. MuJoCo jumps
/// out of `work`, so no object in `work` may need its destructor.
std::string fatal_error_of(const std::function<void()>& work);

/// The element's id, or -1.
inline int id_of(const mjModel& model, mjtObj type, const std::string& name) {
  return mj_name2id(&model, type, name.c_str());
}

/// The element's name; without one "#id", which is unique too.
std::string name_of(const mjModel& model, mjtObj type, int id);

}  // namespace continua
