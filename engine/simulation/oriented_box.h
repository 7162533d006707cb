// Boxes that are turned, and how deep they are in one another.
#pragma once

#include <Eigen/Core>

#include "continua/world/world_snapshot.h"

namespace continua {

/// A box with its centre and axes at a pose.
struct OrientedBox {
  Vec3 center_W = Vec3::Zero();
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();
  Vec3 half_m = Vec3::Zero();
};

/// The least way along a face's axis by which one box would have to be moved to part the two; negative or zero when
/// they are apart. Pairs of edges are left out: they could only make it smaller.
double overlap_depth(const OrientedBox& a, const OrientedBox& b);

/// The box of an object, as it is turned about the vertical.
OrientedBox box_of(const ObjectState& object);

/// The space through which nothing can come down that shall be beside the object: its box, and all below it.
OrientedBox column_of(const ObjectState& object);

/// The table, with all that is below it.
OrientedBox table_block(const Box& table);

}  // namespace continua
