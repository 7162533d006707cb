#include "continua/body/reason.h"

#include <array>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace continua {

namespace {

using Code = ReasonCode;
using Status = ActStatus;

/// In the words of the log {0} is the first object, {1} the others, {2} the first term, {3} the second.
struct Row {
  Code code;
  Status status;
  std::string_view name, words;
};

// In the order of the enumeration.
constexpr std::array rows = {
    Row{Code::none, Status::done, "", ""},
    Row{Code::no_grasp, Status::blocked, "no_grasp", "{0} is nothing that a hand takes"},
    Row{Code::immovable, Status::blocked, "immovable", "{0} cannot be moved"},
    Row{Code::itself, Status::blocked, "itself", "{0} cannot be put {2} itself"},
    Row{Code::wrong_habitat, Status::blocked, "wrong_habitat", "{0} lies the wrong way for that"},
    Row{Code::no_containment, Status::blocked, "no_containment", "{0} has no hollow that anything could be put in"},
    Row{Code::no_support, Status::blocked, "no_support", "nothing can be put on {0}"},
    Row{Code::unknown_program, Status::blocked, "unknown_program", "{2} is no program that the body can perform"},
    Row{Code::incomplete, Status::blocked, "incomplete", "{2} lacks an object or a place"},
    Row{Code::no_landmark, Status::blocked, "no_landmark", "it is not said {2} what"},
    Row{Code::missing, Status::unreachable, "missing", "there is no '{0}'"},
    Row{Code::not_held, Status::blocked, "not_held", "{0} is not in the hand"},
    Row{Code::nothing_held, Status::blocked, "nothing_held", "there is nothing in the hand"},
    Row{Code::held_already, Status::done, "held_already", "{0} is held already"},
    Row{Code::there_already, Status::done, "there_already", "{0} is there already"},
    Row{Code::needs_condition, Status::blocked, "needs_condition", "{2} needs {3}"},
    Row{Code::undecided, Status::blocked, "undecided", "nothing tells whether {2} holds"},
    Row{Code::defines_nothing, Status::blocked, "defines_nothing", "{2} defines no place"},
    Row{Code::repeats_nothing, Status::blocked, "repeats_nothing", "{2} repeats nothing"},
    Row{Code::too_large, Status::blocked, "too_large", "{2} stands for more than can be said"},
    Row{Code::too_deep, Status::blocked, "too_deep", "{2} goes more than {3} programs deep"},
    Row{Code::too_long, Status::blocked, "too_long", "{2} takes more than {3} steps"},
    Row{Code::in_vain, Status::missed, "in_vain", "{2} moves nothing any more"},
    Row{Code::superseded, Status::done, "superseded", "superseded by a newer act"},
    Row{Code::no_place, Status::blocked, "no_place", "nothing can be put {2} {0}"},
    Row{Code::no_room, Status::blocked, "no_room", "there is no room for {0} {2} {1}"},
    Row{Code::does_not_fit, Status::blocked, "does_not_fit", "{0} does not fit into {1}"},
    Row{Code::full, Status::blocked, "full", "{0} is full of {1}"},
    Row{Code::too_narrow, Status::blocked, "too_narrow", "{0} is too narrow to bear {1}"},
    Row{Code::falls_in, Status::blocked, "falls_in", "{0} would fall into {1}"},
    Row{Code::falls_off, Status::blocked, "falls_off", "{0} would fall off the table"},
    Row{Code::moves_along, Status::blocked, "moves_along", "{0} stands on or in {1}, and would move along"},
    Row{Code::stands_on_end, Status::done, "stands_on_end", "{0} stands on its end"},
    Row{Code::out_of_reach, Status::unreachable, "out_of_reach", "{0} is out of my reach"},
    Row{Code::place_out_of_reach, Status::unreachable, "place_out_of_reach", "that place is out of my reach"},
    Row{Code::no_way, Status::unreachable, "no_way", "the arm does not get there"},
    Row{Code::no_turn, Status::unreachable, "no_turn", "the arm cannot turn {0} there"},
    Row{Code::no_room_to_turn, Status::blocked, "no_room_to_turn", "there is no room to turn {0}"},
    Row{Code::too_wide, Status::blocked, "too_wide", "{0} is too wide for the hand"},
    Row{Code::no_such_hold, Status::blocked, "no_such_hold", "{0} cannot be held in that way"},
    Row{Code::no_hold, Status::blocked, "no_hold", "the fingers found no hold"},
    Row{Code::slipped, Status::dropped, "slipped", "{0} slipped out of the fingers"},
    Row{Code::hand_obstructed, Status::blocked, "hand_obstructed", "something is in the hand's way"},
    Row{Code::obstructed, Status::blocked, "obstructed", "something is in {0}'s way"},
    Row{Code::lags, Status::blocked, "lags", "the arm's servos do not follow its motion"},
    Row{Code::in_the_way, Status::blocked, "in_the_way", "{0} is in the way of {1}"},
    Row{Code::no_room_behind, Status::blocked, "no_room_behind", "there is no room for the hand behind {0}"},
    Row{Code::no_way_behind, Status::unreachable, "no_way_behind", "the arm does not get behind {0}"},
    Row{Code::not_on_table, Status::blocked, "not_on_table", "{0} does not stand on the table"},
    Row{Code::only_along_table, Status::blocked, "only_along_table", "{0} can only be pushed along the table"},
    Row{Code::moved_again, Status::unstable, "moved_again", "{0} moved again within a second"},
    Row{Code::turned_wrong, Status::missed, "turned_wrong", "{0} came to be turned {2} degrees too far or too little"},
    Row{Code::off_goal, Status::missed, "off_goal", "{0} came to lie {2} mm from its goal"},
    Row{Code::not_related, Status::missed, "not_related", "{0} did not come to be {2} {1}"},
    Row{Code::diverged, Status::dropped, "diverged",
        "the simulation diverged; the world has been set back to when it was last at rest"},
};

constexpr bool codes_in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].code) != i) return false;
  return rows.size() == static_cast<std::size_t>(Code::diverged) + 1;
}
static_assert(codes_in_order(), "each code has its row");

const Row& row_of(Code code) { return rows[static_cast<std::size_t>(code)]; }

std::string nth(const std::vector<std::string>& list, std::size_t i) { return i < list.size() ? list[i] : ""; }

}  // namespace

std::string name_of(ActStatus status) {
  // In the order of the enumeration.
  constexpr std::array names = {"started", "done",        "missed",   "dropped",
                                "blocked", "unreachable", "unstable", "stopped"};
  static_assert(names.size() == static_cast<std::size_t>(Status::stopped) + 1, "each status has a name");
  return names[static_cast<std::size_t>(status)];
}

std::span<const ReasonCode> all_reasons() {
  static constexpr auto codes = [] {
    std::array<Code, rows.size() - 1> made{};
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = rows[i + 1].code;
    return made;
  }();
  return codes;
}

std::string name_of(ReasonCode code) { return std::string(row_of(code).name); }

ActStatus status_of(ReasonCode code) { return row_of(code).status; }

std::string words_of(const Reason& reason) {
  const auto& objects = reason.objects;
  const std::vector<std::string> others(objects.begin() + (objects.empty() ? 0 : 1), objects.end());
  return fmt::format(fmt::runtime(row_of(reason.code).words), nth(objects, 0), fmt::join(others, " and "),
                     nth(reason.terms, 0), nth(reason.terms, 1));
}

}  // namespace continua
