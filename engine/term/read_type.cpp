#include "continua/term/read_type.h"

namespace continua {

Type read_type(const Item& item) {
  const auto text = item.text("a type");
  if (!item.is_text()) return Type::term();
  const auto type = Type::parse(text);
  if (type) return *type;
  item.problem_in_text(type.error());
  return Type::term();
}

}  // namespace continua
