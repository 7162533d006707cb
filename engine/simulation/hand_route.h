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

/// From `X_WF` to `X_WT`, across above everything on the way. What is held reaches `below_m` below the point between
/// the pads when the hand is turned as at `X_WT`.
std::vector<Pose> way_over(const Pose& X_WF, const Pose& X_WT, const WorldSnapshot& world, const AvatarForm& avatar,
                           double below_m = 0);

/// As way_over, by way of before_grasp(X_WT).
std::vector<Pose> way_to_grasp(const Pose& X_WF, const Pose& X_WT, const WorldSnapshot& world,
                               const AvatarForm& avatar);

/// Where the hand is before it comes to `X_WT`, and after it has left: above, or back along its fingers if one of them
/// is below what it holds.
Pose before_grasp(const Pose& X_WT);

/// A little above an object or, without one, a place; clear of what stands beside it. `X_WT` is where the hand is.
Pose hover_pose(const ObjectState* object, const Vec3& p_W, const WorldSnapshot& world, const Pose& X_WT,
                const AvatarForm& avatar);

/// The table and what is on it, but for what is held: what the avatar keeps clear of.
std::vector<OrientedBox> things_around(const WorldSnapshot& world);

/// Fingers stretched toward a place, from the side of the avatar, at some distance: the ways to do so, best first.
std::vector<Pose> pointing_poses(const Vec3& p_W, const Vec3& base_W);

/// What an object would meet first if it were slid to its goal; it may touch `landmark`.
std::optional<std::string> met_on_way(const ObjectState& object, const Vec3& p_WG, const std::string& landmark,
                                      const WorldSnapshot& world);

/// Whether an object can be slid to its goal without meeting others; it may touch `landmark`.
bool way_is_free(const ObjectState& object, const Vec3& p_WG, const std::string& landmark, const WorldSnapshot& world);

}  // namespace continua
