#include "continua/simulation/mjcf_tags.h"

#include <algorithm>

namespace continua {

namespace {

constexpr auto npos = std::string_view::npos;

}  // namespace

std::optional<Tag> next_tag(std::string_view text, std::size_t from) {
  while (true) {
    const std::size_t begin = text.find('<', from);
    if (begin == npos) return std::nullopt;
    const bool comment = text.substr(begin).starts_with("<!--");
    std::size_t end = comment ? text.find("-->", begin + 4) : begin + 1;
    // A '>' within quotes does not end a tag.
    for (char quote = 0; !comment && end < text.size() && (quote || text[end] != '>'); ++end) {
      if (quote ? text[end] == quote : (text[end] == '"' || text[end] == '\'')) quote = quote ? char{0} : text[end];
    }
    if (end == npos || end >= text.size()) return std::nullopt;
    end += comment ? 3 : 1;
    from = end;
    if (comment || text[begin + 1] == '!' || text[begin + 1] == '?') continue;
    const std::size_t name_end = text.find_first_of(" \t\r\n/>", begin + 2);
    return Tag{begin, end, text.substr(begin + 1, name_end - begin - 1), text[end - 2] == '/'};
  }
}

std::optional<Attribute> attribute_of(std::string_view text, const Tag& whole, std::string_view name) {
  const auto tag = text.substr(0, whole.end);
  for (std::size_t at = tag.find(name, whole.begin + 1); at != npos; at = tag.find(name, at + 1)) {
    if (std::string_view(" \t\r\n").find(tag[at - 1]) == npos) continue;
    std::size_t open = tag.find_first_not_of(" \t\r\n", at + name.size());
    if (open == npos || tag[open] != '=') continue;
    open = tag.find_first_not_of(" \t\r\n", open + 1);
    if (open == npos || (tag[open] != '"' && tag[open] != '\'')) continue;
    const std::size_t close = tag.find(tag[open], open + 1);
    if (close != npos) return Attribute{open + 1, close, std::string(tag.substr(open + 1, close - open - 1))};
  }
  return std::nullopt;
}

std::optional<std::string> value_of(std::string_view text, const Tag& tag, std::string_view name) {
  auto found = attribute_of(text, tag, name);
  return found ? std::optional(std::move(found->value)) : std::nullopt;
}

void make_blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (text[i] != '\n') text[i] = ' ';
  }
}

int line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace continua
