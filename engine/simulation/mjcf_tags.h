// The tags of an MJCF text, for what must be known or changed before MuJoCo compiles the text: inclusions, sizes, and
// the elements that a scene tells of its avatar.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace continua {

/// text[begin, end) from '<' to '>'.
struct Tag {
  std::size_t begin = 0, end = 0;
  std::string_view name;  ///< "/body" for a closing tag
  bool self_closing = false;
};

/// The next tag at or after `from`; comments, declarations and processing instructions are skipped.
std::optional<Tag> next_tag(std::string_view text, std::size_t from);

/// The value of an attribute, with its place in the text; nothing if the tag does not have the attribute.
struct Attribute {
  std::size_t begin = 0, end = 0;
  std::string value;
};
std::optional<Attribute> attribute_of(std::string_view text, const Tag& tag, std::string_view name);
std::optional<std::string> value_of(std::string_view text, const Tag& tag, std::string_view name);

/// Puts spaces for text[begin, end). Newlines stay, so that lines keep their numbers.
void make_blank(std::string& text, std::size_t begin, std::size_t end);

/// From 1.
int line_of(std::string_view text, std::size_t at);

}  // namespace continua
