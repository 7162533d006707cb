// The facts that rules may read besides their arguments: passed along with an evaluation. Rules of the language read
// none; each rule of another folder reads those of its folder.
#pragma once

namespace continua {

struct WorldSnapshot;
struct Learned;
class Beliefs;
class Random;

/// The facts during an evaluation. A rule gives null where a fact that it reads is missing. Everything must outlive the
/// evaluation.
struct Facts {
  const WorldSnapshot* world = nullptr;  ///< world/world_snapshot.h
  Random* random = nullptr;              ///< the generator of the run, which moves on with each draw
  const Learned* learned = nullptr;      ///< learning/learning.h
  const Beliefs* beliefs = nullptr;      ///< automaton/beliefs.h
};

}  // namespace continua
