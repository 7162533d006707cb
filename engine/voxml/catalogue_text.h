// Converts the text of an XML document to UTF-8.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

/// The text in UTF-8, without byte order mark. An unknown encoding is taken for UTF-8. The error, at "path:line", is
/// the first byte that is invalid in the document's encoding.
Result<std::string> utf8_of_xml(std::string_view text, const std::string& path);

}  // namespace continua
