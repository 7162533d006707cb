// Unification of types. The dynamic type `term` unifies with every type and adds no knowledge about it.
#pragma once

#include <optional>
#include <vector>

#include "continua/term/type.h"

namespace continua {

/// The unknown types of one term, and the knowledge about them. Bounded: past a number of steps it gives up; then no
/// types unify any more and every type resolves to `term`.
class Unifier {
 public:
  /// An unknown type.
  Type fresh();
  /// `type` with an unknown type for each of its variables.
  Type instance(const Type& type);

  /// Unifies the two types. On false, knowledge gained before the conflict stays.
  bool unify(const Type& a, const Type& b);

  /// `type`, or its known value if it is an unknown; its parts are not resolved.
  Type known(const Type& type) const;
  /// `type` with its unknowns resolved; those still unknown become `term`.
  Type resolved(const Type& type);
  /// The type in words, for messages: "num", "a list", "a function from e to t", "anything".
  std::string described(const Type& type);

  bool gave_up() const;

 private:
  bool occurs(int variable, const Type& type);

  std::vector<std::optional<Type>> known_;
  std::size_t steps_ = 0;
};

/// The type of an application; none if `function` is not a function type or takes another argument. If `function` is
/// `term` or a type variable, the result is `term`, because the value may be a function.
std::optional<Type> result_type(const Type& function, const Type& argument);

}  // namespace continua
