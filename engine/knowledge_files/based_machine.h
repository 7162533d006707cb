// Machines that are based on others (automaton/FORMAT.md, Based on another machine): a file with changes alone.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "continua/core/result.h"
#include "continua/knowledge_files/data_paths.h"

namespace continua {

struct BasedMachine {
  std::string text;                          ///< the whole machine, a JSON text
  std::map<std::size_t, std::string> where;  ///< line of that text → place of the value in the file that it comes from

  /// An error of that text, which `path` stands for, at its place in a file.
  Error told(const Error& error, const std::string& path) const;
};

/// The machine of a file's text with all that it is based on; nothing if it is based on none. Errors: the machine that
/// it is based on is not there, is no JSON, or is based on this one in its turn.
Result<std::optional<BasedMachine>> based_machine(const std::string& text, const std::string& path,
                                                  const DataPaths& data);

}  // namespace continua
