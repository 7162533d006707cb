#include "continua/replay/inspector/page_file.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "continua/core/gzip.h"
#include "continua/core/located_json.h"
#include "continua/replay/export/run_html.h"
#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_stops.h"
#include "continua/replay/log/schema.h"
#include "continua/web/assets.h"

namespace continua {
namespace {

constexpr std::size_t at_once = 500;  // labels asked for

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

// "9f86…" as bytes.
std::string bytes_of_hex(std::string_view hex) {
  std::string bytes;
  const auto value = [](char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); };
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(value(hex[i]) << 4 | value(hex[i + 1]));
  return bytes;
}

const WebAsset& asset(std::string_view path) {
  const auto all = web_assets();
  const auto found = std::find_if(all.begin(), all.end(), [&](const WebAsset& one) { return one.path == path; });
  require(found != all.end(), "the page's files are built in");
  return *found;
}

// The page's style sheets, in the order in which it links them.
std::string style_sheets() {
  constexpr std::string_view link = "<link rel=\"stylesheet\" href=\"";
  const auto index = gunzipped(asset("/index.html").gzip);
  std::string all;
  for (auto at = index.find(link); at != std::string::npos; at = index.find(link, at)) {
    at += link.size();
    all += gunzipped(asset(index.substr(at, index.find('"', at) - at)).gzip);
  }
  return all;
}

std::string_view unquoted(std::string_view quoted) { return quoted.substr(1, quoted.size() - 2); }

// The inspector's answers for the page, a line each: the question, a tab, the answer.
class Answers {
 public:
  explicit Answers(const std::string& path) : api_({path}) {}

  /// The run's id. Errors: it cannot be read.
  Outcome begin() {
    const auto runs = Json::parse(api_.get("/api/runs").body);
    const auto& one = runs.at("runs").at(0);
    id_ = one.at("id").get<std::string>();
    if (const auto error = one.find("error"); error != one.end())
      return Error{"", error->at("message").get<std::string>()};
    add("start", compact(Json("/r/" + id_)));
    return std::nullopt;
  }

  /// Adds the answer of the run's `view`; a view for which the log has nothing is left out.
  void view(const std::string& key, const std::string& view) {
    const auto answer = ask(view);
    if (answer.status == 200) add(key, answer.body);
  }

  ApiResponse ask(const std::string& view) { return api_.get("/api/runs/" + id_ + (view.empty() ? "" : "/" + view)); }

  void add(const std::string& key, const std::string& json) {
    text_ += key;
    text_ += '\t';
    text_ += json;
    text_ += '\n';
  }

  const std::string& id() const { return id_; }
  std::string& text() { return text_; }

 private:
  InspectorApi api_;
  std::string id_, text_;
};

// All that moved, in one window.
Outcome add_poses(Answers& answers, const RunIndex& run) {
  Json all;
  const auto end = run.entry(run.size() - 1).t.seconds();
  for (double from = 0;;) {
    const auto answer = answers.ask(fmt::format("poses?from={}&to={}", from, end));
    if (answer.status != 200) return std::nullopt;
    auto window = Json::parse(answer.body);
    const auto next = window.value("next", Json());
    if (all.is_null()) {
      all = std::move(window);
    } else {
      for (auto& change : window["changes"]) all["changes"].push_back(std::move(change));
      for (const char* part : {"pointing", "acts"})
        for (auto& one : window[part])
          if (std::find(all[part].begin(), all[part].end(), one) == all[part].end())
            all[part].push_back(std::move(one));
    }
    if (!next.is_number() || next.get<double>() <= from) break;
    from = next.get<double>();
  }
  all.erase("next");
  all["to"] = end;
  answers.add("poses", compact(all));
  return std::nullopt;
}

Outcome collect(Answers& answers, const RunIndex& run, const std::function<void(double)>& progress) {
  answers.view("run", "");
  answers.add("schema", compact(log::schema_json()));
  for (const char* view : {"graph", "scene", "notes"}) answers.view(view, view);
  const auto columns = answers.ask("columns");
  if (columns.status != 200) return Error{run.path(), "its columns cannot be worked out"};
  answers.add("columns", compact(Json(base64(columns.body))));
  if (const auto problem = add_poses(answers, run)) return problem;

  Json labels = Json::array();
  for (std::size_t from = 0; from < run.size(); from += at_once) {
    const auto part = Json::parse(answers.ask(fmt::format("labels?from={}&limit={}", from, at_once)).body);
    for (std::size_t n = from; n < std::min(run.size(), from + at_once); ++n)
      labels.push_back(part.at("labels").value(std::to_string(n), Json::array({"", ""})));
  }
  answers.add("labels", compact(labels));

  if (run.stack_marks().empty()) answers.view("stack 0", "stack?n=0");
  for (const auto& mark : run.stack_marks())
    answers.view(fmt::format("stack {}", mark.n), fmt::format("stack?n={}", mark.n));
  for (const auto n : run.of_kind(log::Branches::kind.name)) {
    const auto record = run.record(n);
    if (!record) return record.error();
    for (const auto& one : member_of(*record, "branches"))
      if (const auto& id = member_of(one, "id"); id.is_number_integer())
        answers.view(fmt::format("branch {} {}", n, id.get<std::int64_t>()),
                     fmt::format("stack?n={}&branch={}", n, id.get<std::int64_t>()));
  }
  for (std::size_t n = 0; n < run.size(); ++n) {
    const auto line = run.line(n);
    if (!line) return line.error();
    answers.add(fmt::format("record {}", n), *line);
  }
  const auto stops = records_worth_stopping_at(run);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (progress) progress(static_cast<double>(i) / static_cast<double>(stops.size()));
    answers.view(fmt::format("explain {}", stops[i]), fmt::format("explain?n={}", stops[i]));
  }
  return std::nullopt;
}

// Text as it may stand in a script element: nothing in it ends the element.
bool ends_element(std::string_view text) { return text.find("</") != std::string_view::npos; }

}  // namespace

Outcome write_page(const std::string& run_path, std::ostream& out, const std::function<void(double)>& progress) {
  const auto run = RunIndex::open(run_path);
  if (!run) return run.error();
  if (run->bytes() > most_page_log)
    return Error{run_path, fmt::format("has {} MB; expected at most {} MB for one file. `continua serve` shows it",
                                       run->bytes() >> 20, most_page_log >> 20)};
  Answers answers(run_path);
  if (const auto problem = answers.begin()) return *problem;
  if (const auto problem = collect(answers, *run, progress)) return *problem;

  const auto starter = gunzipped(asset("/exported.js").gzip), style = style_sheets();
  require(!ends_element(starter) && !ends_element(style), "scripts and styles stand in the file as they are");
  out << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      << "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-"
      << base64(bytes_of_hex(unquoted(asset("/exported.js").etag)))
      << "' blob:; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\">\n"
      << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      << "<title>" << in_html(answers.id()) << " – Continua</title>\n"
      << "<link rel=\"icon\" href=\"data:image/svg+xml;base64," << base64(gunzipped(asset("/icon.svg").gzip)) << "\">\n"
      << "<style>" << style << "</style>\n</head>\n<body>\n"
      << "<div id=\"page\"><p class=\"loading\">Loading…</p></div>\n"
      << "<div id=\"sentence\" class=\"unseen\" role=\"status\" aria-live=\"polite\" data-testid=\"sentence\"></div>\n"
      << "<noscript>This page needs JavaScript; it loads nothing from elsewhere.</noscript>\n";
  for (const auto& one : web_assets())
    if (one.path.ends_with(".js") && one.path != "/exported.js")
      out << "<script type=\"text/plain\" data-module=\"" << one.path << "\">" << base64(one.gzip) << "</script>\n";
  out << "<script type=\"text/plain\" id=\"answers\">" << base64(gzipped(answers.text(), 6)) << "</script>\n"
      << "<script>" << starter << "</script>\n</body>\n</html>\n";
  return std::nullopt;
}

}  // namespace continua
