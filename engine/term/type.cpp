#include "continua/term/type.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "continua/core/located_json.h"

namespace continua {

struct Type::Node {
  Kind kind;
  std::string name;
  int index = 0;
  std::vector<Type> parts;  // the element of a list; the halves of a dot; `from` and `to` of a function
  bool polymorphic = false;
};

namespace {

constexpr int deepest_nesting = 64;

const std::array<const Type*, 7>& built_in() {
  static const std::array<const Type*, 7> types = {&Type::entity(), &Type::location(),  &Type::region(), &Type::truth(),
                                                   &Type::number(), &Type::text_type(), &Type::term()};
  return types;
}

}  // namespace

Type Type::base(std::string name) {
  for (const Type* type : built_in())
    if (type->name() == name) return *type;
  return Type(std::make_shared<const Node>(Node{Kind::base, std::move(name), 0, {}, false}));
}

Type Type::list(Type element) {
  const bool polymorphic = element.polymorphic();
  return Type(std::make_shared<const Node>(Node{Kind::list, {}, 0, {std::move(element)}, polymorphic}));
}

Type Type::dot(Type first, Type second) {
  const bool polymorphic = first.polymorphic() || second.polymorphic();
  return Type(std::make_shared<const Node>(Node{Kind::dot, {}, 0, {std::move(first), std::move(second)}, polymorphic}));
}

Type Type::function(Type from, Type to) {
  const bool polymorphic = from.polymorphic() || to.polymorphic();
  return Type(std::make_shared<const Node>(Node{Kind::function, {}, 0, {std::move(from), std::move(to)}, polymorphic}));
}

Type Type::variable(int index) { return Type(std::make_shared<const Node>(Node{Kind::variable, {}, index, {}, true})); }

// Each built-in type is one node, so that it is compared by address.
#define CONTINUA_BUILT_IN_TYPE(function, name)                                                  \
  const Type& Type::function() {                                                                \
    static const Type type(std::make_shared<const Node>(Node{Kind::base, name, 0, {}, false})); \
    return type;                                                                                \
  }
CONTINUA_BUILT_IN_TYPE(entity, "e")
CONTINUA_BUILT_IN_TYPE(location, "loc")
CONTINUA_BUILT_IN_TYPE(region, "region")
CONTINUA_BUILT_IN_TYPE(truth, "t")
CONTINUA_BUILT_IN_TYPE(number, "num")
CONTINUA_BUILT_IN_TYPE(text_type, "text")
CONTINUA_BUILT_IN_TYPE(term, "term")
#undef CONTINUA_BUILT_IN_TYPE

const Type& Type::pointing() {
  static const Type type = dot(list(entity()), location());
  return type;
}

Type::Kind Type::kind() const { return node_->kind; }
const std::string& Type::name() const {
  require(node_->kind == Kind::base, "name() of a type that is no base type");
  return node_->name;
}
const Type& Type::element() const {
  require(node_->kind == Kind::list, "element() of a type that is no list");
  return node_->parts[0];
}
const Type& Type::first() const {
  require(node_->kind == Kind::dot, "first() of a type that is no dot");
  return node_->parts[0];
}
const Type& Type::second() const {
  require(node_->kind == Kind::dot, "second() of a type that is no dot");
  return node_->parts[1];
}
const Type& Type::from() const {
  require(node_->kind == Kind::function, "from() of a type that is no function");
  return node_->parts[0];
}
const Type& Type::to() const {
  require(node_->kind == Kind::function, "to() of a type that is no function");
  return node_->parts[1];
}
int Type::index() const {
  require(node_->kind == Kind::variable, "index() of a type that is no variable");
  return node_->index;
}
bool Type::polymorphic() const { return node_->polymorphic; }

bool Type::operator==(const Type& other) const {
  if (node_ == other.node_) return true;
  if (kind() != other.kind()) return false;
  switch (kind()) {
    case Kind::base:
      return name() == other.name();
    case Kind::variable:
      return index() == other.index();
    case Kind::list:
      return element() == other.element();
    case Kind::dot:
    case Kind::function:
      return node_->parts == other.node_->parts;
  }
  return false;
}

bool consistent(const Type& a, const Type& b) {
  if (a.kind() == Type::Kind::base && a == b) return true;
  const auto is_place = [](const Type& type) { return type == Type::location() || type == Type::region(); };
  const auto open = [](const Type& type) { return type.kind() == Type::Kind::variable || type == Type::term(); };
  if (open(a) || open(b)) return true;
  if (a.kind() != b.kind()) return false;
  switch (a.kind()) {
    case Type::Kind::list:
      return consistent(a.element(), b.element());
    case Type::Kind::dot:
      return consistent(a.first(), b.first()) && consistent(a.second(), b.second());
    case Type::Kind::function:
      return consistent(a.from(), b.from()) && consistent(a.to(), b.to());
    default:
      return is_place(a) && is_place(b);
  }
}

std::string Type::text() const {
  switch (kind()) {
    case Kind::base:
      return name();
    case Kind::variable: {
      const std::string letter = {'\'', static_cast<char>('a' + index() % 26)};
      return index() < 26 ? letter : letter + std::to_string(index() / 26);
    }
    case Kind::list: {
      const bool loose = element().kind() == Kind::function || element().kind() == Kind::dot;
      return loose ? "(" + element().text() + ")*" : element().text() + "*";
    }
    case Kind::dot: {
      const auto half = [](const Type& type) {
        const bool loose = type.kind() == Kind::function || type.kind() == Kind::dot;
        return loose ? "(" + type.text() + ")" : type.text();
      };
      return half(first()) + " • " + half(second());
    }
    case Kind::function:
      return (from().kind() == Kind::function ? "(" + from().text() + ")" : from().text()) + " -> " + to().text();
  }
  return {};
}

namespace {

class TypeReader {
 public:
  TypeReader(std::string_view text, const std::vector<std::string>& extra, std::size_t first_column)
      : text_(text), extra_(extra), first_column_(first_column) {}

  Result<Type> whole() {
    auto type = arrow(0);
    if (type && at_ < text_.size()) return found("the end of the type");
    return type;
  }

 private:
  Result<Type> arrow(int nesting) {
    if (nesting > deepest_nesting) return error(at_, fmt::format("the type is nested deeper than {}", deepest_nesting));
    auto from = dotted(nesting);
    if (!from || !take("->")) return from;
    auto to = arrow(nesting + 1);
    if (!to) return to;
    return Type::function(*from, *to);
  }

  Result<Type> dotted(int nesting) {
    auto first = starred(nesting);
    if (!first || !take("•")) return first;
    auto second = starred(nesting);
    if (!second) return second;
    return Type::dot(*first, *second);
  }

  Result<Type> starred(int nesting) {
    auto type = atom(nesting);
    for (int stars = 0; type && take("*"); ++stars) {
      if (stars > deepest_nesting) return error(at_, fmt::format("the type is nested deeper than {}", deepest_nesting));
      type = Type::list(*type);
    }
    return type;
  }

  Result<Type> atom(int nesting) {
    skip_space();
    if (take("(")) {
      auto inner = arrow(nesting + 1);
      if (inner && !take(")")) return found("')'");
      return inner;
    }
    const auto from = at_;
    if (take("'")) return variable(from);
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) ++at_;
    if (at_ == from) return found("a type");
    const auto name = text_.substr(from, at_ - from);
    skip_space();
    return named(name, from);
  }

  Result<Type> variable(std::size_t from) {
    if (at_ == text_.size() || text_[at_] < 'a' || text_[at_] > 'z')
      return found("a letter: a type variable is 'a, 'b, …");
    int index = text_[at_++] - 'a', round = 0;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) && round < 1000)
      round = 10 * round + (text_[at_++] - '0');
    if (round >= 1000) return error(from, "a type variable has a number below 1000");
    index += 26 * round;
    skip_space();
    return Type::variable(index);
  }

  Result<Type> named(std::string_view name, std::size_t from) {
    if (name == "entity") return Type::entity();
    if (name == "location") return Type::location();
    std::vector<std::string> known;
    for (const Type* type : built_in()) known.push_back(type->name());
    known.insert(known.end(), extra_.begin(), extra_.end());
    if (std::find(known.begin(), known.end(), name) != known.end()) return Type::base(std::string(name));
    known.insert(known.end(), {"entity", "location"});
    return error(from, fmt::format("unknown type '{}'{}", name, did_you_mean(name, known)));
  }

  bool take(std::string_view token) {
    skip_space();
    if (text_.substr(at_, token.size()) != token) return false;
    at_ += token.size();
    if (token != "'") skip_space();
    return true;
  }
  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }
  Error error(std::size_t at, std::string sentence) const {
    return {fmt::format("column {}", first_column_ + at), std::move(sentence)};
  }
  Error found(std::string_view expected) const {
    if (at_ >= text_.size()) return error(at_, fmt::format("the type ends here, expected {}", expected));
    return error(at_, fmt::format("found '{}', expected {}", text_.substr(at_, 1), expected));
  }

  std::string_view text_;
  const std::vector<std::string>& extra_;
  std::size_t first_column_;
  std::size_t at_ = 0;
};

}  // namespace

Result<Type> Type::parse(std::string_view text, const std::vector<std::string>& extra, std::size_t first_column) {
  return TypeReader(text, extra, first_column).whole();
}

}  // namespace continua
