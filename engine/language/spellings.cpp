#include "continua/language/spellings.h"

#include <algorithm>
#include <iterator>

namespace continua {
namespace {

using Kind = Spelling::Kind;

constexpr std::string_view notation = " |()[]";
constexpr int most_nested = 50;  // brackets within brackets

// A sequence or a choice of one part is that part.
Spelling made_of(Kind kind, std::vector<Spelling> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  return {kind, {}, std::move(parts)};
}

// Reads alternatives by recursive descent.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  // Nothing if a bracket has no partner, or is within too many.
  std::optional<Spelling> read() {
    auto all = alternatives();
    return rest_.empty() ? all : std::nullopt;
  }

 private:
  std::optional<Spelling> alternatives() {
    std::vector<Spelling> all;
    for (;;) {
      auto some = sequence();
      if (!some) return std::nullopt;
      all.push_back(*std::move(some));
      if (rest_.empty() || rest_.front() != '|') return made_of(Kind::choice, std::move(all));
      rest_.remove_prefix(1);
    }
  }

  std::optional<Spelling> sequence() {
    std::vector<Spelling> all;
    for (;;) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size()));
      if (rest_.empty() || rest_.front() == '|' || rest_.front() == ')' || rest_.front() == ']')
        return made_of(Kind::sequence, std::move(all));
      auto part = this->part();
      if (!part) return std::nullopt;
      all.push_back(*std::move(part));
    }
  }

  // A word, or a group in brackets.
  std::optional<Spelling> part() {
    const char first = rest_.front();
    if (first != '(' && first != '[') {
      const auto word = rest_.substr(0, rest_.find_first_of(notation));
      rest_.remove_prefix(word.size());
      return Spelling{Kind::word, word, {}};
    }
    if (++depth_ > most_nested) return std::nullopt;
    rest_.remove_prefix(1);
    auto group = alternatives();
    --depth_;
    if (!group || rest_.empty() || rest_.front() != (first == '(' ? ')' : ']')) return std::nullopt;
    rest_.remove_prefix(1);
    if (first == '(') return group;
    return Spelling{Kind::choice, {}, {*std::move(group), Spelling()}};
  }

  std::string_view rest_;
  int depth_ = 0;
};

// The number of texts, at most one more than most_spellings.
std::size_t count_of(const Spelling& spelling) {
  std::size_t count = spelling.kind == Kind::choice ? 0 : 1;
  for (const auto& part : spelling.parts) {
    const auto more = count_of(part);
    count = std::min(spelling.kind == Kind::choice ? count + more : count * more, most_spellings + 1);
  }
  return count;
}

void append(std::string& text, const std::string& more) {
  if (!text.empty() && !more.empty()) text += ' ';
  text += more;
}

std::vector<std::string> texts_of(const Spelling& spelling) {
  if (spelling.kind == Kind::word) return {std::string(spelling.word)};
  std::vector<std::string> all;
  if (spelling.kind == Kind::choice) {
    for (const auto& part : spelling.parts)
      for (auto& text : texts_of(part)) all.push_back(std::move(text));
    return all;
  }
  all.emplace_back();
  for (const auto& part : spelling.parts) {
    const auto ends = texts_of(part);
    std::vector<std::string> longer;
    longer.reserve(all.size() * ends.size());
    for (const auto& begin : all)
      for (const auto& end : ends) append(longer.emplace_back(begin), end);
    all = std::move(longer);
  }
  return all;
}

}  // namespace

std::optional<Spelling> read_spelling(std::string_view text) {
  auto spelling = Reader(text).read();
  if (!spelling || count_of(*spelling) > most_spellings) return std::nullopt;
  return spelling;
}

std::vector<std::string> spellings(const std::string& text) {
  const auto spelling = read_spelling(text);
  if (!spelling) return {text};
  return texts_of(*spelling);
}

std::vector<std::string_view> parts_of_spellings(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(notation, begin)) != text.npos;) {
    const auto end = std::min(text.find_first_of(notation, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

}  // namespace continua
