// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a number measures.
#pragma once

namespace dem {

// Powers of length, time and mass. Angles and pure numbers have none.
struct Unit {
  int length = 0, time = 0, mass = 0;
};
constexpr bool operator==(const Unit &a, const Unit &b) {
  return a.length == b.length && a.time == b.time && a.mass == b.mass;
}

namespace unit {

constexpr Unit kPure{}, kLength{1, 0, 0}, kTime{0, 1, 0}, kMass{0, 0, 1}, kVelocity{1, -1, 0}, kSpin{0, -1, 0},
    kAcceleration{1, -2, 0}, kForce{1, -2, 1}, kStiffness{0, -2, 1}, kPressure{-1, -2, 1}, kEnergy{2, -2, 1},
    kViscosity{-1, -1, 1}, kDensity{-3, 0, 1}, kRate{0, -1, 0};

}  // namespace unit
}  // namespace dem
