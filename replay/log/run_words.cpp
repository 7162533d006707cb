#include "continua/replay/log/run_words.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/trimmed.h"
#include "continua/replay/log/applied_term.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_text.h"

namespace continua {
namespace {

// The value of `key="…"` or `key=…` in a tag.
std::string attribute(std::string_view tag, std::string_view key) {
  for (auto at = tag.find(key); at != tag.npos; at = tag.find(key, at + 1)) {
    const auto end = at + key.size();
    if (end + 1 >= tag.size() || tag[end] != '=' || (at > 0 && tag[at - 1] != ' ' && tag[at - 1] != '"')) continue;
    const bool quoted = tag[end + 1] == '"';
    const auto from = end + (quoted ? 2 : 1);
    return std::string(tag.substr(from, tag.find_first_of(quoted ? "\"" : " \"/", from) - from));
  }
  return {};
}

std::string mjcf_of(const RunIndex& run) {
  const auto& header = run.header();
  return header ? text_of(member_of(*header, "scene"), "mjcf") : std::string();
}

}  // namespace

RunWords::RunWords(const RunIndex& run) : RunWords(std::string_view(mjcf_of(run))) {}

RunWords::RunWords(std::string_view mjcf) : table_(Json::parse(words_table())) {
  std::map<std::string, int> times;
  for (auto at = mjcf.find("<text "); at != mjcf.npos; at = mjcf.find("<text ", at + 1)) {
    const auto tag = mjcf.substr(at, mjcf.find('>', at) - at);
    const auto name = attribute(tag, "name"), type = attribute(tag, "type"), color = attribute(tag, "color");
    if (name.empty() || type.empty()) continue;
    const auto told = color.empty() ? "the " + type : fmt::format("the {} {}", color, type);
    things_[name] = told;
    ++times[told];
  }
  for (auto& [name, told] : things_)
    if (times[told] > 1) told += fmt::format(" ({})", name);
}

RunWords RunWords::raw() { return {}; }

const std::string* RunWords::word(const char* list, std::string_view name) const {
  if (table_.is_null()) return nullptr;
  const auto& words = table_.at(list);
  const auto found = words.find(std::string(name));
  return found == words.end() ? nullptr : found->get_ptr<const std::string*>();
}

std::string RunWords::thing(std::string_view name) const {
  const auto found = things_.find(name);
  return found == things_.end() ? std::string(name) : found->second;
}

// "<-0.26, 0.05, 0>" is 26 cm left and 5 cm behind: x is to the human's right, y away from the human.
std::string RunWords::place(std::string_view point) const {
  double at[2] = {};
  auto rest = point.substr(1, point.size() - 2);
  for (auto& value : at) {
    const auto end = std::min(rest.find(','), rest.size());
    const auto read = number_in<double>(trimmed(rest.substr(0, end)));
    if (!read) return std::string(point);
    value = *read;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  const auto part = [&](double value, const char* less, const char* more) {
    const auto cm = std::lround(100 * std::abs(value));
    return cm == 0 ? std::string() : fmt::format(fmt::runtime(*word("table", value < 0 ? less : more)), cm);
  };
  const auto across = part(at[0], "left", "right"), along = part(at[1], "near", "far");
  if (across.empty() && along.empty()) return *word("table", "middle");
  return across + (across.empty() || along.empty() ? "" : *word("table", "and")) + along + *word("table", "of");
}

std::string RunWords::spot(const Json& point) const {
  if (table_.is_null() || !point.is_array() || point.size() < 2 || !point[0].is_number() || !point[1].is_number())
    return compact(point);
  return place(fmt::format("<{}, {}>", point[0].get<double>(), point[1].get<double>()));
}

std::string RunWords::elements(std::string_view list) const {
  const auto as_arguments = fmt::format("list({})", list.substr(1, list.size() - 2));
  const auto read = applied(as_arguments);
  if (!read) return std::string(list);
  std::vector<std::string> all;
  for (const auto one : read->arguments) all.push_back(told(one, {}));
  return fmt::format("[{}]", fmt::join(all, ", "));
}

// `about`: the thing that the program around the term is about, or empty.
std::string RunWords::told(std::string_view term, std::string_view about) const {
  term = trimmed(term);
  if (table_.is_null()) return std::string(term);
  if (term.starts_with('<') && term.ends_with('>')) return place(term);
  const auto found = applied(term);
  if (!found) return term.starts_with('[') && term.ends_with(']') ? elements(term) : std::string(term);
  if (found->arguments.empty()) {
    for (const char* list : {"names", "programs"})
      if (const auto* name = word(list, found->name); name && name->find('{') == name->npos) return *name;
    return thing(found->name);
  }
  const auto* itself = found->arguments.front() == about && !about.empty() ? word("itself", found->name) : nullptr;
  if (itself) return *itself;
  // A program whose arguments mean something else when there are so many has words of its own: "point/2".
  const auto* form = word("programs", fmt::format("{}/{}", found->name, found->arguments.size()));
  if (!form) form = word("programs", found->name);
  if (!form) return std::string(term);
  auto text = *form;
  for (std::size_t i = 0; i < found->arguments.size(); ++i) {
    const auto mark = fmt::format("{{{}}}", i);
    if (const auto at = text.find(mark); at != text.npos)
      text.replace(at, mark.size(), argument(found->arguments[i], i == 0 ? "" : found->arguments.front()));
  }
  // A part that the program lacks.
  for (auto at = text.find(" {"); at != text.npos; at = text.find(" {")) text.erase(at, text.find('}', at) + 1 - at);
  return text;
}

std::string RunWords::argument(std::string_view term, std::string_view about) const {
  const auto of_things = property(term);
  return of_things ? *of_things : told(term, about);
}

std::string RunWords::term(std::string_view term) const { return told(term, {}); }

Json RunWords::each(const Json& list) const {
  if (!list.is_array()) return list;
  Json told = Json::array();
  for (const auto& one : list) {
    if (!one.is_string()) {
      told.push_back(one);
      continue;
    }
    const auto text = one.get<std::string>();
    told.push_back(text.find_first_of("(<") == text.npos ? thing(text) : term(text));
  }
  return told;
}

std::string RunWords::gesture(std::string_view name, std::string_view direction) const {
  const auto* known = word("gestures", name);
  auto text = known ? *known : std::string(name);
  if (!direction.empty()) text += " " + std::string(direction);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string RunWords::expectation(std::string_view field) const {
  const auto* known = word("expectations", field);
  return known ? *known : std::string(field);
}

std::string RunWords::expected(std::string_view field, const Json& value) const {
  if (value.is_array()) {
    std::string all;
    for (const auto& one : value) all += (all.empty() ? "" : " or ") + expected(field, one);
    return all.empty() ? expectation("null") : all;
  }
  if (!value.is_string()) return value.is_null() ? expectation("null") : compact(value);
  const auto text = value.get<std::string>();
  if (text == "null") return expectation(text);
  if (field == "says") return "“" + text + "”";
  if (field == "state") return text;
  const auto told = term(text);
  return field == "act" ? "“" + told + "”" : told;
}

std::string RunWords::all() const {
  std::string text;
  for (const auto& [name, told] : things_) text += told + "\n";
  for (const auto& list : table_)
    if (list.is_object())
      for (const auto& told : list) text += told.get<std::string>() + "\n";
  return text;
}

std::string RunWords::missing(std::string_view type) const {
  const auto* known = word("missing", type);
  return known ? *known : std::string();
}

}  // namespace continua
