// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How near a time step is to the limit of stability of all present contacts together.
//
// Kinetic energy makes y = (sqrt(m) u, sqrt(I) angle) the measure of motion. A spring s between bodies a and b stores
// s (f_a y_a - f_b y_b)^2 / 2 <= s ((1 + t) (f_a y_a)^2 + (1 + 1/t) (f_b y_b)^2) / 2 for any t > 0. So each body gets a
// matrix of its own, and the largest eigenvalue of all of them is above any of the network. With t = (m_a / m_b)^(1/3),
// the ratio of sizes, neither a giant with thousands of small neighbours nor these get far too large a share.
#include "dem/engine/step_load.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem {
namespace {

// Eigenvalues of all sizes by one function: compiled for each they take half a minute.
using AnyBlock = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

template <int D, bool turns>
class Network final : public StepLoad<D> {
 public:
  Network(const Setup &setup, const Snapshot &state)
      : setup_(&setup), state_(&state), blocks_(state.count(), Block::Zero()) {}

  void add(const ContactLoad<D> &contact) override {
    const bool wall = contact.b == ContactLoad<D>::kWall;
    const double sizes = wall ? 0 : std::cbrt(state_->masses[contact.a] / state_->masses[contact.b]);
    add_end(contact, contact.a, sizes, contact.normal);
    if (!wall) add_end(contact, contact.b, 1 / sizes, -contact.normal);
  }

  double largest() const override {
    double largest = 0;
    for (const Block &block : blocks_) {
      if (!(block.norm() > largest)) continue;  // no eigenvalue is above that
      largest = std::max(largest, AnyBlock(block).selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff());
    }
    return largest / setup_->scheme.stability;
  }

 private:
  static constexpr int kSpin = turns ? Spin<D, double>::RowsAtCompileTime : 0;
  using Matrix = Eigen::Matrix<double, D, D>;
  using Block = Eigen::Matrix<double, D + kSpin, D + kSpin, Eigen::DontAlign>;

  // The end of a contact at `body`, `out` of which the normal points; `sizes`: that of the body over its partner's.
  void add_end(const ContactLoad<D> &contact, size_t body, double sizes, const Vec<D, double> &out) {
    const double mass = state_->masses[body], step = setup_->time_step;
    if (!std::isfinite(mass)) return;
    const double strength = (step * step * contact.stiffness + 2 * step * contact.damping) * (1 + sizes) / mass;
    const Matrix along = Matrix::Identity() - out * out.transpose();
    Block &block = blocks_[body];
    block.template topLeftCorner<D, D>() += strength * out * out.transpose();
    if constexpr (turns) {
      // A spin moves the surface at n by spin x n, which has the component (n x e) . spin along e.
      Eigen::Matrix<double, D + kSpin, D> slide;
      slide.template topRows<D>() = along;
      for (int k = 0; k < D; k++) {
        slide.template bottomRows<kSpin>().col(k) =
            std::sqrt(inverse_shape(D)) * moment<D, double>(out, Vec<D, double>(along.col(k)));
      }
      block += contact.tangential_ratio * strength * slide * slide.transpose();
      slide.template topRows<D>().setZero();
      const double lever = contact.reduced_radius / state_->radii[body];
      if (has(setup_->effects, kRolling))
        block += contact.rolling_ratio * strength * lever * lever * slide * slide.transpose();
    }
  }

  const Setup *setup_;
  const Snapshot *state_;
  std::vector<Block> blocks_;
};

}  // namespace

template <int D>
std::unique_ptr<StepLoad<D>> make_step_load(const Setup &setup, const Snapshot &state) {
  if (has(setup.effects, kFriction)) return std::make_unique<Network<D, true>>(setup, state);
  return std::make_unique<Network<D, false>>(setup, state);
}

template std::unique_ptr<StepLoad<2>> make_step_load(const Setup &, const Snapshot &);
template std::unique_ptr<StepLoad<3>> make_step_load(const Setup &, const Snapshot &);

}  // namespace dem
