// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How near a time step is to the limit of stability of all present contacts together (docs/theory/time-step.md).
#pragma once

#include "dem/engine/contact_loads.hpp"

#include <memory>

namespace dem {

// From 1 on the step may be unstable: dt^2 K + 2 dt C, the matrices of springs and dashpots, reaches 4 M (other
// schemes: as much as they bear). A bound that is exact for pairs of equal particles and close packings of them, and
// above the truth for others.
template <int D>
class StepLoad {
 public:
  virtual ~StepLoad() = default;
  virtual void add(const ContactLoad<D> &contact) = 0;
  virtual double largest() const = 0;  // of the contacts so far
};

// For contacts of a state, which it refers to.
template <int D>
std::unique_ptr<StepLoad<D>> make_step_load(const Setup &setup, const Snapshot &state);

}  // namespace dem
