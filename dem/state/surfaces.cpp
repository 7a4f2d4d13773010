// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The walls beside those of the box.
#include "dem/state/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dem {
namespace {

template <int D>
Vec<D, double> vector_of(const double (&numbers)[3]) {
  return Eigen::Map<const Vec<D, double>>(numbers);
}

template <int D>
Eigen::Matrix<double, D, D> turn_by(const WallBody &wall, double angle) {
  if constexpr (D == 2) {
    return Eigen::Rotation2Dd(angle).toRotationMatrix();
  } else {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d(wall.axis[0], wall.axis[1], wall.axis[2])).toRotationMatrix();
  }
}

template <int D>
Spin<D, double> spin_about(const WallBody &wall, double speed) {
  if constexpr (D == 2) {
    return Spin<D, double>(speed);
  } else {
    return speed * vector_of<3>(wall.axis);
  }
}

// The part of a torque that turns the wall about its axis.
template <int D>
double along_axis(const WallBody &wall, const Spin<D, double> &torque) {
  if constexpr (D == 2) {
    return torque[0];
  } else {
    return vector_of<3>(wall.axis).dot(torque);
  }
}

template <int D>
void add_surfaces(const Setup &setup, int32_t number, std::vector<Surface<D>> &surfaces) {
  const WallBody &wall = setup.walls[static_cast<size_t>(number)];
  Surface<D> surface;
  surface.wall = number;
  surface.material = static_cast<uint8_t>(wall.material < 0 ? static_cast<int>(setup.materials.size()) : wall.material);
  surface.shape = wall.shape;
  surface.radius = wall.radius;
  surface.third = Vec<D, double>::Zero();
  if (wall.shape != WallShape::kMesh) {
    surface.first = vector_of<D>(wall.point);
    surface.second = vector_of<D>(wall.normal);
    surfaces.push_back(surface);
    return;
  }
  const size_t triangles = wall.corners.size() / 9;
  for (size_t k = 0; k < triangles && D == 3; k++) {
    surface.first = vector_at<Vec<D, double>>(wall.corners, 3 * k);
    surface.second = vector_at<Vec<D, double>>(wall.corners, 3 * k + 1);
    surface.third = vector_at<Vec<D, double>>(wall.corners, 3 * k + 2);
    surfaces.push_back(surface);
  }
}

double reach_of(const WallBody &wall) {
  double farthest = 0;
  for (size_t k = 0; k + 2 < wall.corners.size(); k += 3) {
    double square = 0;
    for (size_t axis = 0; axis < 3; axis++) square += std::pow(wall.corners[k + axis] - wall.pivot[axis], 2);
    farthest = std::max(farthest, square);
  }
  return std::sqrt(farthest);
}

}  // namespace

template <int D>
WallPose<D> pose_of(const WallBody &wall, const WallPlace &place) {
  WallPose<D> pose;
  pose.turn = turn_by<D>(wall, place.angle);
  pose.origin = vector_of<D>(wall.pivot);
  pose.pivot = pose.origin + vector_of<D>(place.shift);
  return pose;
}

template <int D>
Surfaces<D>::Surfaces(const Setup &setup) : walls_(setup.walls), states_(walls_.size()), poses_(walls_.size()) {
  for (size_t k = 0; k < walls_.size(); k++) {
    add_surfaces<D>(setup, static_cast<int32_t>(k), resting_);
    reach_.push_back(reach_of(walls_[k]));
    states_[k].press_speed = walls_[k].start.press_speed;
  }
  surfaces_ = resting_;
  move_to(0);
}

template <int D>
WallPlace Surfaces<D>::place_of(size_t k) const {
  const WallBody &wall = walls_[k];
  WallPlace place = wall.start;
  const double swing = std::sin(2 * kPi * wall.frequency * time_);
  for (size_t axis = 0; axis < D; axis++) {
    place.shift[axis] +=
        wall.velocity[axis] * time_ + wall.swing[axis] * swing + wall.normal[axis] * states_[k].pressed;
  }
  place.angle += wall.turning * time_;
  place.press_speed = states_[k].press_speed;
  return place;
}

template <int D>
void Surfaces<D>::move_to(double time) {
  time_ = time;
  for (size_t k = 0; k < walls_.size(); k++) {
    const WallBody &wall = walls_[k];
    WallPose<D> &pose = poses_[k];
    pose = dem::pose_of<D>(wall, place_of(k));
    const double rate = 2 * kPi * wall.frequency;
    pose.velocity = vector_of<D>(wall.velocity) + rate * std::cos(rate * time) * vector_of<D>(wall.swing) +
                    states_[k].press_speed * vector_of<D>(wall.normal);
    pose.spin = spin_about<D>(wall, wall.turning);
  }
  for (size_t s = 0; s < surfaces_.size(); s++) {
    const Surface<D> &resting = resting_[s];
    const WallPose<D> &pose = pose_of(resting);
    const bool is_mesh = resting.shape == WallShape::kMesh;
    surfaces_[s].first = pose.place(resting.first);
    surfaces_[s].second = is_mesh ? pose.place(resting.second) : pose.direction(resting.second);
    if (is_mesh) surfaces_[s].third = pose.place(resting.third);
  }
}

// Planes turn about their normal and cylinders about their axis, which leaves them where they are.
template <int D>
double Surfaces<D>::way_between(size_t k, const WallPlace &from, const WallPlace &to) const {
  const Vec<D, double> shift = vector_of<D>(to.shift) - vector_of<D>(from.shift),
                       normal = vector_of<D>(walls_[k].normal);
  if (walls_[k].shape == WallShape::kPlane) return std::fabs(normal.dot(shift));
  if (walls_[k].shape == WallShape::kCylinder) return shift.norm();
  return shift.norm() + std::fabs(to.angle - from.angle) * reach_[k];
}

template <int D>
bool Surfaces<D>::hold(double way) const {
  if (listed_at_.empty()) return false;
  for (size_t k = 0; k < walls_.size(); k++) {
    if (!(way_between(k, listed_at_[k], place_of(k)) <= way)) return false;
  }
  return true;
}

template <int D>
template <class Real>
void Surfaces<D>::list(const Bodies<D, Real> &bodies, ContactSearch &search, double range, double way) {
  listed_at_.clear();
  for (size_t k = 0; k < walls_.size(); k++) listed_at_.push_back(place_of(k));
  list_.clear();
  std::vector<double> corners;
  std::vector<int32_t> triangles;  // their surfaces
  for (size_t s = 0; s < surfaces_.size(); s++) {
    const auto surface = static_cast<int32_t>(s);
    if (surfaces_[s].shape == WallShape::kMesh) {
      triangles.push_back(surface);
      for (const Vec<D, double> *corner : {&surfaces_[s].first, &surfaces_[s].second, &surfaces_[s].third}) {
        corners.insert(corners.end(), corner->data(), corner->data() + D);
      }
      continue;
    }
    for (size_t i = 0; i < bodies.count(); i++) {
      const Vec<D, double> x = bodies.position(i).template cast<double>();
      const double reach = static_cast<double>(bodies.radius(i)) + range + 2 * way;
      if (nearest_point<D>(surfaces_[s], x).distance < reach) list_.push_back({static_cast<int32_t>(i), surface});
    }
  }
  if (!triangles.empty()) {
    const hgrid::Rows rows = search.near_triangles(corners);
    for (size_t t = 0; t < triangles.size(); t++) {
      for (const int32_t i : rows[t]) list_.push_back({i, triangles[t]});
    }
  }
  std::sort(list_.begin(), list_.end(),
            [](const hg_pair &x, const hg_pair &y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  pushes_.assign(list_.size(), {});
}

// The mean of the forces at both ends, times the way between them.
template <int D>
void Surfaces<D>::sum_up() {
  std::vector<SurfacePush<D>> sums(walls_.size());
  for (size_t p = 0; p < list_.size(); p++) {
    SurfacePush<D> &sum = sums[static_cast<size_t>(surfaces_[static_cast<size_t>(list_[p].b)].wall)];
    sum.force += pushes_[p].force;
    sum.torque += pushes_[p].torque;
  }
  for (size_t k = 0; k < walls_.size(); k++) {
    State &state = states_[k];
    const WallPlace place = place_of(k);
    const double torque = along_axis<D>(walls_[k], sums[k].torque);
    if (state.known != 0) {
      for (int axis = 0; axis < D; axis++) {
        state.work += 0.5 * (state.push[axis] + sums[k].force[axis]) * (place.shift[axis] - state.shift[axis]);
      }
      state.work += 0.5 * (state.torque + torque) * (place.angle - state.angle);
    }
    std::copy_n(sums[k].force.data(), D, state.push);
    state.torque = torque;
    std::copy_n(place.shift, 3, state.shift);
    state.angle = place.angle;
    state.known = 1;
  }
}

template <int D>
void Surfaces<D>::press(double step) {
  for (size_t k = 0; k < walls_.size(); k++) {
    if (!walls_[k].presses()) continue;
    const double borne = vector_of<D>(states_[k].push).dot(vector_of<D>(walls_[k].normal));
    states_[k].press_speed = walls_[k].fastest * std::clamp(1 - borne / walls_[k].force, -1.0, 1.0);
    states_[k].pressed += states_[k].press_speed * step;
  }
}

template <int D>
std::vector<NamedPlace> Surfaces<D>::named_places() const {
  std::vector<NamedPlace> places;
  for (size_t k = 0, first = 0; k < walls_.size(); k++) {
    const auto is_own = [k](const Surface<D> &surface) { return static_cast<size_t>(surface.wall) == k; };
    const auto count = static_cast<size_t>(std::count_if(resting_.begin(), resting_.end(), is_own));
    places.push_back({walls_[k].name, place_of(k), first, count});
    first += count;
  }
  return places;
}

template <int D>
ContactMemory Surfaces<D>::taken_over(const Beginning &beginning) const {
  ContactMemory result;
  const std::vector<NamedPlace> here = named_places();
  for (size_t p = 0; p < beginning.surfaces.pairs.size(); p++) {
    hg_pair pair = beginning.surfaces.pairs[p];
    const auto surface = static_cast<size_t>(pair.b);
    for (const NamedPlace &former : beginning.wall_places) {
      if (surface < former.first_surface || surface >= former.first_surface + former.surface_count) continue;
      for (const NamedPlace &wall : here) {
        if (wall.name != former.name || wall.surface_count != former.surface_count) continue;
        pair.b = static_cast<int32_t>(surface - former.first_surface + wall.first_surface);
        result.pairs.push_back(pair);
        for (size_t k = 0; k < kHistoryCount; k++) {
          const std::vector<double> &rows = beginning.surfaces.rows[k];
          if (!rows.empty()) result.rows[k].insert(result.rows[k].end(), &rows[p * D], &rows[p * D] + D);
        }
      }
    }
  }
  return result;
}

template <int D>
std::vector<WallReport> Surfaces<D>::reports() const {
  std::vector<WallReport> result;
  for (size_t k = 0; k < walls_.size(); k++) {
    const State &state = states_[k];
    WallReport report{walls_[k].name, place_of(k), {}, state.torque, state.work};
    std::copy_n(state.push, 3, report.push);
    result.push_back(report);
  }
  return result;
}

template <int D>
double Surfaces<D>::work() const {
  double sum = 0;
  for (const State &state : states_) sum += state.work;
  return sum;
}

template <int D>
size_t Surfaces<D>::bytes() const {
  return sizeof(Surface<D>) * (resting_.capacity() + surfaces_.capacity()) + sizeof(hg_pair) * list_.capacity() +
         sizeof(SurfacePush<D>) * pushes_.capacity();
}

template <int D>
void Surfaces<D>::save(Checkpoint &checkpoint) const {
  if (!empty()) checkpoint.put("walls", states_);
}

template <int D>
void Surfaces<D>::restore(const Checkpoint &checkpoint) {
  if (!empty()) checkpoint.get("walls", states_);
}

template WallPose<3> pose_of(const WallBody &, const WallPlace &);
template class Surfaces<2>;
template class Surfaces<3>;
template void Surfaces<2>::list(const Bodies<2, double> &, ContactSearch &, double, double);
template void Surfaces<3>::list(const Bodies<3, double> &, ContactSearch &, double, double);

}  // namespace dem
