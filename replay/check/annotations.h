// Findings of a check in the form that GitHub shows at the line of the file in question.
#pragma once

#include <string>
#include <string_view>

#include "continua/replay/check/check_report.h"

namespace continua {

/// Text as a workflow command of GitHub takes it: as its message, and as the value of a property.
std::string github_message(std::string_view text);
std::string github_property(std::string_view text);

/// A place in the form of errors, "file", "file:line" or "file:line:column"; a missing number is 0.
struct FilePlace {
  std::string file;
  std::size_t line = 0, column = 0;
};
FilePlace place_of(const std::string& where);

/// A line for each problem of a case that fails, else one for its sentence; nothing if it holds.
std::string github_annotations(const CheckCase& one);

}  // namespace continua
