#include "continua/term/elaborate.h"

#include <utility>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/term/lexer.h"
#include "continua/term/unify.h"

namespace continua {
namespace {

class Elaborator {
 public:
  explicit Elaborator(const Signature& names) : names_(names) {}

  Result<Term> run(Syntax& syntax, const Type* expected) {
    auto term = typed(syntax, expected);
    return unifier_.gave_up() ? error(syntax, "the types of this term grow too large to be followed") : term;
  }

 private:
  struct Variable {
    std::string name;
    Type type;
  };

  Result<Term> typed(Syntax& syntax, const Type* expected) {
    const Type wanted = expected ? unifier_.instance(*expected) : unifier_.fresh();
    auto type = infer(syntax, wanted);
    if (!type) return type.error();
    if (!unifier_.unify(*type, wanted))
      return error(syntax, fmt::format("found {}, expected {}", unifier_.described(*type), unifier_.described(wanted)));
    return built(syntax);
  }

  // The type of a term in a place that expects `wanted`. The expectation only guides the inference; the caller checks
  // that it is met.
  Result<Type> infer(Syntax& syntax, const Type& wanted) {
    switch (syntax.kind) {
      case Syntax::Kind::literal:
        return syntax.literal.is_null() ? unifier_.fresh() : syntax.literal.type();
      case Syntax::Kind::name:
        return infer_name(syntax);
      case Syntax::Kind::lambda:
        return infer_lambda(syntax, unifier_.known(wanted));
      case Syntax::Kind::list:
        return infer_list(syntax, unifier_.known(wanted));
      case Syntax::Kind::apply:
        return infer_apply(syntax);
    }
    return Type::term();
  }

  Result<Type> infer_name(Syntax& syntax) {
    for (std::size_t i = scope_.size(); i-- > 0 && !syntax.constant;) {
      if (scope_[i].name != syntax.name) continue;
      syntax.bound = static_cast<int>(scope_.size() - 1 - i);
      syntax.type = scope_[i].type;
      return *syntax.type;
    }
    for (const Signature* signature : {&names_, &core_signature()}) {
      const auto found = signature->find(syntax.name);
      if (found == signature->end()) continue;
      syntax.type = unifier_.instance(found->second);
      return *syntax.type;
    }
    return error(syntax, fmt::format("unknown name '{}'{}", syntax.name, did_you_mean(syntax.name, known_names())));
  }

  Result<Type> infer_lambda(Syntax& syntax, const Type& wanted) {
    const bool function = wanted.kind() == Type::Kind::function;
    if (syntax.annotation)
      syntax.type = unifier_.instance(*syntax.annotation);
    else
      syntax.type = function ? wanted.from() : unifier_.fresh();
    scope_.push_back({syntax.name, *syntax.type});
    auto body = infer(syntax.parts[0], function ? wanted.to() : unifier_.fresh());
    scope_.pop_back();
    if (!body) return body;
    return Type::function(*syntax.type, *body);
  }

  // All elements have the same type, unless a list of `term` is wanted.
  Result<Type> infer_list(Syntax& syntax, const Type& wanted) {
    const bool of_terms = wanted.kind() == Type::Kind::list && unifier_.known(wanted.element()) == Type::term();
    const Type element = of_terms ? Type::term() : unifier_.fresh();
    const Type wanted_element = wanted.kind() == Type::Kind::list ? wanted.element() : element;
    syntax.type = element;
    for (auto& part : syntax.parts) {
      auto type = infer(part, wanted_element);
      if (!type) return type;
      if (!unifier_.unify(element, *type))
        return error(part, fmt::format("the elements of a list have one type: found {} after {}",
                                       unifier_.described(*type), unifier_.described(element)));
    }
    return Type::list(element);
  }

  Result<Type> infer_apply(Syntax& syntax) {
    auto type = infer(syntax.parts[0], unifier_.fresh());
    if (!type) return type;
    for (std::size_t i = 1; i < syntax.parts.size(); ++i) {
      auto& part = syntax.parts[i];
      const Type function = unifier_.known(*type);
      auto argument = infer(part, function.kind() == Type::Kind::function ? Type(function.from()) : unifier_.fresh());
      if (!argument) return argument;
      if (function.kind() == Type::Kind::variable) {
        const Type result = unifier_.fresh();
        if (!unifier_.unify(function, Type::function(*argument, result)))
          return error(part, fmt::format("{} cannot be applied to what contains it", named(syntax.parts[0])));
        type = result;
      } else if (function.kind() == Type::Kind::function) {
        if (!unifier_.unify(function.from(), *argument)) return mismatch(syntax, i, function, *argument);
        type = function.to();
      } else if (!(function == Type::term())) {
        return too_many(syntax, i, function);
      }
    }
    return type;
  }

  // "'size' takes a list, found num"
  Error mismatch(const Syntax& syntax, std::size_t i, const Type& function, const Type& argument) {
    const bool last_and_first = i == 1 && unifier_.known(function.to()).kind() != Type::Kind::function;
    const bool ordinal = !last_and_first && syntax.parts[0].begin < syntax.parts[1].begin;  // not of an infix operator
    return error(syntax.parts[i],
                 fmt::format("{} takes {}{}, found {}", named(syntax.parts[0]), unifier_.described(function.from()),
                             ordinal ? fmt::format(" as argument {}", i) : "", unifier_.described(argument)));
  }

  Error too_many(const Syntax& syntax, std::size_t i, const Type& type) {
    const auto found = syntax.parts.size() - 1;
    if (i == 1)
      return error(syntax.parts[0],
                   fmt::format("{} is no function but {}; found {} argument{} for it", named(syntax.parts[0]),
                               unifier_.described(type), found, found == 1 ? "" : "s"));
    return error(syntax.parts[i], fmt::format("{} takes {} argument{}, found {}", named(syntax.parts[0]), i - 1,
                                              i == 2 ? "" : "s", found));
  }

  Term built(const Syntax& syntax) {
    switch (syntax.kind) {
      case Syntax::Kind::literal:
        return syntax.literal;
      case Syntax::Kind::name: {
        Type type = unifier_.resolved(*syntax.type);
        return syntax.bound < 0 ? Term::constant(syntax.name, std::move(type))
                                : Term::bound(syntax.bound, std::move(type));
      }
      case Syntax::Kind::lambda:
        return Term::lambda(syntax.name, unifier_.resolved(*syntax.type), built(syntax.parts[0]));
      case Syntax::Kind::list: {
        std::vector<Term> elements;
        for (const auto& part : syntax.parts) elements.push_back(built(part));
        return Term::list(std::move(elements), unifier_.resolved(*syntax.type));
      }
      case Syntax::Kind::apply: {
        if (is_region_literal(syntax))
          return Term::place(
              {syntax.parts[1].literal.place_value().min, syntax.parts[2].literal.place_value().min, true});
        Term term = built(syntax.parts[0]);
        for (std::size_t i = 1; i < syntax.parts.size(); ++i)
          term = Term::apply(std::move(term), built(syntax.parts[i]));
        return term;
      }
    }
    return Term();
  }

  // Whether it is box(<…>, <…>) of two literal points.
  static bool is_region_literal(const Syntax& syntax) {
    const auto is_point = [](const Syntax& part) {
      return part.kind == Syntax::Kind::literal && part.literal.kind() == Term::Kind::place;
    };
    const auto& head = syntax.parts[0];
    return syntax.parts.size() == 3 && head.kind == Syntax::Kind::name && head.name == "box" && head.bare &&
           head.bound < 0 && is_point(syntax.parts[1]) && is_point(syntax.parts[2]);
  }

  std::vector<std::string> known_names() const {
    std::vector<std::string> known;
    for (auto variable = scope_.rbegin(); variable != scope_.rend(); ++variable) known.push_back(variable->name);
    for (const Signature* signature : {&names_, &core_signature()})
      for (const auto& [name, type] : *signature)
        if (is_plain_name(name)) known.push_back(name);
    return known;
  }

  static std::string named(const Syntax& syntax) {
    return syntax.kind == Syntax::Kind::name ? fmt::format("'{}'", syntax.name) : "this";
  }
  static Error error(const Syntax& syntax, std::string sentence) { return {column(syntax.begin), std::move(sentence)}; }

  const Signature& names_;
  Unifier unifier_;
  std::vector<Variable> scope_;
};

}  // namespace

Result<Term> elaborate(Syntax syntax, const Signature& names, const Type* expected) {
  return Elaborator(names).run(syntax, expected);
}

}  // namespace continua
