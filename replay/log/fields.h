// How a record of a run log declares its members. Everything else that must know them is derived from that list: JSON
// both ways, the digest of decisions, the comparison of two runs, the tables of RECORDS.md and the schema for the page.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"

namespace continua::log {

/// Said of `because`.
inline constexpr auto of_sources =
    "The records that it came of: inputs, and the registers and symbols that were read, which have a `because` too.";

/// The part that a member plays when runs are compared.
enum class Says : std::uint8_t {
  what,   ///< tells the event; counts as a decision and when two runs are compared
  how,    ///< tells how that was decided; counts as a decision, and makes two records of one event differ
  where,  ///< a place in this log or a time: ids, running numbers; counts as a decision only
  aside,  ///< measured, or an explanation; counts nowhere
};

/// A value that is written as null when there is none. A std::optional, in contrast, is left out.
template <class T>
struct OrNull : std::optional<T> {
  using std::optional<T>::optional;
  OrNull(std::optional<T> value) : std::optional<T>(std::move(value)) {}  // NOLINT(google-explicit-constructor)
};

/// The smallest distance of a compared number from the comparison; null if nothing was compared. Records with a margin
/// below `fragile_margin` are listed as fragile at the end of the log. Rounded to nine decimals: the last digit of exp
/// and log is another one on another kind of processor.
struct Margin : OrNull<double> {
  Margin() = default;
  explicit Margin(double value) : OrNull<double>(std::round(value * 1e9) / 1e9 + 0.0) {}
};

/// A JSON value that nobody looks into: its compact text, which is written as it stands.
struct JsonText {
  std::string text = "null";
};

/// A JSON object whose members are named by data, in their order.
template <class T>
using Named = std::vector<std::pair<std::string, T>>;

/// All else that is said of a member.
struct FieldTraits {
  std::string_view form{};                       ///< what the value is beyond its type: "term", "seconds", "record"
  bool in_brief = false;                         ///< brief() reads it
  bool follows = false;                          ///< other members determine it, so it is no decision of its own
  std::array<std::string_view, 4> leaves_out{};  ///< of a Json value: members that say where
};

/// Everything that a struct declares of one member.
struct Declaration : FieldTraits {
  std::string_view name;
  Says says = Says::what;
  std::string_view sentence;  ///< its meaning, for RECORDS.md
};

/// One member of a record, or of an object within a record.
template <class Struct, class Value>
struct Field : Declaration {
  Value Struct::*member;
};

/// Whether records of a kind are decisions, which must be equal on every machine and in every world.
enum class Decision : std::uint8_t {
  no,
  yes,
  outcome,  ///< only what it came to counts: the progress of an act between other records is measured
};

/// Whether the arrow keys of the page stop at records of a kind. Pointing samples and their consequences come by the
/// hundred.
enum class Stop : std::uint8_t {
  never,
  unless_of_sample,         ///< not at samples and their consequences
  if_sample_changed_stack,  ///< at a sample's consequences only where the stack changed
  always,
};

/// A kind of record.
struct Kind {
  std::string_view name;
  std::string_view when;  ///< when such a record is written, for RECORDS.md
  Decision decision = Decision::no;
  Stop stop = Stop::always;
  bool repeats_event = false;     ///< its members, without `line`, are those of an event of the trace of this kind
  std::string_view brief_adds{};  ///< everything that brief() puts between the values of members
};

/// Does nothing with a member.
struct NoUse {
  template <class Struct, class Value>
  constexpr void operator()(std::string_view, Value Struct::*, Says, std::string_view, const FieldTraits& = {}) const {}
};

/// A struct that declares its members: fields(use) calls `use` with the name, member, Says, sentence and FieldTraits of
/// each, in the order in which they are written. Being a template, the list costs those sources alone that read it.
template <class T>
concept HasFields = requires {
  T::fields(NoUse{});
};

/// A kind of record that declares its members and can be told to people.
template <class T>
concept IsRecord = HasFields<T> && requires {
  { T::kind } -> std::convertible_to<Kind>;
};

template <class T>
concept HasBrief = requires(const T& record) {
  { record.brief() } -> std::same_as<std::string>;
};

/// The kinds of records that a header declares.
template <IsRecord... T>
struct Kinds {};

/// Calls `use(field)` for each member of T, in the order in which they are written.
template <HasFields T, class Use>
constexpr void for_each_field(Use&& use) {
  T::fields([&use]<class Value>(std::string_view name, Value T::*member, Says says, std::string_view sentence,
                                const FieldTraits& traits = {}) {
    use(Field<T, Value>{{traits, name, says, sentence}, member});
  });
}

/// The name of a member in the log.
template <class Struct, class Value>
constexpr std::string_view name_of(Value Struct::*member) {
  std::string_view name;
  for_each_field<Struct>([&]<class Of, class Type>(const Field<Of, Type>& field) {
    if constexpr (std::is_same_v<Type, Value>)
      if (field.member == member) name = field.name;
  });
  return name;
}

}  // namespace continua::log
