#include "replay/run_find.h"

#include <algorithm>
#include <string_view>

#include "replay/line_scan.h"
#include "replay/run_brief.h"
#include "replay/run_labels.h"
#include "replay/run_stops.h"

namespace continua {
namespace {

// Small letters of the ranges of two bytes in which they come a fixed distance after the capitals.
std::uint32_t small(std::uint32_t letter) {
  const auto in = [letter](std::uint32_t from, std::uint32_t to) { return letter >= from && letter <= to; };
  if ((in(0xC0, 0xDE) && letter != 0xD7) || in(0x391, 0x3AB) || in(0x410, 0x42F)) return letter + 0x20;
  if (in(0x400, 0x40F)) return letter + 0x50;
  if ((in(0x100, 0x137) && letter != 0x130 && letter != 0x131) || in(0x14A, 0x177)) return letter | 1;
  return letter;
}

std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t from = 0; from < text.size();) {
    const auto begin = text.find_first_not_of(" \t\r\n", from);
    if (begin == std::string::npos) break;
    from = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    words.push_back(text.substr(begin, from - begin));
  }
  return words;
}

class Finder {
 public:
  explicit Finder(const std::string& text) : words_(words_in(folded(text))) {
    // Words of letters alone stand in the line as they stand in the label, unless brief() adds them.
    for (const auto& word : words_)
      if (std::all_of(word.begin(), word.end(), is_ascii_letter) && brief_words.find(word) == std::string::npos)
        written_.push_back(word);
  }

  bool tells_of(const std::string& kind, std::string_view line) const {
    if (kind != "pose" && !may_tell_of(kind, line)) return false;
    const auto told = folded(kind + " " + label_of(kind, line));
    return all_in(told, words_);
  }

 private:
  static bool is_ascii_letter(char c) { return c >= 'a' && c <= 'z'; }

  static bool all_in(std::string_view text, const std::vector<std::string>& words) {
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return text.find(word) != std::string_view::npos; });
  }

  // False only if the label cannot tell of every word.
  bool may_tell_of(const std::string& kind, std::string_view line) const {
    if (written_.empty() || line.find("\\u") != std::string_view::npos) return true;
    const auto* members = brief_members(kind);
    thread_local std::string text;
    text.assign(kind).append(" ");
    if (members) {
      scan_members(line, [&](std::string_view key, std::string_view value) {
        if (std::find(members->begin(), members->end(), key) != members->end()) text.append(value).append(" ");
      });
    } else {
      text.append(line);
    }
    for (auto& c : text)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    return all_in(text, written_);
  }

  std::vector<std::string> words_;
  std::vector<std::string> written_;  // of the words those that the line must hold as written
};

}  // namespace

std::string folded(std::string_view text) {
  std::string out(text);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto first = static_cast<unsigned char>(out[i]);
    if (first >= 'A' && first <= 'Z') {
      out[i] = static_cast<char>(first + ('a' - 'A'));
    } else if (first >= 0xC3 && first <= 0xDF && i + 1 < out.size()) {
      const auto letter = small(((first & 0x1FU) << 6) | (static_cast<unsigned char>(out[i + 1]) & 0x3FU));
      out[i] = static_cast<char>(0xC0U | (letter >> 6));
      out[i + 1] = static_cast<char>(0x80U | (letter & 0x3FU));
      ++i;
    }
  }
  return out;
}

Result<std::vector<std::uint32_t>> run_find(const RunIndex& run, const std::string& text, const std::string& kind) {
  const Finder finder(text);
  std::vector<std::uint32_t> found;
  const auto stops = kind.empty() ? records_worth_stopping_at(run) : std::vector<std::uint32_t>();
  auto stop = stops.begin();
  const auto problem = run.read_lines(
      [&](std::size_t n) {
        if (!kind.empty()) return kind == "*" || run.kind(n) == kind;
        while (stop != stops.end() && *stop < n) ++stop;
        return stop != stops.end() && *stop == n;
      },
      [&](std::size_t n, std::string_view line) {
        if (finder.tells_of(run.kind(n), line)) found.push_back(static_cast<std::uint32_t>(n));
        return true;
      });
  if (problem) return *problem;
  return found;
}

}  // namespace continua
