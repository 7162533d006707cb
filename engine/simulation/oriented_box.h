// Turned boxes and their overlaps.
#pragma once

#include <limits>

#include <Eigen/Core>

#include "continua/world/world_snapshot.h"

namespace continua {

/// A box with its centre and axes at a pose.
struct OrientedBox {
  Vec3 center_W = Vec3::Zero();
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();
  Vec3 half_m = Vec3::Zero();
};

/// The shortest way along a face's axis that would part the two boxes; zero or negative if they are apart. Axes of
/// pairs of edges are left out: they could only shorten the way. The search ends where it falls to `enough_m`: for
/// callers to whom no lesser depth matters.
double overlap_depth(const OrientedBox& a, const OrientedBox& b,
                     double enough_m = -std::numeric_limits<double>::infinity());

/// The box of an object, turned about the vertical like the object.
OrientedBox box_of(const ObjectState& object);

/// The object's box and everything below it: a thing that comes down beside the object must avoid it.
OrientedBox column_of(const ObjectState& object);

/// The table and everything below it.
OrientedBox table_block(const Box& table);

}  // namespace continua
