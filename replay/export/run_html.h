// Pages that stand by themselves: no script, nothing loaded from elsewhere, light and dark, fit for a phone.
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// Text as HTML shows it, also as the value of an attribute. Control characters but line ends become their pictures.
std::string in_html(std::string_view text);

/// A whole page around `body`, which is HTML and well-formed XML too. Its policy lets it load and run nothing.
std::string html_page(std::string_view title, std::string_view body);

}  // namespace continua
