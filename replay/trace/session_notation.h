// From VoxSim's frame, names and notation to ours; traces/FORMAT.md, "Import of VoxSim session logs", has the tables.
//
// VoxSim: metres, y up, +x to the human's left, +z toward the human, the table's top at y = 0.740948. Frame W: metres,
// z up, x to the human's right, y away from the human. VoxSim's table is 2.5 m wide; ours is 1 m: scale 0.4.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/perception/input_event.h"

namespace continua {

/// The point of the table that a pointing sample (x, y) of VoxSim's recogniser means, in W, with z = 0; rounded to
/// micrometres.
Vec3 table_point_of_sample(double x, double y);

/// A point of VoxSim's world in W, rounded to micrometres.
Vec3 point_from_voxsim(double x, double y, double z);

/// "put(block4,<-0.52; 0.743948; 0.23>)" as "put(block4, <0.208, -0.092, 0.0012>)". A text that is no term is returned
/// as it is.
std::string notation_from_voxsim(std::string_view content);

/// "right point high,-0.14,-0.05" as a gesture (without its time); nothing if there is no name in it. A point after
/// the comma that cannot be read is left out: `point_unread` tells.
struct ImportedGesture {
  InputEvent event;
  bool point_unread = false;
};
std::optional<ImportedGesture> gesture_from_voxsim(std::string_view content);

/// "r,-0.49,-0.01" as a pointing sample (without its time).
std::optional<InputEvent> pointing_from_voxsim(std::string_view content);

/// The whole of `text` as a finite number.
std::optional<double> finite_number(std::string_view text);

}  // namespace continua
