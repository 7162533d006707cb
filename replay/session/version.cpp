#include "continua/replay/session/version.h"

#include <fmt/format.h>

#include "continua/simulation/mujoco_version.h"

namespace continua {
namespace {

// The widest vector instructions that libraries may choose here: with others, sums are rounded otherwise.
const char* instructions() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return "avx512f";
  if (__builtin_cpu_supports("avx2")) return "avx2";
  if (__builtin_cpu_supports("avx")) return "avx";
  return "sse2";
#else
  return "baseline";
#endif
}

}  // namespace

std::string version_text() {
  return fmt::format("continua {}\nMuJoCo {}\n{}", CONTINUA_VERSION, mujoco_version(), CONTINUA_COMPILER);
}

std::string program_version() { return CONTINUA_VERSION; }

log::Fingerprint fingerprint() {
  return {.mujoco = mujoco_version(),
          .compiler = CONTINUA_COMPILER,
          .arch = CONTINUA_ARCHITECTURE,
          .instructions = instructions()};
}

}  // namespace continua
