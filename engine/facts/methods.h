// Facts of the world as functions of the term language: with those of term/FUNCTIONS.md the only C++ names a machine
// may call. Documented in METHODS.md. Objects are constants of type e, by name; a name that is not in the world
// gives null.
#pragma once

#include <optional>
#include <string>

#include "continua/core/random.h"
#include "continua/learning/learning.h"
#include "continua/term/evaluate.h"
#include "continua/world/relations.h"

namespace continua {

class Catalogue;

class Methods {
 public:
  /// `perspective` is whose left, right, front and behind the functions speak of. `voxemes` tell what objects afford,
  /// and must outlive it; without them nothing is known of that.
  explicit Methods(Perspective perspective, const Catalogue* voxemes = nullptr);
  Methods(const Methods&) = delete;  // its rules know where it is
  Methods& operator=(const Methods&) = delete;

  /// What the rules speak of from now on; all must outlive their use. Before that, all is null. `learned`: nullptr,
  /// nothing was.
  void see(const WorldSnapshot* world, Random* random, const Learned* learned = nullptr) {
    world_ = world;
    random_ = random;
    learned_ = learned;
  }

  const Rules& rules() const { return rules_; }
  static const Signature& signature();

 private:
  const ObjectState* object(const Term& entity) const;
  Term scene() const;
  Term position(const Term& entity) const;
  Term closest(const Term& entity, const Term& place) const;
  Term clear(const Term& entity, double share, Evaluation& evaluation) const;
  Term fits(const Term& entity, const Term& place, const Term& except, Evaluation& evaluation) const;
  Term free_place(const Term& entity, const Term& region, Evaluation& evaluation) const;
  std::optional<Landmark> landmark(const Term& term) const;
  /// A relation to things, or `at` a point or region.
  struct Where {
    Relation relation;
    std::vector<Landmark> landmarks;
  };
  std::optional<Where> where(const Term& place) const;
  Term as_seen_by(const Term& who, const Term& place) const;
  Term common_place(const Term& entity, const Term& first, const Term& second, Evaluation& evaluation) const;
  Term located(const Term& entity, const Term& place, Sides sides, Evaluation& evaluation) const;
  Term affordance(const ObjectState& object, const std::string& what) const;
  Term obstacle(const Term& program) const;
  Term offset(const ObjectState& object, const std::string& side) const;
  Term meaning_of(const std::string& name, Evaluation& evaluation) const;
  Signature add_rules();

  Perspective perspective_;
  const Catalogue* voxemes_;
  Rules rules_;
  const WorldSnapshot* world_ = nullptr;
  Random* random_ = nullptr;
  const Learned* learned_ = nullptr;
};

}  // namespace continua
