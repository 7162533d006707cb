// The tables of a Markdown page, so that tests can run their rows.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace continua {

/// Rows of all tables of the page that have `columns` columns, without headings; cells without spaces and backquotes
/// around them.
inline std::vector<std::vector<std::string>> table_rows(std::string_view page, std::size_t columns) {
  const auto trimmed = [](std::string_view cell) {
    const auto from = cell.find_first_not_of(" `"), to = cell.find_last_not_of(" `");
    return from == std::string_view::npos ? std::string() : std::string(cell.substr(from, to + 1 - from));
  };
  std::vector<std::vector<std::string>> rows;
  for (std::size_t at = 0; at < page.size();) {
    const auto end = std::min(page.find('\n', at), page.size());
    std::string_view line = page.substr(at, end - at);
    at = end + 1;
    if (line.empty() || line.front() != '|') continue;
    line.remove_prefix(1);
    std::vector<std::string> cells;
    for (auto bar = line.find('|'); bar != std::string_view::npos; bar = line.find('|')) {
      cells.push_back(trimmed(line.substr(0, bar)));
      line.remove_prefix(bar + 1);
    }
    if (cells.size() != columns) continue;
    // The line of dashes says that the row before it was a heading.
    if (cells[0].starts_with("---"))
      rows.pop_back();
    else
      rows.push_back(std::move(cells));
  }
  return rows;
}

}  // namespace continua
