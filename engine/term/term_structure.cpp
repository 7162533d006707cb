#include "continua/term/term_structure.h"

#include <string>
#include <utility>

#include "continua/term/syntax.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

Json literal(std::string text) { return {{"kind", "literal"}, {"text", std::move(text)}}; }

class Structure {
 public:
  explicit Structure(std::string_view text) : text_(text) {}

  Json of(const Syntax& syntax) const {
    switch (syntax.kind) {
      case Syntax::Kind::literal:
        return value(syntax);
      case Syntax::Kind::name:
        return {{"kind", "name"}, {"name", syntax.name}, {"quoted", text_[syntax.begin] == '`'}};
      case Syntax::Kind::lambda:
        return {{"kind", "lambda"},
                {"name", syntax.name},
                {"type", syntax.annotation ? Json(syntax.annotation->text()) : Json()},
                {"body", of(syntax.parts.front())}};
      case Syntax::Kind::list:
        return {{"kind", "list"}, {"parts", all(syntax, 0)}};
      case Syntax::Kind::apply:
        break;
    }
    if (text_[syntax.begin] == '<') return {{"kind", "point"}, {"parts", all(syntax, 1)}};
    return {{"kind", "apply"}, {"head", of(syntax.parts.front())}, {"args", all(syntax, 1)}};
  }

 private:
  Json all(const Syntax& syntax, std::size_t from) const {
    auto parts = Json::array();
    for (auto i = from; i < syntax.parts.size(); ++i) parts.push_back(of(syntax.parts[i]));
    return parts;
  }

  static Json point(const Point& place) {
    auto parts = Json::array();
    for (const double coordinate : place) parts.push_back(literal(print(Term::number(coordinate))));
    return {{"kind", "point"}, {"parts", parts}};
  }

  static Json value(const Syntax& syntax) {
    if (syntax.literal.kind() != Term::Kind::place) return literal(print(syntax.literal));
    const auto& place = syntax.literal.place_value();
    if (!place.region) return point(place.min);
    return {{"kind", "apply"},
            {"head", {{"kind", "name"}, {"name", "box"}, {"quoted", false}}},
            {"args", {point(place.min), point(place.max)}}};
  }

  std::string_view text_;
};

}  // namespace

Json term_structure(std::string_view text) {
  const auto syntax = parse_syntax(text, {});
  return syntax ? Structure(text).of(*syntax) : literal(std::string(text));
}

}  // namespace continua
