#include "continua/replay/annotation/tier_map.h"

#include <algorithm>
#include <cctype>

#include "continua/core/characters.h"
#include "continua/core/read_document.h"

namespace continua {
namespace {

const std::vector<std::string> kinds = {"speech",   "words", "gesture", "pointing", "gaze",
                                        "observed", "mark",  "expect",  "event"};
const std::vector<std::string> channels = {"speech", "gesture", "action"};
const std::vector<std::string> gesture_parts = {"hand", "name", "direction", "phase", "target"};

std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const bool letter = i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) ||
                                            static_cast<unsigned char>(text[i]) >= 0x80);
    const bool hump = letter && i > 0 && std::isupper(static_cast<unsigned char>(text[i])) &&
                      std::islower(static_cast<unsigned char>(text[i - 1]));
    if ((!letter || hump) && !word.empty()) words.push_back(std::exchange(word, ""));
    if (letter) word += text[i];
  }
  return words;
}

TierUse read_use(const Item& item) {
  TierUse use;
  if (!item.exists() || item.json().is_null()) return use;
  if (!item.expect_object("a tier", {"kind", "channel", "value", "phases", "values", "set"})) return use;
  use.kind = item.required("kind", "the kind of its events").one_of(kinds).value_or("");
  use.channel = item.member("channel").one_of(channels).value_or("");
  if (use.kind == "observed" && use.channel.empty() && !item.member("channel").exists())
    item.problem("there is no \"channel\"; expected speech, gesture or action, since the tier is observed");
  if (item.member("value").exists()) {
    use.parts = words_in(item.member("value").text("the parts of a label, such as \"hand name direction\""));
    for (const auto& part : use.parts)
      if (std::find(gesture_parts.begin(), gesture_parts.end(), part) == gesture_parts.end())
        item.member("value").problem(item.unknown("part", part, gesture_parts) + "; expected " + any_of(gesture_parts));
  }
  use.phases = item.member("phases").truth(false);
  if (const auto values = item.member("values"); values.exists())
    for (const auto& [label, meant] : values.members("labels")) use.values[label] = meant.text("the label to read");
  if (const auto set = item.member("set"); set.exists())
    for (const auto& [name, value] : set.members("members of events")) use.set[name] = value.json();
  return use;
}

TierMap read_map(const Item& root) {
  TierMap map;
  if (!root.expect_object("a map of tiers", {"about", "header", "tiers"})) return map;
  if (const auto header = root.member("header"); header.exists())
    for (const auto& [name, value] : header.members("members of a trace's header")) map.header[name] = value.json();
  for (const auto& [name, item] : root.required("tiers", "an object {TIER: {\"kind\": …}}").members("tiers"))
    map.tiers.emplace_back(name, read_use(item));
  return map;
}

TierNames read_names(const Item& root) {
  TierNames names;
  if (!root.expect_object("names of tiers", {"about", "tier_names", "avatar", "kinds"})) return names;
  root.expect_version("tier_names", 1);
  names.avatar = root.required("avatar", "a list of words").texts("words");
  for (const auto& [kind, item] : root.required("kinds", "an object {KIND: [WORD]}").members("kinds")) {
    const auto& known = kind == "action" ? channels : kinds;
    if (std::find(known.begin(), known.end(), kind) == known.end())
      item.problem_at_key(item.unknown("kind", kind, kinds));
    names.of_kinds.emplace_back(kind, item.texts("words"));
  }
  return names;
}

bool has_any(const std::vector<std::string>& words, const std::vector<std::string>& beginnings) {
  return std::any_of(words.begin(), words.end(), [&](const auto& word) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](const auto& one) { return word.starts_with(one); });
  });
}

// The use of a tier that an export made; the avatar's own side is not of the trace.
std::optional<TierUse> use_of_own(const std::string& name) {
  const auto space = name.find(' ');
  const auto who = name.substr(0, space), rest = space == std::string::npos ? "" : name.substr(space + 1);
  if (who == "human" && rest != "words" && std::find(kinds.begin(), kinds.end(), rest) != kinds.end())
    return TierUse{.kind = rest, .channel = {}};
  if (who == "observed" && std::find(channels.begin(), channels.end(), rest) != channels.end())
    return TierUse{.kind = "observed", .channel = rest};
  if (name == "mark" || name == "expect") return TierUse{.kind = name, .channel = {}};
  return std::nullopt;
}

TierUse use_by_words(const std::string& name, const std::string& participant, const TierNames& names) {
  auto words = words_in(name + " " + participant);
  for (auto& word : words) word = folded(word);
  const auto found = std::find_if(names.of_kinds.begin(), names.of_kinds.end(),
                                  [&](const auto& kind) { return has_any(words, kind.second); });
  if (found == names.of_kinds.end()) return {};
  const auto& kind = found->first;
  const bool deed = kind == "gesture" || kind == "pointing" || kind == "gaze";
  const bool observed = has_any(words, names.avatar) && kind != "mark";
  if (observed && kind == "words") return {};
  if (observed) return TierUse{.kind = "observed", .channel = deed ? "gesture" : kind};
  return kind == "action" ? TierUse{} : TierUse{.kind = kind, .channel = {}};
}

}  // namespace

std::vector<Error> tier_map_problems(std::string_view text, const std::string& name) {
  return problems_of_document(text, name, read_map);
}
Result<TierMap> parse_tier_map(std::string_view text, const std::string& name) {
  return parsed_document(text, name, read_map);
}

std::vector<Error> tier_names_problems(std::string_view text, const std::string& name) {
  return problems_of_document(text, name, read_names);
}
Result<TierNames> parse_tier_names(std::string_view text, const std::string& name) {
  return parsed_document(text, name, read_names);
}

TierMap guessed_map(const Annotations& annotations, const TierNames& names) {
  TierMap map;
  for (const auto& tier : annotations.tiers) {
    const auto own = use_of_own(tier.name);
    const bool events = std::any_of(tier.annotations.begin(), tier.annotations.end(),
                                    [](const auto& annotation) { return annotation.event.is_object(); });
    map.tiers.emplace_back(tier.name, own                           ? *own
                                      : events                      ? TierUse{.kind = "event", .channel = {}}
                                      : !annotations.header.empty() ? TierUse{}
                                                                    : use_by_words(tier.name, tier.participant, names));
  }
  return map;
}

std::string print(const TierMap& map) {
  Json tiers = Json::object();
  for (const auto& [name, use] : map.tiers) {
    if (use.kind.empty()) {
      tiers[name] = nullptr;
      continue;
    }
    tiers[name]["kind"] = use.kind;
    if (!use.channel.empty()) tiers[name]["channel"] = use.channel;
  }
  return Json{{"header", map.header}, {"tiers", tiers}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace continua
