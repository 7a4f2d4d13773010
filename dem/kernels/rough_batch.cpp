// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Friction and rolling of many contacts side by side. One source, compiled for each width of vectors; no operation is
// fused, so that all of them give the same bits. Rows move whole: numbers put together from parts would wait for each
// other.
#include "dem/kernels/rough_batch.hpp"

#include "dem/base/vectors.hpp"
#include "dem/effects/rubbing.hpp"

namespace dem {
namespace {

#ifdef __clang__
#define DEM_SIDE_BY_SIDE _Pragma("clang loop vectorize(assume_safety)")
#else
#define DEM_SIDE_BY_SIDE _Pragma("GCC ivdep")
#endif

// What contacts remember, by their places in the list.
template <Effect effect, int D, class Real>
[[gnu::always_inline]] inline Row<Real> *remembered(const RoughTask<D, Real> &task) {
  return task.history->rows[history_of(effect)].data() - task.history->first;
}

template <bool rolling>
struct Gather {
  template <int D, class Real>
  [[gnu::always_inline]] static void run(const RoughTask<D, Real> &task, RoughBatch<Real> &batch) {
    const Row<Real> *places = task.bodies->places.data();
    const Course<Real> *moves = task.bodies->moves.data(), *turns = task.bodies->turns.data();
    const ContactBatch<Real> &contacts = *task.contacts;
    const History<D, Real> &history = *task.history;
    const Row<Real> *slips = remembered<kFriction>(task);
    [[maybe_unused]] const Row<Real> *rolls = remembered<kRolling>(task);
    for (size_t k = 0; k < task.count; k++) {
      const size_t p = task.first + k, place = contacts.place[p];
      const size_t later_place = place_ahead(contacts, p, task.first + task.count);
      const hg_pair &later = task.pairs[later_place];
      __builtin_prefetch(&slips[later_place], 1);
      if constexpr (rolling) __builtin_prefetch(&rolls[later_place], 1);
      __builtin_prefetch(&moves[later.b], 1);
      __builtin_prefetch(&turns[later.b], 1);
      const auto a = static_cast<size_t>(task.pairs[place].a), b = static_cast<size_t>(task.pairs[place].b);
      const Real half = (contacts.touching[p] - contacts.distance[p]) / 2;
      batch.arm[0][k] = places[a].numbers[3] - half;
      batch.arm[1][k] = places[b].numbers[3] - half;
      batch.velocity[k].four() = moves[a].speed.four() - moves[b].speed.four();
      batch.turning[k].four() = batch.arm[0][k] * turns[a].speed.four() + batch.arm[1][k] * turns[b].speed.four();
      batch.friction.stretch[k] = history.was_there(slips[place]) ? slips[place] : Row<Real>{};
      if constexpr (rolling) {
        batch.spin[k].four() = turns[a].speed.four() - turns[b].speed.four();
        batch.rolling.stretch[k] = history.was_there(rolls[place]) ? rolls[place] : Row<Real>{};
      }
    }
  }
};

template <bool rolling>
struct Rub {
  template <int D, class Real>
  [[gnu::always_inline]] static void run(const RoughTask<D, Real> &task, RoughBatch<Real> &batch) {
    rub_all<D>(task, batch);
    if constexpr (rolling) roll_all<D>(task, batch);
    spread<D>(task, batch);
  }

 private:
  template <int D, class Real>
  [[gnu::always_inline]] static void rub_all(const RoughTask<D, Real> &task, RoughBatch<Real> &batch) {
    const auto &normal = task.contacts->normal;
    const size_t count = task.count, first = task.first;
    const Real step = task.step;
    auto &sliders = batch.friction;
    DEM_SIDE_BY_SIDE
    for (size_t p = 0; p < count; p++) {
      Real unit[D], velocity[3], turning[3], stretch[3], force[3] = {0, 0, 0}, moment[3] = {0, 0, 0};
      for (int k = 0; k < D; k++) unit[k] = normal[k][first + p];
      for (int k = 0; k < 3; k++) velocity[k] = batch.velocity[p].numbers[k];
      for (int k = 0; k < 3; k++) turning[k] = batch.turning[p].numbers[k];
      for (int k = 0; k < 3; k++) stretch[k] = sliders.stretch[p].numbers[k];
      const Slider<Real> slider{sliders.stiffness[p], sliders.damping[p], sliders.limit[p]};
      rub<D>(slider, unit, velocity, turning, step, stretch, force, moment);
      for (int k = 0; k < D; k++) force[k] -= batch.pressing[p] * unit[k];
      for (int k = 0; k < 3; k++) sliders.left[k][p] = stretch[k];
      for (int k = 0; k < 3; k++) batch.force[k][p] = force[k];
      for (int k = 0; k < 3; k++) batch.moment[k][p] = moment[k];
    }
  }

  template <int D, class Real>
  [[gnu::always_inline]] static void roll_all(const RoughTask<D, Real> &task, RoughBatch<Real> &batch) {
    const auto &normal = task.contacts->normal;
    const size_t count = task.count, first = task.first;
    const Real step = task.step;
    auto &sliders = batch.rolling;
    DEM_SIDE_BY_SIDE
    for (size_t p = 0; p < count; p++) {
      Real unit[D], spin[3], stretch[3], torque[3] = {0, 0, 0};
      for (int k = 0; k < D; k++) unit[k] = normal[k][first + p];
      for (int k = 0; k < 3; k++) spin[k] = batch.spin[p].numbers[k];
      for (int k = 0; k < 3; k++) stretch[k] = sliders.stretch[p].numbers[k];
      const Slider<Real> slider{sliders.stiffness[p], sliders.damping[p], sliders.limit[p]};
      roll<D>(slider, unit, spin, batch.radius[p], step, stretch, torque);
      for (int k = 0; k < 3; k++) sliders.left[k][p] = stretch[k];
      for (int k = 0; k < 3; k++) batch.torque[k][p] = torque[k];
    }
  }

  // Written out: rows that a function returns go through memory.
  template <int D, class Real>
  [[gnu::always_inline]] static void spread(const RoughTask<D, Real> &task, const RoughBatch<Real> &batch) {
    using Four = typename Row<Real>::Four;
    Course<Real> *moves = task.bodies->moves.data(), *turns = task.bodies->turns.data();
    Row<Real> *slips = remembered<kFriction>(task);
    [[maybe_unused]] Row<Real> *rolls = remembered<kRolling>(task);
    const Real pass = task.history->pass;
    const auto &f = batch.force, &m = batch.moment, &t = batch.torque, &slip = batch.friction.left,
               &roll = batch.rolling.left;
    for (size_t k = 0; k < task.count; k++) {
      const size_t place = task.contacts->place[task.first + k];
      const auto a = static_cast<size_t>(task.pairs[place].a), b = static_cast<size_t>(task.pairs[place].b);
      slips[place].four() = Four{slip[0][k], slip[1][k], slip[2][k], pass};
      const Four force{f[0][k], f[1][k], f[2][k], 0}, moment{m[0][k], m[1][k], m[2][k], 0};
      Four torque_a = batch.arm[0][k] * moment, torque_b = batch.arm[1][k] * moment;
      if constexpr (rolling) {
        rolls[place].four() = Four{roll[0][k], roll[1][k], roll[2][k], pass};
        const Four torque{t[0][k], t[1][k], t[2][k], 0};
        torque_a += torque;
        torque_b -= torque;
      }
      if (a >= task.first_body) {
        moves[a].push.four() += force;
        turns[a].push.four() += torque_a;
      }
      if (b < task.last_body) {
        moves[b].push.four() -= force;
        turns[b].push.four() += torque_b;
      }
    }
  }
};

template <class Part, int D, class Real>
[[gnu::flatten]] void plain(const RoughTask<D, Real> &task, RoughBatch<Real> &batch) {
  Part::run(task, batch);
}

#ifdef DEM_HAS_VECTORS
template <class Part, int D, class Real>
[[gnu::flatten]] DEM_AVX2 void by_four(const RoughTask<D, Real> &task, RoughBatch<Real> &batch) {
  Part::run(task, batch);
}
template <class Part, int D, class Real>
[[gnu::flatten]] DEM_AVX512 void by_eight(const RoughTask<D, Real> &task, RoughBatch<Real> &batch) {
  Part::run(task, batch);
}
#endif

template <class Part, int D, class Real>
typename RoughKernels<D, Real>::Kernel widest() {
#ifdef DEM_HAS_VECTORS
  if (usable_vectors() == Vectors::kAvx512) return &by_eight<Part, D, Real>;
  if (usable_vectors() == Vectors::kAvx2) return &by_four<Part, D, Real>;
#endif
  return &plain<Part, D, Real>;
}

template <bool rolling, int D, class Real>
RoughKernels<D, Real> kernels() {
  return {widest<Gather<rolling>, D, Real>(), widest<Rub<rolling>, D, Real>()};
}

}  // namespace

template <int D, class Real>
RoughKernels<D, Real> find_rough_kernels(EffectSet effects) {
  return has(effects, kRolling) ? kernels<true, D, Real>() : kernels<false, D, Real>();
}

template RoughKernels<2, double> find_rough_kernels(EffectSet);
template RoughKernels<3, double> find_rough_kernels(EffectSet);
template RoughKernels<2, float> find_rough_kernels(EffectSet);
template RoughKernels<3, float> find_rough_kernels(EffectSet);

}  // namespace dem
