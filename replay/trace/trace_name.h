// The names of the files that come of a trace.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "continua/core/gzip_name.h"

namespace continua {

inline constexpr std::string_view trace_ending = ".trace.jsonl";

/// Whether it is called "x.trace.jsonl", or "x.trace.jsonl.gz".
inline bool is_trace_name(std::string_view path) { return without_gzip_ending(path).ends_with(trace_ending); }

/// As run logs name it: without its folder, and the same whether it is packed or not.
inline std::string name_in_log(const std::string& trace) {
  return std::filesystem::path(without_gzip_ending(trace)).filename().string();
}

/// "x.trace.jsonl" and "x.jsonl", packed or not, are called "x"; without their folder.
inline std::string trace_name(const std::string& trace) {
  auto name = name_in_log(trace);
  for (const std::string ending : {".trace.jsonl", ".jsonl"})
    if (name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
      break;
    }
  return name;
}

}  // namespace continua
