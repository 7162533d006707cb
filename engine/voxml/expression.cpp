#include "voxml/expression.h"

namespace continua {

std::string print(const Expression& expression) {
  using Kind = Expression::Kind;
  const auto& arguments = expression.arguments;
  const auto joined = [&](const char* separator) {
    std::string text;
    for (std::size_t i = 0; i < arguments.size(); ++i) text += (i == 0 ? "" : separator) + print(arguments[i]);
    return text;
  };
  switch (expression.kind) {
    case Kind::name:
      return expression.name;
    case Kind::call:
      return expression.name + "(" + joined(", ") + ")";
    case Kind::component:
      return "[" + expression.name + "]";
    case Kind::text:
      return "'" + expression.name + "'";
    case Kind::negation:
      return "!" + joined("");
    case Kind::both:
      return joined(" ^ ");
    case Kind::either:
      return joined(" | ");
  }
  return "";
}

}  // namespace continua
