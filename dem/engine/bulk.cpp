// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Averages over the box.
#include "dem/engine/bulk.hpp"

#include <cmath>

namespace dem {
namespace {

template <int D>
using Tensor = Eigen::Matrix<double, D, D>;

double volume_of(const Setup &setup) {
  double volume = 1;
  for (int axis = 0; axis < setup.dimension; axis++) {
    const double length = setup.box_max[axis] - setup.box_min[axis];
    volume *= length > 0 ? length : 1;
  }
  return volume;
}

// The symmetric part, as xx, yy, zz, xy, xz, yz.
template <int D>
void store(const Tensor<D> &tensor, double (&components)[6]) {
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

// Contacts of each particle that can move.
template <int D>
std::vector<int> contact_counts(const Snapshot &state, const std::vector<ContactLoad<D>> &loads,
                                const std::vector<bool> &left_out) {
  std::vector<int> counts(state.count(), 0);
  for (const ContactLoad<D> &load : loads) {
    const bool wall = load.b == ContactLoad<D>::kWall;
    if (!(load.overlap > 0) || left_out[load.a] || (!wall && left_out[load.b])) continue;
    counts[load.a]++;
    if (!wall) counts[load.b]++;
  }
  return counts;
}

template <int D>
void count_contacts(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &loads, Bulk &bulk) {
  const int fewest = has(setup.effects, kFriction) ? D : D + 1;
  std::vector<bool> left_out(state.count(), false);
  size_t movable = 0;
  for (const double mass : state.masses) movable += std::isfinite(mass) ? 1 : 0;
  const auto mean = [&](const std::vector<int> &counts, size_t of) {
    double sum = 0;
    for (size_t i = 0; i < counts.size(); i++) sum += std::isfinite(state.masses[i]) ? counts[i] : 0;
    return of > 0 ? sum / static_cast<double>(of) : 0;
  };
  std::vector<int> counts = contact_counts(state, loads, left_out);
  bulk.coordination = mean(counts, movable);
  for (bool again = true; again;) {
    again = false;
    for (size_t i = 0; i < counts.size(); i++) {
      if (left_out[i] || counts[i] >= fewest || !std::isfinite(state.masses[i])) continue;
      left_out[i] = again = true;
      bulk.rattlers++;
    }
    if (again) counts = contact_counts(state, loads, left_out);
  }
  bulk.backbone = mean(counts, movable - bulk.rattlers);
}

}  // namespace

template <int D>
Bulk measure_bulk(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &loads) {
  Bulk bulk;
  Tensor<D> stress = Tensor<D>::Zero(), kinetic = Tensor<D>::Zero(), fabric = Tensor<D>::Zero();
  double pairs = 0, mass = 0;
  for (const ContactLoad<D> &load : loads) {
    stress -= load.force() * ((load.arm_a + load.arm_b) * load.normal).transpose();
    if (load.b == ContactLoad<D>::kWall || !(load.overlap > 0)) continue;
    fabric += load.normal * load.normal.transpose();
    pairs++;
  }
  const Flow<D> flow(setup, state);
  for (size_t i = 0; i < state.count(); i++) {
    if (!std::isfinite(state.masses[i])) continue;
    const Vec<D, double> velocity = flow.against(i);
    kinetic += state.masses[i] * velocity * velocity.transpose();
    mass += state.masses[i];
  }
  const double volume = volume_of(setup);
  if (mass > 0) bulk.temperature = kinetic.trace() / (D * mass);
  if (pairs > 0) store<D>(fabric / pairs, bulk.fabric);
  store<D>(kinetic / volume, bulk.kinetic_stress);
  store<D>((stress + kinetic) / volume, bulk.stress);
  bulk.pressure = (stress + kinetic).trace() / (D * volume);
  count_contacts<D>(setup, state, loads, bulk);
  return bulk;
}

template Bulk measure_bulk(const Setup &, const Snapshot &, const std::vector<ContactLoad<2>> &);
template Bulk measure_bulk(const Setup &, const Snapshot &, const std::vector<ContactLoad<3>> &);

}  // namespace dem
