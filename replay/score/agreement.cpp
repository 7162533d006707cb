#include "continua/replay/score/agreement.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "continua/term/written_term.h"

namespace continua {
namespace {

constexpr double rounding_m = 1e-9;  // 0.102 - 0.1 is more than 0.002

using Kind = WrittenTerm::Kind;

bool is_place(const WrittenTerm& term) { return term.kind == Kind::place; }

bool holds_place(const WrittenTerm& term) {
  return is_place(term) || std::any_of(term.parts.begin(), term.parts.end(), holds_place);
}

// No variables and no operators, as in the programs of acts.
bool is_plain(const WrittenTerm& term) {
  if (term.kind == Kind::lambda || (term.kind == Kind::other && !term.parts.empty())) return false;
  return std::all_of(term.parts.begin(), term.parts.end(), is_plain);
}

// The term of an act's content; nothing where the content is no term.
std::optional<WrittenTerm> plain_term(const std::string& content) {
  auto term = read_written_term(content);
  if (!term || !is_plain(*term)) return std::nullopt;
  return *std::move(term);
}

bool near(double a, double b) { return std::abs(a - b) <= place_tolerance_m + rounding_m; }

bool same(const WrittenTerm& observed, const WrittenTerm& produced, bool lax) {
  // part('front', 'left', <0.1, 0, 0>) describes a place: which one was taken was left open.
  if (lax && is_place(observed) && !is_place(produced) && holds_place(produced)) return true;
  if (observed.kind != produced.kind || observed.parts.size() != produced.parts.size()) return false;
  if (is_place(observed))
    return std::equal(observed.place.min.begin(), observed.place.min.end(), produced.place.min.begin(), near);
  if (observed.kind == Kind::number) return near(observed.number, produced.number);
  if (observed.parts.empty() ? observed.written != produced.written : observed.name != produced.name) return false;
  return std::equal(observed.parts.begin(), observed.parts.end(), produced.parts.begin(),
                    [lax](const WrittenTerm& one, const WrittenTerm& other) { return same(one, other, lax); });
}

bool same(const AvatarMove& observed, const AvatarMove& produced, bool lax) {
  if (observed.channel != produced.channel) return false;
  if (observed.content == produced.content) return true;
  if (observed.channel == "speech") return false;
  const auto a = plain_term(observed.content), b = plain_term(produced.content);
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

std::string blanked(const WrittenTerm& term, const Blanks& blanks) {
  if (is_place(term)) return "_";
  const bool list = term.kind == Kind::list;
  if (term.parts.empty() && !list)
    return blanks.names.contains(lower(term.written)) ? "_" : blanked_words(term.written, blanks);
  // The description of a place is blanked like the place; on(block1) describes none by coordinates.
  std::string parts;
  for (const auto& part : term.parts)
    parts += (parts.empty() ? "" : ", ") + (holds_place(part) ? "_" : blanked(part, blanks));
  return list ? "[" + parts + "]" : term.name + "(" + parts + ")";
}

}  // namespace

std::string name_of(AgreementLevel level) {
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
  const auto term = move.channel == "action" ? plain_term(move.content) : std::nullopt;
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
