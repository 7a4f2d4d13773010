// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Forces of the box's walls on the particles that reach them.
#include "dem/effects/choice.hpp"
#include "dem/kernels/contact_kernel.hpp"
#include "dem/kernels/wall_contact.hpp"

namespace dem {
namespace {

// The force of wall contact p; false if it is none now.
template <EffectSet E, int D, class Real>
bool wall_force(const ContactTask<D, Real> &task, const PairRun<D, Real> &run, size_t p) {
  Bodies<D, Real> &bodies = *task.bodies;
  const int32_t wall = run.pairs[p].b;
  const auto i = static_cast<size_t>(run.pairs[p].a);
  Contact<D, Real> contact;
  contact.overlap = wall_overlap(*task.boundary, bodies.position(i)[axis_of(wall)], bodies.radius(i), wall);
  if (!(contact.overlap > -task.range)) return false;
  contact.normal = Vec<D, Real>::Zero();
  contact.normal[axis_of(wall)] = is_upper(wall) ? Real(1) : Real(-1);
  const Real arm = bodies.radius(i) - contact.overlap;
  describe_with_wall<E>(bodies, i, arm, contact);
  const auto &law = law_with<E>(task, i, [&] { return task.boundary->materials[wall]; });
  add_wall_force<E>(bodies, i, arm, contact_force<E>(law, contact, run.history, task.step, p));
  return true;
}

template <EffectSet E, int D, class Real>
size_t wall_forces(const ContactTask<D, Real> &task, const PairRun<D, Real> &run) {
  size_t found = 0;
  if constexpr (has(E, effects_with_history())) run.history->begin_pass();
  for (size_t p = run.first_pair; p < run.last_pair; p++) found += wall_force<E>(task, run, p) ? 1 : 0;
  return found;
}

}  // namespace

template <int D, class Real>
ContactKernel<D, Real> find_wall_kernel(EffectSet effects) {
  return choose<kContactEffects, Real>(effects, [](auto set) { return &wall_forces<decltype(set)::value, D, Real>; });
}

template ContactKernel<2, double> find_wall_kernel(EffectSet);
template ContactKernel<3, double> find_wall_kernel(EffectSet);
template ContactKernel<2, float> find_wall_kernel(EffectSet);
template ContactKernel<3, float> find_wall_kernel(EffectSet);

}  // namespace dem
