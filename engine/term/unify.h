// Unification of types with `term` as the dynamic type: it goes with everything and tells nothing about it.
#pragma once

#include <optional>
#include <vector>

#include "continua/term/type.h"

namespace continua {

/// The unknown types of one term, and everything known of them. Bounded: past a number of steps it gives up, no types
/// unify any more and all is `term`.
class Unifier {
 public:
  /// An unknown type.
  Type fresh();
  /// `type` with an unknown type for each of its variables.
  Type instance(const Type& type);

  /// Makes the two types one, where that can be. False keeps everything learnt until then.
  bool unify(const Type& a, const Type& b);

  /// `type`, or the type known for it when it is an unknown; its parts are not looked at.
  Type known(const Type& type) const;
  /// `type` with all known parts; an unknown becomes `term`.
  Type resolved(const Type& type);
  /// The type as a message to a person says it: "num", "a list", "a function from e to t", "anything".
  std::string described(const Type& type);

  bool gave_up() const;

 private:
  bool occurs(int variable, const Type& type);

  std::vector<std::optional<Type>> known_;
  std::size_t steps_ = 0;
};

/// Type of something of type `function` applied to something of type `argument`; none where the first is no function,
/// or takes another type. A `term`, or a type variable, may be a function: then the result is `term`.
std::optional<Type> result_type(const Type& function, const Type& argument);

}  // namespace continua
