// The files of the inspector's page, for pages that are files themselves.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "continua/web/assets.h"

namespace continua {

/// The longest log, in bytes, that is put into a file.
inline constexpr std::size_t most_page_log = std::size_t{64} << 20;

std::string base64(std::string_view bytes);

/// `text` compressed, as it may stand in a script.
std::string packed(std::string_view text);

/// REQUIRES that the page has a file at this path.
const WebAsset& page_asset(std::string_view path);

/// Whether the asset is one of the page's modules.
bool is_page_module(const WebAsset& asset);

/// The page's style sheets, in the order in which it links them.
std::string page_style();

/// The body of a page before its modules have run.
extern const std::string_view page_body;

}  // namespace continua
