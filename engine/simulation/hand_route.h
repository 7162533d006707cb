// Poses and ways of the hand over the table, clear of what stands there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/simulation/avatar_form.h"
#include "continua/simulation/hand_turn.h"
#include "continua/world/world_snapshot.h"

namespace continua {

inline constexpr double resting_opening_m = 0.02;  ///< of each finger, when there is nothing to hold

/// Poses from `X_WF` to `X_WT`, across above everything on the way. `below_m`: reach of the held object below the point
/// between the pads, with the hand turned as at `X_WT`.
std::vector<Pose> way_over(const Pose& X_WF, const Pose& X_WT, const WorldSnapshot& world, const AvatarForm& avatar,
                           double below_m = 0);

/// Like way_over, through before_grasp(X_WT).
std::vector<Pose> way_to_grasp(const Pose& X_WF, const Pose& X_WT, const WorldSnapshot& world,
                               const AvatarForm& avatar);

/// The hand's pose before it comes to `X_WT` and after it has left: above, or back along its fingers if one of them is
/// below the object.
Pose before_grasp(const Pose& X_WT);

/// A pose a little above an object or, without one, a place, clear of the neighbours. `X_WT`: the hand now.
Pose hover_pose(const ObjectState* object, const Vec3& p_W, const WorldSnapshot& world, const Pose& X_WT,
                const AvatarForm& avatar);

/// The table and the things on it without the held one: the avatar keeps clear of them.
std::vector<OrientedBox> things_around(const WorldSnapshot& world);

/// Poses with the fingers stretched toward a place from the avatar's side, at some distance, best first.
std::vector<Pose> pointing_poses(const Vec3& p_W, const Vec3& base_W);

/// The first thing in the way of an object that slides to its goal; touching `landmark` is allowed.
std::optional<std::string> met_on_way(const ObjectState& object, const Vec3& p_WG, const std::string& landmark,
                                      const WorldSnapshot& world);

/// An object can slide to its goal and meet nothing; touching `landmark` is allowed.
bool way_is_free(const ObjectState& object, const Vec3& p_WG, const std::string& landmark, const WorldSnapshot& world);

}  // namespace continua
