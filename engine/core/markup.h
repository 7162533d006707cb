// Text within HTML, SVG and XML.
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// `text` as HTML, SVG and XML show it, between tags and as the value of an attribute. Control characters but line ends
/// become their pictures (U+2400 and on); bytes that are not UTF-8, and characters that XML cannot have, U+FFFD.
std::string in_markup(std::string_view text);

}  // namespace continua
