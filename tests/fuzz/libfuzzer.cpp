// The targets for libFuzzer: CONTINUA_FUZZ names the one that is attacked (fuzz.sh).
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const auto* target = [] {
    const char* name = std::getenv("CONTINUA_FUZZ");
    const auto* found = continua::fuzz_target(name ? name : "");
    if (!found)
      std::fprintf(stderr, "CONTINUA_FUZZ: expected the name of a target in tests/fuzz/targets.cpp\n"), std::exit(2);
    return found;
  }();
  target->read({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
