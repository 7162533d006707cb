#include "continua/replay/inspector/page_file.h"

#include <string_view>

#include <fmt/format.h>

#include "continua/core/gzip.h"
#include "continua/core/located_json.h"
#include "continua/core/markup.h"
#include "continua/replay/inspector/page_parts.h"
#include "continua/replay/inspector/run_answers.h"
#include "continua/replay/log/run_index.h"

namespace continua {
namespace {

// "9f86…" as bytes.
std::string bytes_of_hex(std::string_view hex) {
  std::string bytes;
  const auto value = [](char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); };
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(value(hex[i]) << 4 | value(hex[i + 1]));
  return bytes;
}

std::string_view unquoted(std::string_view quoted) { return quoted.substr(1, quoted.size() - 2); }

// Text as it may stand in a script element: nothing in it ends the element.
bool ends_element(std::string_view text) { return text.find("</") != std::string_view::npos; }

}  // namespace

Outcome write_page(const std::string& run_path, std::ostream& out, const std::function<void(double)>& progress,
                   const PageMedia& media) {
  const auto run = RunIndex::open(run_path);
  if (!run) return run.error();
  const auto id = RunLibrary({run_path}).runs().front().id;
  InspectorApi api({run_path});
  const auto answers = run_answers(api, id, *run, progress);
  if (!answers) return answers.error();
  const auto recordings = media_in_page(api, id, media);
  if (!recordings) return recordings.error();

  const auto starter = gunzipped(page_asset("/exported.js").gzip), style = page_style();
  require(!ends_element(starter) && !ends_element(style), "scripts and styles stand in the file as they are");
  out << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      << "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-"
      << base64(bytes_of_hex(unquoted(page_asset("/exported.js").etag)))
      << "' blob:; style-src 'unsafe-inline'; img-src data:; media-src " << (media.embed ? "blob:" : "'self' file:")
      << "; base-uri 'none'; form-action 'none'\">\n"
      << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      << "<title>" << in_markup(id) << " – Continua</title>\n"
      << "<link rel=\"icon\" href=\"data:image/svg+xml;base64," << base64(gunzipped(page_asset("/icon.svg").gzip))
      << "\">\n"
      << "<style>" << style << "</style>\n</head>\n<body>\n"
      << page_body;
  for (const auto& one : web_assets())
    if (is_page_module(one))
      out << "<script type=\"text/plain\" data-module=\"" << one.path << "\">" << base64(one.gzip) << "</script>\n";
  out << recordings->elements << "<script type=\"text/plain\" id=\"answers\">"
      << packed(answer_line("start", compact(Json("/r/" + id))) + recordings->answers + *answers) << "</script>\n"
      << "<script>" << starter << "</script>\n</body>\n</html>\n";
  return std::nullopt;
}

}  // namespace continua
