// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Averages over the box.
#include "dem/engine/bulk.hpp"

#include <cmath>

namespace dem {
namespace {

double volume_of(const Setup &setup) {
  double volume = 1;
  for (int axis = 0; axis < setup.dimension; axis++) {
    const double length = setup.box_max[axis] - setup.box_min[axis];
    volume *= length > 0 ? length : 1;
  }
  return volume;
}

// The symmetric part, as xx, yy, zz, xy, xz, yz.
template <int D, class Tensor>
void store(const Tensor &tensor, double (&components)[6]) {
  constexpr int kAxes[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < 6; k++) {
    const auto [i, j] = kAxes[k];
    components[k] = i < D && j < D ? (tensor(i, j) + tensor(j, i)) / 2 : 0;
  }
}

template <int D>
class Flow {
 public:
  Flow(const Setup &setup, const Snapshot &state) : setup_(&setup), state_(&state) {
    double mass = 0;
    for (size_t i = 0; i < state.count(); i++) {
      if (!std::isfinite(state.masses[i])) continue;
      mass += state.masses[i];
      mean_ += state.masses[i] * vector_at<Vec<D, double>>(state.velocities, i);
    }
    if (mass > 0) mean_ /= mass;
    if (has(setup.effects, kShear)) mean_.setZero();
  }

  // The velocity of particle i against the flow.
  Vec<D, double> against(size_t i) const {
    Vec<D, double> velocity = vector_at<Vec<D, double>>(state_->velocities, i) - mean_;
    if (has(setup_->effects, kShear)) {
      const double middle = (setup_->box_min[1] + setup_->box_max[1]) / 2;
      velocity[0] -= setup_->shear_rate * (state_->centers[i * D + 1] - middle);
    }
    return velocity;
  }

 private:
  const Setup *setup_;
  const Snapshot *state_;
  Vec<D, double> mean_ = Vec<D, double>::Zero();
};

// Of each particle among those that are not left out.
std::vector<int> contact_counts(const std::vector<TouchingPair> &touching, const std::vector<bool> &left_out) {
  std::vector<int> counts(left_out.size(), 0);
  for (const TouchingPair &pair : touching) {
    const bool wall = pair.b == TouchingPair::kWall;
    if (left_out[pair.a] || (!wall && left_out[pair.b])) continue;
    counts[pair.a]++;
    if (!wall) counts[pair.b]++;
  }
  return counts;
}

void count_contacts(int fewest, const Snapshot &state, const std::vector<TouchingPair> &touching, Bulk &bulk) {
  std::vector<bool> left_out(state.count(), false);
  size_t movable = 0;
  for (const double mass : state.masses) movable += std::isfinite(mass) ? 1 : 0;
  const auto mean = [&](const std::vector<int> &counts, size_t of) {
    double sum = 0;
    for (size_t i = 0; i < counts.size(); i++) sum += std::isfinite(state.masses[i]) ? counts[i] : 0;
    return of > 0 ? sum / static_cast<double>(of) : 0;
  };
  std::vector<int> counts = contact_counts(touching, left_out);
  bulk.coordination = mean(counts, movable);
  for (bool again = true; again;) {
    again = false;
    for (size_t i = 0; i < counts.size(); i++) {
      if (left_out[i] || counts[i] >= fewest || !std::isfinite(state.masses[i])) continue;
      left_out[i] = again = true;
      bulk.rattlers++;
    }
    if (again) counts = contact_counts(touching, left_out);
  }
  bulk.backbone = mean(counts, movable - bulk.rattlers);
}

}  // namespace

template <int D>
void BulkMeasure<D>::add(const ContactLoad<D> &load) {
  const bool wall = load.b == ContactLoad<D>::kWall;
  stress_ -= load.force() * ((load.arm_a + load.arm_b) * load.normal).transpose();
  if (!(load.overlap > 0)) return;
  touching_.push_back({static_cast<uint32_t>(load.a), wall ? TouchingPair::kWall : static_cast<uint32_t>(load.b)});
  if (wall) return;
  fabric_ += load.normal * load.normal.transpose();
  pairs_++;
}

template <int D>
Bulk BulkMeasure<D>::of(const Setup &setup, const Snapshot &state) const {
  Bulk bulk;
  Tensor kinetic = Tensor::Zero();
  double mass = 0;
  const Flow<D> flow(setup, state);
  for (size_t i = 0; i < state.count(); i++) {
    if (!std::isfinite(state.masses[i])) continue;
    const Vec<D, double> velocity = flow.against(i);
    kinetic += state.masses[i] * velocity * velocity.transpose();
    mass += state.masses[i];
  }
  const double volume = volume_of(setup);
  if (mass > 0) bulk.temperature = kinetic.trace() / (D * mass);
  if (pairs_ > 0) store<D>(Tensor(fabric_ / pairs_), bulk.fabric);
  store<D>(Tensor(kinetic / volume), bulk.kinetic_stress);
  store<D>(Tensor((stress_ + kinetic) / volume), bulk.stress);
  bulk.pressure = (stress_ + kinetic).trace() / (D * volume);
  count_contacts(has(setup.effects, kFriction) ? D : D + 1, state, touching_, bulk);
  return bulk;
}

template class BulkMeasure<2>;
template class BulkMeasure<3>;

}  // namespace dem
