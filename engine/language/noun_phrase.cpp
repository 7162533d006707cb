#include "continua/language/noun_phrase.h"

#include <algorithm>
#include <array>
#include <utility>

#include "continua/language/pointing.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

constexpr std::size_t most_work = 400000;               // nodes of the conditions tried
constexpr std::size_t exhausted_work = most_work / 20;  // added for an evaluation that ran out of steps
constexpr std::size_t most_conjuncts = 1000;
constexpr int deepest_phrase = 50;

// The conjuncts of `condition`, each with the variable of `condition` free.
std::vector<Term> conjuncts(const Term& condition) {
  std::vector<Term> found,
      open = {condition.kind() == Term::Kind::lambda ? condition.body()
                                                     : Term::apply(condition, Term::bound(0, Type::entity()))};
  for (std::size_t steps = 0; !open.empty() && steps < most_conjuncts; ++steps) {
    const Term next = std::move(open.back());
    open.pop_back();
    const auto [head, arguments] = next.spine();
    if (head.kind() == Term::Kind::constant && head.name() == "and" && arguments.size() == 2) {
      open.push_back(arguments[1]);
      open.push_back(arguments[0]);
    } else if (next.kind() == Term::Kind::apply && next.function().kind() == Term::Kind::lambda) {
      open.push_back(instantiate(next.function().body(), next.argument()));
    } else {
      found.push_back(next);
    }
  }
  found.insert(found.end(), open.rbegin(), open.rend());
  return found;
}

Term negated(const Term& condition) {
  static const Term negation = Term::constant("not", core_signature().at("not"));
  return Term::apply(negation, condition);
}

// Whether `condition` is `phrase = …` or `… = phrase`, or a disjunction that contains one of them.
bool equates(const Term& condition, const Term& phrase) {
  static const Name equals("="), either("or");
  const auto [head, arguments] = condition.spine();
  if (head.kind() != Term::Kind::constant) return false;
  if (head.interned_name() == equals) return std::find(arguments.begin(), arguments.end(), phrase) != arguments.end();
  return head.interned_name() == either &&
         std::any_of(arguments.begin(), arguments.end(), [&](const Term& each) { return equates(each, phrase); });
}

// \x. x != object
Term all_but(const std::string& object) {
  static const Term differs = Term::constant("!=", Type::parse("e -> e -> t").value());
  return Term::lambda("x", Type::entity(),
                      Term::apply(Term::apply(differs, Term::bound(0, Type::entity())), Term::entity(object)));
}

Term located(Sides sides) {
  static const Type type = Type::parse("e -> loc -> t").value();
  static const std::array names = {"located", "located_roughly", "located_loosely"};
  return Term::constant(names[static_cast<std::size_t>(sides)], type);
}

// The region that pointing at a place may mean: three standard deviations to each side.
Term pointed_region(const Vec3& p_W, double sd_m) {
  const Vec3 p = on_grid(p_W);
  const double reach_m = 3 * sd_m;
  return Term::place({{p.x() - reach_m, p.y() - reach_m, p.z()}, {p.x() + reach_m, p.y() + reach_m, p.z()}, true});
}

}  // namespace

Term anything() { return Term::lambda("x", Type::entity(), Term::truth(true)); }

NounPhraseSearch::NounPhraseSearch(const Context& context, const Meanings& meanings, std::optional<Vec3> pointed_W,
                                   Sides sides)
    : context_(context), meanings_(meanings), pointed_W_(std::move(pointed_W)), sides_(sides) {}

Term NounPhraseSearch::resolved(const Term& term) const {
  return rewritten(term, [this](const Term& part) -> std::optional<Term> {
    const auto* proform = proform_of(part, *meanings_.operators);
    if (!proform) return std::nullopt;
    switch (proform->source) {
      case Proform::Source::focus:
      case Proform::Source::handled: {
        const auto& named = *objects_of(proform->source, context_);
        if (part.type().kind() != Type::Kind::list) return named.empty() ? Term::null() : Term::entity(named.front());
        std::vector<Term> objects;
        for (const auto& each : named) objects.push_back(Term::entity(each));
        return Term::list(std::move(objects), Type::entity());
      }
      case Proform::Source::pointed:
        return context_.pointed_W ? pointed_region(*context_.pointed_W, context_.pointed_sd_m) : Term::null();
      case Proform::Source::topic:
        return context_.topics.empty() ? anything() : context_.topics.front();
      case Proform::Source::avatar:
        return Term::entity("avatar");
      case Proform::Source::human:
        return Term::entity("human");
      case Proform::Source::other:
        break;
    }
    return std::nullopt;
  });
}

void NounPhraseSearch::compare(const std::vector<const ObjectState*>& objects) {
  std::vector<Term> names;
  for (const auto* each : objects) names.push_back(Term::entity(each->name));
  compared_ = Term::list(std::move(names), Type::entity());
}

Fitting NounPhraseSearch::fitting(const std::vector<const ObjectState*>& objects, const Term& condition,
                                  const std::string& other) {
  const auto parts = conjuncts(condition);
  Fitting fitting;
  for (const auto* object : objects) {
    const Term name = Term::entity(object->name);
    const auto failing = std::find_if(parts.begin(), parts.end(), [&](const Term& part) {
      return !holds(instantiate(part, name), object->name, other);
    });
    if (failing == parts.end())
      fitting.objects.push_back(object);
    else
      fitting.ruled_out.push_back({object->name, print(negated(instantiate(*failing, name)))});
  }
  return fitting;
}

// Whether `condition` is true. Its first nested noun phrase stands for each of its referents in turn, until one makes
// the condition true; a plural stands for all of them at once. The object itself (`about`) is not a referent of a
// nested phrase, because nothing is left of itself; it is one where the condition equates the two.
bool NounPhraseSearch::holds(const Term& condition, const std::string& about, const std::string& other) {
  work_ += condition.size();
  if (work_ > most_work) return false;
  std::optional<Term> phrase;
  const auto with_phrase_as = [&](const Term& value) {
    bool replaced = false;
    return rewritten(condition, [&](const Term& part) -> std::optional<Term> {
      if (replaced || !part.closed() || !determiner_of(part, *meanings_.operators)) return std::nullopt;
      replaced = true;
      phrase = part;
      return value;
    });
  };
  with_phrase_as(Term::null());
  if (!phrase) return is_true(condition, other);
  std::vector<Term> others;
  for (const auto& each : referents(*phrase, about))
    if (each.name() != about || equates(condition, *phrase)) others.push_back(each);
  if (phrase->type().kind() == Type::Kind::list)
    return holds(with_phrase_as(Term::list(std::move(others), Type::entity())), about, other);
  return std::any_of(others.begin(), others.end(),
                     [&](const Term& each) { return holds(with_phrase_as(each), about, other); });
}

bool NounPhraseSearch::is_true(const Term& condition, const std::string& other) {
  const Term ready = rewritten(condition, [&](const Term& part) -> std::optional<Term> {
    if (sides_ != Sides::exact && part == located(Sides::exact)) return located(sides_);
    if (!proform_of(part, *meanings_.operators)) return std::nullopt;
    return other.empty() ? anything() : all_but(other);
  });
  const auto lookup = [this](Name name) -> Evaluation::Held {
    if (compared_ && name.text() == meanings_.operators->compared) return {&*compared_};
    return meanings_.lookup ? meanings_.lookup(name) : Evaluation::Held(nullptr);
  };
  Evaluation evaluation(*meanings_.rules, lookup, context_.facts);
  const bool result = evaluation.value(ready).is_true();
  if (evaluation.exhausted) work_ += exhausted_work;
  margin_ = std::min(margin_, evaluation.margin);
  return result;
}

const std::vector<Term>& NounPhraseSearch::referents(const Term& phrase, const std::string& about) {
  const auto [found, added] =
      found_.try_emplace(Term::list({phrase, Term::entity(about)}, Type::entity()), std::vector<Term>());
  if (!added || depth_ >= deepest_phrase) return found->second;
  auto& referents = found->second;
  ++depth_;
  const auto compared = std::exchange(compared_, std::nullopt);
  const Determiner& determiner = *determiner_of(phrase, *meanings_.operators);
  std::vector<const ObjectState*> objects;
  for (const auto& each : context_.facts.world->objects)
    if (!determiner.other || each.name != about) objects.push_back(&each);
  Fitting fits = fitting(objects, phrase.argument(), about);
  if (determiner.deictic && pointed_W_) keep_pointed(*pointed_W_, context_.pointed_sd_m, fits, margin_);
  compared_ = compared;
  --depth_;
  for (const auto* each : fits.objects) referents.push_back(Term::entity(each->name));
  return referents;
}

std::vector<double> keep_pointed(const Vec3& pointed_W, double sd_m, Fitting& fitting, double& margin) {
  struct Candidate {
    const ObjectState* object;
    double density;
  };
  std::vector<Candidate> candidates;
  for (const auto* each : fitting.objects) candidates.push_back({each, pointing_density(pointed_W, *each, sd_m)});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.density > b.density; });
  fitting.objects.clear();
  std::vector<double> densities;
  for (const auto& [object, density] : candidates) {
    const auto& best = candidates.front();
    if (object != best.object)
      margin = std::min(margin, pointing_margin(pointed_W, *object, *best.object, least_share, sd_m));
    if (density < least_share * best.density) {
      fitting.ruled_out.push_back({object->name, "not pointed at"});
      continue;
    }
    if (!fitting.objects.empty())
      margin = std::min(margin, pointing_margin(pointed_W, *fitting.objects.back(), *object, 1, sd_m));
    fitting.objects.push_back(object);
    densities.push_back(density);
  }
  return densities;
}

}  // namespace continua
