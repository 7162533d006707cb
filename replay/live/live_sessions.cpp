#include "continua/replay/live/live_sessions.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/live/hand_model.h"
#include "continua/replay/live/live_trace.h"
#include "continua/replay/session/live_setup.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_live = 8;
constexpr double least_speed = 0.01, most_speed = 100;
constexpr std::size_t longest_name = 64;

const std::vector<std::string> fields = {"scene",   "machine", "language", "seed", "perspective", "objects",
                                         "physics", "clock",   "speed",    "name", "recorder",    "after"};

LiveRefusal bad(const std::string& name, const Json& found, const std::string& expected) {
  return {400, fmt::format("'{}' is {}; expected {}", name, in_quotes(compact(found)), expected)};
}

// A session that goes on with that of the trace.
Result<std::shared_ptr<LiveSession>> go_on(LiveOptions options, const std::string& trace, const std::string& folder,
                                           std::optional<bool> physics) {
  auto before = read_before(trace, folder);
  if (!before) return before.error();
  options.header = std::move(before->header);
  options.replay.physics = physics.value_or(options.replay.physics);
  return LiveSession::start(std::move(options), before->events);
}

bool is_among(const Json& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool is_file_name(const std::string& name) {
  return !name.empty() && name.size() <= longest_name &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

Result<std::shared_ptr<LiveSessions>> LiveSessions::create(LiveDefaults defaults) {
  auto data = find_data_paths(defaults.replay.knowledge);
  if (!data) return data.error();
  auto setup = live_setup(*data);
  if (!setup) return setup.error();
  (*setup)["hands"] = hand_model_folder().has_value();
  for (const auto& [field, own] : {std::pair("scene", &defaults.scene), std::pair("machine", &defaults.machine)}) {
    if (own->empty()) continue;
    (*setup)[field] = *own;
    auto& names = (*setup)[std::string(field) + "s"];
    if (!is_among(names, *own)) names.insert(names.begin(), *own);
  }
  return std::shared_ptr<LiveSessions>(new LiveSessions(std::move(defaults), *std::move(setup)));
}

LiveSessions::LiveSessions(LiveDefaults defaults, Json setup)
    : defaults_(std::move(defaults)), setup_(std::move(setup)), after_(defaults_.after) {}

std::variant<LiveOptions, LiveRefusal> LiveSessions::options_of(const Json& asked, bool any_file) const {
  if (!asked.is_object()) return LiveRefusal{400, "expected an object: {\"scene\": …, \"machine\": …}"};
  // A trace's header may say more than is asked for.
  const bool is_header = asked.contains("kind") && asked["kind"] == "trace";
  for (const auto& [key, value] : asked.items())
    if (!is_header && std::find(fields.begin(), fields.end(), key) == fields.end())
      return LiveRefusal{400, fmt::format("unknown field {}{}; expected {}", in_quotes(key), did_you_mean(key, fields),
                                          fmt::join(fields, ", "))};
  LiveOptions options;
  options.replay = defaults_.replay;
  options.timing = defaults_.timing;
  options.speed = defaults_.speed;
  options.durable = defaults_.durable;

  Json header{{"kind", "trace"}, {"version", is_header && asked.contains("version") ? asked["version"] : Json(1)}};
  if (defaults_.replay.seed) header["seed"] = *defaults_.replay.seed;
  if (!defaults_.replay.language.empty()) header["language"] = defaults_.replay.language;
  if (!defaults_.replay.settings.empty()) header["parameters"] = defaults_.replay.settings;
  for (const char* field : {"language", "seed", "perspective", "objects"})
    if (asked.contains(field)) header[field] = asked[field];
  for (const std::string field : {"scene", "machine"}) {
    const Json name = asked.contains(field) ? asked[field] : setup_[field];
    const Json& names = setup_[field + "s"];
    if (!name.is_string() || !(any_file || is_among(names, name)))
      return bad(field, name, fmt::format("one of {}", fmt::join(names.get<std::vector<std::string>>(), ", ")));
    header[field] = name;
  }
  auto read = read_trace_text(compact(header), "session");
  if (!read) return LiveRefusal{400, read.error().sentence};
  options.header = std::move(read->header);
  options.header.json = nullptr;
  options.replay.seed.reset();
  options.replay.language.clear();
  options.replay.settings = Json::object();

  if (const auto physics = asked.find("physics"); physics != asked.end()) {
    if (!physics->is_boolean()) return bad("physics", *physics, "true or false");
    options.replay.physics = *physics;
  }
  if (const auto clock = asked.find("clock"); clock != asked.end()) {
    if (*clock != "wall" && *clock != "events") return bad("clock", *clock, "\"wall\" or \"events\"");
    options.timing = *clock == "wall" ? LiveTiming::wall : LiveTiming::events;
  }
  if (const auto speed = asked.find("speed"); speed != asked.end()) {
    if (!speed->is_number() || *speed < least_speed || *speed > most_speed)
      return bad("speed", *speed, fmt::format("a number from {} to {}", least_speed, most_speed));
    options.speed = *speed;
  }
  if (const auto recorder = asked.find("recorder"); recorder != asked.end()) {
    if (!recorder->is_string()) return bad("recorder", *recorder, "a text");
    options.recorder = *recorder;
  }
  return options;
}

// Those that ended by themselves leave a thread, which takes memory until it is joined. Where so many are live as may
// be, those that wait for a recorder who has gone away end now.
void LiveSessions::make_room() {
  std::vector<std::shared_ptr<LiveSession>> ended, live;
  for (const auto& one : all()) (one.session->audience().state().live ? live : ended).push_back(one.session);
  for (const auto& session : ended) session->end();
  if (live.size() < most_live) return;
  for (const auto& session : live)
    if (session->is_left()) session->end();
}

// Of scene and machine, which may be paths, as the trace is to name them. Gives the session's id.
std::optional<std::string> LiveSessions::take_place(LiveOptions& options, const std::string& name) {
  for (auto* path : {&options.header.scene, &options.header.machine})
    if (std::error_code problem; path->find('/') != std::string::npos || fs::is_regular_file(*path, problem)) {
      const auto nearer = fs::proximate(*path, defaults_.folder, problem);
      if (!problem) *path = nearer.string();
    }
  const std::lock_guard lock(mutex_);
  const auto live = std::count_if(sessions_.begin(), sessions_.end(),
                                  [](const ListedSession& one) { return one.session->audience().state().live; });
  if (sessions_.size() >= defaults_.most_begun) return std::nullopt;
  if (taken_.size() - sessions_.size() + static_cast<std::size_t>(live) >= most_live) return std::nullopt;
  for (int number = 1;; ++number) {
    const auto id = number == 1 ? name : fmt::format("{}-{}", name, number);
    const auto path = (fs::path(defaults_.folder) / id).lexically_normal();
    options.trace_path = path.string() + defaults_.ending;
    options.log_path = path.string() + ".run.jsonl";
    std::error_code problem;
    if (taken_.contains(id) || fs::exists(options.trace_path, problem) || fs::exists(options.log_path, problem))
      continue;
    taken_.insert(id);
    return id;
  }
}

std::variant<ListedSession, LiveRefusal> LiveSessions::start(const Json& asked, bool any_file,
                                                             std::optional<WallTime> began) {
  auto found = options_of(asked, any_file);
  if (auto* refusal = std::get_if<LiveRefusal>(&found)) return std::move(*refusal);
  auto& options = std::get<LiveOptions>(found);
  options.began = began;
  const Json name = asked.contains("name") ? asked["name"] : Json(defaults_.name);
  if (!name.is_string() || (asked.contains("name") && !is_file_name(name)))
    return bad("name", name, fmt::format("1 to {} letters, digits, _ or -", longest_name));
  const auto after = after_of(asked);
  if (const auto* refusal = std::get_if<LiveRefusal>(&after)) return *refusal;
  return begin(std::move(options), name, std::get<std::optional<After>>(after));
}

// The session that is gone on with, if any.
std::variant<std::optional<LiveSessions::After>, LiveRefusal> LiveSessions::after_of(const Json& asked) {
  if (const auto named = asked.find("after"); named != asked.end()) {
    const auto ended = named->is_string() ? find(*named) : std::nullopt;
    if (!ended || ended->session->audience().state().live)
      return bad("after", *named, "the id of a session that has ended");
    const auto& own = ended->session->setting().options;
    return After{ended->id, own.trace_path, own.replay.physics};
  }
  const std::lock_guard lock(mutex_);
  if (after_.empty()) return std::optional<After>();
  return After{trace_name(after_), std::exchange(after_, {}), std::nullopt};
}

std::string LiveSessions::next_after() const {
  const std::lock_guard lock(mutex_);
  return after_.empty() ? after_ : trace_name(after_);
}

std::variant<ListedSession, LiveRefusal> LiveSessions::begin(LiveOptions options, const std::string& name,
                                                             const std::optional<After>& after) {
  std::error_code problem;
  fs::create_directories(defaults_.folder, problem);
  make_room();
  const bool named = !after || name != defaults_.name || !defaults_.after.empty();
  const auto id = take_place(options, named ? name : after->name);
  if (!id)
    return LiveRefusal{503, fmt::format("there are {} live sessions, or {} were begun; end one first, or the program",
                                        most_live, defaults_.most_begun)};
  const auto log_path = options.log_path;
  auto session = after ? go_on(std::move(options), after->trace, defaults_.folder, after->physics)
                       : LiveSession::start(std::move(options));
  if (!session) {
    const std::lock_guard lock(mutex_);
    taken_.erase(*id);
    return LiveRefusal{422, session.error().text()};
  }
  const ListedSession listed{*id, publish_ ? publish_(*id, log_path) : "", *std::move(session)};
  const std::lock_guard lock(mutex_);
  sessions_.push_back(listed);
  return listed;
}

std::optional<ListedSession> LiveSessions::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  for (const auto& one : sessions_)
    if (one.id == id) return one;
  return std::nullopt;
}

std::optional<ListedSession> LiveSessions::newest() const {
  const std::lock_guard lock(mutex_);
  for (auto one = sessions_.rbegin(); one != sessions_.rend(); ++one)
    if (one->session->audience().state().live) return *one;
  return std::nullopt;
}

std::vector<ListedSession> LiveSessions::all() const {
  const std::lock_guard lock(mutex_);
  return sessions_;
}

bool LiveSessions::is_live(const std::string& log_path) const {
  const auto sessions = all();
  std::error_code problem;
  return std::any_of(sessions.begin(), sessions.end(), [&](const ListedSession& one) {
    return one.session->audience().state().live &&
           fs::equivalent(one.session->setting().options.log_path, log_path, problem);
  });
}

void LiveSessions::end() {
  for (const auto& one : all()) one.session->end();
}

}  // namespace continua
