// Properties and reasons of a run in words: "white cup", "not leftmost block".
#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/trimmed.h"
#include "continua/replay/log/applied_term.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_text.h"
#include "continua/replay/log/run_words.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

constexpr std::string_view negation = "not ", lambda = "\\";

std::string spaced(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

// The parts of a conjunction, also of one within another.
std::vector<std::string_view> conjuncts(std::string_view term) {
  const auto parts = parted(unbracketed(term), " and ");
  if (parts.size() == 1) return {unbracketed(term)};
  std::vector<std::string_view> all;
  for (const auto part : parts)
    for (const auto one : conjuncts(part)) all.push_back(one);
  return all;
}

// The text with each name in it as `told(name, text before it)`.
template <class Told>
std::string with_names(std::string_view text, const Told& told) {
  const auto is_name_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  std::string out;
  while (!text.empty()) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_name_part);
    const auto length = static_cast<std::size_t>(end - text.begin());
    out += length == 0 ? std::string(1, text.front()) : told(text.substr(0, length), out);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

}  // namespace

std::optional<std::string> RunWords::joined(const std::vector<std::string_view>& parts, std::string_view thing,
                                            std::string_view joint) const {
  std::vector<std::string> told;
  for (const auto part : parts) {
    auto one = about(part, thing);
    if (!one) return std::nullopt;
    if (std::find(told.begin(), told.end(), *one) == told.end()) told.push_back(*std::move(one));
  }
  return fmt::format("{}", fmt::join(told, joint));
}

std::optional<std::string> RunWords::about(std::string_view term, std::string_view thing) const {
  term = unbracketed(term);
  if (const auto parts = parted(term, " or "); parts.size() > 1) return joined(parts, thing, " or ");
  if (const auto parts = conjuncts(term); parts.size() > 1) return joined(parts, thing, " ");
  if (term.starts_with(negation)) {
    const auto rest = about(term.substr(negation.size()), thing);
    return rest ? std::optional(std::string(negation) + *rest) : std::nullopt;
  }
  if (const auto sides = parted(term, " = "); sides.size() == 2 && sides.front() == thing) {
    auto other = told(sides.back(), {});
    return other == sides.back() ? std::nullopt : std::optional(std::move(other));
  }
  const auto found = applied(term);
  if (!found || found->arguments.empty() || found->arguments.size() > 2) return std::nullopt;
  const auto& [name, arguments] = *found;
  if (arguments.size() == 1) return arguments[0] == thing ? std::optional(spaced(name)) : std::nullopt;
  if (arguments[1] == thing)
    if (const auto of = property(arguments[0])) return spaced(name) + " " + *of;
  if (arguments[0] != thing || !word("programs", name)) return std::nullopt;
  return told(fmt::format("{}({})", name, arguments[1]), {});
}

std::optional<std::string> RunWords::property(std::string_view term) const {
  const auto dot = term.find('.');
  if (table_.is_null() || !term.starts_with(lambda) || dot == term.npos) return std::nullopt;
  return about(term.substr(dot + 1), trimmed(term.substr(lambda.size(), dot - lambda.size())));
}

std::string RunWords::reason(std::string_view reason, std::string_view thing) const {
  if (table_.is_null()) return std::string(reason);
  return about(reason, thing).value_or(std::string(reason));
}

std::string RunWords::named(std::string_view sentence) const {
  return with_names(sentence, [&](std::string_view name, const std::string& before) {
    return before.ends_with("the ") ? std::string(name) : thing(name);
  });
}

std::string RunWords::reason_of_act(std::string_view line) const {
  const auto result = member_in(line, log::name_of(&log::Act::result));
  return named(text_in(member_in(result, log::name_of(&log::ActResult::reason))));
}

std::string RunWords::meaning(std::string_view term) const {
  const auto dot = term.find('.');
  if (table_.is_null() || !term.starts_with(lambda) || dot == term.npos) return this->term(term);
  const auto body = trimmed(term.substr(dot + 1)), bound = term.substr(lambda.size(), dot - lambda.size());
  const auto binders = bound.substr(0, bound.find(':'));  // without a type
  const auto text = told(body, {});
  if (text == body) return std::string(term);
  const auto names = parted(binders, " ");
  return with_names(text, [&](std::string_view name, const std::string&) {
    return std::find(names.begin(), names.end(), name) != names.end() ? "…" : std::string(name);
  });
}

}  // namespace continua
