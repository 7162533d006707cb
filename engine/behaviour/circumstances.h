// What expressions of VoxML stand for and whether they hold, in the world as it is now.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "continua/facts/methods.h"
#include "continua/term/term.h"
#include "continua/voxml/expression.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// What names stand for: x, l1, and [1] for a part.
using Bindings = std::map<std::string, Term, std::less<>>;

/// The avatar as the agent of programs.
Term agent_term();

/// Where an object is, as a place term: on(plate) or in(cup) if it stands there, else the point below its centre.
Term place_term(const ObjectState& object, const WorldSnapshot& world);

class Circumstances {
 public:
  explicit Circumstances(Perspective perspective) : perspective_(perspective), methods_(perspective) {}

  /// `world` must outlive its use.
  void see(const WorldSnapshot& world) {
    world_ = &world;
    methods_.see(&world, nullptr);
  }
  const WorldSnapshot& world() const { return *world_; }
  Perspective perspective() const { return perspective_; }

  /// The things that the act has brought to their places so far; must outlive its use. A thing is at a place that is
  /// wide, such as left(plate), only once it was brought there: that it stands somewhere to the left is not enough.
  void see_brought(const std::set<std::string>& brought) { brought_ = &brought; }

  /// put(x, on(y)) with what x and y stand for; loc(y) is the place where it is. A name that stands for nothing is the
  /// thing of the world that is called so, else itself.
  Term value(const Expression& expression, const Bindings& bindings) const;
  /// hold(x,y), the relations of world/relations.h as at(y,z) and on(y,z), contain(z,y) and support(z,y), and
  /// what ! ^ | make of them. Nothing if the world cannot tell.
  std::optional<bool> hold(const Expression& condition, const Bindings& bindings) const;

 private:
  std::optional<bool> one_holds(const Expression& condition, const Bindings& bindings) const;

  Perspective perspective_;
  Methods methods_;
  const WorldSnapshot* world_ = nullptr;
  const std::set<std::string>* brought_ = nullptr;
};

}  // namespace continua
