// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Forces of walls beside those of the box on the particles that reach them.
#include "dem/kernels/surface_kernel.hpp"

#include "dem/effects/choice.hpp"
#include "dem/kernels/contact_kernel.hpp"
#include "dem/kernels/wall_contact.hpp"

#include <cstddef>
#include <utility>

namespace dem {
namespace {

// Where a particle goes on from one triangle of a mesh to the next, what the contact remembers goes along: it is taken
// from a triangle that is still touched but has ceased to count.
template <int D>
void follow_over_edges(const Surfaces<D> &surfaces, const std::vector<SurfaceTouch<D>> &touches,
                       History<D, double> &history) {
  const PairView list = surfaces.pairs();
  const auto wall_of = [&](size_t place) { return surfaces.surfaces()[static_cast<size_t>(list[place].b)].wall; };
  const auto was_there = [&](size_t place) { return history.was_there(history.row(kFriction, place)); };
  for (const SurfaceTouch<D> &now : touches) {
    if (!now.counts || was_there(now.place)) continue;
    for (const SurfaceTouch<D> &former : touches) {
      if (former.counts || !was_there(former.place) || wall_of(former.place) != wall_of(now.place)) continue;
      for (auto &rows : history.rows) {
        if (!rows.empty()) std::swap(rows[now.place - history.first], rows[former.place - history.first]);
      }
      break;
    }
  }
}

template <EffectSet E, int D>
void touch_force(const SurfaceTask<D> &task, const SurfaceTouch<D> &touch, History<D, double> *history) {
  Bodies<D, double> &bodies = *task.bodies;
  const hg_pair &pair = task.surfaces->pairs()[touch.place];
  const auto i = static_cast<size_t>(pair.a);
  const Surface<D> &surface = task.surfaces->surfaces()[static_cast<size_t>(pair.b)];
  const WallPose<D> &pose = task.surfaces->pose_of(surface);
  const double arm = touch.nearest.distance;
  const Vec<D, double> point = bodies.position(i) + arm * touch.nearest.normal;
  Contact<D, double> contact;
  contact.overlap = bodies.radius(i) - touch.nearest.distance;
  contact.normal = touch.nearest.normal;
  describe_with_wall<E>(bodies, i, arm, contact);
  if constexpr (has(E, kNeedVelocity)) contact.velocity -= pose.velocity_at(point);
  if constexpr (has(E, kRolling)) contact.spin -= pose.spin;
  const auto &law = law_with<E>(task, i, [&] { return surface.material; });
  const ContactForce<D, double> on_body = contact_force<E>(law, contact, history, task.step, touch.place);
  add_wall_force<E>(bodies, i, arm, on_body);
  SurfacePush<D> &push = task.surfaces->pushes()[touch.place];
  push.force = on_body.force;
  push.torque = moment<D, double>(Vec<D, double>(point - pose.pivot), on_body.force);
  if constexpr (has(E, kRolling)) push.torque += on_body.rolling;
}

template <EffectSet E, int D>
void surface_forces(const SurfaceTask<D> &task, size_t first, size_t last, History<D, double> *history) {
  const Bodies<D, double> &bodies = *task.bodies;
  const PairView list = task.surfaces->pairs();
  std::vector<SurfaceTouch<D>> touches;
  if constexpr (has(E, effects_with_history())) history->begin_pass();
  while (first < last) {
    const auto i = static_cast<size_t>(list[first].a);
    size_t end = first + 1;
    while (end < last && list[end].a == list[first].a) end++;
    find_touches<D>(task.surfaces->surfaces(), list.data(), first, end, bodies.position(i), bodies.radius(i),
                    task.range, touches);
    if constexpr (has(E, effects_with_history())) follow_over_edges<D>(*task.surfaces, touches, *history);
    for (const SurfaceTouch<D> &touch : touches) {
      if (touch.counts) touch_force<E, D>(task, touch, history);
    }
    first = end;
  }
}

}  // namespace

template <int D>
SurfaceKernel<D> find_surface_kernel(EffectSet effects) {
  return choose<kContactEffects, double>(effects, [](auto set) { return &surface_forces<decltype(set)::value, D>; });
}

template SurfaceKernel<2> find_surface_kernel(EffectSet);
template SurfaceKernel<3> find_surface_kernel(EffectSet);

}  // namespace dem
