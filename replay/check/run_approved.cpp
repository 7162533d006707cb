#include "continua/replay/check/run_approved.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "continua/core/gzip_name.h"
#include "continua/core/located_json.h"
#include "continua/replay/log/kept_documents.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_log.h"
#include "continua/replay/log/run_log_file.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

std::string beside(const std::string& trace_path, const std::string& ending) {
  const auto trace = without_gzip_ending(trace_path);
  const auto stem = trace.ends_with(trace_ending)
                        ? trace.substr(0, trace.size() - trace_ending.size())
                        : trace.substr(0, trace.size() - fs::path(trace).extension().string().size());
  return std::string(stem) + ending;
}

Json part(const Json& record, const char* pointer) {
  const Json::json_pointer at(pointer);
  return record.contains(at) ? record[at] : Json();
}

// A run log as text, with its first and last line. There may be very many poses: they are never parsed.
struct Log {
  std::vector<std::string_view> lines;
  Json header, end;
};

Result<Log> read_log(std::string_view text, const std::string& name) {
  Log log;
  while (!text.empty()) {
    const auto length = std::min(text.find('\n'), text.size());
    log.lines.push_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  if (log.lines.empty()) return Error{name, "is empty; expected a run log"};
  auto header = parse_json_line(log.lines.front(), name, 1);
  if (!header) return header.error();
  auto end = parse_json_line(log.lines.back(), name, log.lines.size());
  if (!end) return end.error();
  log.header = *std::move(header);
  log.end = *std::move(end);
  if (part(log.header, "/kind") != "run") return Error{name + ":1", "is no header of a run log"};
  if (part(log.end, "/kind") != "end")
    return Error{fmt::format("{}:{}", name, log.lines.size()), "the log is cut short; expected an 'end'"};
  return log;
}

bool same_bytes(Log a, Log b) {
  for (Log* log : {&a, &b}) {
    log->header.erase("fingerprint");
    log->end.erase("digest");
  }
  return a.lines.size() == b.lines.size() && a.header == b.header && a.end == b.end &&
         std::equal(a.lines.begin() + 1, a.lines.end() - 1, b.lines.begin() + 1);
}

// The decisions of a log, one after another; null after the last.
class Decisions {
 public:
  Decisions(const Log& log, const std::string& name) : log_(log), name_(name) {}

  Result<Json> next() {
    for (; at_ < log_.lines.size(); ++at_) {
      bool is_pose = false;
      const auto look = [&](std::string_view key, std::string_view value) {
        is_pose = is_pose || (key == "\"kind\"" && value == "\"pose\"");
      };
      if (scan_members(log_.lines[at_], look) && is_pose) continue;
      auto record = parse_json_line(log_.lines[at_], name_, at_ + 1);
      if (!record) return record.error();
      if (auto decision = order_.next(*record)) {
        ++at_;
        return *std::move(decision);
      }
    }
    if (!outcomes_) outcomes_ = order_.outcomes();
    return told_ < outcomes_->size() ? (*outcomes_)[told_++] : Json();
  }

 private:
  const Log& log_;
  const std::string& name_;
  std::size_t at_ = 0, told_ = 0;
  DecisionOrder order_;
  std::optional<std::vector<Json>> outcomes_;  // once all records are read
};

Result<RunComparison> compare_logs(const Log& run, const ApprovedRun& approved) {
  const auto other = read_log(approved.content, approved.path);
  if (!other) return other.error();
  const Json approved_trace = part(other->header, "/trace/digest");
  if (!approved_trace.is_null() && approved_trace != part(run.header, "/trace/digest"))
    return RunComparison{Sameness::stale, ""};
  if (same_bytes(run, *other)) return RunComparison{Sameness::same, ""};
  Decisions now(run, approved.path), before(*other, approved.path);
  for (;;) {
    const auto a = now.next(), b = before.next();
    if (!a) return a.error();
    if (!b) return b.error();
    if (*a != *b) return RunComparison{Sameness::changed, "decisions differ"};
    if (a->is_null()) return RunComparison{Sameness::same_decisions, ""};
  }
}

Json digests_of(const Log& run) {
  Json digests = {{"approved", 1},
                  {"trace", part(run.header, "/trace/digest")},
                  {"world", part(run.header, "/world")},
                  {"decisions", part(run.end, "/decisions")},
                  {"digest", part(run.end, "/digest")},
                  {"counts", part(run.end, "/counts")}};
  if (digests["world"] == "physics") digests["mujoco"] = part(run.header, "/fingerprint/mujoco");
  return digests;
}

Result<RunComparison> compare_digests(const Log& run, const ApprovedRun& approved) {
  const auto document = LocatedJson::parse(approved.content, approved.path);
  if (!document) return document.error();
  if (const auto& doubled = document->duplicates(); !doubled.empty())
    return document->error(doubled.front().place,
                           fmt::format("the key {} a second time in this object", in_quotes(doubled.front().key)));
  const Json now = digests_of(run), before = document->root();
  if (!before.is_object() || part(before, "/approved") != 1)
    return Error{approved.path, "is no approved run; expected \"approved\": 1"};
  if (now["trace"] != part(before, "/trace")) return RunComparison{Sameness::stale, ""};
  if (now["digest"] == part(before, "/digest")) return RunComparison{Sameness::same, ""};
  if (now["decisions"] == part(before, "/decisions")) return RunComparison{Sameness::same_decisions, ""};
  const auto counts = part(before, "/counts");
  for (const auto& [kind, count] : now["counts"].items())
    if (const Json was = counts.is_object() && counts.contains(kind) ? counts[kind] : Json(0);
        was != count && is_decision(kind))
      return RunComparison{Sameness::changed,
                           fmt::format("{} records of {}, approved {}", compact(count), kind, compact(was))};
  return RunComparison{Sameness::changed, "decisions differ; only their digest was approved"};
}

// The length of the file that the run would be approved by.
std::size_t bytes_of_file(std::string_view run, const std::string& trace_path) {
  if (!documents_above(trace_path)) return run.size();
  const auto header = run.substr(0, run.find('\n'));
  return run.size() - header.size() + without_documents(header).line.size();
}

// The circumstances that an approved run tells; empty what it does not tell.
struct Circumstances {
  std::string world, mujoco, trace;
};

std::string text_at(const Json& record, const char* pointer) {
  const auto value = part(record, pointer);
  return value.is_string() ? value.get<std::string>() : "";
}

Circumstances circumstances_of(const ApprovedRun& approved) {
  const bool whole = is_whole_log(approved);
  const auto document = parse_json_line(
      whole ? approved.content.substr(0, approved.content.find('\n')) : approved.content, approved.path, 1);
  if (!document) return {};
  return {text_at(*document, "/world"), text_at(*document, whole ? "/fingerprint/mujoco" : "/mujoco"),
          text_at(*document, whole ? "/trace/digest" : "/trace")};
}

constexpr std::string_view of_mujoco = ".physics.mujoco-";

// The part between a trace's name and ".run.": of the world of a run, or of its MuJoCo.
std::string part_of_name(const Json& header, const std::optional<ApprovedRun>& before) {
  if (!before) return "";
  const auto world = text_at(header, "/world"), mujoco = text_at(header, "/fingerprint/mujoco");
  const auto was = circumstances_of(*before);
  const bool by_another = world == "physics" && was.world == world && !was.mujoco.empty() && was.mujoco != mujoco &&
                          was.trace == text_at(header, "/trace/digest");
  const auto own = std::string(of_mujoco) + mujoco;
  if (by_another || before->path.find(own + ".run.") != std::string::npos) return own;
  const bool elsewhere =
      before->path.find("." + world + ".run.") != std::string::npos || (!was.world.empty() && was.world != world);
  return elsewhere ? "." + world : "";
}

}  // namespace

std::string other_mujocos(const std::string& trace_path, const ApprovedRun& approved, const std::string& mujoco) {
  const auto first = circumstances_of(approved).mujoco;
  if (first.empty() || first == mujoco) return "";
  std::vector<std::string> versions = {"MuJoCo " + first};
  const auto begin = fs::path(beside(trace_path, std::string(of_mujoco))).filename().string();
  const auto folder = fs::path(trace_path).parent_path();
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, problem)) {
    const auto name = entry.path().filename().string();
    const auto end = name.rfind(".run.json");
    if (name.starts_with(begin) && end != std::string::npos)
      versions.push_back(name.substr(begin.size(), end - begin.size()));
  }
  std::sort(versions.begin() + 1, versions.end());
  return fmt::format("{}", fmt::join(versions, ", "));
}

Result<std::optional<ApprovedRun>> find_approved_run(const std::string& trace_path, const std::string& world,
                                                     const std::string& mujoco) {
  std::vector<std::string> parts = {"." + world, std::string()};
  if (world == "physics" && !mujoco.empty()) parts.insert(parts.begin(), std::string(of_mujoco) + mujoco);
  for (const auto& of_world : parts) {
    std::optional<ApprovedRun> found;
    for (const char* ending : {".run.jsonl", ".run.jsonl.gz", ".run.json"}) {
      const auto path = beside(trace_path, of_world + ending);
      if (!fs::exists(path)) continue;
      if (found) return Error{path, fmt::format("is approved beside {}; expected one of them", found->path)};
      auto content = is_run_log_name(path) ? read_run_log(path) : read_file(path);
      if (!content) return content.error();
      found = ApprovedRun{path, *std::move(content)};
    }
    if (found) return found;
  }
  return std::optional<ApprovedRun>();
}

bool is_whole_log(const ApprovedRun& approved) { return is_run_log_name(approved.path); }

Outcome write_approval(const ApprovedRun& approval) {
  if (!is_whole_log(approval)) return replace_file(approval.path, approval.content);
  RunLogFile file(approval.path, documents_above(approval.path).value_or(""));
  file.stream() << approval.content;
  return file.commit();
}

bool takes_place_of(const ApprovedRun& approval, const ApprovedRun& before) {
  const auto stem = [](const std::string& path) { return path.substr(0, path.rfind(".run.")); };
  return approval.path != before.path && stem(approval.path) == stem(before.path);
}

ApprovedRun approval_of(const std::string& trace_path, std::string_view run, const std::optional<ApprovedRun>& before) {
  const bool whole = before ? is_whole_log(*before) : true;
  const auto log = read_log(run, trace_path);
  require(log.ok(), "a run is a run log");
  const auto of_world = part_of_name(log->header, before);
  const bool packed = before && is_gzip_name(before->path);
  if (whole && (packed || bytes_of_file(run, trace_path) <= longest_approved_log))
    return {beside(trace_path, fmt::format("{}.run.jsonl{}", of_world, packed ? gzip_ending : "")), std::string(run)};
  return {beside(trace_path, of_world + ".run.json"), digests_of(*log).dump(2) + "\n"};
}

Result<RunComparison> compare_to_approved(std::string_view run, const ApprovedRun& approved) {
  const auto log = read_log(run, "the run");
  require(log.ok(), "a run is a run log");
  return is_whole_log(approved) ? compare_logs(*log, approved) : compare_digests(*log, approved);
}

}  // namespace continua
