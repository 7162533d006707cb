// A voxeme: the spatial meaning of a word for an object, program, attribute, relation or function (VoxML; Pustejovsky
// and Krishnaswamy 2016). A value with the contents of its document.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continua/voxml/expression.h"

namespace continua {

/// A part or habitat with its number: cylindroid[1], UP[3].
struct Numbered {
  std::string name;
  std::string number;  ///< empty if it has none
};

struct HabitatClause {
  Numbered name;      ///< UP[3]
  std::string value;  ///< align(Y,E_y)
};

/// x:agent
struct VoxemeArgument {
  std::string name, type;
};

/// The parts of a compound type, physobj[] and location of physobj[]•location; a simple type is its only part.
std::vector<std::string> halves_of(const std::string& type);

/// How far a vector strays from the place that it means: one standard deviation, by the distance that it extends.
struct VoxemeSpread {
  double least_m = 0;      ///< at any distance
  double per_metre_m = 0;  ///< for each metre of distance, if that is more
};

struct Voxeme {
  enum class Entity { object, program, attribute, relation, function };
  Entity entity = Entity::object;
  std::string predicate;  ///< Lex/Pred
  std::string path;       ///< of its document
  std::string lex_type;   ///< Lex/Type: physobj*artifact, transition_event

  Numbered head;  ///< Type/Head: cylindroid[1], transition
  std::vector<Numbered> components;
  Numbered concavity;  ///< Concave[2], Flat, Convex
  std::vector<std::string> rotational_symmetry, reflectional_symmetry;

  std::vector<VoxemeArgument> arguments;  ///< Type/Args
  std::vector<Subevent> body;             ///< Type/Body, of programs
  std::string goal;                       ///< Type/Goal, of collective programs (facts/formations.h), as text
  std::optional<VoxemeSpread> spread;     ///< Type/Spread, of programs with a vector

  std::vector<HabitatClause> intrinsic, extrinsic;
  std::vector<Affordance> affordances;

  std::string scale;  ///< Embodiment/Scale: <agent
  bool movable = false;
  std::vector<std::string> attributes;  ///< Attributes/Attrs

  /// All other elements with text, also unknown ones, by their path below VoxML: "Type/Class" → "config", "Type/Constr"
  /// → "X(x) > X(y)", "Type/Referent" → "x".
  std::map<std::string, std::string> others;
};

}  // namespace continua
