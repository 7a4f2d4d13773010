// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The forces of the pairs that this rank has found.
#include "dem_mpi/pair_forces.hpp"

#include "dem/effects/choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dem::ranks {
namespace {

// A pair by its name, for sorting.
struct Named {
  uint64_t key;
  hg_pair rows;
};

Named named(hg_pair pair, const std::vector<int64_t> &names) {
  auto a = static_cast<uint64_t>(names[static_cast<size_t>(pair.a)]);
  auto b = static_cast<uint64_t>(names[static_cast<size_t>(pair.b)]);
  if (a > b) {
    std::swap(a, b);
    std::swap(pair.a, pair.b);
  }
  return {a << 32 | b, pair};
}

// Inlined whatever the compiler thinks: to gcc 12 a call that only fetches has no effect, and is left out.
[[gnu::always_inline]] inline void fetch([[maybe_unused]] const void *place) {
#ifdef __GNUC__
  __builtin_prefetch(place, 1);
#endif
}

template <EffectSet E>
double spring_at(const ContactLaw<double> &law, const NormalContact<double> &contact) {
  return normal_force<E>(law, contact).spring;
}

}  // namespace

template <int D>
PairForces<D>::PairForces(const Setup &setup)
    : effects_(setup.effects),
      range_(contact_range(setup)),
      laws_(setup, Partner::kParticle),
      batch_filler_(find_batch_filler<D, double>(setup.effects)),
      rough_kernels_(find_rough_kernels<D, double>(setup.effects)),
      kernel_(find_pair_kernel<D, double>(setup.effects)),
      history_(setup.effects) {
  bodies_.resize(2 * kAtOnce, effects_);
  for (size_t k = 0; k < kAtOnce; k++)
    copies_.push_back({static_cast<int32_t>(2 * k), static_cast<int32_t>(2 * k + 1)});
}

template <int D>
void PairForces<D>::list(const hg_pair *pairs, size_t count, const std::vector<int64_t> &names) {
  std::vector<Named> found;
  found.reserve(count);
  for (size_t p = 0; p < count; p++) found.push_back(named(pairs[p], names));
  std::sort(found.begin(), found.end(), [](const Named &x, const Named &y) { return x.key < y.key; });
  rows_.clear();
  names_.clear();
  for (const Named &pair : found) {
    rows_.push_back(pair.rows);
    names_.push_back({static_cast<int32_t>(pair.key >> 32), static_cast<int32_t>(pair.key & 0xffffffffu)});
  }
  history_.unpack(this->names(), {{0, count, nullptr}});
}

// Second particles lie far apart in memory, and are asked for in time.
template <int D>
size_t PairForces<D>::later_row(size_t k) const {
  constexpr size_t kAhead = 8;
  return static_cast<size_t>(rows_[touching_.place[std::min(k + kAhead, touching_.count - 1)]].b);
}

template <int D>
void PairForces<D>::copy_bodies(const Bodies<D, double> &bodies) {
  size_t copy = 0;
  for (size_t k = 0; k < touching_.count; k++) {
    const size_t later = later_row(k);
    fetch(&bodies.moves[later]);
    if (bodies.rotating()) fetch(&bodies.turns[later]);
    const hg_pair &pair = rows_[touching_.place[k]];
    for (const int32_t row : {pair.a, pair.b}) {
      const auto i = static_cast<size_t>(row);
      bodies_.places[copy] = bodies.places[i];
      bodies_.moves[copy] = {bodies.moves[i].speed, {}};
      if (bodies.rotating()) bodies_.turns[copy] = {bodies.turns[i].speed, {}};
      if (!bodies.materials.empty()) bodies_.materials[copy] = bodies.materials[i];
      copy++;
    }
  }
}

// The kernel numbers the contacts that it is given from 0 on; what they remember stands at their places in the list.
template <int D>
void PairForces<D>::add_contacts(const Boundary<D, double> &boundary, double step) {
  History<D, double> &known = *history_.part(0);
  const auto for_memories = [&](auto visit) {
    for (size_t row = 0; row < kHistoryCount; row++) {
      if (known.rows[row].empty()) continue;
      remembered_.rows[row].resize(kAtOnce);
      for (size_t k = 0; k < touching_.count; k++) visit(remembered_.rows[row][k], known.rows[row][touching_.place[k]]);
    }
  };
  for_memories([](auto &copy, const auto &memory) { copy = memory; });
  remembered_.pass = known.pass;
  const ContactTask<D, double> task{&bodies_, &boundary, laws_.all().data(), laws_.width(),
                                    step,     range_,    batch_filler_,      rough_kernels_};
  kernel_(task, {copies_.data(), 0, touching_.count, 0, bodies_.count(), &remembered_});
  for_memories([](const auto &copy, auto &memory) { memory = copy; });
}

template <int D>
void PairForces<D>::add(const Bodies<D, double> &bodies, const Boundary<D, double> &boundary, double step,
                        PushSums &sums) {
  const BatchTask<D, double> source{bodies.places.data(), &boundary, rows_.data(), range_};
  for (size_t first = 0; first < rows_.size(); first += kAtOnce) {
    batch_filler_(source, first, std::min(rows_.size(), first + kAtOnce), touching_);
    copy_bodies(bodies);
    add_contacts(boundary, step);
    for (size_t k = 0; k < touching_.count; k++) {
      const double *later = sums.of(later_row(k));
      fetch(later);
      fetch(later + sums.columns() - 1);
      const hg_pair &pair = rows_[touching_.place[k]];
      size_t copy = 2 * k;
      for (const int32_t row : {pair.a, pair.b}) {
        sums.add(static_cast<size_t>(row), bodies_.moves[copy], bodies.rotating() ? &bodies_.turns[copy] : nullptr);
        copy++;
      }
    }
  }
  history_.part(0)->begin_pass();
}

double deepest_force(const Setup &setup) {
  constexpr EffectSet kNormalEffects = kContactEffects & ~effects_with_history();
  const auto spring =
      choose<kNormalEffects, double>(setup.effects, [](auto set) { return &spring_at<decltype(set)::value>; });
  const double radius = *std::max_element(setup.radii.begin(), setup.radii.end());
  const NormalContact<double> contact{radius, 0, 0, 2 / radius, 2 / radius};
  double largest = 0;
  const LawTable<double> laws(setup, Partner::kParticle);
  for (const ContactLaw<double> &law : laws.all()) {
    const double force = spring(law, contact) + law.adhesion_force;
    if (std::isfinite(force)) largest = std::max(largest, force);
  }
  return largest;
}

template class PairForces<2>;
template class PairForces<3>;

}  // namespace dem::ranks
