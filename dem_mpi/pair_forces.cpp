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
      rough_kernel_(find_rough_kernel<D, double>(setup.effects)),
      kernel_(find_pair_kernel<D, double>(setup.effects)),
      history_(setup.effects) {
  bodies_.resize(2 * kAtOnce, effects_);
}

template <int D>
void PairForces<D>::list(const hg_pair *pairs, size_t count, const std::vector<int64_t> &names) {
  std::vector<Named> found;
  found.reserve(count);
  for (size_t p = 0; p < count; p++) found.push_back(named(pairs[p], names));
  std::sort(found.begin(), found.end(), [](const Named &x, const Named &y) { return x.key < y.key; });
  rows_.clear();
  names_.clear();
  copies_.clear();
  std::vector<ListPart> parts;
  for (size_t p = 0; p < count; p++) {
    const auto copy = static_cast<int32_t>(2 * (p % kAtOnce));
    rows_.push_back(found[p].rows);
    names_.push_back({static_cast<int32_t>(found[p].key >> 32), static_cast<int32_t>(found[p].key & 0xffffffffu)});
    copies_.push_back({copy, copy + 1});
    if (p % kAtOnce == 0) parts.push_back({p, std::min(count, p + kAtOnce), nullptr});
  }
  history_.unpack(this->names(), parts);
}

template <int D>
void PairForces<D>::copy_bodies(const Bodies<D, double> &bodies, size_t first, size_t last) {
  size_t copy = 0;
  for (size_t p = first; p < last; p++) {
    for (const int32_t row : {rows_[p].a, rows_[p].b}) {
      const auto i = static_cast<size_t>(row);
      bodies_.places[copy] = bodies.places[i];
      bodies_.moves[copy] = {bodies.moves[i].speed, {}};
      if (bodies.rotating()) bodies_.turns[copy] = {bodies.turns[i].speed, {}};
      if (!bodies.materials.empty()) bodies_.materials[copy] = bodies.materials[i];
      copy++;
    }
  }
}

template <int D>
void PairForces<D>::add(const Bodies<D, double> &bodies, const Boundary<D, double> &boundary, double step,
                        PushSums &sums) {
  const ContactTask<D, double> task{&bodies_, &boundary, laws_.all().data(), laws_.width(),
                                    step,     range_,    batch_filler_,      rough_kernel_};
  for (size_t first = 0, part = 0; first < rows_.size(); first += kAtOnce, part++) {
    const size_t last = std::min(rows_.size(), first + kAtOnce);
    copy_bodies(bodies, first, last);
    kernel_(task, {copies_.data(), first, last, 0, 2 * kAtOnce, history_.part(part)});
    for (size_t p = first; p < last; p++) {
      size_t copy = 2 * (p - first);
      for (const int32_t row : {rows_[p].a, rows_[p].b}) {
        sums.add(static_cast<size_t>(row), bodies_.moves[copy], bodies.rotating() ? &bodies_.turns[copy] : nullptr);
        copy++;
      }
    }
  }
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
