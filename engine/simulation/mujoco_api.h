// MuJoCo's interface, with one name for each part that differs among its versions from 2.2 on. The only header that
// knows versions: mjVERSION_HEADER is 222 for 2.2.2, and 3005000 for 3.5.0, from which on a part takes three digits.
#pragma once

#include <mujoco/mujoco.h>

namespace continua::mujoco {

#if mjVERSION_HEADER >= 3009000
using CollisionData = mjData;
using FoundContact = mjPreContact;
#else
using CollisionData = const mjData;
using FoundContact = mjContact;
#endif

/// The unit vector of a contact that leads from the first geom to the second.
inline const mjtNum* normal_of(const FoundContact& contact) {
#if mjVERSION_HEADER >= 3009000
  return contact.normal;
#else
  return contact.frame;
#endif
}

/// Two boxes with flush faces may get a contact of two edges instead.
inline constexpr bool edges_before_faces = mjVERSION_HEADER >= 3012000;

/// The distance along `along` from `from` to a geom in the frame of its body, or -1.
inline mjtNum ray_to_geom(const mjtNum* pos, const mjtNum* mat, const mjtNum* size, const mjtNum* from,
                          const mjtNum* along, int type) {
#if mjVERSION_HEADER >= 3005000
  return mju_rayGeom(pos, mat, size, from, along, type, nullptr);
#else
  return mju_rayGeom(pos, mat, size, from, along, type);
#endif
}

/// Gives a geom of a picture the place and length that lead from one point to the other.
inline void connect(mjvGeom* geom, int type, mjtNum width, const mjtNum* from, const mjtNum* to) {
#if mjVERSION_HEADER >= 237
  mjv_connector(geom, type, width, from, to);
#else
  mjv_makeConnector(geom, type, width, from[0], from[1], from[2], to[0], to[1], to[2]);
#endif
}

}  // namespace continua::mujoco
