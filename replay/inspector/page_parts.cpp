#include "continua/replay/inspector/page_parts.h"

#include <algorithm>

#include "continua/core/gzip.h"
#include "continua/core/result.h"

namespace continua {

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= left ? letters[three >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

std::string packed(std::string_view text) {
  constexpr int level = 6;  // 9 takes twice as long for a hundredth less
  return base64(gzipped(text, level));
}

const WebAsset& page_asset(std::string_view path) {
  const auto all = web_assets();
  const auto found = std::find_if(all.begin(), all.end(), [&](const WebAsset& one) { return one.path == path; });
  require(found != all.end(), "the page's files are built in");
  return *found;
}

bool is_page_module(const WebAsset& asset) {
  return asset.path.ends_with(".js") && asset.path != "/exported.js" && !asset.path.starts_with("/hands/");
}

std::string page_style() {
  constexpr std::string_view link = "<link rel=\"stylesheet\" href=\"";
  const auto index = gunzipped(page_asset("/index.html").gzip);
  std::string all;
  for (auto at = index.find(link); at != std::string::npos; at = index.find(link, at)) {
    at += link.size();
    all += gunzipped(page_asset(index.substr(at, index.find('"', at) - at)).gzip);
  }
  return all;
}

constinit const std::string_view page_body =
    "<div id=\"page\"><p class=\"loading\">Loading…</p></div>\n"
    "<div id=\"sentence\" class=\"unseen\" role=\"status\" aria-live=\"polite\" data-testid=\"sentence\"></div>\n"
    "<noscript>This page needs JavaScript; it loads nothing from elsewhere.</noscript>\n";

}  // namespace continua
