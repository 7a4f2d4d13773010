// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Names of effects and which of them go together.
#include "dem/effects/effects.hpp"

#include "dem/base/error.hpp"

namespace dem {

std::string names_of(EffectSet set) {
  const struct {
    Effect effect;
    const char *name;
  } names[] = {{kDissipation, "dissipation"},
               {kFriction, "friction"},
               {kRolling, "rolling"},
               {kAdhesion, "adhesion"},
               {kHertz, "hertz"},
               {kPeriodic, "periodic"},
               {kShear, "shear"},
               {kWalls, "walls"},
               {kGravity, "gravity"},
               {kDrag, "drag"},
               {kGrowth, "growth"}};
  std::string result;
  for (const auto &[effect, name] : names) {
    if (has(set, effect)) result += (result.empty() ? "" : ", ") + std::string(name);
  }
  return result.empty() ? "none" : result;
}

void require_possible(EffectSet set) {
  if (has(set, kRolling) && !has(set, kFriction)) {
    throw Error("rolling resistance needs friction: without it particles do not rotate");
  }
  if (has(set, kAdhesion) && has(set, kHertz)) {
    throw Error("adhesion is a law of linear contacts: it does not go together with hertz");
  }
  if (has(set, kShear) && !has(set, kPeriodic)) throw Error("shear needs the periodic axes x and y");
}

}  // namespace dem
