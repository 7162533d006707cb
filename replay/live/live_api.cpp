#include "continua/replay/live/live_api.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/replay/live/live_save.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

constexpr double events_per_s = 2000, most_at_once = 4000;
constexpr std::string_view below = "/api/sessions";

// ID and the rest of "/api/sessions/ID/WHAT".
std::pair<std::string, std::string> parts_of(std::string_view path) {
  path.remove_prefix(std::min(path.size(), below.size() + 1));
  const auto slash = std::min(path.find('/'), path.size());
  return {std::string(path.substr(0, slash)),
          slash < path.size() ? std::string(path.substr(slash + 1)) : std::string()};
}

ApiResponse unknown_session(const std::string& id) {
  return api_error(404, fmt::format("there is no session {}", in_quotes(id)));
}

// An empty body asks for nothing in particular.
Result<Json> asked_in(std::string_view body) {
  if (body.find_first_not_of(" \t\r\n") == std::string_view::npos) return Json::object();
  auto json = parse_json_line(body, "body", 1);
  if (json && !json->is_object()) return Error{"body", "expected an object"};
  return json;
}

}  // namespace

Json session_json(const ListedSession& listed, const LiveSessions& sessions) {
  const auto& session = *listed.session;
  const auto state = session.audience().state();
  const auto t = std::max(state.t, state.clock.at(std::chrono::steady_clock::now()));
  Json json{{"id", listed.id},
            {"run", listed.run},
            {"trace", session.setting().options.trace_path},
            {"t", t.seconds()},
            {"clock", state.timing == LiveTiming::wall     ? Json("wall")
                      : state.timing == LiveTiming::events ? Json("events")
                                                           : Json()},
            {"speed", state.clock.speed()},
            {"paused", state.live && state.timing == LiveTiming::wall && !state.clock.runs()},
            {"live", state.live},
            {"scene", session.setting().scene},
            {"machine", session.setting().machine},
            {"state", state.machine_state},
            {"viewers", session.audience().viewers()},
            {"gestures", *session.setting().palette},
            {"buttons", sessions.setup()["buttons"]},
            {"hands", sessions.setup()["hands"]}};
  if (session.setting().warning) json["warning"] = session.setting().warning->text();
  if (state.broke) json["broke"] = state.broke->text();
  return json;
}

ApiResponse LiveApi::get(std::string_view target) {
  const auto path = split_target(target).path;
  if (path == below) {
    Json body = sessions_->setup();
    if (const auto after = sessions_->next_after(); !after.empty()) body["after"] = after;
    body["sessions"] = Json::array();
    for (const auto& one : sessions_->all()) {
      body["sessions"].push_back(session_json(one, *sessions_));
      for (const char* known : {"gestures", "buttons"}) body["sessions"].back().erase(known);
    }
    return answer(body);
  }
  const auto [id, what] = parts_of(path);
  const auto listed = sessions_->find(id);
  if (!listed) return unknown_session(id);
  if (!what.empty()) return api_error(405, "this address takes a POST");
  return answer(session_json(*listed, *sessions_));
}

ApiResponse LiveApi::post(std::string_view target, std::string_view body) {
  const auto [path, query] = split_target(target);
  if (path == below) {
    const auto asked = asked_in(body);
    if (!asked) return api_error(400, asked.error().text());
    const auto started = sessions_->start(*asked);
    if (const auto* refusal = std::get_if<LiveRefusal>(&started)) return api_error(refusal->status, refusal->sentence);
    return answer(session_json(std::get<ListedSession>(started), *sessions_), 201);
  }
  const auto [id, what] = parts_of(path);
  const auto listed = sessions_->find(id);
  if (!listed) return unknown_session(id);
  auto& session = *listed->session;
  const auto& recorder = session.setting().options.recorder;
  const auto named = query.find("recorder");
  if (what != "save" && !recorder.empty() && (named == query.end() || named->second != recorder))
    return api_error(409, "somebody else records into this session");
  if (what == "events") return events(*listed, query, body);
  if (what == "media") return media(*listed, query, body);
  if (what == "end") {
    session.end();
    return answer(session_json(*listed, *sessions_));
  }
  const auto asked = asked_in(body);
  if (!asked) return api_error(400, asked.error().text());
  if (what == "save") return save(*listed, *asked);
  if (what == "away") {
    const auto gone = asked->find("gone");
    if (gone == asked->end() || !gone->is_boolean()) return api_error(400, "expected {\"gone\": true or false}");
    session.away(*gone);
    return answer(session_json(*listed, *sessions_));
  }
  if (what != "pause") return api_error(404, fmt::format("there is nothing at {}", path));
  const auto paused = asked->find("paused");
  if (paused == asked->end() || !paused->is_boolean()) return api_error(400, "expected {\"paused\": true or false}");
  if (const auto refused = session.pause(*paused)) return api_error(409, refused->sentence);
  return answer(session_json(*listed, *sessions_));
}

ApiResponse LiveApi::events(const ListedSession& listed, const Query& query, std::string_view body) {
  const auto events = events_in(body);
  if (!events) return api_error(400, events.error().text());
  if (!listed.session->audience().state().live) return api_error(409, "the session has ended");
  if (static_cast<double>(events->size()) > most_at_once)
    return api_error(413, fmt::format("found {} events; expected at most {} at a time", events->size(), most_at_once));
  if (!admits(listed.id, events->size()))
    return api_error(429, fmt::format("more than {} events a second; try again in a second", events_per_s));
  const auto batch = query.find("batch");
  const auto reply = listed.session->receive(*events, batch == query.end() ? "" : batch->second);
  if (!reply) {
    const auto state = listed.session->audience().state();
    return api_error(state.broke ? 500 : state.live ? 400 : 409, reply.error().text());
  }
  // Records of the log as they are: they need not be read to be handed on.
  auto text = fmt::format(R"({{"accepted":{},"t":{},"moves":[)", reply->accepted, compact(reply->t.seconds()));
  for (std::size_t i = 0; i < reply->moves.size(); ++i) text += (i ? "," : "") + reply->moves[i];
  return {200, "application/json", text + "]}"};
}

ApiResponse LiveApi::media(const ListedSession& listed, const Query& query, std::string_view body) {
  const auto text = [&](const char* name) {
    const auto found = query.find(name);
    return found == query.end() ? std::string() : found->second;
  };
  const auto take = number_in<std::uint64_t>(text("take")), part = number_in<std::uint64_t>(text("part"));
  const auto t = number_in<double>(text("t"));
  if (!take || !part || !t || !(*t >= 0 && *t <= trace_time_limit_s))
    return api_error(400, "expected take and part, numbers, and t, seconds");
  if (body.empty()) return api_error(400, "expected bytes of a recording");
  if (!listed.session->audience().state().live) return api_error(409, "the session has ended");
  const MediaPart given{text("source"), text("type"), *take, *part, SimTime::from_seconds(*t), body};
  if (const auto refused = listed.session->media().add(given)) return api_error(400, refused->sentence);
  return answer(Json{{"accepted", body.size()}});
}

bool LiveApi::admits(const std::string& id, std::size_t events) {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  const auto [known, is_new] = allowances_.try_emplace(id, Allowance{most_at_once, now});
  auto& [left, at] = known->second;
  left = std::min(most_at_once, left + std::chrono::duration<double>(now - at).count() * events_per_s);
  at = now;
  if (static_cast<double>(events) > left) return false;
  left -= static_cast<double>(events);
  return true;
}

ApiResponse LiveApi::save(const ListedSession& listed, const Json& asked) {
  const auto name = asked.find("name");
  if (name == asked.end() || !name->is_string() || !is_file_name(*name))
    return api_error(400, "expected {\"name\": a word of letters, digits, _ and -}");
  const auto& defaults = sessions_->defaults();
  const auto saved =
      save_as_test(listed.session->setting().options.trace_path, defaults.tests, *name, defaults.replay.knowledge);
  if (!saved) return api_error(409, saved.error().text());
  if (defaults.say) defaults.say(fmt::format("Saved as a test: {}", saved->check));
  return answer({{"trace", saved->trace}, {"runs", saved->runs}, {"check", saved->check}}, 201);
}

}  // namespace continua
