#include "continua/replay/inspector/run_find.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "continua/core/characters.h"
#include "continua/replay/inspector/run_labels.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_stops.h"
#include "continua/replay/log/run_text.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

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

constexpr std::size_t most_told = 5000;

bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }

bool all_in(std::string_view text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return text.find(word) != std::string_view::npos; });
}

// Whether brief() shows the value as written. A value of another type than declared is shown otherwise.
bool shows_as_written(std::string_view value, std::string_view type) {
  const bool any = type == "any";
  if (is_plain_text(value)) return any || type.starts_with("text");
  if (value == "null" || value == "true" || value == "false") return any;
  const bool whole = value.size() <= 15 && number_in<std::int64_t>(value) && !value.starts_with("-0");
  return whole && (any || type.starts_with("integer"));
}

// Finds words in records of a kind. A label is made only where its sources hold the words.
class Finder {
 public:
  /// `in_words`: the words of the run, where some of those that are searched may stand among them; else null.
  Finder(std::string kind, const std::vector<std::string>& words, const RunWords* in_words)
      : kind_(std::move(kind)), schema_(log::schema_of(kind_)), words_(words), in_words_(in_words) {
    const auto told = folded(kind_);
    const auto adds = folded(schema_ ? schema_->kind.brief_adds : "");
    for (const auto& word : words_) {
      if (told.find(word) != std::string::npos) continue;
      told_by_kind_ = false;
      // The additions of brief() may hold it, or a part of it.
      const bool added = adds.find(word) != std::string::npos || std::any_of(word.begin(), word.end(), [&](char c) {
                           return !is_small_letter(c) && adds.find(c) != std::string::npos;
                         });
      if (added) continue;
      plain_.push_back(word);
      if (std::all_of(word.begin(), word.end(), is_small_letter)) letters_.push_back(word);
    }
  }

  bool tells_of_words(std::string_view line) {
    if (told_by_kind_) return true;
    if (log::is<log::Pose>(kind_)) return false;
    shown_.clear();
    bool as_written = schema_ != nullptr;
    if (schema_) {
      const auto& members = schema_->members;
      scan_members(line, [&](std::string_view key, std::string_view value) {
        const auto member = std::find_if(members.begin(), members.end(),
                                         [&](const auto& one) { return one.in_brief && one.name == key; });
        if (member == members.end()) return;
        shown_.append(1, static_cast<char>(1 + (member - members.begin()))).append(value);
        as_written = as_written && shows_as_written(value, member->type);
      });
    } else {
      shown_ = line;
    }
    if (!may_tell_of_words(as_written)) return false;
    // Many records of a run say the same.
    if (const auto known = told_.find(shown_); known != told_.end()) return known->second;
    auto label = kind_ + " " + label_of(kind_, line);
    if (in_words_) label += "\n" + label_in_words(*in_words_, kind_, line);
    const bool tells = all_in(folded(label), words_);
    if (told_.size() < most_told) told_.emplace(shown_, tells);
    return tells;
  }

 private:
  // False only if the label cannot. Letters stay the same even where a value is shown otherwise than written.
  bool may_tell_of_words(bool as_written) const {
    if (plain_.empty() || in_words_) return true;
    if (!as_written && (letters_.empty() || shown_.find("\\u") != std::string::npos)) return true;
    return all_in(folded(shown_), as_written ? plain_ : letters_);
  }

  std::string kind_;
  const log::KindSchema* schema_;
  std::vector<std::string> words_;
  const RunWords* in_words_;
  bool told_by_kind_ = true;
  std::string shown_;                           // of the record at hand, the sources of its label
  std::unordered_map<std::string, bool> told_;  // by that
  std::vector<std::string> plain_;              // words that stand as written in the sources of any label that has them
  std::vector<std::string> letters_;            // of these, those of small letters alone
};

}  // namespace

Result<std::vector<std::uint32_t>> run_find(const RunIndex& run, const std::string& text, const std::string& kind) {
  const auto words = words_in(folded(text));
  std::vector<Finder> finders;
  const RunWords run_words(run);
  const auto known = folded(run_words.all());
  const bool in_words =
      std::any_of(words.begin(), words.end(), [&](const auto& one) { return known.find(one) != known.npos; });
  for (const auto& one : run.kinds()) finders.emplace_back(one, words, in_words ? &run_words : nullptr);
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
        if (finders[run.entry(n).kind].tells_of_words(line)) found.push_back(static_cast<std::uint32_t>(n));
        return true;
      });
  if (problem) return *problem;
  return found;
}

}  // namespace continua
