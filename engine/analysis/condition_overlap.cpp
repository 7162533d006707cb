#include "continua/analysis/condition_overlap.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr std::size_t most_clauses = 256;
constexpr int deepest = 64;

// A requirement of a clause: `left relation right`, or that `left` is true (relation "is") or false ("is not").
struct Literal {
  std::string left, relation;
  Term right;
};
using Clause = std::vector<Literal>;  // all must hold
using Clauses = std::vector<Clause>;  // one must hold

bool is_value(const Term& term) {
  switch (term.kind()) {
    case Term::Kind::null:
    case Term::Kind::truth:
    case Term::Kind::number:
    case Term::Kind::text:
    case Term::Kind::place:
      return true;
    case Term::Kind::list:
      return std::all_of(term.elements().begin(), term.elements().end(), is_value);
    default:
      return false;
  }
}

const std::map<std::string, std::string, std::less<>>& contraries() {
  static const std::map<std::string, std::string, std::less<>> table = {
      {"=", "!="}, {"!=", "="}, {"<", ">="}, {">=", "<"}, {">", "<="}, {"<=", ">"}, {"is", "is not"}, {"is not", "is"}};
  return table;
}

const std::map<std::string, std::string, std::less<>>& mirrored() {
  static const std::map<std::string, std::string, std::less<>> table = {{"=", "="},   {"!=", "!="}, {"<", ">"},
                                                                        {">=", "<="}, {">", "<"},   {"<=", ">="}};
  return table;
}

class Expansion {
 public:
  explicit Expansion(const Machine& machine) : machine_(machine) {}

  // The condition, or its contrary if `holds` is false, as a disjunction of conjunctions.
  Clauses clauses(const Term& term, bool holds, int depth) {
    const auto [head, arguments] = term.spine();
    if (term.kind() == Term::Kind::truth) return term.truth_value() == holds ? Clauses{{}} : Clauses{};
    if (head.kind() == Term::Kind::constant && depth < deepest) {
      const auto& name = head.name();
      if (name == "not" && arguments.size() == 1) return clauses(arguments[0], !holds, depth + 1);
      if ((name == "and" || name == "or") && arguments.size() == 2) {
        auto left = clauses(arguments[0], holds, depth + 1), right = clauses(arguments[1], holds, depth + 1);
        return (name == "and") == holds ? both(left, right) : either(std::move(left), right);
      }
      if (const auto definition = machine_.definitions.find(name);
          arguments.empty() && definition != machine_.definitions.end())
        return clauses(definition->second, holds, depth + 1);
      if (mirrored().contains(name) && arguments.size() == 2) return {{comparison(name, arguments, holds)}};
    }
    return {{Literal{print(term), holds ? "is" : "is not", Term()}}};
  }

  static Clauses both(const Clauses& a, const Clauses& b) {
    Clauses product;
    for (const auto& left : a)
      for (const auto& right : b) {
        if (product.size() == most_clauses) return product;
        product.push_back(left);
        product.back().insert(product.back().end(), right.begin(), right.end());
      }
    return product;
  }

 private:
  static Clauses either(Clauses a, const Clauses& b) {
    a.insert(a.end(), b.begin(), b.end());
    if (a.size() > most_clauses) a.resize(most_clauses);
    return a;
  }

  static Literal comparison(const std::string& name, const std::vector<Term>& sides, bool holds) {
    const bool value_first = is_value(sides[0]) && !is_value(sides[1]);
    auto relation = value_first ? mirrored().find(name)->second : name;
    if (!holds) relation = contraries().find(relation)->second;
    return {print(sides[value_first ? 1 : 0]), relation, sides[value_first ? 0 : 1]};
  }

  const Machine& machine_;
};

// The requirements of a clause on one term.
class KnownFacts {
 public:
  // Adds a requirement. Returns whether it is consistent with those before.
  bool add(const Literal& literal) {
    const auto& [left, relation, right] = literal;
    if (!is_value(right)) {
      relations_.emplace(relation, print(right));
      return consistent();
    }
    if (relation == "is" || relation == "is not") {
      (relation == "is" ? is_ : is_not_) = true;
    } else if (relation == "=") {
      if (equal_ && !(*equal_ == right)) return false;
      equal_ = right;
    } else if (relation == "!=") {
      unequal_.push_back(right);
    } else if (right.kind() == Term::Kind::number) {
      bound(relation, right.number_value());
    }
    return consistent();
  }

 private:
  void bound(const std::string& relation, double value) {
    unequal_.push_back(Term::null());
    const bool strict = relation.size() == 1;
    if (relation[0] == '>') {
      if (value > low_ || (value == low_ && strict)) low_strict_ = strict, low_ = value;
    } else if (value < high_ || (value == high_ && strict)) {
      high_strict_ = strict, high_ = value;
    }
  }

  bool consistent() const {
    if (is_ && is_not_) return false;
    for (const auto& [relation, right] : relations_)
      if (relations_.contains({contraries().find(relation)->second, right})) return false;
    if (low_ > high_ || (low_ == high_ && (low_strict_ || high_strict_))) return false;
    if (!equal_) return true;
    if (std::any_of(unequal_.begin(), unequal_.end(), [&](const Term& value) { return value == *equal_; }))
      return false;
    if (equal_->kind() != Term::Kind::number) return true;
    const double value = equal_->number_value();
    return value >= low_ && value <= high_ && !(value == low_ && low_strict_) && !(value == high_ && high_strict_);
  }

  bool is_ = false, is_not_ = false;
  std::set<std::pair<std::string, std::string>> relations_;  // to terms that are not values
  std::optional<Term> equal_;
  std::vector<Term> unequal_;
  double low_ = -std::numeric_limits<double>::infinity(), high_ = std::numeric_limits<double>::infinity();
  bool low_strict_ = false, high_strict_ = false;
};

std::string text(const Literal& literal) {
  if (literal.relation == "is") return literal.left;
  if (literal.relation == "is not") return "not " + literal.left;
  return fmt::format("{} {} {}", literal.left, literal.relation, print(literal.right));
}

// The clause as text, without repetitions; nothing if it contradicts itself.
std::optional<std::string> satisfied(const Clause& clause) {
  std::map<std::string, KnownFacts> facts;
  std::vector<std::string> texts;
  for (const auto& literal : clause) {
    if (!facts[literal.left].add(literal)) return std::nullopt;
    const auto words = text(literal);
    if (std::find(texts.begin(), texts.end(), words) == texts.end()) texts.push_back(words);
  }
  std::string all;
  for (const auto& words : texts) all += (all.empty() ? "" : " and ") + words;
  return all;
}

}  // namespace

std::optional<std::string> overlap(const std::optional<Term>& a, const std::optional<Term>& b, const Machine& machine) {
  Expansion expansion(machine);
  const auto of = [&](const std::optional<Term>& condition) {
    return condition ? expansion.clauses(*condition, true, 0) : Clauses{{}};
  };
  for (const auto& clause : Expansion::both(of(a), of(b)))
    if (const auto words = satisfied(clause)) return words;
  return std::nullopt;
}

}  // namespace continua
