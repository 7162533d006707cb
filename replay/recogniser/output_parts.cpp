#include "continua/replay/recogniser/output_parts.h"

#include <algorithm>

namespace continua {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Whether a value may begin where these brackets are open, after this character.
bool value_may_begin(const std::string& open, char before) {
  return open.empty() || before == ':' || (open.back() == '[' && (before == '[' || before == ','));
}

// The name of an XML document's root; none if its tag is not there yet.
std::optional<std::string> root_of(std::string_view text) {
  for (auto at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] == '?' || text[at + 1] == '!') continue;
    const auto end = text.find_first_of(" \t\r\n/>", at + 1);
    if (end == std::string_view::npos) return std::nullopt;
    return std::string(text.substr(at + 1, end - at - 1));
  }
  return std::nullopt;
}

}  // namespace

std::optional<OutputPart> OutputParts::next() {
  if (byte_order_mark.starts_with(rest_)) return std::nullopt;
  if (looked_ == 0) pass_blanks();
  std::optional<std::size_t> end;
  if (kind_ == PartKind::json && !rest_.empty() && (rest_[0] == '{' || rest_[0] == '['))
    end = json_end();
  else if (kind_ == PartKind::xml)
    end = xml_end();
  else if (const auto newline = rest_.find('\n', looked_); newline != std::string::npos)
    end = newline;
  else
    looked_ = rest_.size();
  return end ? std::optional(take(*end)) : std::nullopt;
}

std::optional<OutputPart> OutputParts::last() {
  pass_blanks();
  return rest_.empty() ? std::nullopt : std::optional(take(rest_.size()));
}

void OutputParts::pass_blanks() {
  if (rest_.starts_with(byte_order_mark)) rest_.erase(0, byte_order_mark.size());
  const char* blanks = kind_ == PartKind::json ? " \t\r\n," : " \t\r\n";
  take(std::min(rest_.find_first_not_of(blanks), rest_.size()));
}

std::optional<std::size_t> OutputParts::json_end() {
  for (auto& at = looked_; at < rest_.size(); ++at) {
    const char c = rest_[at];
    if (quoted_) {
      if (c == '\n') return at;
      if (c == '"' && before_ != '\\') quoted_ = false;
      before_ = c == '\\' && before_ == '\\' ? '"' : c;  // a backslash that is itself escaped escapes nothing
      continue;
    }
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    if (c == '{' && !value_may_begin(open_, before_)) return at;
    if (c == '"') quoted_ = true;
    if (c == '{' || c == '[') open_ += c;
    if (c == '}' || c == ']') open_.pop_back();
    before_ = c;
    if (open_.empty()) return at + 1;
  }
  return std::nullopt;
}

std::optional<std::size_t> OutputParts::xml_end() {
  const auto root = root_of(rest_);
  if (!root) return std::nullopt;
  const auto tag = rest_.find("<" + *root);
  const auto tag_end = rest_.find('>', tag);
  if (tag_end == std::string::npos) return std::nullopt;
  if (rest_[tag_end - 1] == '/') return tag_end + 1;
  const auto closing = rest_.find("</" + *root, tag_end), another = rest_.find("<?xml", tag_end);
  if (another < closing) return another;
  const auto end = closing == std::string::npos ? closing : rest_.find('>', closing);
  return end == std::string::npos ? std::nullopt : std::optional(end + 1);
}

OutputPart OutputParts::take(std::size_t length) {
  OutputPart part{rest_.substr(0, length), line_};
  line_ += static_cast<std::size_t>(std::count(part.text.begin(), part.text.end(), '\n'));
  rest_.erase(0, length);
  looked_ = 0;
  open_.clear();
  before_ = 0;
  quoted_ = false;
  return part;
}

}  // namespace continua
