#include "continua/simulation/object_shape.h"

#include <algorithm>
#include <cmath>

#include "continua/core/angles.h"
#include "continua/simulation/mujoco_api.h"
#include "continua/simulation/mujoco_model.h"

namespace continua {

namespace {

constexpr double column_m = 0.002;  // width of a column: fine enough for fingers, and some thousand for a plate

/// The height at which a vertical ray from `from`, in the body's frame, first meets a geom.
std::optional<double> met_at(const mjModel& model, int geom, const Vec3& from, double direction) {
  const mjtNum* quat = model.geom_quat + 4 * geom;
  mjtNum mat[9];
  mju_quat2Mat(mat, quat);
  const mjtNum along[3] = {0, 0, direction};
  const int type = model.geom_type[geom] == mjGEOM_MESH ? static_cast<int>(mjGEOM_BOX) : model.geom_type[geom];
  const mjtNum distance =
      mujoco::ray_to_geom(model.geom_pos + 3 * geom, mat, model.geom_size + 3 * geom, from.data(), along, type);
  if (distance < 0) return std::nullopt;
  return from.z() + direction * distance;
}

}  // namespace

ObjectShape ObjectShape::of_body(const mjModel& model, int body, const Vec3& half_extents_m) {
  ObjectShape shape;
  shape.half_ = half_extents_m;
  const auto count = [](double half) { return std::max(1, static_cast<int>(std::lround(2 * half / column_m))); };
  shape.nx_ = count(half_extents_m.x());
  shape.ny_ = count(half_extents_m.y());
  for (int iy = 0; iy < shape.ny_; ++iy) {
    for (int ix = 0; ix < shape.nx_; ++ix) {
      const Vec3 p(shape.center_m(0, ix), shape.center_m(1, iy), 0), outside(0, 0, 2 * half_extents_m.z());
      Column column;
      for (int geom = model.body_geomadr[body]; geom < model.body_geomadr[body] + model.body_geomnum[body]; ++geom) {
        if (model.geom_contype[geom] == 0 && model.geom_conaffinity[geom] == 0) continue;
        const auto bottom = met_at(model, geom, p - outside, 1), top = met_at(model, geom, p + outside, -1);
        if (!bottom || !top) continue;
        column.bottom_m = column.empty ? *bottom : std::min(column.bottom_m, *bottom);
        column.top_m = column.empty ? *top : std::max(column.top_m, *top);
        column.empty = false;
      }
      shape.columns_.push_back(column);
    }
  }
  const std::string prefix = name_of(model, mjOBJ_BODY, body) + "_";
  for (int site = 0; site < model.nsite; ++site) {
    const std::string name = name_of(model, mjOBJ_SITE, site);
    if (model.site_bodyid[site] != body || model.site_type[site] != mjGEOM_BOX || !name.starts_with(prefix)) continue;
    const mjtNum *p = model.site_pos + 3 * site, *size = model.site_size + 3 * site;
    const Vec3 center(p[0], p[1], p[2]), half(size[0], size[1], size[2]);
    shape.parts_[name.substr(prefix.size())] = {center - half, center + half};
  }
  return shape;
}

const Box* ObjectShape::part(const std::vector<std::string>& names) const {
  for (const auto& name : names)
    if (const auto found = parts_.find(name); found != parts_.end()) return &found->second;
  return nullptr;
}

double ObjectShape::center_m(int axis, int i) const {
  return half_[axis] * ((2 * i + 1.0) / (axis == 0 ? nx_ : ny_) - 1);
}

const ObjectShape::Column* ObjectShape::at(double x, double y) const {
  if (std::abs(x) >= half_.x() || std::abs(y) >= half_.y()) return nullptr;
  const int ix = std::min(nx_ - 1, static_cast<int>((x / half_.x() + 1) / 2 * nx_));
  const int iy = std::min(ny_ - 1, static_cast<int>((y / half_.y() + 1) / 2 * ny_));
  const Column& column = columns_[static_cast<std::size_t>(iy * nx_ + ix)];
  return column.empty ? nullptr : &column;
}

std::optional<ObjectShape::Slice> ObjectShape::slice(int side, double at_m, double half_width_m, double above_m) const {
  // A line of columns runs along the slice; only those within its width are looked at, from both ends.
  const int lines = side == 0 ? ny_ : nx_, length = side == 0 ? nx_ : ny_;
  const double half_column = half_[side] / length;
  std::optional<Slice> slice;
  for (int line = 0; line < lines; ++line) {
    if (std::abs(center_m(1 - side, line) - at_m) > half_width_m) continue;
    const auto high = [&](int i) {
      const Column& column = columns_[static_cast<std::size_t>(side == 0 ? line * nx_ + i : i * nx_ + line)];
      return !column.empty && column.top_m >= above_m;
    };
    int first = 0, last = length - 1;
    while (first <= last && !high(first)) ++first;
    while (last > first && !high(last)) --last;
    if (first > last) continue;
    const double min_m = center_m(side, first) - half_column, max_m = center_m(side, last) + half_column;
    slice = slice ? Slice{std::min(slice->min_m, min_m), std::max(slice->max_m, max_m)} : Slice{min_m, max_m};
  }
  return slice;
}

std::vector<ObjectShape::Edge> ObjectShape::edges(double inset_m, double half_width_m, double thickest_m,
                                                  double air_m) const {
  constexpr int directions = 16;
  const double farthest_m = half_.head<2>().norm();
  std::vector<Edge> found;
  for (int i = 0; i < directions; ++i) {
    Edge edge;
    edge.direction = full_turn * i / directions;
    const Vec3 out(std::cos(edge.direction), std::sin(edge.direction), 0), aside(-out.y(), out.x(), 0);
    for (double r = 0; r < farthest_m; r += column_m / 2)
      if (at(r * out.x(), r * out.y())) edge.radius_m = r;
    // Over the length and width of a finger the edge must be thin, with air below.
    edge.bottom_m = half_.z();
    edge.top_m = -half_.z();
    bool whole = edge.radius_m > inset_m;
    for (double in = column_m; in <= inset_m && whole; in += column_m) {
      for (const double beside : {-half_width_m, 0.0, half_width_m}) {
        const Vec3 p = (edge.radius_m - in) * out + beside * aside;
        const Column* column = at(p.x(), p.y());
        if (!column) {
          whole = beside != 0 && in < inset_m / 2;  // round edges end earlier there
          continue;
        }
        edge.bottom_m = std::min(edge.bottom_m, column->bottom_m);
        edge.top_m = std::max(edge.top_m, column->top_m);
      }
    }
    if (whole && edge.top_m - edge.bottom_m <= thickest_m && edge.bottom_m + half_.z() >= air_m) found.push_back(edge);
  }
  return found;
}

bool ObjectShape::is_round() const {
  constexpr int directions = 16;
  constexpr double as_round = 0.1;  // a regular octagon is
  const double radius_m = std::max(half_.x(), half_.y()), margin_m = as_round * radius_m + column_m;
  for (int i = 0; i < directions; ++i) {
    const double angle = full_turn * i / directions;
    double reach_m = 0;
    for (double r = 0; r < half_.head<2>().norm(); r += column_m / 2)
      if (at(r * std::cos(angle), r * std::sin(angle))) reach_m = r;
    if (std::abs(reach_m - radius_m) > margin_m) return false;
  }
  return true;
}

}  // namespace continua
