#include "continua/voxml/expression.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "continua/voxml/expression_reader.h"

namespace continua {
namespace {

using Kind = Expression::Kind;
using When = Subevent::When;

std::string joined(const std::vector<Expression>& expressions, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < expressions.size(); ++i)
    text += (i == 0 ? "" : std::string(separator)) + print(expressions[i]);
  return text;
}

// Prints an operand of ^ or !, in brackets if it is itself joined by ^ or |.
std::string operand(const Expression& expression) {
  const bool loose = expression.kind == Kind::both || expression.kind == Kind::either;
  return loose ? "(" + print(expression) + ")" : print(expression);
}

Expression all_of(const std::vector<Expression>& expressions) {
  Expression all{Kind::both, "", {}};
  for (const auto& each : expressions)
    if (each.kind == Kind::both)
      all.arguments.insert(all.arguments.end(), each.arguments.begin(), each.arguments.end());
    else
      all.arguments.push_back(each);
  return all.arguments.size() == 1 ? Expression(all.arguments[0]) : all;
}

std::vector<Expression> parts(const Expression& expression) {
  return expression.kind == Kind::both ? expression.arguments : std::vector{expression};
}

// Reads expressions with commas or semicolons between them.
Result<std::vector<Expression>> list(ExpressionReader& reader) {
  std::vector<Expression> all;
  do {
    auto each = reader.expression();
    if (!each) return each.error();
    all.push_back(std::move(*each));
  } while (reader.take(",") || reader.take(";"));
  return all;
}

// The number of a habitat H, H2, H_2, H[2] or H_[2]; empty for a bare H; nothing if it is not a habitat.
std::optional<std::string> habitat_number(const Expression& expression) {
  if (expression.kind != Kind::name || !expression.name.starts_with('H')) return std::nullopt;
  std::string_view rest = std::string_view(expression.name).substr(1);
  if (rest.starts_with('_')) rest.remove_prefix(1);
  if (rest.starts_with('[') && rest.ends_with(']')) rest = rest.substr(1, rest.size() - 2);
  if (rest.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  return std::string(rest);
}

// Reads the rest of a step after "while(" or "if(".
Result<Subevent> guarded(ExpressionReader& reader, When when) {
  Subevent subevent{when, {}, {}};
  auto inside = list(reader);
  if (!inside) return inside.error();
  if (auto problem = reader.close(")")) return *problem;
  if (reader.take(":") || reader.take("->")) {
    auto event = reader.expression();
    if (!event) return event.error();
    subevent.event = std::move(*event);
  } else if (inside->size() > 1) {
    subevent.event = std::move(inside->back());
    inside->pop_back();
  } else if (when == When::once) {
    return reader.expected("':' and what happens then");
  }
  subevent.condition = all_of(*inside);
  return subevent;
}

Result<Subevent> subevent_of(ExpressionReader& reader) {
  if (reader.take_opening("while")) return guarded(reader, When::during);
  if (reader.take_opening("if")) return guarded(reader, When::once);
  auto event = reader.expression();
  if (!event) return event.error();
  if (!reader.take("->")) return Subevent{When::always, {}, std::move(*event)};
  auto then = reader.expression();
  if (!then) return then.error();
  return Subevent{When::once, std::move(*event), std::move(*then)};
}

// Skips the label of "E1 = grasp(x,y)" and "e1: grasp(x,y)".
void skip_label(ExpressionReader& reader) {
  const auto begin = reader.at();
  const auto label = reader.expression();
  if (!label || label->kind != Kind::name || !(reader.take("=") || reader.take(":"))) reader.go_back(begin);
}

}  // namespace

bool is_vector(const Expression& expression) {
  return expression.kind == Kind::call && expression.name == "vec" && expression.arguments.size() == 3;
}

std::string print(const Expression& expression) {
  const auto& arguments = expression.arguments;
  switch (expression.kind) {
    case Kind::name:
      return expression.name;
    case Kind::call:
      if (is_vector(expression))
        return fmt::format("{}({} -> {} × {})", expression.name, print(arguments[0]), print(arguments[1]),
                           print(arguments[2]));
      return expression.name + "(" + joined(arguments, ", ") + ")";
    case Kind::component:
      return "[" + expression.name + "]";
    case Kind::text: {
      const bool quotes =
          expression.name.find('\'') != std::string::npos || expression.name.find("’") != std::string::npos;
      const char mark = quotes ? '"' : '\'';
      return mark + expression.name + mark;
    }
    case Kind::negation:
      return "!" + operand(arguments[0]);
    case Kind::either:
      return joined(arguments, " | ");
    case Kind::both: {
      std::string text;
      for (const auto& each : arguments) text += (text.empty() ? "" : " ^ ") + operand(each);
      return text;
    }
  }
  return "";
}

std::string print(const Subevent& subevent) {
  const auto event = print(subevent.event);
  if (subevent.when == When::always) return event;
  return fmt::format("{}({}){}{}", subevent.when == When::once ? "if" : "while", print(subevent.condition),
                     event.empty() ? "" : ":", event);
}

std::string print(const Affordance& affordance) {
  return fmt::format("H{}{}{}->[{}]{}", affordance.habitat.empty() ? "" : "[" + affordance.habitat + "]",
                     affordance.conditions.empty() ? "" : ",", joined(affordance.conditions, ", "),
                     print(affordance.event), joined(affordance.results, ", "));
}

Result<Expression> parse_expression(std::string_view text) {
  ExpressionReader reader(text, false);
  auto expression = reader.expression();
  if (expression && !reader.at_end()) return reader.expected("the end");
  return expression;
}

Result<Subevent> parse_subevent(std::string_view text) {
  auto all = parse_subevents(text);
  if (!all) return all.error();
  if (all->size() > 1) return Error{"", fmt::format("found {} steps, expected one", all->size())};
  return std::move(all->front());
}

Result<std::vector<Subevent>> parse_subevents(std::string_view text) {
  ExpressionReader reader(text, true);
  std::vector<Subevent> all;
  do {
    skip_label(reader);
    reader.take("[");
    auto each = subevent_of(reader);
    if (!each) return each.error();
    all.push_back(std::move(*each));
    reader.skip_closing();
  } while (reader.take(";") && !reader.at_end());
  if (!reader.at_end()) return reader.expected("';' or the end");
  return all;
}

Result<Affordance> parse_affordance(std::string_view text) {
  ExpressionReader reader(text, true);
  Affordance affordance;
  if (!reader.take("->") && !reader.comes("[")) {
    auto before = list(reader);
    if (!before) return before.error();
    auto conditions = parts(all_of(*before));
    if (auto number = habitat_number(conditions[0])) {
      affordance.habitat = std::move(*number);
      conditions.erase(conditions.begin());
    }
    affordance.conditions = std::move(conditions);
    if (!reader.take("->")) return reader.expected("'->'");
  }
  const bool bracketed = reader.take("[");
  auto events = list(reader);
  if (!events) return events.error();
  affordance.event = all_of(*events);
  if (bracketed) {
    while (reader.take(")")) continue;
    if (auto problem = reader.close("]")) return *problem;
  }
  reader.take(",");
  if (!reader.at_end() && !reader.comes("]") && !reader.comes(")")) {
    auto results = list(reader);
    if (!results) return results.error();
    affordance.results = parts(all_of(*results));
  }
  reader.skip_closing();
  if (!reader.at_end()) return reader.expected("the end");
  return affordance;
}

}  // namespace continua
