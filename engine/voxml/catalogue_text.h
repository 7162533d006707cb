// The text of an XML document in UTF-8, from any encoding that is read.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

/// Without byte order mark. The error, at "path:line", is the first byte that the document's encoding does not have;
/// one that is not known is taken for UTF-8.
Result<std::string> utf8_of_xml(std::string_view text, const std::string& path);

}  // namespace continua
