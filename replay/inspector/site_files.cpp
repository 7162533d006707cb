#include "continua/replay/inspector/site_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "continua/core/gzip.h"
#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/inspector/page_parts.h"
#include "continua/replay/inspector/run_answers.h"
#include "continua/replay/inspector/run_library.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t shortest_document = 2000;  // bytes: a shorter text is not worth a file
constexpr char document_mark = '\x01';           // no JSON text has it

constexpr std::string_view index_page = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'self' file: blob:; style-src 'self' file:; img-src 'self' file: data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Continua</title>
<link rel="icon" href="assets/icon.svg">
<link rel="stylesheet" href="assets/style.css">
</head>
<body>
)html";

Outcome write(const fs::path& path, std::string_view text) {
  std::error_code problem;
  fs::create_directories(path.parent_path(), problem);
  if (problem) return Error{path.parent_path().string(), "cannot be made: " + problem.message()};
  return replace_file(path.string(), text);
}

class Site {
 public:
  Site(const SiteRequest& request, fs::path folder)
      : request_(request), folder_(std::move(folder)), files_(RunLibrary(request.paths).runs()), api_(request.paths) {}

  Result<SiteCounts> write_all(const std::function<void(double)>& progress) {
    if (files_.empty()) return Error{request_.paths.front(), "has no run logs (.run.jsonl)"};
    if (const auto problem = check_ids()) return *problem;
    if (const auto problem = read_listing()) return *problem;
    const auto pairs = chosen_pairs();
    if (!pairs) return pairs.error();
    if (const auto problem = write_assets()) return *problem;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (const auto problem = add_run(files_[i])) return *problem;
      if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(files_.size()));
    }
    for (const auto& [a, b] : *pairs)
      if (const auto problem = add_comparison(a, b)) return *problem;
    if (const auto problem = write_start()) return *problem;
    return SiteCounts{files_.size(), pairs->size()};
  }

 private:
  using Pair = std::array<std::string, 2>;  // ids

  // A script that hands its text to the page (web/run/site.js).
  Outcome put(const std::string& name, const std::string& text) {
    return write(folder_ / (name + ".js"),
                 fmt::format("continua_arrived({}, \"{}\");\n", compact(Json(name)), packed(text)));
  }

  // Many file systems do not tell such names apart.
  Outcome check_ids() const {
    std::map<std::string, const RunFile*> seen;
    for (const auto& file : files_) {
      auto key = file.id;
      std::transform(key.begin(), key.end(), key.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
      const auto [at, is_new] = seen.emplace(key, &file);
      if (!is_new)
        return Error{file.path, fmt::format("its name differs from that of {} only in case; expected names that every "
                                            "file system tells apart",
                                            at->second->path)};
    }
    return std::nullopt;
  }

  // The start page's lines, without what depends on the machine and the day.
  Outcome read_listing() {
    const auto told = Json::parse(api_.get("/api/runs").body);
    for (const auto& line : told.at("runs")) lines_.emplace(line.at("id").get<std::string>(), line);
    for (const auto& file : files_) {
      auto& line = lines_[file.id];
      if (const auto error = line.find("error"); error != line.end())
        return Error{"", error->at("message").get<std::string>()};
      line.erase("changed");
      line["live"] = false;
    }
    return std::nullopt;
  }

  Result<std::vector<Pair>> chosen_pairs() const {
    std::vector<Pair> pairs;
    for (const auto& given : request_.pairs) {
      Pair ids;
      for (std::size_t side = 0; side < 2; ++side) {
        const auto found = std::find_if(files_.begin(), files_.end(), [&](const RunFile& file) {
          return file.path == given[side] || file.name == given[side] || file.id == given[side];
        });
        if (found == files_.end())
          return Error{given[side], "is none of the runs of the site; expected a path or a name"};
        ids[side] = found->id;
      }
      pairs.push_back(ids);
    }
    if (!pairs.empty()) return pairs;
    std::map<std::string, std::string> last;  // trace -> run
    for (const auto& file : files_) {
      const auto trace = lines_.at(file.id).value("trace", "");
      if (const auto before = last.find(trace); before != last.end() && !trace.empty())
        pairs.push_back({before->second, file.id});
      last[trace] = file.id;
    }
    return pairs;
  }

  Outcome write_assets() {
    Json modules = Json::object();
    for (const auto& one : web_assets())
      if (is_page_module(one)) modules[std::string(one.path)] = base64(one.gzip);
    const auto assets = folder_ / "assets";
    const std::vector<std::pair<fs::path, std::string>> all = {
        {assets / "modules.js", "globalThis.continua_modules = " + compact(modules) + ";\n"},
        {assets / "start.js", gunzipped(page_asset("/exported.js").gzip)},
        {assets / "style.css", page_style()},
        {assets / "icon.svg", gunzipped(page_asset("/icon.svg").gzip)},
        {folder_ / "index.html", std::string(index_page) + std::string(page_body) +
                                     "<script src=\"assets/modules.js\"></script>\n"
                                     "<script src=\"assets/start.js\"></script>\n</body>\n</html>\n"}};
    for (const auto& [path, text] : all)
      if (const auto problem = write(path, text)) return problem;
    return std::nullopt;
  }

  Outcome add_run(const RunFile& file) {
    const auto run = RunIndex::open(file.path);
    if (!run) return run.error();
    const auto answers = run_answers(api_, file.id, *run);
    if (!answers) return answers.error();
    std::string lean;
    for (std::size_t from = 0; from < answers->size();) {
      const auto end = answers->find('\n', from), tab = answers->find('\t', from);
      const auto question = answers->substr(from, tab - from);
      auto json = answers->substr(tab + 1, end - tab - 1);
      from = end + 1;
      if (question == "schema") continue;  // a file of its own
      if (question == "labels") add_words(file.id, Json::parse(json));
      const auto kept = without_documents(question, std::move(json));
      if (!kept) return kept.error();
      lean += answer_line(question, *kept);
    }
    return put("runs/" + file.id, lean);
  }

  void add_words(const std::string& id, const Json& labels) {
    auto& said = words_[id] = Json::array();
    for (std::size_t n = 0; n < labels.size(); ++n)
      if (const auto& text = labels[n].at(1); text != "") said.push_back({n, text});
  }

  // The answer with its long parts that other runs may have too replaced by their numbers.
  Result<std::string> without_documents(const std::string& question, std::string json) {
    if (question == "scene") return document(json);
    if (question == "record 0") return without_long_members(Json::parse(json));
    if (question != "run") return json;
    auto summary = Json::parse(json);
    const auto header = without_long_members(summary.at("header"));
    if (!header) return header;
    summary["header"] = nullptr;
    const std::string gap = "\"header\":null";
    auto text = compact(summary);
    return text.replace(text.find(gap), gap.size(), "\"header\":" + *header);
  }

  Result<std::string> without_long_members(const Json& object) {
    std::string text;
    for (const auto& [name, value] : object.items()) {
      const auto member = document(compact(value));
      if (!member) return member;
      text += (text.empty() ? "" : ",") + compact(Json(name)) + ":" + *member;
    }
    return "{" + text + "}";
  }

  Result<std::string> document(const std::string& json) {
    if (json.size() < shortest_document) return json;
    const auto [at, is_new] = documents_.emplace(json, documents_.size() + 1);
    if (is_new)
      if (const auto problem = put(fmt::format("documents/{}", at->second), json)) return *problem;
    return fmt::format("{0}{1}{0}", document_mark, at->second);
  }

  Outcome add_comparison(const std::string& a, const std::string& b) {
    const auto told = api_.get(fmt::format("/api/diff?a={}&b={}", a, b));
    const auto body = Json::parse(told.body);
    if (told.status != 200) return Error{a + ", " + b, body.at("error").at("message").get<std::string>()};
    lines_[a]["compared"].push_back({{"with", b}, {"same", body.at("same")}, {"sentence", body.at("sentence")}});
    return put(fmt::format("diffs/{}/{}", a, b), told.body);
  }

  Outcome write_start() {
    Json runs = Json::array();
    for (const auto& file : files_) {
      auto& line = lines_[file.id];
      if (!line.contains("compared")) line["compared"] = Json::array();
      runs.push_back(line);
    }
    for (const auto& [name, content] : {std::pair("runs", Json{{"runs", std::move(runs)}}), std::pair("words", words_),
                                        std::pair("schema", log::schema_json())})
      if (const auto problem = put(name, compact(content))) return problem;
    return std::nullopt;
  }

  const SiteRequest& request_;
  const fs::path folder_;
  const std::vector<RunFile> files_;
  InspectorApi api_;
  std::map<std::string, Json> lines_;             // of the start page, by id
  std::map<std::string, std::size_t> documents_;  // text -> number
  Json words_ = Json::object();
};

}  // namespace

Result<SiteCounts> write_site(const SiteRequest& request, const std::string& folder,
                              const std::function<void(double done)>& progress) {
  return Site(request, folder).write_all(progress);
}

}  // namespace continua
