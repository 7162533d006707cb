#include "continua/language/interpretation.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "continua/language/referring.h"
#include "continua/term/continuation.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

using By = Resolution::By;

// The computation of a term recurses as deep as the term has parts; the bound protects the call stack.
constexpr std::size_t most_parts = 1000;
// "those blocks on those plates" is one command for each pair; the bound keeps the product small.
constexpr std::size_t most_commands = 100;

/// A term and the inputs that it draws on.
struct Value {
  Term term;
  std::vector<By> by;
};

/// The meaning of a sentence, in which variables stand for open parts, the outermost first.
struct Answer {
  struct Open {
    Gap gap;
    Term variable;
  };
  Term meaning;
  std::vector<Open> open;
};

using Rest = Continuation<Value, Answer>;
using Meaning = Comp<Value, Answer>;
using ValueFunction = std::function<Value(Value)>;

std::vector<By> together(const std::vector<By>& a, const std::vector<By>& b) {
  std::vector<By> all = a;
  for (const auto each : b)
    if (std::find(all.begin(), all.end(), each) == all.end()) all.push_back(each);
  return all;
}

// Answers for several objects as one answer: the list of their terms, below the same gaps.
Answer together(std::vector<Answer> answers) {
  std::vector<Term> meanings;
  for (const auto& each : answers) {
    if (each.meaning.kind() == Term::Kind::list)
      meanings.insert(meanings.end(), each.meaning.elements().begin(), each.meaning.elements().end());
    else
      meanings.push_back(each.meaning);
  }
  Answer all = std::move(answers.front());
  Type type = meanings.empty() ? Type::term() : meanings.front().type();
  all.meaning = Term::list(std::move(meanings), std::move(type));
  return all;
}

class Interpreter {
 public:
  Interpreter(const Reading& reading, const std::vector<std::string>& words, const Context& context,
              const Meanings& meanings, const RaisingRules& raising)
      : reading_(reading),
        referring_(reading, words, context, meanings),
        facts_(context.facts),
        meanings_(meanings),
        raising_(raising) {
    collect_names(reading.term);
    for (const auto& object : context.facts.world->objects) names_.insert(object.name);
  }

  Interpretation run() {
    const Term& term = reading_.term;
    if (!term.closed() || term.size() > most_parts) return {};
    const Answer answer = referring_.is_noun(term) ? noun(term)(finished) : sentence(term);
    result_.meaning = answer.meaning;
    for (auto open = answer.open.rbegin(); open != answer.open.rend(); ++open) {
      result_.meaning = abstraction(open->variable, result_.meaning);
      result_.gaps.insert(result_.gaps.begin(), open->gap);
    }
    return std::move(result_);
  }

 private:
  void collect_names(const Term& term) {
    switch (term.kind()) {
      case Term::Kind::constant:
        names_.insert(term.name());
        break;
      case Term::Kind::lambda:
        return collect_names(term.body());
      case Term::Kind::apply:
        collect_names(term.function());
        return collect_names(term.argument());
      case Term::Kind::list:
        for (const auto& each : term.elements()) collect_names(each);
        break;
      default:
        break;
    }
  }

  // A new variable. It is a constant with a unique name until the lambda around it is built.
  Term variable(const std::string& hint, const Type& type) {
    std::string name = hint.empty() ? usual_name(type) : hint;
    while (!names_.insert(name).second) name += '\'';
    return Term::constant(name, type);
  }
  static std::string usual_name(const Type& type) {
    if (type.kind() == Type::Kind::function) return "f";
    return type == Type::location() ? "v" : "x";
  }
  static Term abstraction(const Term& variable, const Term& term) {
    return Term::lambda(variable.name(), variable.type(), abstracted(term, variable));
  }

  // Gaps of the reading itself are open below all gaps of its phrases.
  Answer sentence(Term term) {
    std::vector<Answer::Open> own;
    while (term.type().kind() == Type::Kind::function) {
      const bool is_lambda = term.kind() == Term::Kind::lambda;
      const Type type = term.type().from();
      own.push_back({Gap{Gap::Why::unsaid, type, {}, ""}, variable(is_lambda ? term.name() : "", type)});
      enclosing_.push_back(own.back().variable);
      term = is_lambda ? instantiate(term.body(), enclosing_.back()) : Term::apply(term, enclosing_.back());
    }
    Answer answer = meaning_of(term, Type::term())(finished);
    answer.open.insert(answer.open.end(), own.begin(), own.end());
    return answer;
  }
  static Answer finished(const Value& value) { return {value.term, {}}; }

  // intTerm(f(x)) = cpsApply(intTerm(f), intTerm(x)); `wanted`: the type that the surrounding term expects.
  Meaning meaning_of(const Term& term, const Type& wanted) {
    if (referring_.is_phrase(term, enclosing_))
      return phrase(
          term, [this, term, occurrence = next_occurrence(term)] { return referring_.meant(term, occurrence); },
          wanted);
    switch (term.kind()) {
      case Term::Kind::apply: {
        if (is_each(term.function())) return each(term.argument(), wanted);
        const Type& function = term.function().type();
        const Type argument = function.kind() == Type::Kind::function ? Type(function.from()) : Type::term();
        const Meaning applied = meaning_of(term.function(), function);
        return cpsApply<Value, Value, Answer>(functions(applied), meaning_of(term.argument(), argument));
      }
      case Term::Kind::lambda:
        return lambda(term);
      case Term::Kind::list:
        return list(term);
      default:
        return unit<Answer>(Value{term, {}});
    }
  }

  // Turns the computation of a function term into a computation of a function over values.
  Comp<ValueFunction, Answer> functions(Meaning function) {
    return [this, function = std::move(function)](const Continuation<ValueFunction, Answer>& k) {
      return function([this, k](const Value& f) { return k([this, f](const Value& x) { return application(f, x); }); });
    };
  }

  Value application(const Value& function, const Value& argument) {
    const Type& type = function.term.type();
    Term raised_argument = argument.term;
    std::string rule;
    if (type.kind() == Type::Kind::function && !fits(argument.term, type.from())) {
      Evaluation evaluation(*meanings_.rules, meanings_.lookup, facts_);
      if (auto lifted = raised(argument.term, type.from(), raising_, evaluation)) {
        raised_argument = std::move(lifted->term);
        rule = std::move(lifted->rule);
      }
    }
    const bool reduces = function.term.kind() == Term::Kind::lambda && fits(raised_argument, type.from());
    Value result{
        reduces ? instantiate(function.term.body(), raised_argument) : Term::apply(function.term, raised_argument),
        together(function.by, argument.by)};
    result_.applied.push_back({{function.term, argument.term, result.term, std::move(rule)}, result.by});
    return result;
  }

  // A lambda inside the reading. Its phrases are computed outside of it.
  Meaning lambda(const Term& term) {
    const Term own = variable(term.name(), term.variable_type());
    enclosing_.push_back(own);
    const Meaning body = meaning_of(instantiate(term.body(), own), Type::term());
    enclosing_.pop_back();
    return [body, own](const Rest& k) {
      return body([k, own](const Value& value) { return k(Value{abstraction(own, value.term), value.by}); });
    };
  }

  // From the first element to the last. The objects of one command are in focus for the next.
  Meaning list(const Term& term) {
    std::vector<Meaning> elements;
    for (const auto& each : term.elements()) elements.push_back(meaning_of(each, Type::term()));
    return [this, elements = std::move(elements), type = term.type().element()](const Rest& k) {
      return elements_from(0, elements, {Term::list({}, type), {}}, k);
    };
  }
  Answer elements_from(std::size_t at, const std::vector<Meaning>& elements, const Value& done, const Rest& k) {
    if (at == elements.size()) return k(done);
    if (at > 0) referring_.focus_on(std::exchange(spoken_of_, {}));
    return elements[at]([this, at, &elements, done, k](const Value& next) {
      const Type type = done.term.type().element();
      auto values = done.term.elements();
      if (next.term.kind() == Term::Kind::list && type.kind() != Type::Kind::list)
        values.insert(values.end(), next.term.elements().begin(), next.term.elements().end());
      else
        values.push_back(next.term);
      return elements_from(at + 1, elements, {Term::list(std::move(values), type), together(done.by, next.by)}, k);
    });
  }

  // each(group) does the rest of the sentence once for each object of the group, a noun phrase or a list. A list that
  // the reading uses in two places stands for the same object in both.
  Meaning each(const Term& group, const Type& wanted) {
    if (referring_.is_phrase(group, enclosing_)) return meaning_of(group, wanted);
    auto& now = each_now_[group];
    if (!now) now = std::make_shared<std::optional<Value>>();
    return [this, all = meaning_of(group, group.type()), type = group.type(), now](const Rest& k) {
      if (*now) return k(**now);
      return all([this, k, type, now](const Value& value) {
        if (value.term.kind() == Term::Kind::list && !value.term.elements().empty() &&
            affords(value.term.elements().size()))
          return for_each(value.term.elements(), value.by, [now, &k](const Value& one) {
            const auto before = std::exchange(*now, one);
            Answer answer = k(one);
            *now = before;
            return answer;
          });
        const Type element = type.kind() == Type::Kind::list ? Type(type.element()) : Type::term();
        return k(Value{Term::apply(Term::constant("each", Type::function(type, element)), value.term), value.by});
      });
    };
  }
  static bool is_each(const Term& term) {
    static const Name each("each");
    return term.kind() == Term::Kind::constant && term.interned_name() == each;
  }

  Meaning noun(const Term& term) {
    return phrase(
        term, [this, term] { return referring_.meant_by_noun(term); }, Type::term());
  }

  // A phrase gives its value to the rest of the sentence. Several values that are meant together are given as a list
  // where a list can be used; else the rest is done for each. Where nothing or too much is meant, the rest is captured:
  // it is done with a variable, and the meaning waits for a value of that variable.
  // A phrase that the reading uses in two places ("push the block to the left") is found once.
  Meaning phrase(const Term& term, std::function<Meant()> find, const Type& wanted) {
    auto& known = found_[term];
    if (!known || times_said(term) > 1) known = std::make_shared<Found>();
    return [this, find = std::move(find), found = known, wanted](const Rest& k) {
      Meant& meant = found->meant;
      if (!std::exchange(found->done, true)) meant = resolved(find(), wanted);
      const std::vector<By> by = {meant.resolution.by};
      if (!found->now.is_null()) return k(Value{found->now, by});
      const bool separately = is_for_each(meant, wanted);
      if (meant.gap) {
        if (found->variable.is_null()) found->variable = variable("", separately ? Type::entity() : meant.gap->type);
        meant.gap->type = found->variable.type();
        Answer answer = k(Value{found->variable, {}});
        std::erase_if(answer.open, [&](const Answer::Open& open) { return open.variable == found->variable; });
        answer.open.push_back({*meant.gap, found->variable});
        return answer;
      }
      if (!meant.plural) return k(Value{meant.values.front(), by});
      if (!separately) return k(Value{meant.resolution.value, by});
      return for_each(meant.values, by, [found, &k](const Value& each) {
        const auto before = std::exchange(found->now, each.term);
        Answer answer = k(each);
        found->now = before;
        return answer;
      });
    };
  }

  // Numbers the uses of a phrase that is said several times. Phrases are met in the order of their words.
  std::size_t next_occurrence(const Term& term) { return times_said(term) > 1 ? occurrences_[term]++ : 0; }

  std::size_t times_said(const Term& term) const {
    return static_cast<std::size_t>(std::count_if(reading_.phrases.begin(), reading_.phrases.end(),
                                                  [&](const Phrase& phrase) { return phrase.term == term; }));
  }

  bool affords(std::size_t times) const { return commands_ * times <= most_commands; }
  Answer for_each(const std::vector<Term>& values, const std::vector<By>& by, const Rest& k) {
    std::vector<Answer> answers;
    commands_ *= values.size();
    for (const auto& each : values) answers.push_back(k(Value{each, by}));
    commands_ /= values.size();
    return together(std::move(answers));
  }

  static bool is_for_each(const Meant& meant, const Type& wanted) {
    return meant.plural && !consistent(wanted, Type::list(Type::entity()));
  }

  Meant resolved(Meant meant, const Type& wanted) {
    if (!meant.gap && is_for_each(meant, wanted) && !affords(meant.values.size())) {
      meant.gap = Gap{Gap::Why::several, Type::entity(), {}, meant.resolution.words};
      for (const auto& each : meant.values) meant.gap->choices.push_back(each.name());
      meant.resolution.value = Term();
    }
    if (!meant.there.empty()) referring_.not_it(meant.there);
    if (!meant.gap && meant.resolution.by != By::presence)
      for (const auto& value : meant.values)
        if (value.kind() == Term::Kind::constant) {
          spoken_of_.push_back(value.name());
          referring_.named(value.name());
        }
    for (const auto& each : meant.within) select_half(each);
    select_half(meant.resolution);
    result_.resolutions.insert(result_.resolutions.end(), meant.within.begin(), meant.within.end());
    result_.resolutions.push_back(meant.resolution);
    return meant;
  }

  // A phrase that goes with a pointing: the pointing, of things and a place, comes about; then the phrase's type
  // selects a half of it. Nothing is selected where words lead to a thing that the pointing only helped to find.
  void select_half(const Resolution& phrase) {
    const auto made = phrase.showing ? referring_.pointing(*phrase.showing) : std::nullopt;
    if (!made) return;
    const std::vector<By> by = {By::pointed};
    if (pointings_.insert(*phrase.showing).second) result_.applied.push_back({*made, by});
    for (const auto& wanted : {phrase.value.type(), Type::list(Type::entity())}) {
      Evaluation evaluation(*meanings_.rules, meanings_.lookup, facts_);
      const auto half = raised(made->result, wanted, raising_, evaluation);
      if (!half || !(half->term == phrase.value || is_among(phrase.value, half->term))) continue;
      const auto rule = std::find_if(raising_.begin(), raising_.end(),
                                     [&](const RaisingRule& each) { return each.name == half->rule; });
      result_.applied.push_back({{rule->by, made->result, half->term, half->rule}, by});
      return;
    }
  }
  static bool is_among(const Term& thing, const Term& things) {
    if (things.kind() != Term::Kind::list) return false;
    const auto& all = things.elements();
    return thing.is_null() ? !all.empty() : std::find(all.begin(), all.end(), thing) != all.end();
  }

  // The meaning found for a phrase, and the variable that stands for it where it is open.
  struct Found {
    bool done = false;
    Meant meant;
    Term variable;
    Term now;  // the object of a plural for which the rest of the sentence is being done
  };

  const Reading& reading_;
  Referring referring_;
  Facts facts_;
  const Meanings& meanings_;
  const RaisingRules& raising_;
  std::unordered_map<Term, std::shared_ptr<Found>, TermHash> found_;
  std::unordered_map<Term, std::size_t, TermHash> occurrences_;
  std::unordered_map<Term, std::shared_ptr<std::optional<Value>>, TermHash> each_now_;  // as Found::now, of a list
  std::set<std::string> names_;         // taken, so that no variable has them
  std::vector<Term> enclosing_;         // variables of the lambdas around
  std::set<std::size_t> pointings_;     // the showings whose pointing was told
  std::vector<std::string> spoken_of_;  // objects mentioned since the command began
  std::size_t commands_ = 1;            // number of times that the rest of the sentence is being done
  Interpretation result_;
};

}  // namespace

Interpretation interpret(const Reading& reading, const std::vector<std::string>& utterance_words,
                         const Context& context, const Meanings& meanings, const RaisingRules& raising) {
  return Interpreter(reading, utterance_words, context, meanings, raising).run();
}

std::size_t preferred(const std::vector<Interpretation>& interpretations) {
  // How loosely the words had to be taken: whether a phrase fits nothing, whether a pointing is missed, then the
  // loosest sense of sides.
  const auto stretched = [](const Interpretation& one) {
    const bool in_vain =
        std::any_of(one.gaps.begin(), one.gaps.end(), [](const Gap& gap) { return gap.why == Gap::Why::none; });
    const bool unshown = std::any_of(one.gaps.begin(), one.gaps.end(), [](const Gap& gap) { return gap.unshown; });
    Sides most = Sides::exact;
    for (const auto& resolution : one.resolutions) most = std::max(most, resolution.reference.sides);
    return std::tuple(in_vain, unshown, in_vain ? Sides::exact : most);
  };
  const auto least = std::min_element(interpretations.begin(), interpretations.end(),
                                      [&](const auto& a, const auto& b) { return stretched(a) < stretched(b); });
  return least == interpretations.end() ? 0 : static_cast<std::size_t>(least - interpretations.begin());
}

}  // namespace continua
