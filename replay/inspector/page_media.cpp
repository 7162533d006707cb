#include "continua/replay/inspector/page_media.h"

#include <cctype>
#include <filesystem>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/inspector/page_parts.h"
#include "continua/replay/inspector/run_answers.h"

namespace continua {
namespace {

// A path as an address.
std::string address_of(const std::string& path) {
  std::string address;
  for (const char c : path)
    if (std::isalnum(static_cast<unsigned char>(c)) || std::string_view("/._-~").find(c) != std::string_view::npos)
      address += c;
    else
      address += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  return address;
}

// The way to a file from a folder.
std::string way_to(const std::string& file, const std::string& folder) {
  std::error_code problem;
  const auto from = std::filesystem::absolute(folder.empty() ? "." : folder, problem);
  return std::filesystem::proximate(file, from, problem).generic_string();
}

}  // namespace

Result<MediaInPage> media_in_page(InspectorApi& api, const std::string& id, const PageMedia& how) {
  const auto address = "/api/runs/" + id + "/media";
  auto told = Json::parse(api.get(address).body);
  MediaInPage page;
  if (!told.contains("media") || told["media"].empty()) return page;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < told["media"].size(); ++i) {
    const auto asked = api.media_file(fmt::format("{}/{}", address, i));
    const auto* file = std::get_if<ServedMedia>(&asked);
    if (!file) continue;
    if (const auto peaks = api.get(fmt::format("{}/{}/peaks", address, i)); peaks.status == 200)
      page.answers += answer_line(fmt::format("peaks {}", i), peaks.body);
    if (!how.embed) {
      told["media"][i]["src"] = address_of(way_to(file->path, how.folder));
      continue;
    }
    bytes += told["media"][i].value("bytes", std::size_t{0});
    if (bytes > most_page_media)
      return Error{file->path, fmt::format("is too much for one file: recordings may have {} MiB in it; without "
                                           "--embed-media the page links them",
                                           most_page_media >> 20)};
    const auto content = read_file(file->path);
    if (!content) return content.error();
    page.elements += fmt::format("<script type=\"text/plain\" data-media=\"{}\" data-type=\"{}\">{}</script>\n", i,
                                 file->type, base64(*content));
  }
  page.answers += answer_line("media", compact(told));
  return page;
}

}  // namespace continua
