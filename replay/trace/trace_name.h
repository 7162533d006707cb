// The names of the files that come of a trace.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace continua {

inline constexpr std::string_view trace_ending = ".trace.jsonl";

/// "x.trace.jsonl" and "x.jsonl" are called "x"; without their folder.
inline std::string trace_name(const std::string& trace) {
  auto name = std::filesystem::path(trace).filename().string();
  for (const std::string ending : {".trace.jsonl", ".jsonl"})
    if (name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
      break;
    }
  return name;
}

}  // namespace continua
