#include "continua/replay/coverage/coverage_part.h"

#include "continua/core/located_json.h"

namespace continua {

std::string text_of_part(const std::optional<MachineCoverage>& run) {
  if (!run) return "{}";
  Json json{{"name", run->name},       {"digest", run->digest},
            {"lexicon", run->lexicon}, {"lexicon_digest", run->lexicon_digest},
            {"runs", run->runs},       {"kinds", Json::array()}};
  for (const auto& kind : run->kinds) {
    Json items = Json::array();
    for (const auto& item : kind.items) items.push_back({item.name, item.outcome, item.what, item.count});
    json["kinds"].push_back({{"kind", kind.name}, {"of_knowledge", kind.of_knowledge}, {"items", std::move(items)}});
  }
  return compact(json);
}

Outcome add_part(std::vector<MachineCoverage>& runs, const std::string& text) {
  try {
    const auto json = Json::parse(text);
    if (json.empty()) return std::nullopt;
    MachineCoverage run{json.at("name"),           json.at("digest"), json.at("lexicon"),
                        json.at("lexicon_digest"), json.at("runs"),   {}};
    for (const auto& kind : json.at("kinds")) {
      run.kinds.push_back({kind.at("kind"), {}, kind.at("of_knowledge")});
      for (const auto& item : kind.at("items"))
        run.kinds.back().items.push_back({item.at(0), item.at(1), item.at(2), item.at(3)});
    }
    runs.push_back(std::move(run));
    return std::nullopt;
  } catch (const Json::exception&) {
    return Error{"--merge", "found " + in_quotes(text) + "; expected the coverage of a run"};
  }
}

}  // namespace continua
