#include "term/raising_file.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/located_json.h"

namespace continua {
namespace {

// Reads until the first problem.
class Reader {
 public:
  Reader(const LocatedJson& document, const Signature& names) : document_(document), names_(names) {}

  Result<RaisingRules> read() {
    const Json& root = document_.root();
    if (has_shape(root, "", "raising rules", {"raising", "about", "programs", "rules"}, {"raising", "rules"})) {
      if (root["raising"] != 1) fail("/raising", "found another version of the format, expected 1");
      if (root.contains("programs")) read_programs(root["programs"]);
      if (!root["rules"].is_array()) fail("/rules", "expected the rules, a list");
    }
    RaisingRules rules;
    for (std::size_t i = 0; !error_ && i < root["rules"].size(); ++i) {
      rules.push_back(read_rule(root["rules"][i], "/rules/" + std::to_string(i)));
      for (std::size_t j = 0; j < i; ++j)
        if (rules[j].name == rules[i].name)
          fail(fmt::format("/rules/{}/name", i), fmt::format("{} is another rule's name", in_quotes(rules[i].name)));
    }
    if (error_) return *error_;
    return rules;
  }

 private:
  void fail(const std::string& pointer, std::string sentence) {
    if (!error_) error_ = document_.error(pointer, std::move(sentence));
  }

  bool has_shape(const Json& json, const std::string& pointer, const char* what, std::vector<std::string> keys,
                 std::initializer_list<const char*> required) {
    if (!json.is_object()) return fail(pointer, fmt::format("expected {}, an object", what)), false;
    for (const auto& [key, value] : json.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        fail(pointer, fmt::format("unknown key {} of {}{}", in_quotes(key), what, did_you_mean(key, keys)));
    for (const char* key : required)
      if (!json.contains(key)) fail(pointer, fmt::format("there is no \"{}\" in {}", key, what));
    return !error_;
  }

  std::string text(const Json& json, const std::string& pointer, const char* what) {
    if (!json.is_string() || json.get<std::string>().empty()) fail(pointer, fmt::format("expected {}, a string", what));
    return json.is_string() ? json.get<std::string>() : std::string();
  }

  void fail_in_text(const std::string& pointer, const Error& error) {
    constexpr std::string_view prefix = "column ";
    require(error.where.starts_with(prefix), "an error in a text names its column");
    if (!error_)
      error_ = document_.error(document_.place_in_text(pointer, std::stoul(error.where.substr(prefix.size())) - 1),
                               error.sentence);
  }

  Type read_type(const Json& json, const std::string& pointer) {
    const auto type = Type::parse(text(json, pointer, "a type"));
    if (type) return *type;
    fail_in_text(pointer, type.error());
    return Type::term();
  }

  Term read_term(const Json& json, const std::string& pointer, const Type& expected) {
    const auto term = parse_term(text(json, pointer, "a term"), names_, expected);
    if (term) return *term;
    fail_in_text(pointer, term.error());
    return Term();
  }

  void read_programs(const Json& programs) {
    if (!programs.is_object()) return fail("/programs", "expected programs, an object");
    for (const auto& [name, value] : programs.items()) {
      const auto pointer = "/programs/" + escaped(name);
      const auto type = read_type(value, pointer);
      if (const auto [known, added] = names_.emplace(name, type); !added && !(known->second == type))
        fail(pointer, fmt::format("{} is known already, with the type {}", in_quotes(name), known->second.text()));
    }
  }

  // As part of a JSON pointer (RFC 6901).
  static std::string escaped(const std::string& key) {
    std::string result;
    for (const char c : key) result += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return result;
  }

  RaisingRule read_rule(const Json& json, const std::string& at) {
    RaisingRule rule;
    if (!has_shape(json, at, "a rule", {"name", "about", "from", "to", "when", "by"}, {"name", "from", "to", "by"}))
      return rule;
    rule.name = text(json["name"], at + "/name", "the rule's name");
    rule.from = read_type(json["from"], at + "/from");
    rule.to = read_type(json["to"], at + "/to");
    if (json.contains("when"))
      rule.when = read_term(json["when"], at + "/when", Type::function(rule.from, Type::truth()));
    rule.by = read_term(json["by"], at + "/by", Type::function(rule.from, rule.to));
    return rule;
  }

  const LocatedJson& document_;
  Signature names_;
  std::optional<Error> error_;
};

Result<RaisingRules> read(const Result<LocatedJson>& document, const Signature& names) {
  if (!document) return document.error();
  return Reader(*document, names).read();
}

}  // namespace

Result<RaisingRules> load_raising(const std::string& path, const Signature& names) {
  return read(LocatedJson::read(path), names);
}

Result<RaisingRules> parse_raising(std::string_view text, const std::string& name, const Signature& names) {
  return read(LocatedJson::parse(text, name), names);
}

}  // namespace continua
