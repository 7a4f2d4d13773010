// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers with units, such as "9.81 m/s^2", turned to SI.
#pragma once

#include <string>
#include <string_view>

namespace scene {

// Powers of length, time and mass. Angles and pure numbers have none.
struct Unit {
  int length = 0, time = 0, mass = 0;
};
constexpr bool operator==(const Unit &a, const Unit &b) {
  return a.length == b.length && a.time == b.time && a.mass == b.mass;
}

constexpr Unit kPure{}, kLength{1, 0, 0}, kTime{0, 1, 0}, kMass{0, 0, 1}, kVelocity{1, -1, 0}, kSpin{0, -1, 0},
    kAcceleration{1, -2, 0}, kForce{1, -2, 1}, kStiffness{0, -2, 1}, kPressure{-1, -2, 1}, kEnergy{2, -2, 1},
    kViscosity{-1, -1, 1}, kDensity{-3, 0, 1}, kRate{0, -1, 0};

// The value in SI of a number followed by a product of units: m mm cm km um nm s ms us ns min h kg g mg t N kN MN Pa
// mPa kPa MPa GPa J mJ Hz rad deg %, powers with ^, one '/' before each divisor. Throws Error saying what is wrong,
// also if the unit measures something else than `wanted`.
double in_si(std::string_view text, Unit wanted);

// "length", "m s^-2" ...: for messages.
std::string describe(Unit unit);

}  // namespace scene
