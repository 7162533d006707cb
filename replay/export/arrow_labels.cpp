#include "continua/replay/export/arrow_labels.h"

#include <algorithm>
#include <limits>

namespace continua {
namespace {

bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_small(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

// The bytes of `text` in at most `most` columns, but one character at least.
std::size_t bytes_in(std::string_view text, std::size_t most) {
  std::size_t end = 0;
  while (end < text.size()) {
    auto next = end + 1;
    while (next < text.size() && goes_on(text[next])) ++next;
    if (end > 0 && columns(text.substr(0, next)) > most) break;
    end = next;
  }
  return end;
}

// The parts between which a name may be broken; each begins with the blank or mark before it, if there is one.
std::vector<std::string_view> parts_of(std::string_view name) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= name.size(); ++i) {
    const bool ends = i == name.size() || name[i] == ' ' || name[i] == '_' || name[i] == '-' ||
                      (is_capital(name[i]) && is_small(name[i - 1]));
    if (!ends) continue;
    parts.push_back(name.substr(begin, i - begin));
    begin = i;
  }
  return parts;
}

}  // namespace

std::vector<std::string> broken(std::string_view text, std::size_t most, std::string_view indent) {
  std::vector<std::string> lines;
  std::string line;
  const auto room = [&] { return most - std::min(most - 1, lines.empty() ? 0 : columns(indent)); };
  const auto end_line = [&] {
    lines.push_back((lines.empty() ? "" : std::string(indent)) + line);
    line.clear();
  };
  while (!text.empty()) {
    auto end = text.find(' ', 1);
    auto word = text.substr(0, end);
    if (columns(line) + columns(word) > room() && !line.empty()) {
      end_line();
      continue;
    }
    if (line.empty() && !lines.empty() && word.size() > 1 && word.front() == ' ') {
      text.remove_prefix(1);
      word.remove_prefix(1);
    }
    const auto taken = word.substr(0, bytes_in(word, room() - std::min(columns(line), room() - 1)));
    line += taken;
    text.remove_prefix(taken.size());
    if (taken.size() < word.size()) end_line();
  }
  if (!line.empty() || lines.empty()) end_line();
  return lines;
}

std::vector<std::string> broken_name(const std::string& name, std::size_t most) {
  std::vector<std::string> lines;
  for (auto part : parts_of(name)) {
    if (!lines.empty() && columns(lines.back()) + columns(part) <= most) {
      lines.back() += part;
      continue;
    }
    if (!lines.empty() && part.size() > 1 && part.front() == ' ') part.remove_prefix(1);
    lines.emplace_back(part);
  }
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::vector<ArrowLabel> labels_of(const std::vector<Arrow>& arrows, const LabelRoom& room) {
  std::vector<ArrowLabel> labels;
  std::vector<std::size_t> numbered;
  for (const auto& arrow : arrows) {
    ArrowLabel label;
    for (const auto& one : arrow.labels) {
      if (label.lines.size() > room.lines || room.columns == 0) break;
      for (auto& line : broken(one, room.columns, " ")) label.lines.push_back(std::move(line));
    }
    if (label.lines.empty() || label.lines.size() > room.lines) numbered.push_back(labels.size());
    labels.push_back(std::move(label));
  }
  // Those of a state follow one another; those of every state are the last.
  constexpr auto last = std::numeric_limits<std::size_t>::max();
  std::stable_sort(numbered.begin(), numbered.end(), [&](std::size_t a, std::size_t b) {
    return arrows[a].from.value_or(last) < arrows[b].from.value_or(last);
  });
  for (std::size_t i = 0; i < numbered.size(); ++i) labels[numbered[i]] = {{std::to_string(i + 1)}, i + 1};
  return labels;
}

}  // namespace continua
