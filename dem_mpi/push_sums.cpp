// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The quanta of sums.
#include "dem_mpi/push_sums.hpp"

#include <cmath>

namespace dem::ranks {
namespace {

// The power of two that is not below it.
double power_above(double number) { return std::exp2(std::ceil(std::log2(number))); }

constexpr double kCoarse = 0x1p-32;  // of the force of the deepest contact

}  // namespace

PushSums::PushSums(double force, double arm, bool rotating)
    : rows_(rotating ? 4 : 2),
      inverse_arm_(1 / power_above(arm)),
      most_weight_(0x1p52 * kCoarse * power_above(force)),
      least_weight_(most_weight_ / kMostContacts),
      force_(kCoarse * power_above(force)),
      torque_(kCoarse * power_above(force) / inverse_arm_) {}

}  // namespace dem::ranks
