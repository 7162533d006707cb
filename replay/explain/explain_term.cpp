#include "replay/explain/explain_term.h"

#include <cctype>

namespace continua {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The texts between the commas of `text` that are in no bracket; nothing where brackets do not match.
std::vector<std::string> elements_of(std::string_view text) {
  std::vector<std::string> elements;
  std::string open;
  std::size_t from = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\'') {
      at = text.find('\'', at + 1);
      if (at == std::string_view::npos) return {};
    } else if (c == '(' || c == '[' || c == '<' || c == '{') {
      open += c;
    } else if (c == ')' || c == ']' || (c == '>' && (at == 0 || text[at - 1] != '-')) || c == '}') {
      if (open.empty()) return {};
      open.pop_back();
    } else if (c == ',' && open.empty()) {
      elements.emplace_back(trimmed(text.substr(from, at - from)));
      from = at + 1;
    }
  }
  if (!open.empty()) return {};
  if (const auto last = trimmed(text.substr(from)); !last.empty()) elements.emplace_back(last);
  return elements;
}

// "x: e v" has x and v: a type follows a colon.
std::vector<std::string> binders_of(std::string_view text) {
  std::vector<std::string> binders;
  const bool typed = text.find(':') != std::string_view::npos;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find(' ', at), text.size());
    auto word = text.substr(at, end - at);
    if (word.ends_with(':'))
      binders.emplace_back(word.substr(0, word.size() - 1));
    else if (!typed && !word.empty())
      binders.emplace_back(word);
    at = end + 1;
  }
  return binders;
}

}  // namespace

TermParts term_parts(std::string_view text) {
  text = trimmed(text);
  TermParts parts;
  parts.whole = text;
  if (text.starts_with('\\')) {
    if (const auto dot = text.find(". "); dot != std::string_view::npos) {
      parts.binders = binders_of(text.substr(1, dot - 1));
      parts.body = trimmed(text.substr(dot + 2));
    }
    return parts;
  }
  std::size_t name = 0;
  while (name < text.size() && is_word(text[name])) ++name;
  if (name + 1 >= text.size()) return parts;
  const char opening = text[name], closing = text.back();
  if (!((opening == '(' && name > 0 && closing == ')') || (opening == '[' && name == 0 && closing == ']')))
    return parts;
  parts.elements = elements_of(text.substr(name + 1, text.size() - name - 2));
  if (!parts.elements.empty()) parts.head = text.substr(0, name);
  return parts;
}

bool mentions(std::string_view text, std::string_view name) {
  if (name.empty()) return false;
  for (auto at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const auto end = at + name.size();
    if ((at == 0 || !is_word(text[at - 1]) || !is_word(name.front())) &&
        (end == text.size() || !is_word(text[end]) || !is_word(name.back())))
      return true;
  }
  return false;
}

}  // namespace continua
