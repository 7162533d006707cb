#include "continua/replay/log/applied_term.h"

#include <algorithm>
#include <cctype>

#include "continua/core/trimmed.h"

namespace continua {
namespace {

// How much deeper in brackets the text behind this letter is.
int deeper(char letter) {
  return letter == '(' || letter == '<' || letter == '[' ? 1 : letter == ')' || letter == '>' || letter == ']' ? -1 : 0;
}

}  // namespace

std::optional<Applied> applied(std::string_view term) {
  const auto is_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  const auto end = static_cast<std::size_t>(std::find_if_not(term.begin(), term.end(), is_name) - term.begin());
  if (end == 0) return std::nullopt;
  Applied found{term.substr(0, end), {}};
  if (end == term.size()) return found;
  if (term[end] != '(' || term.back() != ')') return std::nullopt;
  int depth = 0;
  auto from = end + 1;
  for (auto at = from; at + 1 < term.size(); ++at) {
    depth += deeper(term[at]);
    if (depth < 0) return std::nullopt;
    if (term[at] != ',' || depth != 0) continue;
    found.arguments.push_back(trimmed(term.substr(from, at - from)));
    from = at + 1;
  }
  found.arguments.push_back(trimmed(term.substr(from, term.size() - 1 - from)));
  return found;
}

std::vector<std::string_view> parted(std::string_view term, std::string_view joint) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t from = 0;
  for (std::size_t at = 0; at < term.size(); ++at) {
    depth += deeper(term[at]);
    if (depth != 0 || !term.substr(at).starts_with(joint)) continue;
    parts.push_back(trimmed(term.substr(from, at - from)));
    from = at + joint.size();
  }
  parts.push_back(trimmed(term.substr(from)));
  return parts;
}

std::string_view unbracketed(std::string_view term) {
  term = trimmed(term);
  if (!term.starts_with('(')) return term;
  int depth = 0;
  for (std::size_t at = 0; at < term.size(); ++at)
    if ((depth += deeper(term[at])) == 0)
      return at + 1 == term.size() ? unbracketed(term.substr(1, term.size() - 2)) : term;
  return term;
}

}  // namespace continua
