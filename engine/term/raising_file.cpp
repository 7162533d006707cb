#include "continua/term/raising_file.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "continua/core/document_reader.h"
#include "continua/term/read_type.h"

namespace continua {
namespace {

Term read_term(const Item& item, const Signature& names, const Type& expected) {
  const auto text = item.name("a term");
  if (text.empty()) return Term();
  const auto term = parse_term(text, names, expected);
  if (term) return *term;
  item.problem_in_text(term.error());
  return Term();
}

// `names` with the file's programs.
Signature with_programs(const Item& programs, Signature names) {
  for (const auto& [name, item] : programs.members("programs")) {
    const auto type = read_type(item);
    if (const auto [known, added] = names.emplace(name, type); !added && !(known->second == type))
      item.problem(fmt::format("{} is known already, with the type {}", in_quotes(name), known->second.text()));
  }
  return names;
}

RaisingRule read_rule(const Item& item, const Signature& names) {
  RaisingRule rule;
  if (!item.expect_object("a rule", {"name", "about", "from", "to", "when", "by"})) return rule;
  rule.name = item.required("name", "the rule's name").name("the rule's name");
  const auto from = item.required("from", "the type that is raised");
  const auto to = item.required("to", "the type that it is raised to");
  const auto by = item.required("by", "the function that raises, a term");
  if (!from.exists() || !to.exists()) return rule;
  rule.from = read_type(from);
  rule.to = read_type(to);
  if (const auto when = item.member("when"); when.exists())
    rule.when = read_term(when, names, Type::function(rule.from, Type::truth()));
  rule.by = read_term(by, names, Type::function(rule.from, rule.to));
  return rule;
}

Result<RaisingRules> read(const Result<LocatedJson>& document, const Signature& names) {
  if (!document) return document.error();
  DocumentReader reader;
  const auto root = reader.root(*document);
  RaisingRules rules;
  if (root.expect_object("raising rules", {"raising", "about", "programs", "rules"})) {
    root.expect_version("raising", 1);
    const auto known = with_programs(root.member("programs"), names);
    const auto items = root.required("rules", "the rules, a list");
    // Terms use the programs: if the programs have problems, problems of the terms would only follow from these.
    for (const auto& item : reader.sound() ? items.elements("the rules") : std::vector<Item>()) {
      auto rule = read_rule(item, known);
      const auto same_name = [&](const RaisingRule& other) { return other.name == rule.name; };
      if (!rule.name.empty() && std::any_of(rules.begin(), rules.end(), same_name))
        item.member("name").problem(fmt::format("{} is another rule's name", in_quotes(rule.name)));
      rules.push_back(std::move(rule));
    }
  }
  if (!reader.sound()) return reader.problems().front();
  return rules;
}

}  // namespace

Result<RaisingRules> load_raising(const std::string& path, const Signature& names) {
  return read(LocatedJson::read(path), names);
}

Result<RaisingRules> parse_raising(std::string_view text, const std::string& name, const Signature& names) {
  return read(LocatedJson::parse(text, name), names);
}

}  // namespace continua
