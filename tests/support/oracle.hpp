// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The oracle's names as the tests use them.
#pragma once

#include "oracle/pairs.hpp"

namespace hgtest {

using oracle::all_in_sphere;
using oracle::all_pairs;
using oracle::can_meet_twice;
using oracle::double_interact;
using oracle::exact_interact;
using oracle::pair_equal;
using oracle::pair_less;
using oracle::Pairs;
using oracle::relative_gap;
using oracle::Rule;
using oracle::Sphere;
using oracle::swept_pairs;
using Particles = particles::ParticleSet;

}  // namespace hgtest
