#include "replay/score/agreement.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace continua {
namespace {

// A term as it is printed: a head and its arguments, a place or a list with its elements; nothing is known of types.
struct Node {
  std::string head;  // "<" of a place, "[" of a list
  std::vector<Node> parts;
};

constexpr std::size_t deepest_term = 200;
constexpr double rounding_m = 1e-9;  // 0.102 - 0.1 is more than 0.002

class TermReader {
 public:
  explicit TermReader(std::string_view text) : rest_(text) {}

  // Nothing, if the text is no term.
  std::optional<Node> whole() {
    auto node = term(0);
    skip_spaces();
    if (!node || !rest_.empty()) return std::nullopt;
    return node;
  }

 private:
  std::optional<Node> term(std::size_t depth) {
    skip_spaces();
    if (rest_.empty() || depth > deepest_term) return std::nullopt;
    if (take('<')) return closed({"<", {}}, '>', depth);
    if (take('[')) return closed({"[", {}}, ']', depth);
    Node node;
    if (rest_.front() == '\'') {
      const auto end = rest_.find('\'', 1);
      if (end == std::string_view::npos) return std::nullopt;
      node.head = take_until(end + 1);
      return node;
    }
    node.head = take_until(std::min(rest_.find_first_of("(),<>[]' "), rest_.size()));
    if (node.head.empty()) return std::nullopt;
    if (take('(')) return closed(std::move(node), ')', depth);
    return node;
  }

  std::optional<Node> closed(Node node, char end, std::size_t depth) {
    skip_spaces();
    if (take(end)) return node;
    for (;;) {
      auto part = term(depth + 1);
      if (!part) return std::nullopt;
      node.parts.push_back(std::move(*part));
      skip_spaces();
      if (take(end)) return node;
      if (!take(',')) return std::nullopt;
    }
  }

  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string take_until(std::size_t end) {
    std::string taken(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return taken;
  }

  void skip_spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  std::string_view rest_;
};

std::optional<double> number(const std::string& text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_place(const Node& node) { return node.head == "<"; }

bool holds_place(const Node& node) {
  return is_place(node) || std::any_of(node.parts.begin(), node.parts.end(), holds_place);
}

bool same(const Node& observed, const Node& produced, bool lax) {
  // part('front', 'left', <0.1, 0, 0>) describes a place: which one was taken was left open.
  if (lax && is_place(observed) && !is_place(produced) && holds_place(produced)) return true;
  if (observed.parts.size() != produced.parts.size()) return false;
  const auto a = number(observed.head), b = number(produced.head);
  if (a && b ? std::abs(*a - *b) > place_tolerance_m + rounding_m : observed.head != produced.head) return false;
  return std::equal(observed.parts.begin(), observed.parts.end(), produced.parts.begin(),
                    [lax](const Node& one, const Node& other) { return same(one, other, lax); });
}

bool same(const AvatarMove& observed, const AvatarMove& produced, bool lax) {
  if (observed.channel != produced.channel) return false;
  if (observed.content == produced.content) return true;
  if (observed.channel == "speech") return false;
  const auto a = TermReader(observed.content).whole(), b = TermReader(produced.content).whole();
  return a && b && same(*a, *b, lax);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || (c & 0x80); }

std::string blanked_words(std::string_view text, const Blanks& blanks) {
  std::string out;
  while (!text.empty()) {
    const auto end = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_word) - text.begin());
    const std::string word(text.substr(0, end));
    out += blanks.names.contains(lower(word)) ? "_" : word;
    text.remove_prefix(end);
    if (!text.empty()) out += text.front(), text.remove_prefix(1);
  }
  return out;
}

std::string blanked(const Node& node, const Blanks& blanks) {
  if (is_place(node)) return "_";
  const bool list = node.head == "[";
  if (node.parts.empty() && !list)
    return blanks.names.contains(lower(node.head)) ? "_" : blanked_words(node.head, blanks);
  // What describes a place is blanked like the place; on(block1) describes none by coordinates.
  std::string parts;
  for (const auto& part : node.parts)
    parts += (parts.empty() ? "" : ", ") + (holds_place(part) ? "_" : blanked(part, blanks));
  return list ? "[" + parts + "]" : node.head + "(" + parts + ")";
}

}  // namespace

std::string text(AgreementLevel level) {
  switch (level) {
    case AgreementLevel::none:
      return "none";
    case AgreementLevel::same_template:
      return "template";
    case AgreementLevel::lax:
      return "lax";
    case AgreementLevel::exact:
      return "exact";
  }
  return {};
}

Blanks blanks_of(const WorldSnapshot& world) {
  Blanks blanks;
  for (const auto& object : world.objects) {
    blanks.names.insert(lower(object.name));
    for (const auto& [attribute, value] : object.attributes)
      if (attribute != "type") blanks.names.insert(lower(value));
  }
  return blanks;
}

AgreementLevel agreement(const std::vector<AvatarMove>& observed, const std::vector<AvatarMove>& produced,
                         const Blanks& blanks) {
  const auto agree = [&](bool lax) {
    return std::equal(observed.begin(), observed.end(), produced.begin(), produced.end(),
                      [lax](const AvatarMove& one, const AvatarMove& other) { return same(one, other, lax); });
  };
  if (agree(false)) return AgreementLevel::exact;
  if (agree(true)) return AgreementLevel::lax;
  const auto shape = template_of(observed, blanks);
  if (!shape.empty() && shape == template_of(produced, blanks)) return AgreementLevel::same_template;
  return AgreementLevel::none;
}

std::string template_of(const AvatarMove& move, const Blanks& blanks) {
  const auto term = move.channel == "action" ? TermReader(move.content).whole() : std::nullopt;
  return term ? blanked(*term, blanks) : blanked_words(move.content, blanks);
}

std::vector<std::string> template_of(const std::vector<AvatarMove>& moves, const Blanks& blanks) {
  std::vector<std::string> shapes;
  for (const auto& move : moves)
    if (move.channel != "gesture")
      shapes.push_back((move.channel == "speech" ? "say " : "") + template_of(move, blanks));
  return shapes;
}

}  // namespace continua
