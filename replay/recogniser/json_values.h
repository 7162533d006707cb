// Values in the JSON that recognisers write: whole documents, one after the other, on one line or many.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// A value and the line on which it begins.
struct LocatedValue {
  Json json;
  std::size_t line = 1;
};

/// The objects of a text, one after the other; of a list, its objects. Error: something else is there, with its line.
Result<std::vector<LocatedValue>> objects_in(std::string_view text, const std::string& name);

/// A number of an object, if it is there.
std::optional<double> number_of(const Json& object, const char* member);

/// The words of a recogniser without blanks around them.
std::string trimmed_words(std::string_view text);

/// "file:line: found …; expected WHAT" for an object that lacks something.
Error lacks(const std::string& name, std::size_t line, const std::string& expected);

}  // namespace continua
