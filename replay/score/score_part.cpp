#include "continua/replay/score/score_part.h"

namespace continua {
namespace {

Score score_of(const Json& json) {
  const auto count = [&](const char* name) { return json.at(name).get<int>(); };
  return {.inputs = count("inputs"),
          .speaking = count("speaking"),
          .exact = count("exact"),
          .lax = count("lax"),
          .same_template = count("template"),
          .answered = count("answered"),
          .spurious = count("spurious"),
          .right = count("right"),
          .samples = count("samples"),
          .silent_samples = count("silent_samples")};
}

std::vector<AvatarMove> moves_of(const Json& list) {
  std::vector<AvatarMove> moves;
  for (const auto& move : list) moves.push_back({move.at("channel"), move.at("content")});
  return moves;
}

Episode miss_of(const Json& json) {
  Episode miss;
  miss.t = SimTime::from_seconds(json.at("t"));
  miss.line = json.at("line");
  miss.n = json.at("record");
  miss.symbol = json.at("input");
  miss.observed = moves_of(json.at("observed"));
  miss.produced = moves_of(json.at("produced"));
  miss.level = AgreementLevel::none;
  for (const auto level : {AgreementLevel::same_template, AgreementLevel::lax, AgreementLevel::exact})
    if (json.at("level") == name_of(level)) miss.level = level;
  return miss;
}

TraceScore trace_of(const Json& json) {
  TraceScore trace{json.at("trace"),
                   json.at("path"),
                   json.at("run").is_null() ? std::string() : json.at("run").get<std::string>(),
                   score_of(json),
                   {},
                   {}};
  for (const auto& kind : json.at("kinds")) {
    auto& score = trace.kinds[kind.at("kind")];
    score.speaking = kind.at("speaking");
    score.exact = kind.at("exact");
    score.lax = kind.at("lax");
    score.same_template = kind.at("template");
  }
  for (const auto& miss : json.at("misses")) trace.misses.push_back(miss_of(miss));
  return trace;
}

}  // namespace

std::string text_of_part(const std::string& variant, const std::optional<TraceScore>& trace) {
  Json json{{"variant", variant}};
  if (trace) {
    json["score"] = json_of(*trace);
    json["score"]["path"] = trace->trace;
  }
  return compact(json);
}

Outcome add_part(ScoreReport& report, const std::string& text) {
  try {
    const auto json = Json::parse(text);
    report.variant = json.at("variant");
    if (json.contains("score")) report.traces.push_back(trace_of(json["score"]));
    return std::nullopt;
  } catch (const Json::exception&) {
    return Error{"--merge", "found " + in_quotes(text) + "; expected the score of a trace"};
  }
}

}  // namespace continua
