// Reasons why an act ended as it did: a code for machines and phrases, with the objects concerned.
//
// The table in reason.cpp has a row for each code: its name, the status in which such an act ends, and the words of the
// log. The avatar's words come from the phrases of a language (knowledge/phrases, `reason_words`).
#pragma once

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "continua/core/result.h"

namespace continua {

/// `unstable`: the object moved again within a second after the hand had let go of it.
enum class ActStatus { started, done, missed, dropped, blocked, unreachable, unstable, stopped };

/// `done`, `blocked` …
std::string name_of(ActStatus status);

enum class ReasonCode {
  none,
  // Obstacles in the nature of the things (facts/FACTS.md).
  no_grasp,
  immovable,
  itself,
  wrong_habitat,
  no_containment,
  no_support,
  // The program as it was asked for.
  unknown_program,
  incomplete,
  no_landmark,
  missing,
  not_held,
  nothing_held,
  held_already,
  there_already,
  needs_condition,
  undecided,
  defines_nothing,
  repeats_nothing,
  too_large,
  too_deep,
  too_long,
  in_vain,
  superseded,
  // The place.
  no_place,
  no_room,
  does_not_fit,
  full,
  too_narrow,
  falls_in,
  falls_off,
  moves_along,
  stands_on_end,
  // Arm and hand.
  out_of_reach,
  place_out_of_reach,
  no_way,
  no_turn,
  no_room_to_turn,
  too_wide,
  no_such_hold,
  no_hold,
  slipped,
  hand_obstructed,
  obstructed,
  lags,
  in_the_way,
  no_room_behind,
  no_way_behind,
  not_on_table,
  only_along_table,
  // The outcome.
  moved_again,
  turned_wrong,
  off_goal,
  not_related,
  diverged
};

struct Reason {
  ReasonCode code = ReasonCode::none;
  std::vector<std::string> objects = {};  ///< names of objects and participants, in the order of the row's words
  std::vector<std::string> terms = {};    ///< relation, program, condition or measure, as the log prints them

  bool empty() const { return code == ReasonCode::none; }
};

/// All codes but `none`, in order.
std::span<const ReasonCode> all_reasons();

/// `no_room`, `slipped` …; empty for `none`.
std::string name_of(ReasonCode code);

/// The status of an act that ends for this reason.
ActStatus status_of(ReasonCode code);

/// The reason as the log has it: "cup slipped out of the fingers"; empty for `none`.
std::string words_of(const Reason& reason);

/// A T, or the reason why there is none.
template <class T>
class [[nodiscard]] OrReason {
 public:
  OrReason(T value) : held_(std::move(value)) {}   // NOLINT(google-explicit-constructor)
  OrReason(Reason why) : held_(std::move(why)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return held_.index() == 0; }

  /// Each REQUIRES that there is a value.
  const T& operator*() const {
    require(held_.index() == 0, "the value of an OrReason that holds a reason");
    return std::get<0>(held_);
  }
  T& operator*() {
    require(held_.index() == 0, "the value of an OrReason that holds a reason");
    return std::get<0>(held_);
  }
  const T* operator->() const { return &**this; }
  T* operator->() { return &**this; }

  /// REQUIRES that there is none.
  const Reason& reason() const {
    require(held_.index() == 1, "the reason of an OrReason that holds a value");
    return std::get<1>(held_);
  }

 private:
  std::variant<T, Reason> held_;
};

}  // namespace continua
