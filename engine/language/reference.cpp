#include "continua/language/reference.h"

#include <algorithm>
#include <cmath>

#include "continua/language/noun_phrase.h"
#include "continua/language/pointing.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

std::size_t place_in(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

// Referents by their share, which is rounded to a millionth so that the last bits of an exponential reach no log. Ties
// go by the order of focus, then of the scene.
std::vector<Referent> ranked(const Fitting& fitting, const std::vector<double>& densities, const Context& context) {
  double sum = 0;
  for (const double each : densities) sum += each;
  std::vector<Referent> referents;
  for (const auto& each : context.facts.world->objects) {
    const auto found = std::find(fitting.objects.begin(), fitting.objects.end(), &each);
    if (found == fitting.objects.end()) continue;
    const double share = densities[static_cast<std::size_t>(found - fitting.objects.begin())] / sum;
    referents.push_back({each.name, std::round(share * 1e6) / 1e6});
  }
  std::stable_sort(referents.begin(), referents.end(), [&](const Referent& a, const Referent& b) {
    if (a.weight != b.weight) return a.weight > b.weight;
    return place_in(context.focus, a.object) < place_in(context.focus, b.object);
  });
  return referents;
}

std::vector<RuledOut> in_scene_order(std::vector<RuledOut> ruled_out, const WorldSnapshot& world) {
  const auto place = [&world](const RuledOut& each) { return world.find(each.object); };
  std::stable_sort(ruled_out.begin(), ruled_out.end(),
                   [&](const RuledOut& a, const RuledOut& b) { return place(a) < place(b); });
  return ruled_out;
}

// The objects that the question was about; adds the others to `ruled_out`.
std::vector<const ObjectState*> asked_about(const Context& context, std::vector<RuledOut>& ruled_out) {
  std::vector<const ObjectState*> objects;
  for (const auto& each : context.facts.world->objects) {
    if (context.among.empty() || place_in(context.among, each.name) < context.among.size())
      objects.push_back(&each);
    else
      ruled_out.push_back({each.name, "not asked about"});
  }
  return objects;
}

// The object that "the other cup" excludes: among those that fit without "other", the first in focus. May be empty.
std::string first_in_focus(NounPhraseSearch& search, const Term& condition, const Context& context) {
  std::vector<const ObjectState*> objects;
  for (const auto& name : context.focus)
    if (const auto* object = context.facts.world->find(name)) objects.push_back(object);
  const Fitting fitting = search.fitting(objects, condition, "");
  return fitting.objects.empty() ? "" : fitting.objects.front()->name;
}

bool speaks_of_sides(const Term& condition) {
  static const Term located = Term::constant("located", Type::parse("e -> loc -> t").value());
  return contains(condition, located);
}

Reference refer(const Term& condition, const Determiner& determiner, const Context& context, const Meanings& meanings,
                Sides sides) {
  const auto pointed_W = context.pointed_W;
  NounPhraseSearch search(context, meanings, determiner.deictic ? std::nullopt : pointed_W, sides);
  const std::string in_focus = first_in_focus(search, search.resolved(condition), context);

  std::vector<RuledOut> ruled_out;
  auto objects = asked_about(context, ruled_out);
  if (determiner.other)
    std::erase_if(objects, [&](const ObjectState* each) {
      if (each->name != in_focus) return false;
      ruled_out.push_back({each->name, "in focus"});
      return true;
    });
  if (!context.among.empty()) search.compare(objects);
  Fitting fitting = search.fitting(objects, search.resolved(condition), in_focus);
  Reference reference;
  reference.sides = sides;
  reference.margin = search.margin();
  std::vector<double> densities(fitting.objects.size(), 1);
  if (determiner.deictic && pointed_W)
    densities = keep_pointed(*pointed_W, context.pointed_sd_m, fitting, reference.margin);
  reference.referents = ranked(fitting, densities, context);
  ruled_out.insert(ruled_out.end(), fitting.ruled_out.begin(), fitting.ruled_out.end());
  reference.ruled_out = in_scene_order(std::move(ruled_out), *context.facts.world);
  return reference;
}

}  // namespace

Reference refer(const Term& condition, const Determiner& determiner, const Context& context, const Meanings& meanings) {
  Reference reference = refer(condition, determiner, context, meanings, Sides::exact);
  for (const auto sides : {Sides::rough, Sides::loose}) {
    if (!reference.referents.empty() || !speaks_of_sides(condition)) break;
    Reference other = refer(condition, determiner, context, meanings, sides);
    other.margin = reference.margin = std::min(other.margin, reference.margin);
    if (!other.referents.empty()) reference = std::move(other);
  }
  return reference;
}

const std::vector<std::string>* objects_of(Proform::Source source, const Context& context) {
  if (source == Proform::Source::focus) return &context.focus;
  return source == Proform::Source::handled ? &context.handled : nullptr;
}

Reference refer_to_pointed(const Context& context) {
  Reference reference;
  Fitting fitting;
  const auto candidates = asked_about(context, fitting.ruled_out);
  // One that is near enough makes it a pointing at things; whatever is about as likely is then a rival of it.
  bool means_things = false;
  for (const auto* each : candidates) {
    if (!context.pointed_W) continue;
    reference.margin = std::min(reference.margin, pointing_margin(*context.pointed_W, *each, context.pointed_sd_m));
    means_things = means_things || is_pointed_at(*context.pointed_W, *each, context.pointed_sd_m);
  }
  std::vector<double> densities;
  if (means_things) {
    fitting.objects = candidates;
    densities = keep_pointed(*context.pointed_W, context.pointed_sd_m, fitting, reference.margin);
  } else {
    for (const auto* each : candidates) fitting.ruled_out.push_back({each->name, "not pointed at"});
  }
  reference.referents = ranked(fitting, densities, context);
  reference.ruled_out = in_scene_order(std::move(fitting.ruled_out), *context.facts.world);
  if (!reference.referents.empty() || context.among.empty()) return reference;
  Context anything = context;
  anything.among.clear();
  return refer_to_pointed(anything);
}

}  // namespace continua
