// Terms: the form of conditions, stack contents, commands and the log. Immutable values that share structure, with
// numbered binders (de Bruijn indices), so that alpha-equivalent terms are equal. SEMANTICS.md §2.
//
// Every node carries a digest of all that counts for equality, made from those of its parts when it is built. So terms
// are compared and hashed in constant time, as by hash-consing. A table of all nodes would be shared and locked, and
// its addresses would differ from run to run; content addressing needs none, and equal terms have equal keys in every
// thread and process.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/term/name.h"
#include "continua/term/term_digest.h"
#include "continua/term/type.h"

namespace continua {

/// A point of frame W, metres.
using Point = std::array<double, 3>;

/// A place is a point, or an axis-aligned region of W with two corners. A region may have no extent.
struct Place {
  Point min{};
  Point max{};
  bool region = false;
  bool operator==(const Place&) const = default;
};

struct TermNode;
struct TermSpine;

class Term {
 public:
  enum class Kind {
    null,   ///< nothing; of every type
    truth,  ///< true, false
    number,
    text,      ///< 'a quoted text'
    place,     ///< <x, y, z>, or box(<x,y,z>, <x,y,z>)
    constant,  ///< a name: an object, a program, a function, a slot
    bound,     ///< variable bound by the index-th enclosing lambda, 0 the innermost
    lambda,
    apply,
    list,
  };

  /// null
  Term();
  static Term null() { return Term(); }
  static Term truth(bool value);
  /// A number that is not finite is null; -0 is 0.
  static Term number(double value);
  static Term text(std::string value);
  /// Coordinates are rounded to a micrometre, so that the last bits of a sum neither decide nor print. The corners
  /// of a region may come in any order. A place with a coordinate that is not finite is null.
  static Term place(Place value);
  static Term point(double x_m, double y_m, double z_m);
  static Term constant(std::string_view name, Type type);
  /// The constant of type e that stands for an object of the world.
  static Term entity(std::string_view name);
  static Term bound(int index, Type type);
  /// `hint`: the name to print for the variable; equality ignores it.
  static Term lambda(std::string hint, Type variable, Term body);
  /// Null where the types do not go together (result_type() in unify.h): the first term is no function, or takes
  /// another type than the argument's. Null itself and a term of type `term` may be applied to anything.
  static Term apply(Term function, Term argument);
  /// apply(function, argument), quicker where these have the very types of function and argument of `application`.
  static Term applied_like(const Term& application, Term function, Term argument);
  static Term list(std::vector<Term> elements, Type element);

  Kind kind() const;
  const Type& type() const;
  bool is_null() const { return kind() == Kind::null; }
  /// True only for the term `true`; null and all other terms count as not true.
  bool is_true() const;

  bool truth_value() const;                   ///< REQUIRES truth
  double number_value() const;                ///< REQUIRES number
  const std::string& text_value() const;      ///< REQUIRES text
  const Place& place_value() const;           ///< REQUIRES place
  const std::string& name() const;            ///< REQUIRES constant, or lambda (its hint)
  Name interned_name() const;                 ///< REQUIRES constant
  int index() const;                          ///< REQUIRES bound
  const Term& body() const;                   ///< REQUIRES lambda
  const Type& variable_type() const;          ///< REQUIRES lambda
  const Term& function() const;               ///< REQUIRES apply
  const Term& argument() const;               ///< REQUIRES apply
  const std::vector<Term>& elements() const;  ///< REQUIRES list

  /// f(a, b) as (f, [a, b]); any other term as (itself, []).
  TermSpine spine() const;

  /// The digest of the structure up to alpha-equivalence. Hints and types are left out: `head` of a list of objects and
  /// `head` of a list of numbers are the same name.
  const TermDigest& digest() const;
  /// Equal digests. O(1), as is the hash.
  bool operator==(const Term& other) const { return node_ == other.node_ || digest() == other.digest(); }
  /// The very same node: hints and types are the same too.
  bool same_node(const Term& other) const { return node_ == other.node_; }

  /// Whether every bound variable is bound inside the term.
  bool closed() const { return reach() == 0; }
  /// Number of enclosing lambdas that its bound variables need; 0 if closed.
  int reach() const;
  /// Height and (saturating) number of nodes of the written-out tree, a text counting by its length. A loop that builds
  /// terms must bound both: shared structure makes it easy to build a small thing that prints endlessly.
  std::size_t depth() const;
  std::size_t size() const;

 private:
  static Term applied_of_type(Type type, Term function, Term argument);
  explicit Term(std::shared_ptr<const TermNode> node) : node_(std::move(node)) {}
  std::shared_ptr<const TermNode> node_;
};

/// By content, for tables.
struct TermHash {
  std::size_t operator()(const Term& term) const { return static_cast<std::size_t>(term.digest().low); }
};

struct TermSpine {
  Term head;
  std::vector<Term> arguments;
};

/// `term` if it is a place, else the first place inside it, from left to right; nullptr if there is none.
const Term* first_place(const Term& term);

}  // namespace continua
