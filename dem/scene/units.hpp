// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers with units, such as "9.81 m/s^2", turned to SI.
#pragma once

#include "dem/base/unit.hpp"

#include <string>
#include <string_view>

namespace scene {

using dem::Unit;
using namespace dem::unit;

// The value in SI of a number followed by a product of units: m mm cm km um nm s ms us ns min h kg g mg t N kN MN Pa
// mPa kPa MPa GPa J mJ Hz rad deg %, also with the sign of micro, powers with ^, one '/' before each divisor. Throws
// Error saying what is wrong, also if the unit measures something else than `wanted`.
double in_si(std::string_view text, Unit wanted);

// "length", "m s^-2" ...: for messages.
std::string describe(Unit unit);

}  // namespace scene
