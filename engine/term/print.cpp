#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "continua/term/lexer.h"
#include "continua/term/substitution.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

// How tightly an operator binds, and the least binding of a left and right operand without parentheses.
struct Infix {
  std::string_view sign;
  int binding, left, right;
};
constexpr int negation_binding = 3, sum_binding = 5, minus_binding = 7, operand_binding = 8;
constexpr std::array<Infix, 12> infixes = {{{"or", 1, 1, 2},
                                            {"and", 2, 2, 3},
                                            {"=", 4, 5, 5},
                                            {"!=", 4, 5, 5},
                                            {"<", 4, 5, 5},
                                            {"<=", 4, 5, 5},
                                            {">", 4, 5, 5},
                                            {">=", 4, 5, 5},
                                            {"+", 5, 5, 6},
                                            {"-", 5, 5, 6},
                                            {"*", 6, 6, 7},
                                            {"/", 6, 6, 7}}};

const Infix* infix(const std::string& name) {
  const auto found = std::find_if(infixes.begin(), infixes.end(), [&](const Infix& each) { return each.sign == name; });
  return found == infixes.end() ? nullptr : &*found;
}

bool mentions_name(const Term& term, const std::string& constant) {
  switch (term.kind()) {
    case Term::Kind::constant:
      return term.name() == constant;
    case Term::Kind::lambda:
      return mentions_name(term.body(), constant);
    case Term::Kind::apply:
      return mentions_name(term.function(), constant) || mentions_name(term.argument(), constant);
    case Term::Kind::list:
      return std::any_of(term.elements().begin(), term.elements().end(),
                         [&](const Term& each) { return mentions_name(each, constant); });
    default:
      return false;
  }
}
class Printer {
 public:
  explicit Printer(Lambda lambda) : lambda_(lambda) {}

  // Appends `term`, in parentheses if it binds less tightly than `least`.
  void print(const Term& term, int least) {
    switch (term.kind()) {
      case Term::Kind::null:
        out_ += "null";
        break;
      case Term::Kind::truth:
        out_ += term.truth_value() ? "true" : "false";
        break;
      case Term::Kind::number:
        number(term.number_value());
        break;
      case Term::Kind::text:
        quoted(term.text_value(), '\'');
        break;
      case Term::Kind::place:
        place(term.place_value());
        break;
      case Term::Kind::constant:
        constant(term.name());
        break;
      case Term::Kind::bound:
        bound(term.index());
        break;
      case Term::Kind::lambda:
        lambda(term, least);
        break;
      case Term::Kind::apply:
        apply(term, least);
        break;
      case Term::Kind::list:
        list(term.elements(), '[', ']', 0);
        break;
    }
  }

  std::string take() { return std::move(out_); }

 private:
  void number(double value) { fmt::format_to(std::back_inserter(out_), "{}", value); }

  void quoted(const std::string& text, char quote) {
    out_ += quote;
    for (char c : text) {
      if (c == quote || c == '\\') out_ += '\\';
      out_ += c;
    }
    out_ += quote;
  }

  void place(const Place& place) {
    const auto point = [&](const Point& p) {
      fmt::format_to(std::back_inserter(out_), "<{}, {}, {}>", p[0], p[1], p[2]);
    };
    if (!place.region) return point(place.min);
    out_ += "box(";
    point(place.min);
    out_ += ", ";
    point(place.max);
    out_ += ')';
  }

  void constant(const std::string& name) {
    if (infix(name) || name == "not")
      out_ += "(" + name + ")";
    else if (is_plain_name(name) && !is_keyword(name))
      out_ += name;
    else
      quoted(name, '`');
  }

  // A variable bound outside the printed term has no name; it is printed for debugging only.
  void bound(int index) {
    const auto depth = static_cast<int>(scope_.size());
    out_ += index < depth ? scope_[depth - 1 - index] : fmt::format("`free {}`", index - depth);
  }

  void lambda(const Term& term, int least) {
    const auto outer = scope_.size();
    if (least > 0) out_ += '(';
    out_ += lambda_ == Lambda::greek ? "λ" : "\\";
    const Term* body = &term;
    for (; body->kind() == Term::Kind::lambda; body = &body->body()) {
      if (body != &term) out_ += ' ';
      scope_.push_back(unused(body->name(), body->body()));
      out_ += scope_.back();
    }
    out_ += ". ";
    print(*body, 0);
    if (least > 0) out_ += ')';
    scope_.resize(outer);
  }

  // The hint of a variable, with primes as long as the body mentions something else of that name.
  std::string unused(const std::string& hint, const Term& body) const {
    std::string name = is_plain_name(hint) && !is_keyword(hint) ? hint : "x";
    const auto taken = [&] {
      if (name == "box" || mentions_name(body, name)) return true;  // box(…) is how regions print
      for (std::size_t i = 0; i < scope_.size(); ++i)
        if (scope_[i] == name && mentions(body, static_cast<int>(scope_.size() - i))) return true;
      return false;
    };
    while (taken()) name += '\'';
    return name;
  }

  void apply(const Term& term, int least) {
    const TermSpine spine = term.spine();
    const auto& head = spine.head;
    const auto& arguments = spine.arguments;
    if (head.kind() != Term::Kind::constant) return call(head, arguments);
    const auto& name = head.name();
    const Infix* sign = infix(name);
    if (sign && arguments.size() == 2) return operation(*sign, arguments, least);
    if (name == "not" && arguments.size() == 1) return prefix("not ", arguments[0], negation_binding, least);
    if (name == "negate" && arguments.size() == 1 && arguments[0].kind() != Term::Kind::number)
      return prefix("-", arguments[0], minus_binding, least);
    const auto is = [&](Term::Kind kind) {
      return std::all_of(arguments.begin(), arguments.end(), [&](const Term& each) { return each.kind() == kind; });
    };
    if (name == "xyz" && arguments.size() == 3 && !is(Term::Kind::number))
      return list(arguments, '<', '>', sum_binding);
    if (name == "box" && arguments.size() == 2 && is(Term::Kind::place))
      out_ += "(box)";
    else
      constant(name);
    list(arguments, '(', ')', 0);
  }

  void call(const Term& head, const std::vector<Term>& arguments) {
    print(head, operand_binding);
    list(arguments, '(', ')', 0);
  }

  void operation(const Infix& sign, const std::vector<Term>& arguments, int least) {
    if (sign.binding < least) out_ += '(';
    print(arguments[0], sign.left);
    fmt::format_to(std::back_inserter(out_), " {} ", sign.sign);
    print(arguments[1], sign.right);
    if (sign.binding < least) out_ += ')';
  }

  void prefix(std::string_view sign, const Term& inner, int binding, int least) {
    if (binding < least) out_ += '(';
    out_ += sign;
    print(inner, binding);
    if (binding < least) out_ += ')';
  }

  void list(const std::vector<Term>& parts, char open, char close, int least) {
    out_ += open;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i > 0) out_ += ", ";
      print(parts[i], least);
    }
    out_ += close;
  }

  Lambda lambda_;
  std::string out_;
  std::vector<std::string> scope_;
};

}  // namespace

std::string print(const Term& term, Lambda lambda) {
  Printer printer(lambda);
  printer.print(term, 0);
  return printer.take();
}

}  // namespace continua
