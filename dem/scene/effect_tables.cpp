// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The tables of a scene that switch effects on, and the contact law.
#include "dem/scene/effect_tables.hpp"

#include "dem/base/error.hpp"

#include <algorithm>

namespace scene {
namespace {

constexpr double kUsualStiffnessRatio = 2.0 / 7;  // tangential and normal springs of a sphere then swing alike

void require(const Table &table, const char *key, bool fulfilled, const char *range) {
  if (!fulfilled) table.fail(key, std::string("lies ") + range + ", not at " + dem::text(table.number(key)));
}

void read_hertz(const Table &table, dem::Setup &setup) {
  dem::ContactParameters &contact = setup.contact;
  contact.young_modulus = table.number("young_modulus");
  require(table, "young_modulus", contact.young_modulus > 0, "above 0");
  contact.poisson_ratio = table.number("poisson_ratio");
  require(table, "poisson_ratio", contact.poisson_ratio > -1 && contact.poisson_ratio <= 0.5, "in (-1, 0.5]");
  contact.wall_young_modulus = table.number("wall_young_modulus", 0);
  contact.wall_poisson_ratio = table.number("wall_poisson_ratio", 0);
  setup.impact_speed = table.number("impact_speed", 0);
  setup.effects |= dem::kHertz;
}

void read_normal_law(const Table &top, dem::Setup &setup) {
  const auto hertz = top.part("hertz"), contact = top.part("contact");
  if (hertz && contact) top.fail("hertz", "stands instead of [contact]");
  if (!hertz && !contact) top.fail("contact", "a scene needs [contact] or [hertz]");
  if (hertz) {
    read_hertz(*hertz, setup);
  } else {
    setup.contact.stiffness = contact->number("stiffness");
    require(*contact, "stiffness", setup.contact.stiffness > 0, "above 0");
  }
  if (const auto table = top.part("dissipation")) {
    setup.contact.restitution = table->number("restitution");
    require(*table, "restitution", setup.contact.restitution > 0 && setup.contact.restitution <= 1, "in (0, 1]");
    setup.effects |= dem::kDissipation;
  }
  if (const auto table = top.part("adhesion")) {
    if (hertz) top.fail("adhesion", "is a law of linear contacts: it does not go together with [hertz]");
    setup.contact.adhesion_force = table->number("force");
    require(*table, "force", setup.contact.adhesion_force >= 0, "at 0 or above");
    setup.contact.adhesion_range = table->number("range");
    require(*table, "range", setup.contact.adhesion_range > 0, "above 0");
    setup.effects |= dem::kAdhesion;
  }
}

void read_tangential_law(const Table &top, dem::Setup &setup) {
  if (const auto table = top.part("friction")) {
    setup.contact.friction = table->number("coefficient");
    require(*table, "coefficient", setup.contact.friction >= 0, "at 0 or above");
    setup.contact.tangential_stiffness = table->number("stiffness", kUsualStiffnessRatio);
    require(*table, "stiffness", setup.contact.tangential_stiffness > 0, "above 0");
    setup.effects |= dem::kFriction;
  }
  if (const auto table = top.part("rolling")) {
    if (!has(setup.effects, dem::kFriction)) {
      top.fail("rolling", "needs [friction]: without it particles do not rotate");
    }
    setup.contact.rolling_friction = table->number("coefficient");
    require(*table, "coefficient", setup.contact.rolling_friction >= 0, "at 0 or above");
    setup.contact.rolling_stiffness = table->number("stiffness", kUsualStiffnessRatio);
    require(*table, "stiffness", setup.contact.rolling_stiffness > 0, "above 0");
    setup.effects |= dem::kRolling;
  }
}

void read_surroundings(const Table &top, dem::Setup &setup) {
  if (const auto table = top.part("gravity")) {
    const std::vector<double> g = table->vector("acceleration", static_cast<size_t>(setup.dimension));
    std::copy(g.begin(), g.end(), setup.gravity);
    setup.effects |= dem::kGravity;
  }
  if (const auto table = top.part("drag")) {
    setup.viscosity = table->number("viscosity");
    require(*table, "viscosity", setup.viscosity >= 0, "at 0 or above");
    setup.effects |= dem::kDrag;
  }
  if (const auto table = top.part("growth")) {
    setup.growth_rate = table->number("rate");
    require(*table, "rate", setup.growth_rate >= 0, "at 0 or above");
    setup.growth_end = table->number("end", setup.growth_end);
    setup.effects |= dem::kGrowth;
  }
  if (const auto table = top.part("periodic")) {
    table->axes("axes", setup.dimension, setup.periodic);
    if (!setup.periodic[0] && !setup.periodic[1] && !setup.periodic[2]) table->fail("axes", "names no axis");
    setup.effects |= dem::kPeriodic;
  }
  if (const auto table = top.part("shear")) {
    if (!setup.periodic[0] || !setup.periodic[1]) top.fail("shear", "needs the periodic axes x and y");
    setup.shear_rate = table->number("rate");
    setup.effects |= dem::kShear;
  }
}

}  // namespace

void read_effects(const Table &top, dem::Setup &setup) {
  read_normal_law(top, setup);
  read_tangential_law(top, setup);
  read_surroundings(top, setup);
}

void add_shear_profile(dem::Setup &setup) {
  if (!has(setup.effects, dem::kShear)) return;
  const auto dimension = static_cast<size_t>(setup.dimension);
  const double middle = (setup.box_min[1] + setup.box_max[1]) / 2;
  for (size_t i = 0; i < setup.count(); i++) {
    setup.velocities[i * dimension] += setup.shear_rate * (setup.centers[i * dimension + 1] - middle);
  }
}

}  // namespace scene
