#include "continua/replay/experiment/what_if_session.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/replaced_file.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/pipeline/pipeline.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/scene/run_points.h"
#include "continua/replay/session/outside_choice.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/trace_file.h"
#include "continua/replay/trace/trace_name.h"
#include "continua/simulation/scene.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_log = std::uintmax_t{256} << 20;  // bytes
constexpr double longest_physics_s = 7200;                         // of simulated time
constexpr std::chrono::minutes longest_replay{10};
constexpr double same_place = 2e-5;  // logs round to 1e-5

Outcome write_file(const fs::path& path, const std::string& text) {
  std::error_code problem;
  fs::create_directories(path.parent_path(), problem);
  return replace_file(path.string(), text);
}

// A name of the log as the name of a file.
std::string file_name(const std::string& name, const char* otherwise) {
  const auto last = fs::path(name).filename().string();
  return last.empty() || last == "." || last == ".." || last.size() > 100 || last.find('\0') != std::string::npos
             ? otherwise
             : last;
}

// Not a way to a file. Empty: not said.
bool is_plain_name(const std::string& name) {
  return std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

// Turned about z by so much, if it is turned about nothing else.
std::optional<double> yaw_of(const PoseNumbers& pose) {
  if (std::abs(pose[4]) > 1e-4 || std::abs(pose[5]) > 1e-4) return std::nullopt;
  return 2 * std::atan2(pose[6], pose[3]);
}

bool near(const PoseNumbers& a, const PoseNumbers& b, std::size_t from, std::size_t to) {
  for (auto i = from; i < to; ++i)
    if (std::abs(a[i] - b[i]) > same_place) return false;
  return true;
}

// Makes the trace of a run, and the files of the engine that answered it, from the run's log.
class WhatIfFiles {
 public:
  WhatIfFiles(const RunIndex& run, const WhatIfRequest& request, fs::path folder)
      : run_(run), request_(request), folder_(std::move(folder)) {}

  Outcome make() {
    auto header = run_.record(0);
    if (!header) return header.error();
    header_ = *std::move(header);
    if (header_.contains("what_if"))
      return Error{"",
                   "the run is itself one that was changed in mid-run; expected the run that it was made from, or "
                   "one changed from its beginning"};
    auto data = find_data_paths();
    if (!data) return data.error();
    data_ = *std::move(data);
    for (const auto& step : {&WhatIfFiles::make_scene, &WhatIfFiles::make_knowledge, &WhatIfFiles::make_machine,
                             &WhatIfFiles::make_trace, &WhatIfFiles::make_options})
      if (auto wrong = (this->*step)()) return wrong;
    return std::nullopt;
  }

  const Json& header() const { return header_; }
  const std::string& trace() const { return trace_; }
  const ReplayOptions& options() const { return options_; }

 private:
  Result<std::string> named(const char* part, const char* document) const {
    const auto& text = member_of(member_of(header_, part), document);
    if (text.is_null()) return Error{run_.where(0), fmt::format("the log carries no {} to replay with", part)};
    return text.is_string() ? text.get<std::string>() : compact(text);
  }

  // The program's scene if it is the very one of the log, with its files; else the log's.
  Outcome make_scene() {
    const auto mjcf = named("scene", "mjcf");
    if (!mjcf) return mjcf.error();
    const auto& scene = header_["scene"];
    const auto name = file_name(text_of(scene, "name"), "scene") + ".xml";
    scene_ = (data_.mjcf / "scenes" / name).string();
    std::error_code unknown;
    if (fs::is_regular_file(scene_, unknown) && lay_out() && laid_out_ == *mjcf) return std::nullopt;
    scene_ = (folder_ / name).string();
    if (auto wrong = write_file(scene_, *mjcf)) return wrong;
    return lay_out() ? std::nullopt : Outcome(Error{run_.where(0), "the log's scene cannot be used: " + problem_});
  }

  // Puts into objects_ the objects that stood elsewhere, or were not there, when the run began.
  bool lay_out() {
    objects_ = Json::object();
    const auto& bodies = member_of(header_["scene"], "bodies");
    const auto scene = load_scene(scene_);
    if (!scene) {
      problem_ = scene.error().text();
      return false;
    }
    const auto own = scene->description()["bodies"];
    std::vector<ObjectOverride> removed;
    for (const auto& object : scene->objects()) {
      const auto was = pose_in(member_of(bodies, object.name.c_str()));
      const auto is = pose_in(member_of(own, object.name.c_str()));
      if (!was) {
        objects_[object.name] = nullptr;
        removed.push_back({object.name, {}, {}, {}, {}, true});
        continue;
      }
      if (!is || near(*was, *is, 0, 7)) continue;
      Json start = Json::object();
      if (!near(*was, *is, 0, 3)) start["position"] = {(*was)[0], (*was)[1], (*was)[2]};
      if (const auto yaw = yaw_of(*was); yaw && !near(*was, *is, 3, 7)) start["yaw"] = *yaw;
      objects_[object.name] = std::move(start);
    }
    if (removed.empty()) {
      laid_out_ = scene->text();
      return true;
    }
    const auto without = load_scene(scene_, removed);
    if (!without) problem_ = without.error().text();
    laid_out_ = without ? without->text() : "";
    return without.ok();
  }

  // The program's knowledge, but with the log's phrases.
  Outcome make_knowledge() {
    const auto& phrases = member_of(header_, "phrases");
    if (!phrases.is_object()) return std::nullopt;
    const auto name = file_name(text_of(phrases, "name"), "phrases") + ".json";
    const auto own = read_file((data_.knowledge / "phrases" / name).string());
    if (own && digest(*own) == text_of(phrases, "digest")) return std::nullopt;
    const auto document = named("phrases", "document");
    if (!document) return document.error();
    const auto knowledge = folder_ / "knowledge";
    if (auto wrong = write_file(knowledge / "phrases" / name, *document)) return wrong;
    std::error_code problem;
    for (fs::directory_iterator part(data_.knowledge, problem), end; !problem && part != end; part.increment(problem))
      if (part->path().filename() != "phrases")
        fs::create_directory_symlink(fs::absolute(part->path()), knowledge / part->path().filename(), problem);
    if (problem) return Error{knowledge.string(), "cannot be filled: " + problem.message()};
    options_.knowledge = knowledge.string();
    return std::nullopt;
  }

  Outcome make_machine() {
    const auto document = named("machine", "document");
    if (!document) return document.error();
    const auto& machine = header_["machine"];
    const auto name = file_name(text_of(machine, "name"), "machine") + ".json";
    machine_ = (data_.knowledge / "machines" / name).string();
    const auto own = read_file(machine_);
    if (own && digest(*own) == text_of(machine, "digest")) return std::nullopt;
    machine_ = (folder_ / name).string();
    return write_file(machine_, *document);
  }

  Outcome make_trace() {
    const auto lines = trace_lines(run_, request_);
    if (!lines) return lines.error();
    Json first{{"kind", "trace"}, {"version", 1}, {"scene", scene_}, {"machine", machine_}};
    for (const char* key : {"seed", "perspective"})
      if (const auto& value = member_of(header_, key); !value.is_null()) first[key] = value;
    if (!objects_.empty()) first["objects"] = objects_;
    const auto language = text_of(member_of(header_, "lexicon"), "name");
    if (language != text_of(member_of(header_["machine"], "document"), "lexicon")) first["language"] = language;
    trace_ = (folder_ / file_name(text_of(member_of(header_, "trace"), "name"), "what_if.trace.jsonl")).string();
    return write_file(trace_, compact(first) + '\n' + *lines);
  }

  // The run's options with the request's changes; from an instant on if the request says so and it makes a difference.
  Outcome make_options() {
    options_.physics = text_of(header_, "world") == "physics";
    const auto end = run_.entry(run_.size() - 1).t.seconds();
    if (options_.physics && end > longest_physics_s)
      return Error{"", fmt::format("the run takes {} s; expected at most {} s to be replayed with physics", end,
                                   longest_physics_s)};
    options_.choice = parse_choice(text_of(header_, "choice"));
    if (is_outside_choice(text_of(header_, "choice")))
      options_.outside = "run:" + run_.path();
    else if (!options_.choice)
      return Error{run_.where(0),
                   fmt::format("its choice is {}; expected {}", in_quotes(text_of(header_, "choice")), choice_names())};
    if (const auto& most = member_of(header_, "most_branches"); most.is_number_unsigned())
      options_.most_branches = most.get<std::size_t>();
    if (const auto& forced = member_of(header_, "forced"); forced.is_object())
      for (const auto& [step, transition] : forced.items())
        if (transition.is_string()) options_.forced[std::atoi(step.c_str())] = transition.get<std::string>();
    if (const auto& learned = member_of(header_, "learned"); !learned.is_null()) {
      options_.learned = (folder_ / "learned.json").string();
      if (auto wrong = write_file(options_.learned, compact(learned))) return wrong;
    }
    const bool otherwise_from = request_.from && (request_.seed || !request_.choice.empty());
    if (otherwise_from) {
      options_.before = std::make_shared<const ReplayOptions>(options_);
      options_.from = request_.from;
    }
    for (const auto& [step, transition] : request_.forced) options_.forced[step] = transition;
    if (request_.seed) options_.seed = request_.seed;
    if (request_.choice.empty()) return std::nullopt;
    options_.choice = parse_choice(request_.choice);
    options_.outside.clear();
    if (options_.choice) return std::nullopt;
    return Error{"", fmt::format("'choice' is {}; expected {}", in_quotes(request_.choice), choice_names())};
  }

  const RunIndex& run_;
  const WhatIfRequest& request_;
  fs::path folder_;
  Json header_, objects_;
  DataPaths data_;
  std::string scene_, machine_, trace_, laid_out_, problem_;
  ReplayOptions options_;
};

// Why the new run may differ from the old for reasons that nobody asked for.
std::vector<std::string> warnings_of(const Json& was, const Json& is) {
  std::vector<std::string> warnings;
  std::vector<std::string> files;
  const auto &known_was = member_of(was, "knowledge"), &known_is = member_of(is, "knowledge");
  if (known_was.is_object() && known_is.is_object()) {
    for (const auto& [file, of_file] : known_was.items())
      if (member_of(known_is, file.c_str()) != of_file) files.push_back(file);
    for (const auto& [file, of_file] : known_is.items())
      if (!known_was.contains(file)) files.push_back(file);
  } else if (text_of(member_of(was, "lexicon"), "digest") != text_of(member_of(is, "lexicon"), "digest") ||
             text_of(member_of(was, "voxemes"), "digest") != text_of(member_of(is, "voxemes"), "digest")) {
    files.push_back("the words or the voxemes");
  }
  if (!files.empty())
    warnings.push_back(fmt::format("what is known is no longer what it was in the run: {}{}", files.front(),
                                   files.size() > 1 ? fmt::format(" and {} more", files.size() - 1) : ""));
  if (text_of(was, "continua") != text_of(is, "continua"))
    warnings.push_back(fmt::format("the run is of version {} of the program, this is {}", text_of(was, "continua"),
                                   text_of(is, "continua")));
  if (text_of(was, "world") == "physics" && member_of(was, "fingerprint") != member_of(is, "fingerprint"))
    warnings.push_back("the run was made on a machine whose physics differs in small things from this one's");
  return warnings;
}

class SessionWhatIf : public RunWhatIf {
 public:
  Result<Replayed> replay(const RunIndex& run, const WhatIfRequest& request, const std::string& folder,
                          const std::atomic<bool>& stop) override {
    WhatIfFiles files(run, request, folder);
    if (auto wrong = files.make()) return *wrong;
    auto session = load(files.trace(), files.options(), stop);
    if (!session) return session.error();
    if (auto wrong = unknown_transition(session->machine(), request)) return *wrong;
    const auto path = (fs::path(folder) / "what_if.run.jsonl").string();
    const auto ran = write_run(*session, path, stop);
    if (!ran) return ran.error();
    const auto& summary = *ran;
    for (const auto& [step, transition] : summary.not_forced)
      if (request.forced.count(step))
        return Error{"", fmt::format("step {}: the transition '{}' does not apply there", step, transition)};
    const auto fresh = RunIndex::open(path);
    if (!fresh) return fresh.error();
    const auto& header = fresh->header();
    if (!header) return header.error();
    return Replayed{path, warnings_of(files.header(), *header)};
  }

  Result<Replayed> replay_trace(const std::string& trace, const std::string& folder,
                                const std::atomic<bool>& stop) override {
    const auto read = read_trace(trace);
    if (!read) return read.error();
    const auto& header = read->header;
    for (const auto& [what, name] : {std::pair("scene", header.scene), std::pair("machine", header.machine),
                                     std::pair("language", header.language)})
      if (!is_plain_name(name))
        return Error{trace, fmt::format("its {} is {}; expected one of the program's own: a file can be named on a "
                                        "command line (continua replay)",
                                        what, in_quotes(name))};
    if (!read->events.empty() && read->events.back().t.seconds() > longest_physics_s)
      return Error{trace, fmt::format("it takes {} s; expected at most {} s", read->events.back().t.seconds(),
                                      longest_physics_s)};
    auto session = load(trace, {}, stop);
    if (!session) return session.error();
    const auto path = (fs::path(folder) / fmt::format("{}.run.jsonl", trace_name(trace))).string();
    const auto ran = write_run(*session, path, stop);
    if (!ran) return ran.error();
    return Replayed{path, {}};
  }

 private:
  static Result<Session> load(const std::string& trace, ReplayOptions options, const std::atomic<bool>& stop) {
    const auto deadline = std::chrono::steady_clock::now() + longest_replay;
    options.give_up = [&stop, deadline] { return stop || std::chrono::steady_clock::now() > deadline; };
    return Session::load(trace, options);
  }

  // Writes the log to its end, within the limits.
  static Result<ReplaySummary> write_run(Session& session, const std::string& path, const std::atomic<bool>& stop) {
    std::ofstream log(path, std::ios::binary);
    bool too_long = false;
    const auto watch = [&](const Situation&) {
      too_long = too_long || static_cast<std::uintmax_t>(std::max<std::streamoff>(log.tellp(), 0)) > largest_log;
      return too_long || stop;
    };
    auto summary = session.run(log, watch);
    log.close();
    if (stop) return Error{"", "the server ends"};
    if (too_long || session.options().give_up())
      return Error{"", "the replay takes longer, or writes more, than is served here; it was given up"};
    if (!log) return Error{path, "could not be written to its end"};
    if (summary.stopped) return *summary.stopped;
    return summary;
  }

  static Outcome unknown_transition(const Machine& machine, const WhatIfRequest& request) {
    for (const auto& [step, id] : request.forced)
      if (std::none_of(machine.transitions.begin(), machine.transitions.end(),
                       [&id = id](const Transition& transition) { return transition.id == id; }))
        return Error{"", fmt::format("step {}: the machine has no transition {}", step, in_quotes(id))};
    return std::nullopt;
  }
};

}  // namespace

std::shared_ptr<RunWhatIf> replayed_what_if() { return std::make_shared<SessionWhatIf>(); }

}  // namespace continua
