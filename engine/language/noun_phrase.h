// Whether conditions with noun phrases inside hold of objects: the search behind reference (language/reference.h).
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "continua/language/reference.h"

namespace continua {

/// \x. true
Term anything();

/// The objects that fit a noun phrase's words, in the scene's order.
struct Fitting {
  std::vector<const ObjectState*> objects;
  std::vector<RuledOut> ruled_out;
};

/// Finds the objects that a noun phrase fits: one search for a noun phrase and all those inside it. The work is
/// bounded; past the bound, nothing more is true.
class NounPhraseSearch {
 public:
  /// `pointed_W` counts for nested deictic noun phrases. `context` and `meanings` must outlive the search.
  NounPhraseSearch(const Context& context, const Meanings& meanings, std::optional<Vec3> pointed_W,
                   Sides sides = Sides::exact);

  /// The `objects` for which `condition` (e -> t) is true. `other`: the object that the word "other" excludes.
  Fitting fitting(const std::vector<const ObjectState*>& objects, const Term& condition, const std::string& other);

  /// From now on superlatives compare only these objects.
  void compare(const std::vector<const ObjectState*>& objects);

  /// `term` with the values of its pro-forms; those that mean "other" stay.
  Term resolved(const Term& term) const;

  /// How near the nearest decision was, metres.
  double margin() const { return margin_; }

 private:
  bool holds(const Term& condition, const std::string& about, const std::string& other);
  bool is_true(const Term& condition, const std::string& other);
  const std::vector<Term>& referents(const Term& phrase, const std::string& about);

  const Context& context_;
  const Meanings& meanings_;
  std::optional<Vec3> pointed_W_;
  Sides sides_;
  std::optional<Term> compared_;                                 // e*; none: all there is
  std::unordered_map<Term, std::vector<Term>, TermHash> found_;  // by [noun phrase, the object it is said about]
  std::size_t work_ = 0;
  int depth_ = 0;
  double margin_ = std::numeric_limits<double>::infinity();
};

/// Drops from `fitting` the objects that pointing with this spread speaks against, the likeliest first; returns the
/// densities of those that stay. Lowers `margin` to the distance from another outcome.
std::vector<double> keep_pointed(const Vec3& pointed_W, double sd_m, Fitting& fitting, double& margin);

}  // namespace continua
