// Pages that stand by themselves: no script, nothing loaded from elsewhere, light and dark, fit for a phone.
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// A whole page around `body`, which is HTML and well-formed XML too. Its policy lets it load and run nothing.
std::string html_page(std::string_view title, std::string_view body);

}  // namespace continua
