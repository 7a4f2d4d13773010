// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles that come and go between two steps.
#include "dem/engine/simulation.hpp"
#include "dem/setup/space_order.hpp"

#include <utility>

namespace dem {

// Forces of the present positions come first: who goes pushes its neighbours once more, who comes touches nobody yet.
// So contacts remember each step once, whether somebody has looked at the state or not.
template <int D, class Real>
void Simulation<D, Real>::exchange() {
  find_forces();
  const std::vector<Newcomer<D>> newcomers = exchange_.coming(since_beginning(), steps_, bodies_, search_, surfaces_);
  std::vector<uint32_t> staying = exchange_.staying(bodies_);
  if (newcomers.empty() && staying.size() == bodies_.count()) return;
  replace(std::move(staying), newcomers);
}

template <int D, class Real>
void Simulation<D, Real>::replace(std::vector<uint32_t> staying, const std::vector<Newcomer<D>> &newcomers) {
  constexpr uint64_t kShare = 4;  // of newcomers, from which on neighbours in space are brought together in memory
  unsorted_ += newcomers.size();
  if (unsorted_ > staying.size() / kShare) {
    std::vector<double> centers;
    for (const uint32_t i : staying) {
      for (int axis = 0; axis < D; axis++) centers.push_back(static_cast<double>(bodies_.position(i)[axis]));
    }
    std::vector<uint32_t> sorted = space_order(centers, D);
    for (uint32_t &place : sorted) place = staying[place];
    staying.swap(sorted);
    unsorted_ = newcomers.size();
  }
  std::vector<uint32_t> numbers(bodies_.count(), kGone);
  for (size_t k = 0; k < staying.size(); k++) numbers[staying[k]] = static_cast<uint32_t>(k);
  keep_contacts(numbers);
  std::vector<uint32_t> places;
  for (const uint32_t place : places_) {
    if (numbers[place] != kGone) places.push_back(numbers[place]);
  }
  places_.swap(places);
  if (staying.empty()) {
    bodies_ = {};
    bodies_.resize(newcomers.size(), setup_.effects);
  } else {
    bodies_ = bodies_.reordered(staying, newcomers.size());
  }
  const auto behind = static_cast<Real>(lag());
  const AccelerationKernel<D, Real> acceleration = find_acceleration<D, Real>(setup_.effects);
  for (const Newcomer<D> &one : newcomers) {
    const size_t i = places_.size();
    bodies_.position(i) = one.center.template cast<Real>();
    bodies_.velocity(i) = one.velocity.template cast<Real>();
    bodies_.radius(i) = static_cast<Real>(one.radius);
    bodies_.inverse_mass(i) = static_cast<Real>(1 / one.mass);
    if (!bodies_.materials.empty()) bodies_.materials[i] = one.material;
    bodies_.velocity(i) -= behind * acceleration(bodies_, body_force_, i);
    places_.push_back(static_cast<uint32_t>(i));
  }
  radii_new_ = true;
  room_.forget();
}

// Of those who stay, under their new numbers.
template <int D, class Real>
void Simulation<D, Real>::keep_contacts(const std::vector<uint32_t> &numbers) {
  pair_history_.begin(renumbered_pairs(pair_history_.memory_of(pairs_), numbers));
  wall_history_.begin(renumbered_walls(wall_history_.memory_of(walls()), numbers));
  if (!surfaces_.empty())
    surface_history_.begin(renumbered_walls(surface_history_.memory_of(surfaces_.pairs()), numbers));
}

#define DEM_INSTANTIATE(D, Real)                                                                       \
  template void Simulation<D, Real>::exchange();                                                       \
  template void Simulation<D, Real>::replace(std::vector<uint32_t>, const std::vector<Newcomer<D>> &); \
  template void Simulation<D, Real>::keep_contacts(const std::vector<uint32_t> &);

DEM_INSTANTIATE(2, double)
DEM_INSTANTIATE(3, double)
DEM_INSTANTIATE(2, float)
DEM_INSTANTIATE(3, float)

}  // namespace dem
