// The facts that rules may read besides their arguments; they are passed along with an evaluation. Rules of the
// language read none; the rules of another folder read the facts of that folder.
#pragma once

namespace continua {

struct WorldSnapshot;
struct Learned;
class Beliefs;
class Random;
struct Looked;

/// The facts of an evaluation. A rule gives null if it needs a fact that is not there. All facts must outlive the
/// evaluation.
struct Facts {
  const WorldSnapshot* world = nullptr;  ///< world/world_snapshot.h
  Random* random = nullptr;              ///< the generator of the run; each draw advances it
  const Learned* learned = nullptr;      ///< learning/learning.h
  const Beliefs* beliefs = nullptr;      ///< automaton/beliefs.h
  const Looked* looked = nullptr;        ///< automaton/looked.h
};

}  // namespace continua
