#include "simulation/avatar_elements.h"

#include <vector>

#include <fmt/format.h>

#include "simulation/mujoco_model.h"

namespace continua {

Result<std::pair<Arm, AvatarElements>> find_avatar(const mjModel& model, const std::string& path) {
  const auto missing = [&](const std::string& what) {
    return Error{path, fmt::format("the scene's avatar has no {}", what)};
  };
  Arm arm;
  AvatarElements ids;
  const int grip = id_of(model, mjOBJ_SITE, "grip");
  if (grip < 0) return missing("site 'grip'");
  ids.hand = model.site_bodyid[grip];
  ids.weld = id_of(model, mjOBJ_EQUALITY, "grip");
  if (ids.weld < 0 || model.eq_type[ids.weld] != mjEQ_WELD || model.eq_obj1id[ids.weld] != ids.hand)
    return missing("weld 'grip' whose body1 is the body of site 'grip'");

  std::vector<int> bodies;  // from the world outward
  for (int body = ids.hand; body > 0; body = model.body_parentid[body]) bodies.insert(bodies.begin(), body);
  int found = 0;
  Pose X_PB;
  for (const int body : bodies) {
    const Pose X{vec_of(model.body_pos + 3 * body), quat_of(model.body_quat + 4 * body)};
    X_PB = {X_PB.p_WB + X_PB.R_WB * X.p_WB, X_PB.R_WB * X.R_WB};
    if (model.body_jntnum[body] == 0) continue;
    const int joint = model.body_jntadr[body];
    const std::string name = fmt::format("arm_{}", found + 1);
    if (model.body_jntnum[body] > 1 || model.jnt_type[joint] != mjJNT_HINGE || found == arm_joint_count ||
        name_of(model, mjOBJ_JOINT, joint) != name || !model.jnt_limited[joint] ||
        vec_of(model.jnt_pos + 3 * joint).norm() > 0)
      return missing(fmt::format("limited hinge '{}' in its place: one per body, at the body's origin", name));
    const int servo = id_of(model, mjOBJ_ACTUATOR, name);
    if (servo < 0) return missing(fmt::format("actuator '{}'", name));
    arm.joints[found] = {X_PB, vec_of(model.jnt_axis + 3 * joint), model.jnt_range[2 * joint],
                         model.jnt_range[2 * joint + 1]};
    ids.dof[found] = model.jnt_dofadr[joint];
    ids.qpos[found] = model.jnt_qposadr[joint];
    ids.servo[found] = servo;
    ids.lead_s[found] = model.actuator_biasprm[mjNBIAS * servo + 2] / model.actuator_biasprm[mjNBIAS * servo + 1];
    X_PB = {};
    ++found;
  }
  if (found < arm_joint_count) return missing(fmt::format("hinge 'arm_{}'", found + 1));
  arm.X_LT = {X_PB.p_WB + X_PB.R_WB * vec_of(model.site_pos + 3 * grip),
              X_PB.R_WB * quat_of(model.site_quat + 4 * grip)};

  constexpr std::array sides = {"left", "right"};
  for (int side = 0; side < 2; ++side) {
    ids.pad[side] = id_of(model, mjOBJ_GEOM, fmt::format("pad_{}", sides[side]));
    ids.finger_servo[side] = id_of(model, mjOBJ_ACTUATOR, fmt::format("finger_{}", sides[side]));
    if (ids.pad[side] < 0) return missing(fmt::format("geom 'pad_{}'", sides[side]));
    if (ids.finger_servo[side] < 0) return missing(fmt::format("actuator 'finger_{}'", sides[side]));
  }
  return std::pair(arm, ids);
}

}  // namespace continua
