// The inspector's addresses that change something: notes, and runs with changes.
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/inspector/run_notes.h"
#include "continua/replay/inspector/run_what_if.h"
#include "continua/replay/log/line_scan.h"

namespace continua {
namespace {

constexpr int most_replays = 2;      // at a time
constexpr int most_what_ifs = 1000;  // served at a time

// ID of "/api/runs/ID/notes"; empty for any other path.
std::string run_of_notes(const std::string& path) {
  constexpr std::string_view before = "/api/runs/", after = "/notes";
  if (!path.starts_with(before) || !path.ends_with(after) || path.size() <= before.size() + after.size()) return {};
  return path.substr(before.size(), path.size() - before.size() - after.size());
}

// The body as JSON, or the answer that it cannot be used. A page elsewhere cannot send JSON unasked.
Result<Json> json_of(std::string_view content_type, std::string_view body, int& status) {
  status = 415;
  if (content_type.substr(0, content_type.find(';')) != "application/json")
    return Error{"", "expected a body of the content type application/json"};
  status = 400;
  return parse_json_line(body, "body", 1);
}

// Takes one of so many places as long as it lives.
class Place {
 public:
  Place(std::atomic<int>& taken, int most) : taken_(taken), free_(taken_.fetch_add(1) < most) {}
  ~Place() { --taken_; }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  bool free() const { return free_; }

 private:
  std::atomic<int>& taken_;
  bool free_;
};

// Without the folder that nobody knows of.
std::string sentence_without(const std::string& folder, const Error& error) {
  auto text = error.text();
  for (auto at = text.find(folder + "/"); at != std::string::npos; at = text.find(folder + "/"))
    text.erase(at, folder.size() + 1);
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.replace(at, folder.size(), "its folder");
  return text;
}

}  // namespace

ApiResponse InspectorApi::put(std::string_view target, std::string_view content_type, std::string_view body) {
  const auto id = run_of_notes(split_target(target).path);
  if (id.empty()) return api_error(405, "this address can only be read");
  int status = 0;
  const auto json = json_of(content_type, body, status);
  if (!json) return api_error(status, json.error().text());
  const auto opened = library_.open(id);
  if (!opened) return api_error(422, opened.error().text());
  if (!*opened) return api_error(404, fmt::format("there is no run '{}'", id));
  const auto notes = notes_in(*json, (*opened)->size());
  if (!notes) return api_error(400, notes.error().sentence);
  const auto version = json->find("version");
  if (version == json->end() || !version->is_string())
    return api_error(400, "'version' is missing: that of the notes that were read");

  const std::lock_guard lock(notes_mutex_);
  const auto kept = keep_notes(notes_path((*opened)->path()), *notes, version->get<std::string>());
  switch (kept.how) {
    case NotesKept::How::kept:
      return answer(notes_json({*notes, kept.version}));
    case NotesKept::How::changed_meanwhile:
      return api_error(409, kept.sentence);
    case NotesKept::How::broken:
      return api_error(422, kept.sentence);
    case NotesKept::How::not_writable:
      break;
  }
  return api_error(403, kept.sentence);
}

ApiResponse InspectorApi::notes(const RunIndex& run) {
  const std::lock_guard lock(notes_mutex_);
  const auto notes = read_notes(notes_path(run.path()));
  return notes ? answer(notes_json(*notes)) : api_error(422, notes.error().text());
}

ApiResponse InspectorApi::post(std::string_view target, std::string_view content_type, std::string_view body) {
  if (split_target(target).path == "/api/dropped") return dropped(split_target(target).query, content_type, body);
  if (split_target(target).path != "/api/what-if") return api_error(405, "this address can only be read");
  int status = 0;
  const auto json = json_of(content_type, body, status);
  if (!json) return api_error(status, json.error().text());
  const auto request = what_if_request(*json);
  if (!request) return api_error(400, request.error().sentence);
  const auto opened = library_.open(request->run);
  if (!opened) return api_error(422, opened.error().text());
  if (!*opened) return api_error(400, fmt::format("there is no run '{}'", request->run));
  if (!what_if_) return api_error(501, "runs are not replayed here");
  const Place place(replays_, most_replays);
  if (!place.free()) return api_error(503, fmt::format("{} runs are being replayed; try again", most_replays));
  const int number = ++what_ifs_;
  if (number > most_what_ifs)
    return api_error(503, fmt::format("{} what-ifs have been made; start the server anew", most_what_ifs));
  return replay(**opened, *request, number);
}

ApiResponse InspectorApi::replay(const RunIndex& run, const WhatIfRequest& request, int number) {
  const auto name = fmt::format("what-if-{}", number);
  const auto folder = temporary_.folder(name);
  if (!folder) return api_error(500, folder.error().text());
  const auto gone = [&](const ApiResponse& response) {
    std::error_code ignored;
    std::filesystem::remove_all(*folder, ignored);
    return response;
  };
  const auto replayed = what_if_->replay(run, request, *folder, stopped_);
  if (!replayed) return gone(api_error(400, sentence_without(*folder, replayed.error())));
  const auto fresh = RunIndex::open(replayed->log);
  if (!fresh) return gone(api_error(500, fresh.error().text()));
  const auto told = diff_runs(run, *fresh);
  if (!told) return gone(api_error(500, told.error().text()));
  Json made{
      {"run", library_.add(name, replayed->log, request.run)}, {"same", is_same(*told)}, {"sentence", told->sentence}};
  if (!replayed->warnings.empty()) made["warning"] = fmt::format("{}", fmt::join(replayed->warnings, "; "));
  return answer(made);
}

// A part of a file. The last is answered with the run: that of the log, or of the trace when it has been replayed.
ApiResponse InspectorApi::dropped(const Query& query, std::string_view content_type, std::string_view body) {
  if (content_type.substr(0, content_type.find(';')) != "application/octet-stream")
    return api_error(415, "expected a body of the content type application/octet-stream");
  const auto text = [&](const char* name) {
    const auto found = query.find(name);
    return found == query.end() ? std::string() : found->second;
  };
  const auto part = number_in<std::size_t>(text("part"));
  if (!part) return api_error(400, "'part' is missing: a number from 0");
  const auto taken = dropped_.add({text("file"), text("name"), *part, text("last") == "1", body});
  if (!taken) return api_error(400, taken.error().text());
  if (!*taken) return answer(Json{{"parts", *part + 1}});
  const auto& file = **taken;
  const auto refuse = [&](int status, const Error& error) {
    std::error_code ignored;
    std::filesystem::remove_all(file.folder, ignored);
    return api_error(status, sentence_without(file.folder, error));
  };
  auto log = file.path;
  if (file.is_trace) {
    if (!what_if_) return refuse(501, Error{"", "traces are not replayed here"});
    const Place place(replays_, most_replays);
    if (!place.free())
      return refuse(503, Error{"", fmt::format("{} runs are being replayed; try again", most_replays)});
    const auto replayed = what_if_->replay_trace(file.path, file.folder, stopped_);
    if (!replayed) return refuse(400, replayed.error());
    log = replayed->log;
  }
  if (const auto opened = RunIndex::open(log); !opened) return refuse(400, opened.error());
  return answer(Json{{"run", library_.add(file.name, log)}});
}

}  // namespace continua
