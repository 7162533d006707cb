#include "continua/language/spellings.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

namespace continua {
namespace {

using Texts = std::vector<std::string>;

constexpr std::string_view notation = " |()[]";

void append(std::string& text, const std::string& more) {
  if (!text.empty() && !more.empty()) text += ' ';
  text += more;
}

// Reads alternatives by recursive descent.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  // Nothing if a bracket has no partner, or there are too many ways.
  std::optional<Texts> read() {
    auto all = alternatives();
    return rest_.empty() ? all : std::nullopt;
  }

 private:
  std::optional<Texts> alternatives() {
    Texts all;
    for (;;) {
      auto some = sequence();
      if (!some || all.size() + some->size() > most_spellings) return std::nullopt;
      std::move(some->begin(), some->end(), std::back_inserter(all));
      if (rest_.empty() || rest_.front() != '|') return all;
      rest_.remove_prefix(1);
    }
  }

  std::optional<Texts> sequence() {
    Texts all = {""};
    while (!rest_.empty() && rest_.front() != '|' && rest_.front() != ')' && rest_.front() != ']') {
      const auto part = this->part();
      if (!part || all.size() * part->size() > most_spellings) return std::nullopt;
      if (part->size() == 1) {
        for (auto& begin : all) append(begin, part->front());
        continue;
      }
      Texts longer;
      for (const auto& begin : all)
        for (const auto& end : *part) append(longer.emplace_back(begin), end);
      all = std::move(longer);
    }
    return all;
  }

  // A word, or a group in brackets.
  std::optional<Texts> part() {
    const char first = rest_.front();
    if (first == ' ') return rest_.remove_prefix(1), Texts{""};
    if (first != '(' && first != '[') {
      const auto end = rest_.find_first_of(notation);
      const auto word = rest_.substr(0, end);
      rest_.remove_prefix(word.size());
      return Texts{std::string(word)};
    }
    rest_.remove_prefix(1);
    auto group = alternatives();
    if (!group || rest_.empty() || rest_.front() != (first == '(' ? ')' : ']')) return std::nullopt;
    rest_.remove_prefix(1);
    if (first == '[') group->push_back("");
    return group;
  }

  std::string_view rest_;
};

}  // namespace

std::vector<std::string_view> parts_of_spellings(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(notation, begin)) != text.npos;) {
    const auto end = std::min(text.find_first_of(notation, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

std::vector<std::string> spellings(const std::string& text) {
  if (auto all = Reader(text).read()) return *std::move(all);
  return {text};
}

}  // namespace continua
