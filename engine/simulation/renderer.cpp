#include "continua/simulation/renderer.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/located_json.h"
#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/geom_bounds.h"
#include "continua/simulation/mujoco_api.h"
#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/off_screen.h"
#include "continua/simulation/view_fit.h"

namespace continua {
namespace {

constexpr double fovy = 30;      // degrees; of cameras that are not the scene's
constexpr int most_marks = 300;  // geoms besides the scene's
constexpr double disc_radius_m = 0.022, disc_height_m = 0.0015, ray_radius_m = 0.003;
// A target of three discs: parts of the whole radius, and the height of each above the one below.
constexpr double ring = 0.62, bull = 0.3, disc_step_m = 0.0003;

struct FreeScene {
  void operator()(mjvScene* scene) const {
    mjv_freeScene(scene);
    delete scene;
  }
};

/// Poses of bodies, written straight into the kinematics: a picture needs no joints.
class Posed {
 public:
  Posed(const mjModel& model, const std::map<std::string, Pose>& at_start)
      : model_(model), data_(mj_makeData(&model)), hand_site_(id_of(model, mjOBJ_SITE, grip_name)) {
    mj_kinematics(&model_, data_.get());
    for (int body = 0; body < model_.nbody; ++body) {
      bounds_B_.push_back(body_bounds_B(model_, body));
      if (const char* name = mj_id2name(&model_, mjOBJ_BODY, body)) bodies_[name] = body;
    }
    write(at_start);
    xpos_at_start_.assign(data_->xpos, data_->xpos + 3 * model_.nbody);
    xquat_at_start_.assign(data_->xquat, data_->xquat + 4 * model_.nbody);
    set({});
  }

  void set(const std::map<std::string, Pose>& poses) {
    std::copy(xpos_at_start_.begin(), xpos_at_start_.end(), data_->xpos);
    std::copy(xquat_at_start_.begin(), xquat_at_start_.end(), data_->xquat);
    write(poses);
    for (int body = 0; body < model_.nbody; ++body) mju_quat2Mat(data_->xmat + 9 * body, data_->xquat + 4 * body);
    for (int i = 0; i < model_.ngeom; ++i)
      place(model_.geom_bodyid[i], model_.geom_pos + 3 * i, model_.geom_quat + 4 * i, data_->geom_xpos + 3 * i,
            data_->geom_xmat + 9 * i);
    for (int i = 0; i < model_.nsite; ++i)
      place(model_.site_bodyid[i], model_.site_pos + 3 * i, model_.site_quat + 4 * i, data_->site_xpos + 3 * i,
            data_->site_xmat + 9 * i);
    mj_camlight(&model_, data_.get());
  }

  /// Corners of everything that the picture should show.
  std::vector<Vec3> corners_W() const {
    std::vector<Vec3> corners;
    for (int body = 1; body < model_.nbody; ++body) {
      if (model_.body_geomnum[body] == 0) continue;
      for (const Vec3& corner : corners_W(body)) corners.push_back(corner);
    }
    if (corners.empty()) corners = {Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 0.5)};
    return corners;
  }

  /// The middle of the top of the body of that name, if there is one.
  std::optional<Vec3> top_of(const std::string& name) const {
    const auto body = bodies_.find(name);
    if (body == bodies_.end() || model_.body_geomnum[body->second] == 0) return std::nullopt;
    const Box box = bounds_W(body->second);
    return Vec3(box.center().x(), box.center().y(), box.max.z());
  }

  /// `p_W`, raised to the top of the highest object there.
  Vec3 above_objects(const Vec3& p_W) const {
    Vec3 above = p_W;
    for (int body = 1; body < model_.nbody; ++body) {
      const int joint = model_.body_jntadr[body];
      if (model_.body_geomnum[body] == 0 || joint < 0 || model_.jnt_type[joint] != mjJNT_FREE) continue;
      const Box box = bounds_W(body);
      const bool within =
          (p_W.head<2>() - box.center().head<2>()).cwiseAbs().cwiseQuotient((box.max - box.min).head<2>()).maxCoeff() <
          0.5;
      if (within) above.z() = std::max(above.z(), box.max.z());
    }
    return above;
  }

  std::optional<Vec3> hand() const {
    return hand_site_ < 0 ? std::nullopt : std::optional(vec(data_->site_xpos + 3 * hand_site_));
  }

  mjData* data() const { return data_.get(); }

 private:
  void write(const std::map<std::string, Pose>& poses) {
    for (const auto& [name, pose] : poses) {
      const auto body = bodies_.find(name);
      if (body == bodies_.end()) continue;
      mju_copy3(data_->xpos + 3 * body->second, pose.p_WB.data());
      const std::array<mjtNum, 4> q{pose.R_WB.w(), pose.R_WB.x(), pose.R_WB.y(), pose.R_WB.z()};
      std::copy(q.begin(), q.end(), data_->xquat + 4 * body->second);
      mju_normalize4(data_->xquat + 4 * body->second);
    }
  }

  void place(int body, const mjtNum* pos, const mjtNum* quat, mjtNum* xpos, mjtNum* xmat) const {
    const mjtNum* body_quat = data_->xquat + 4 * body;
    mju_rotVecQuat(xpos, pos, body_quat);
    mju_addTo3(xpos, data_->xpos + 3 * body);
    std::array<mjtNum, 4> q{};
    mju_mulQuat(q.data(), body_quat, quat);
    mju_quat2Mat(xmat, q.data());
  }

  std::array<Vec3, 8> corners_W(int body) const {
    const Box& box = bounds_B_[static_cast<std::size_t>(body)];
    std::array<Vec3, 8> corners;
    std::size_t next = 0;
    for (const double x : {box.min.x(), box.max.x()})
      for (const double y : {box.min.y(), box.max.y()})
        for (const double z : {box.min.z(), box.max.z()}) corners[next++] = in_W(body, {x, y, z});
    return corners;
  }

  Box bounds_W(int body) const {
    const auto corners = corners_W(body);
    Box bounds{corners[0], corners[0]};
    for (const Vec3& corner : corners) {
      bounds.min = bounds.min.cwiseMin(corner);
      bounds.max = bounds.max.cwiseMax(corner);
    }
    return bounds;
  }

  Vec3 in_W(int body, const Vec3& p_B) const {
    Vec3 p_W;
    mju_rotVecQuat(p_W.data(), p_B.data(), data_->xquat + 4 * body);
    return p_W + vec(data_->xpos + 3 * body);
  }

  const mjModel& model_;
  DataOwner data_;
  std::vector<mjtNum> xpos_at_start_, xquat_at_start_;
  std::vector<Box> bounds_B_;
  std::map<std::string, int> bodies_;
  int hand_site_;
};

}  // namespace

class Renderer::Impl {
 public:
  Impl(ModelOwner model, OffScreen place, ImageSize size, const std::map<std::string, Pose>& at_start)
      : model_(std::move(model)), place_(std::move(place)), posed_(*model_, at_start), size_(size) {
    mjr_defaultContext(&context_);
    mjv_defaultOption(&options_);
    std::fill(std::begin(options_.sitegroup), std::end(options_.sitegroup), mjtByte{0});
    mjv_defaultScene(scene_.get());
    mjv_makeScene(model_.get(), scene_.get(), static_cast<int>(model_->ngeom) + most_marks);
  }
  ~Impl() {
    const OffScreen::Current current(place_);
    mjr_freeContext(&context_);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Prepares OpenGL for this model.
  Outcome prepare() {
    const OffScreen::Current current(place_);
    const auto fatal = fatal_error_of([this] {
      mjr_makeContext(model_.get(), &context_, mjFONTSCALE_100);
      mjr_setBuffer(mjFB_OFFSCREEN, &context_);
    });
    if (!fatal.empty()) return Error{"", "pictures cannot be drawn with this machine's OpenGL: " + fatal};
    if (context_.currentBuffer != mjFB_OFFSCREEN)
      return Error{"", "pictures cannot be drawn with this machine's OpenGL: it cannot draw without a window"};
    return std::nullopt;
  }

  Outcome look_from(const RenderView& view, const std::string& where) {
    const int camera = view.camera.empty() ? -1 : id_of(*model_, mjOBJ_CAMERA, view.camera);
    if (camera >= 0) {
      mjv_defaultCamera(&camera_);
      camera_.type = mjCAMERA_FIXED;
      camera_.fixedcamid = camera;
      return std::nullopt;
    }
    model_->vis.global.fovy = fovy;
    const auto fitted = camera_from(view.camera.empty() ? "front" : view.camera, posed_.corners_W(), fovy,
                                    static_cast<double>(size_.width) / size_.height, view.free_below);
    if (fitted) {
      camera_ = *fitted;
      return std::nullopt;
    }
    auto names = side_names();
    for (int i = 0; i < model_->ncam; ++i)
      if (const char* name = mj_id2name(model_.get(), mjOBJ_CAMERA, i)) names.emplace_back(name);
    return Error{where, fmt::format("the scene has no camera {}{}; expected one of {}", in_quotes(view.camera),
                                    did_you_mean(view.camera, names), fmt::join(names, ", "))};
  }

  Image draw(const std::map<std::string, Pose>& poses, const std::vector<RenderMark>& marks) {
    const OffScreen::Current current(place_);
    posed_.set(poses);
    mjv_updateScene(model_.get(), posed_.data(), &options_, nullptr, &camera_, mjCAT_ALL, scene_.get());
    for (const auto& mark : marks) add(mark);
    const mjrRect all{0, 0, size_.width, size_.height};
    mjr_render(all, scene_.get(), &context_);
    const auto row = static_cast<std::size_t>(size_.width) * 3, rows = static_cast<std::size_t>(size_.height);
    Image image{size_, std::vector<unsigned char>(row * rows)};
    mjr_readPixels(image.rgb.data(), nullptr, all, &context_);
    for (std::size_t i = 0; i < rows / 2; ++i)  // OpenGL's first row is the lowest
      std::swap_ranges(image.rgb.begin() + static_cast<std::ptrdiff_t>(i * row),
                       image.rgb.begin() + static_cast<std::ptrdiff_t>((i + 1) * row),
                       image.rgb.begin() + static_cast<std::ptrdiff_t>((rows - 1 - i) * row));
    return image;
  }

 private:
  void add(const RenderMark& mark) {
    const Vec3 to = posed_.top_of(mark.on_body).value_or(posed_.above_objects(mark.to_W));
    const auto from = mark.from_hand ? posed_.hand() : mark.from_W;
    const std::array<float, 4> colour{mark.rgb[0], mark.rgb[1], mark.rgb[2], 1}, light{1, 1, 1, 1};
    const auto disc = [&](double radius, double height, const std::array<float, 4>& rgba) {
      const std::array<mjtNum, 3> size{radius, height, 0};
      const Vec3 at = to + Vec3(0, 0, height);
      if (auto* geom = new_geom()) mjv_initGeom(geom, mjGEOM_CYLINDER, size.data(), at.data(), nullptr, rgba.data());
    };
    disc(disc_radius_m, disc_height_m, colour);
    disc(disc_radius_m * ring, disc_height_m + disc_step_m, light);
    disc(disc_radius_m * bull, disc_height_m + 2 * disc_step_m, colour);
    if (!from || (to - *from).norm() < disc_height_m) return;
    if (auto* geom = new_geom()) {
      mjv_initGeom(geom, mjGEOM_CAPSULE, nullptr, nullptr, nullptr, colour.data());
      mujoco::connect(geom, mjGEOM_CAPSULE, ray_radius_m, from->data(), to.data());
      geom->emission = 0.4F;
    }
  }

  mjvGeom* new_geom() { return scene_->ngeom < scene_->maxgeom ? &scene_->geoms[scene_->ngeom++] : nullptr; }

  ModelOwner model_;
  OffScreen place_;
  Posed posed_;
  ImageSize size_;
  mjrContext context_{};
  mjvOption options_{};
  mjvCamera camera_{};
  std::unique_ptr<mjvScene, FreeScene> scene_{new mjvScene{}};
};

Result<Renderer> Renderer::open(const RenderScene& scene, ImageSize size, const RenderView& view) {
  require(size.width > 0 && size.height > 0 && size.width <= max_image_side && size.height <= max_image_side,
          "a picture of a size that cannot be drawn");
  auto place = OffScreen::open();
  if (!place) return place.error();
  auto compiled = compile_mjcf(scene.mjcf, scene.asset_directory);
  if (const auto* error = std::get_if<CompileError>(&compiled)) return Error{scene.where, error->sentence};
  auto model = std::get<ModelOwner>(std::move(compiled));
  model->vis.global.offwidth = size.width;
  model->vis.global.offheight = size.height;

  auto impl = std::make_unique<Impl>(std::move(model), std::move(place).value(), size, scene.poses);
  if (auto problem = impl->look_from(view, scene.where)) return *problem;
  if (auto problem = impl->prepare()) return *problem;
  return Renderer(std::move(impl));
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::draw(const std::map<std::string, Pose>& poses, const std::vector<RenderMark>& marks) {
  return impl_->draw(poses, marks);
}

Outcome cannot_render() {
  static const Outcome reason = [] {
    const auto place = OffScreen::open();
    return place ? std::nullopt : Outcome(place.error());
  }();
  return reason;
}

}  // namespace continua
