// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How well an elastic gas keeps its energy.
#pragma once

#include "dem/engine/engine.hpp"
#include "programs/accuracy/simulation/elastic_gas.hpp"
#include "programs/accuracy/simulation/power_law.hpp"

namespace accuracy {

struct EnergyCase {
  GasCase gas;
  dem::Scheme scheme = dem::velocity_verlet();
  double steps = 50;  // per contact of the lightest two
  dem::Precision precision = dem::Precision::kDouble;
  double contacts_per_span = 25;  // time between two looks, in t_c
  int spans = 80;
};

// Relative to the energy at the start.
struct EnergyErrors {
  double change = 0;   // rms over the spans
  double largest = 0;  // at the end of any span
};

EnergyErrors energy_errors(const EnergyCase &what);

// The rms change that kinetic theory and the laws of single collisions predict for a gas with a mass spread, to leading
// order.
PowerLaw energy_change_law(const EnergyCase &what);

}  // namespace accuracy
