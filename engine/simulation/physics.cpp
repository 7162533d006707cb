#include "continua/simulation/physics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/mujoco_model.h"

namespace continua {

struct Physics::State {
  ModelOwner model;  // a copy: the weld is switched in it
  DataOwner data;
  std::vector<SceneObject> objects;
  Box table;
  int table_body = -1;
  AvatarForm avatar;
  AvatarElements ids;
  int grip = -1;  // the object the weld may hold
  DataOwner saved_data;
  int saved_grip = -1;
  std::vector<mjtNum> servo_damping;  // in the joints, for each degree of freedom

  bool welded() const {
#if mjVERSION_HEADER >= 300
    return data->eq_active[ids.weld];
#else
    return model->eq_active[ids.weld];
#endif
  }

  void set_welded(bool active) {
#if mjVERSION_HEADER >= 300
    data->eq_active[ids.weld] = active;
#else
    model->eq_active[ids.weld] = active;
#endif
  }

  /// Lets things pass through geoms in front of the pads, so that the pads themselves press.
  void clear_pads() {
    for (const auto& one : ids.before_pads) model->geom_contype[one.geom] = model->geom_conaffinity[one.geom] = 0;
  }

  /// Makes the pads soft and frictionless. Pads press and the weld carries: friction besides the weld drives pads off.
  /// On soft pads the pressure makes a contact some tenths of a millimetre deep, which no jolt undoes.
  void soften_pads() {
    constexpr std::array<mjtNum, mjNREF> solref = {0.006, 1};
    constexpr std::array<mjtNum, mjNIMP> solimp = {0.6, 0.6, 0.001, 0.5, 2};
    const int priority = *std::max_element(model->geom_priority, model->geom_priority + model->ngeom) + 1;
    for (const int pad : ids.pad) {
      model->geom_condim[pad] = 1;
      model->geom_priority[pad] = priority;
      std::copy(solref.begin(), solref.end(), model->geom_solref + mjNREF * pad);
      std::copy(solimp.begin(), solimp.end(), model->geom_solimp + mjNIMP * pad);
    }
  }

  /// Damping of the servo, for each radian or metre per second of its joint.
  mjtNum damping_of(int servo) const {
    if (model->actuator_biastype[servo] != mjBIAS_AFFINE) return 0;
    return -model->actuator_biasprm[mjNBIAS * servo + 2] * std::pow(model->actuator_gear[6 * servo], 2);
  }

  /// Lets Euler's integrator, at half the cost, do what the implicit one is there for: the damping of the servos. Euler
  /// takes the damping of joints at the speed after the step as well; so a joint gets the damping of its servo, and in
  /// each step a force against its effect at the speed before. A servo of several joints keeps the implicit integrator.
  void damp_in_joints() {
    servo_damping.assign(static_cast<std::size_t>(model->nv), 0);
    if (model->opt.integrator != mjINT_IMPLICIT) return;
    for (int i = 0; i < model->nu; ++i)
      if (damping_of(i) != 0 && model->actuator_trntype[i] != mjTRN_JOINT) return;
    model->opt.integrator = mjINT_EULER;
    for (int i = 0; i < model->nu; ++i) {
      if (damping_of(i) == 0) continue;
      const int dof = model->jnt_dofadr[model->actuator_trnid[2 * i]];
      model->dof_damping[dof] += damping_of(i);
      servo_damping[static_cast<std::size_t>(dof)] += damping_of(i);
    }
  }

  /// Welds the object in its present pose in the hand's frame.
  void weld_to(int body) {
    mj_kinematics(model.get(), data.get());
    const Eigen::Quaterniond R_WH = quat_of(data->xquat + 4 * ids.hand), R_WO = quat_of(data->xquat + 4 * body);
    const Vec3 p_HO = R_WH.conjugate() * (vec_of(data->xpos + 3 * body) - vec_of(data->xpos + 3 * ids.hand));
    const Eigen::Quaterniond R_HO = R_WH.conjugate() * R_WO;
    model->eq_obj2id[ids.weld] = body;
    mjtNum* relative = model->eq_data + mjNEQDATA * ids.weld;  // anchor in object, p_HO, R_HO, scale of torque
    std::fill(relative, relative + 3, 0);
    std::copy(p_HO.data(), p_HO.data() + 3, relative + 3);
    relative[6] = R_HO.w();
    std::copy(R_HO.vec().data(), R_HO.vec().data() + 3, relative + 7);
    set_welded(true);
  }

  bool touches(int geom, int body) const {
    for (int i = 0; i < data->ncon; ++i) {
      const mjContact& contact = data->contact[i];
      const bool first = contact.geom1 == geom && model->geom_bodyid[contact.geom2] == body;
      const bool second = contact.geom2 == geom && model->geom_bodyid[contact.geom1] == body;
      if ((first || second) && contact.dist <= 0) return true;
    }
    return false;
  }

  bool of_hand(int body) const {
    return std::find(ids.hand_bodies.begin(), ids.hand_bodies.end(), body) != ids.hand_bodies.end();
  }

  /// Applies forces against the weight of the arm and the held object, so that servos need not carry it.
  void carry_weight() {
    for (const int dof : ids.dof) data->qfrc_applied[dof] += data->qfrc_bias[dof];
    if (!welded()) return;
    const int body = model->eq_obj2id[ids.weld];
    std::vector<mjtNum> J(3 * static_cast<std::size_t>(model->nv));
    mj_jac(model.get(), data.get(), J.data(), nullptr, data->xipos + 3 * body, ids.hand);
    for (const int dof : ids.dof)
      for (int axis = 0; axis < 3; ++axis)
        data->qfrc_applied[dof] -=
            J[static_cast<std::size_t>(axis * model->nv + dof)] * model->body_mass[body] * model->opt.gravity[axis];
  }

  /// The weld holds while both pads touch.
  void update_weld() {
    const int body = grip < 0 ? -1 : objects[grip].body;
    const bool may_hold = body >= 0 && touches(ids.pad[0], body) && touches(ids.pad[1], body);
    if (welded() && (!may_hold || model->eq_obj2id[ids.weld] != body)) set_welded(false);
    if (may_hold && !welded()) weld_to(body);
  }
};

Physics::Physics(std::unique_ptr<State> state) : state_(std::move(state)) {}
Physics::~Physics() = default;

Result<std::unique_ptr<Physics>> Physics::create(const Scene& scene) {
  auto avatar = find_avatar(scene.model(), scene.initial_qpos(), scene.path());
  if (!avatar) return avatar.error();
  auto state = std::make_unique<State>();
  state->model = ModelOwner(mj_copyModel(nullptr, &scene.model()));
  state->data = DataOwner(mj_makeData(state->model.get()));
  state->objects = scene.objects();
  state->table = scene.table();
  state->table_body = state->model->geom_bodyid[id_of(*state->model, mjOBJ_GEOM, "table_top")];
  std::tie(state->avatar, state->ids) = *avatar;
  state->clear_pads();
  state->soften_pads();
  state->damp_in_joints();
  std::copy(scene.initial_qpos().begin(), scene.initial_qpos().end(), state->data->qpos);
  mj_forward(state->model.get(), state->data.get());
  std::unique_ptr<Physics> physics(new Physics(std::move(state)));
  physics->state_->saved_data = DataOwner(mj_makeData(physics->state_->model.get()));
  physics->save();
  return physics;
}

double Physics::timestep_s() const { return state_->model->opt.timestep; }
const AvatarForm& Physics::avatar() const { return state_->avatar; }
const std::vector<SceneObject>& Physics::objects() const { return state_->objects; }

bool Physics::step(const AvatarTarget& target) {
  State& s = *state_;
  const mjModel* model = s.model.get();
  mjData* data = s.data.get();
  for (std::size_t i = 0; i < s.ids.servo.size(); ++i) {
    // A lead as large as the lag by the servo's damping leaves little error.
    const Servo& servo = s.ids.servo[i];
    const auto hinge = static_cast<Eigen::Index>(i);
    data->ctrl[servo.actuator] = servo.control(target.hinges.q[hinge] + servo.lead_s * target.hinges.qdot[hinge]);
  }
  for (int dof = 0; dof < model->nv; ++dof)
    data->qfrc_applied[dof] = s.servo_damping[static_cast<std::size_t>(dof)] * data->qvel[dof];
  s.carry_weight();
  for (const Servo& servo : s.ids.finger_servo) data->ctrl[servo.actuator] = servo.control(target.opening_m);
  mj_step(model, data);
  // MuJoCo restarts a diverged simulation by itself; its state is not this world any more.
  if (data->warning[mjWARN_BADQPOS].number + data->warning[mjWARN_BADQVEL].number +
          data->warning[mjWARN_BADQACC].number >
      0)
    return false;
  s.update_weld();
  return true;
}

void Physics::save() {
  mj_copyData(state_->saved_data.get(), state_->model.get(), state_->data.get());
  state_->saved_grip = held();
}

void Physics::restore() {
  mj_copyData(state_->data.get(), state_->model.get(), state_->saved_data.get());
  state_->grip = state_->saved_grip;
  state_->set_welded(false);
  if (state_->grip >= 0) state_->weld_to(state_->objects[state_->grip].body);
}

void Physics::set_grip(int object) {
  state_->grip = object;
  if (object < 0) state_->set_welded(false);
}

int Physics::held() const {
  if (!state_->welded()) return -1;
  const int body = state_->model->eq_obj2id[state_->ids.weld];
  for (std::size_t i = 0; i < state_->objects.size(); ++i) {
    if (state_->objects[i].body == body) return static_cast<int>(i);
  }
  return -1;
}

bool Physics::pad_touches(bool left, int object) const {
  return state_->touches(state_->ids.pad[left ? 0 : 1], state_->objects[object].body);
}

double Physics::outside_force(int object) const {
  const State& s = *state_;
  const int held_object = held();
  const int held_body = held_object < 0 ? -1 : s.objects[held_object].body;
  const auto inside = [&](int body) { return object < 0 ? s.of_hand(body) : body == s.objects[object].body; };
  const auto outside = [&](int body) { return !s.of_hand(body) && body != held_body && !inside(body); };
  double largest = 0;
  for (int i = 0; i < s.data->ncon; ++i) {
    const int body1 = s.model->geom_bodyid[s.data->contact[i].geom1];
    const int body2 = s.model->geom_bodyid[s.data->contact[i].geom2];
    if (!(inside(body1) && outside(body2)) && !(inside(body2) && outside(body1))) continue;
    std::array<mjtNum, 6> force{};
    mj_contactForce(s.model.get(), s.data.get(), i, force.data());
    largest = std::max(largest, force[0]);
  }
  return largest;
}

std::vector<std::string> Physics::touched_by(int object) const {
  const State& s = *state_;
  std::set<std::string> names;
  for (int i = 0; i < s.data->ncon; ++i) {
    if (s.data->contact[i].dist > 0) continue;
    const int body1 = s.model->geom_bodyid[s.data->contact[i].geom1];
    const int body2 = s.model->geom_bodyid[s.data->contact[i].geom2];
    if (body1 != s.objects[object].body && body2 != s.objects[object].body) continue;
    const int other = body1 == s.objects[object].body ? body2 : body1;
    const auto is_other = [&](const SceneObject& one) { return one.body == other; };
    if (other == s.table_body) names.insert("table");
    if (std::any_of(s.objects.begin(), s.objects.end(), is_other)) names.insert(name_of(*s.model, mjOBJ_BODY, other));
  }
  return {names.begin(), names.end()};
}

ArmVector Physics::hinges() const {
  ArmVector q(arm().size());
  for (int i = 0; i < arm().size(); ++i) q[i] = state_->data->qpos[state_->ids.qpos[static_cast<std::size_t>(i)]];
  return q;
}

Pose Physics::object_pose(int object) const {
  const mjtNum* q =
      state_->data->qpos + state_->model->jnt_qposadr[state_->model->body_jntadr[state_->objects[object].body]];
  return {vec_of(q), quat_of(q + 3)};
}

std::vector<std::pair<std::string, Pose>> Physics::poses() const {
  const State& s = *state_;
  mj_kinematics(s.model.get(), s.data.get());  // the last step computed poses before it moved things
  std::vector<std::pair<std::string, Pose>> poses;
  for (int body = 1; body < s.model->nbody; ++body) {
    if (s.model->body_weldid[body] == 0) continue;
    poses.push_back(
        {name_of(*s.model, mjOBJ_BODY, body), {vec_of(s.data->xpos + 3 * body), quat_of(s.data->xquat + 4 * body)}});
  }
  return poses;
}

bool Physics::slower_than(double m_per_s, double rad_per_s) const {
  const State& s = *state_;
  for (int joint = 0; joint < s.model->njnt; ++joint) {
    const mjtNum* v = s.data->qvel + s.model->jnt_dofadr[joint];
    const bool free = s.model->jnt_type[joint] == mjJNT_FREE, slide = s.model->jnt_type[joint] == mjJNT_SLIDE;
    if (free && (vec_of(v).norm() > m_per_s || vec_of(v + 3).norm() > rad_per_s)) return false;
    if (!free && std::abs(v[0]) > (slide ? m_per_s : rad_per_s)) return false;
  }
  return true;
}

bool Physics::objects_slower_than(double m_per_s, double rad_per_s) const {
  const State& s = *state_;
  return std::all_of(s.objects.begin(), s.objects.end(), [&](const SceneObject& object) {
    const mjtNum* v = s.data->qvel + s.model->jnt_dofadr[s.model->body_jntadr[object.body]];
    return vec_of(v).norm() <= m_per_s && vec_of(v + 3).norm() <= rad_per_s;
  });
}

WorldSnapshot Physics::snapshot(SimTime t) const {
  WorldSnapshot world;
  world.t = t;
  world.table = state_->table;
  for (std::size_t i = 0; i < state_->objects.size(); ++i)
    world.objects.push_back(observed(state_->objects[i], object_pose(static_cast<int>(i))));
  const int object = held();
  if (object >= 0) world.held = state_->objects[object].name;
  return world;
}

}  // namespace continua
