// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The curves by mass that powders, soils and aggregates are described by, from radius 1 to the ratio of a law, and
// curves from tables. They hold NaN where nothing lies between their ends.
#pragma once

#include "packing/size_law.hpp"
#include "packing/sizes/curve.hpp"

namespace packing {

SizeCurve fuller_curve(const SizeLaw &law);
SizeCurve rosin_rammler_curve(const SizeLaw &law);
SizeCurve log_normal_mass_curve(const SizeLaw &law);

// The table must be there.
SizeCurve table_curve(const SizeLaw &law);

}  // namespace packing
