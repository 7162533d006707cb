#include "continua/simulation/avatar_elements.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "continua/core/angles.h"
#include "continua/simulation/geom_bounds.h"
#include "continua/simulation/mujoco_model.h"

namespace continua {

namespace {

constexpr std::array sides = {"left", "right"};

/// A joint that follows a servo's value: value * per_unit + at_zero.
struct Driven {
  int joint = 0;
  double at_zero = 0, per_unit = 1;
};

/// Each joint's part in an actuator's length; nothing if the actuator does not act on joints.
std::optional<std::vector<std::pair<int, double>>> transmission(const mjModel& model, int actuator) {
  const double gear = model.actuator_gear[6 * actuator];
  const int target = model.actuator_trnid[2 * actuator];
  if (model.actuator_trntype[actuator] == mjTRN_JOINT) return std::vector{std::pair(target, gear)};
  if (model.actuator_trntype[actuator] != mjTRN_TENDON) return std::nullopt;
  std::vector<std::pair<int, double>> joints;
  for (int i = model.tendon_adr[target]; i < model.tendon_adr[target] + model.tendon_num[target]; ++i) {
    if (model.wrap_type[i] != mjWRAP_JOINT) return std::nullopt;
    joints.emplace_back(model.wrap_objid[i], gear * model.wrap_prm[i]);
  }
  return joints;
}

/// The servo that moves these joints by one value, and no other joint; nothing if the actuator is no such servo.
std::optional<Servo> servo_of(const mjModel& model, int actuator, const std::vector<Driven>& driven) {
  const auto joints = transmission(model, actuator);
  const mjtNum* gain = model.actuator_gainprm + mjNGAIN * actuator;
  const mjtNum* bias = model.actuator_biasprm + mjNBIAS * actuator;
  const bool is_position_servo = model.actuator_gaintype[actuator] == mjGAIN_FIXED && gain[0] != 0 &&
                                 model.actuator_biastype[actuator] == mjBIAS_AFFINE && bias[1] < 0;
  if (!joints || joints->empty() || !is_position_servo) return std::nullopt;
  double length_at_zero = 0, length_per_unit = 0, damping = -bias[2], least_part = std::abs(joints->front().second);
  for (const auto& [joint, part] : *joints) {
    const auto found =
        std::find_if(driven.begin(), driven.end(), [joint = joint](const Driven& one) { return one.joint == joint; });
    if (found == driven.end()) return std::nullopt;
    length_at_zero += part * found->at_zero;
    length_per_unit += part * found->per_unit;
    least_part = std::min(least_part, std::abs(part));
    damping += model.dof_damping[model.jnt_dofadr[joint]] / (part * part);
  }
  // It rests where gain * control + bias0 + bias1 * length = 0.
  return Servo{actuator, (-bias[0] - bias[1] * length_at_zero) / gain[0], -bias[1] * length_per_unit / gain[0],
               -bias[1] * std::abs(length_per_unit) * least_part, -damping / bias[1]};
}

std::vector<Servo> servos_of(const mjModel& model, const std::vector<Driven>& driven) {
  std::vector<Servo> servos;
  for (int actuator = 0; actuator < model.nu; ++actuator)
    if (auto servo = servo_of(model, actuator, driven)) servos.push_back(*servo);
  return servos;
}

/// Reads one avatar out of a model whose arm is at home.
class Reader {
 public:
  Reader(const mjModel& model, const std::vector<double>& qpos, std::string path)
      : model_(model), path_(std::move(path)), data_(mj_makeData(&model)), qpos_(qpos) {
    std::copy(qpos.begin(), qpos.end(), data_->qpos);
    mj_kinematics(&model_, data_.get());
  }

  Result<std::pair<AvatarForm, AvatarElements>> read() {
    for (const auto part : {&Reader::read_hand, &Reader::read_arm, &Reader::read_fingers, &Reader::measure_palm}) {
      if (const auto wrong = (this->*part)()) return Error{path_, "the scene's avatar has no " + *wrong};
    }
    face_the_table();
    measure_parts();
    return std::pair(form_, ids_);
  }

 private:
  using Missing = std::optional<std::string>;

  Pose X_WBody(int body) const { return {vec_of(data_->xpos + 3 * body), quat_of(data_->xquat + 4 * body)}; }
  Pose X_WGrip() const {
    const Pose X_BT{vec_of(model_.site_pos + 3 * grip_), quat_of(model_.site_quat + 4 * grip_)};
    return X_WBody(ids_.hand) * X_BT;
  }

  Missing read_hand() {
    grip_ = id_of(model_, mjOBJ_SITE, grip_name);
    if (grip_ < 0) return fmt::format("site '{}' between its finger pads", grip_name);
    ids_.hand = model_.site_bodyid[grip_];
    for (int body = 1; body < model_.nbody; ++body)
      if (is_below(model_, body, ids_.hand)) ids_.hand_bodies.push_back(body);
    ids_.weld = id_of(model_, mjOBJ_EQUALITY, grip_name);
    if (ids_.weld < 0 || model_.eq_type[ids_.weld] != mjEQ_WELD || model_.eq_obj1id[ids_.weld] != ids_.hand)
      return fmt::format("weld '{}' whose body1 is the body of site '{}'", grip_name, grip_name);
    return {};
  }

  Missing read_arm() {
    const auto hinges = arm_hinges(model_);
    if (hinges.empty() || hinges.size() > most_arm_joints)
      return fmt::format("arm: expected 1 to {} hinges between the world and the site '{}', found {}", most_arm_joints,
                         grip_name, hinges.size());
    Arm& arm = form_.arm;
    arm.home.resize(static_cast<int>(hinges.size()));
    Pose X_WL;  // of the frame after the hinge before
    for (const int joint : hinges) {
      const std::string name = name_of(model_, mjOBJ_JOINT, joint);
      if (model_.jnt_type[joint] != mjJNT_HINGE)
        return fmt::format("arm of hinges: joint '{}' between the world and the site '{}' is none", name, grip_name);
      const auto servos = servos_of(model_, {{joint}});
      if (servos.size() != 1)
        return fmt::format("position servo for hinge '{}': expected one actuator with biastype affine, as <position>",
                           name);
      ids_.servo.push_back(servos[0]);
      ids_.dof.push_back(model_.jnt_dofadr[joint]);
      ids_.qpos.push_back(model_.jnt_qposadr[joint]);
      const double q = qpos_[static_cast<std::size_t>(ids_.qpos.back())];
      const bool limited = model_.jnt_limited[joint];
      // MuJoCo gives anchor and axis in W, turned by the previous hinges; the hinge itself is turned back to zero.
      const Vec3 axis_W = vec_of(data_->xaxis + 3 * joint);
      const int body = model_.jnt_bodyid[joint];
      const Eigen::Quaterniond R_WJ = X_WBody(body).R_WB;
      const Vec3 axis_J = (R_WJ.conjugate() * axis_W).normalized();
      const Pose X_WJ{vec_of(data_->xanchor + 3 * joint), R_WJ};
      const Pose unturned{Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(-q, axis_J))};
      arm.home[static_cast<int>(arm.joints.size())] = q;
      arm.joints.push_back({inverse(X_WL) * X_WJ * unturned, axis_J, limited ? model_.jnt_range[2 * joint] : -full_turn,
                            limited ? model_.jnt_range[2 * joint + 1] : full_turn});
      X_WL = X_WJ;
    }
    arm.X_LT = inverse(X_WL) * X_WGrip();
    return {};
  }

  /// Reads pads and finger joints. The tool's y is the closing direction, with either pad at its positive side.
  Missing read_fingers() {
    std::vector<Driven> driven;
    HandShape& hand = form_.hand;
    hand.widest_opening_m = 1;
    for (int side = 0; side < 2; ++side) {
      const std::string pad = fmt::format("pad_{}", sides[side]);
      const int geom = id_of(model_, mjOBJ_GEOM, pad);
      if (geom < 0) return fmt::format("geom '{}'", pad);
      ids_.pad[side] = geom;
      int body = model_.geom_bodyid[geom], joint = -1;
      for (; body > 0 && body != ids_.hand; body = model_.body_parentid[body]) {
        if (model_.body_jntnum[body] > 1 || (model_.body_jntnum[body] == 1 && joint >= 0))
          return fmt::format("single slide joint between the hand and geom '{}'", pad);
        if (model_.body_jntnum[body] == 1) joint = model_.body_jntadr[body];
      }
      if (body != ids_.hand || joint < 0 || model_.jnt_type[joint] != mjJNT_SLIDE || !model_.jnt_limited[joint])
        return fmt::format("limited slide joint between the body of site '{}' and geom '{}'", grip_name, pad);

      const Pose X_TW = inverse(X_WGrip());
      const double out = bounds_T(geom).center().y() > 0 ? 1 : -1,
                   axis_y = (X_TW.R_WB * vec_of(data_->xaxis + 3 * joint)).y() * out;
      constexpr double straight = 0.999;  // cosine: 2.5 degrees
      if (std::abs(axis_y) < straight)
        return fmt::format("slide joint '{}' along the y axis of site '{}': they are {:.0f} degrees apart",
                           name_of(model_, mjOBJ_JOINT, joint), grip_name,
                           std::acos(std::min(1.0, std::abs(axis_y))) / rad_per_deg);
      const double inner = read_pad(geom, model_.jnt_bodyid[joint], out);
      // The pad's inner face is at inner + axis_y * (q - now): that is the opening.
      const double now = data_->qpos[model_.jnt_qposadr[joint]];
      const double most =
          std::max((model_.jnt_range[2 * joint] - now) * axis_y, (model_.jnt_range[2 * joint + 1] - now) * axis_y);
      constexpr double spare_m = 0.002;  // a finger at its limit presses on it
      hand.widest_opening_m = std::min(hand.widest_opening_m, inner + most - spare_m);
      driven.push_back({joint, now - inner * axis_y, axis_y});
      measure_finger(model_.jnt_bodyid[joint], out, inner);
    }
    ids_.finger_servo = servos_of(model_, driven);
    if (ids_.finger_servo.empty()) return "position servo that moves its fingers, as <position>";
    hand.finger_N_per_m = ids_.finger_servo.front().stiffness;
    return {};
  }

  /// A geom's bounds along the axes of the tool's frame.
  Box bounds_T(int geom) const {
    const GeomBox box = geom_box_B(model_, geom);
    const auto corners = corners_A(inverse(X_WGrip()) * X_WBody(model_.geom_bodyid[geom]) * box.X_BG, box.half_m);
    Box bounds{corners.front(), corners.front()};
    for (const Vec3& corner : corners) bounds = {bounds.min.cwiseMin(corner), bounds.max.cwiseMax(corner)};
    return bounds;
  }

  /// The distance of the named geom's face from the middle. Other geoms of the finger may be nearer.
  double read_pad(int named, int finger, double out) {
    const auto inner_of = [&](const Box& box) { return out > 0 ? box.min.y() : -box.max.y(); };
    const double face_m = inner_of(bounds_T(named));
    for (int geom = 0; geom < model_.ngeom; ++geom) {
      if (geom == named || !is_below(model_, model_.geom_bodyid[geom], finger) || !is_solid(model_, geom)) continue;
      const double ahead_m = face_m - inner_of(bounds_T(geom));
      if (ahead_m > position_grid_m) ids_.before_pads.push_back({geom, named, ahead_m});
    }
    return face_m;
  }

  void measure_finger(int finger, double out, double inner_m) {
    HandShape& hand = form_.hand;
    for (const int body : ids_.hand_bodies) {
      if (!is_below(model_, body, finger)) continue;
      fingers_.push_back(body);
      for (const Vec3& corner : corners_T(body)) {
        hand.finger_tip_m = std::max(hand.finger_tip_m, corner.x());
        hand.finger_half_width_m = std::max(hand.finger_half_width_m, std::abs(corner.z()));
        hand.finger_thickness_m = std::max(hand.finger_thickness_m, corner.y() * out - inner_m);
      }
    }
  }

  /// Corners of the boxes of a body's geoms, in the tool's frame.
  std::vector<Vec3> corners_T(int body) const {
    const Pose X_TB = inverse(X_WGrip()) * X_WBody(body);
    std::vector<Vec3> corners;
    for (int geom = model_.body_geomadr[body]; geom < model_.body_geomadr[body] + model_.body_geomnum[body]; ++geom) {
      const GeomBox box = geom_box_B(model_, geom);
      for (const Vec3& corner : corners_A(X_TB * box.X_BG, box.half_m)) corners.push_back(corner);
    }
    return corners;
  }

  /// Measures the hand without the fingers, which is behind the point between the pads.
  Missing measure_palm() {
    HandShape& hand = form_.hand;
    hand.palm_front_m = 1;
    Vec3 low = Vec3::Ones(), high = -Vec3::Ones();
    for (const int body : ids_.hand_bodies) {
      if (std::find(fingers_.begin(), fingers_.end(), body) != fingers_.end()) continue;
      for (const Vec3& corner : corners_T(body)) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
        hand.palm_front_m = std::min(hand.palm_front_m, -corner.x());
        hand.palm_back_m = std::max(hand.palm_back_m, -corner.x());
        hand.palm_half_length_m = std::max(hand.palm_half_length_m, std::abs(corner.y()));
        hand.palm_half_width_m = std::max(hand.palm_half_width_m, std::abs(corner.z()));
      }
    }
    const Vec3 palm_T = -(low + high) / 2;
    constexpr double roughly = 0.5;  // cosine: 60 degrees; a palm may stand out to one side
    if (low.x() <= high.x() && palm_T.x() < roughly * palm_T.norm())
      return fmt::format("site '{}' whose x axis points out of the palm: it points {:.0f} degrees off that", grip_name,
                         std::acos(palm_T.x() / palm_T.norm()) / rad_per_deg);
    hand.palm_front_m = std::clamp(hand.palm_front_m, 0.0, hand.palm_back_m);
    return {};
  }

  /// Chooses the direction of the tool's y nearer to natural at home: the pads are alike.
  void face_the_table() {
    Arm& arm = form_.arm;
    const Pose X_WT = tool_pose(arm, arm.home);
    const double natural = form_.natural_yaw(X_WT.p_WB);
    double off = std::remainder(yaw_of_closing(X_WT) - natural, full_turn);
    if (std::abs(off) > quarter_turn) {
      arm.X_LT = arm.X_LT * Pose{Vec3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(half_turn, Vec3::UnitX()))};
      off = std::remainder(off + half_turn, full_turn);
    }
    constexpr double along = 0.99;  // cosine: 8 degrees
    constexpr double spare = 0.15;  // radians: a wrist at its limit leaves the arm no way
    const ArmJoint& last = arm.joints.back();
    const double axis_T = (arm.X_LT.R_WB.conjugate() * last.axis_J).x(), home = arm.home[arm.size() - 1];
    if (std::abs(axis_T) < along) return;
    // With the fingers down, a hinge along them turns the hand the other way.
    const double a = off - axis_T * (last.min - home), b = off - axis_T * (last.max - home);
    form_.least_wrist = std::min(a, b) + spare;
    form_.most_wrist = std::max(a, b) - spare;
  }

  static double yaw_of_closing(const Pose& X_WT) {
    const Vec3 closing = X_WT.R_WB * Vec3::UnitY();
    return std::atan2(closing.y(), closing.x());
  }

  /// Measures the arm's parts that move and can touch things, without the hand.
  void measure_parts() {
    const auto links = link_poses(form_.arm, form_.arm.home);
    const auto hinges = arm_hinges(model_);
    for (int geom = 0; geom < model_.ngeom; ++geom) {
      const int body = model_.geom_bodyid[geom];
      if (!is_solid(model_, geom)) continue;
      if (is_below(model_, body, ids_.hand)) continue;
      int hinge = -1;  // the last one that moves the body
      for (std::size_t i = 0; i < hinges.size(); ++i)
        if (is_below(model_, body, model_.jnt_bodyid[hinges[i]])) hinge = static_cast<int>(i);
      if (hinge < 0) continue;
      const GeomBox box = geom_box_B(model_, geom);
      const Pose X_WL = links[static_cast<std::size_t>(hinge)];
      form_.parts.push_back({hinge, inverse(X_WL) * X_WBody(body) * box.X_BG, box.half_m});
    }
  }

  const mjModel& model_;
  const std::string path_;
  const DataOwner data_;
  const std::vector<double>& qpos_;
  int grip_ = -1;
  std::vector<int> fingers_;  // their bodies
  AvatarForm form_;
  AvatarElements ids_;
};

}  // namespace

std::vector<int> arm_hinges(const mjModel& model) {
  const int grip = id_of(model, mjOBJ_SITE, grip_name);
  return hinges_to(model, grip < 0 ? 0 : model.site_bodyid[grip]);
}

std::vector<int> hinges_to(const mjModel& model, int body) {
  std::vector<int> joints;
  for (; body > 0; body = model.body_parentid[body]) {
    for (int i = model.body_jntnum[body] - 1; i >= 0; --i) joints.insert(joints.begin(), model.body_jntadr[body] + i);
  }
  return joints;
}

bool is_below(const mjModel& model, int body, int ancestor) {
  while (body > ancestor) body = model.body_parentid[body];
  return body == ancestor;
}

bool is_solid(const mjModel& model, int geom) {
  return model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
}

Result<std::pair<AvatarForm, AvatarElements>> find_avatar(const mjModel& model, const std::vector<double>& qpos,
                                                          const std::string& path) {
  return Reader(model, qpos, path).read();
}

}  // namespace continua
