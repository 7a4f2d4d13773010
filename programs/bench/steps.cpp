// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Steps of one dense system under chosen effects, for counting what they cost: hgrid_steps EFFECTS EDGE STEPS.
//
// EFFECTS are names with commas, or "none". EDGE^3 equal spheres stand on a cubic lattice, pressed together a little,
// so that each touches six others, and swing; a third of them would do for a fluid. It prints the bytes of state per
// particle, the time, and a checksum of the final state. Built twice: with all effects, and with the others left out.
#include "dem/base/error.hpp"
#include "dem/effects/table.hpp"
#include "dem/engine/engine.hpp"
#include "dem/setup/time_step.hpp"
#include "programs/bench/program.hpp"
#include "programs/measure/timing.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace {

struct Options {
  std::string effects;
  int edge = 0;
  uint64_t steps = 0;
};

dem::EffectSet effects_of(const std::string &names) {
  dem::EffectSet effects = 0;
  for (size_t first = 0; first <= names.size();) {
    const size_t end = std::min(names.find(',', first), names.size());
    const std::string name = names.substr(first, end - first);
    const dem::EffectRow *row = dem::effect_of_name(name);
    if (row == nullptr && name != "none") throw dem::Error("no effect is called '" + name + "'");
    if (row != nullptr) effects |= row->effect;
    first = end + 1;
  }
  return effects;
}

void set_numbers(dem::Setup &setup) {
  setup.contact.stiffness = 1e4;
  setup.contact.restitution = 0.9;
  setup.contact.friction = 0.5;
  setup.contact.tangential_stiffness = 2.0 / 7;
  setup.contact.rolling_friction = 0.1;
  setup.contact.rolling_stiffness = 2.0 / 7;
  setup.contact.adhesion_force = 10;
  setup.contact.adhesion_range = 0.01;
  setup.contact.young_modulus = 1e5;
  setup.contact.poisson_ratio = 0.3;
  setup.impact_speed = 10;
  setup.gravity[2] = -1;
  setup.viscosity = 0.01;
  setup.growth_rate = 1e-6;
  setup.shear_rate = 0.01;
}

dem::Setup make_system(dem::EffectSet effects, int edge) {
  constexpr double kSpacing = 1.98;
  dem::Setup setup;
  setup.effects = effects;
  set_numbers(setup);
  for (int k = 0; k < 3; k++) {
    setup.box_max[k] = edge * kSpacing;
    setup.walled[k] = dem::has(effects, dem::kWalls);
    setup.periodic[k] = dem::has(effects, dem::kPeriodic);
  }
  uint64_t state = 1;
  for (int i = 0; i < edge * edge * edge; i++) {
    for (const int n : {i % edge, i / edge % edge, i / (edge * edge)}) {
      setup.centers.push_back((n + 0.5) * kSpacing);
      state = state * 6364136223846793005u + 1442695040888963407u;
      setup.velocities.push_back(static_cast<double>(state >> 40) * 0x1p-24 - 0.5);
    }
    setup.radii.push_back(1);
    setup.masses.push_back(1);
  }
  if (dem::has(effects, dem::kMaterials)) {  // four of the same numbers, mixed
    setup.materials.assign(4, {"m", 1, setup.contact});
    setup.pairs.assign(20, setup.contact);
    for (size_t i = 0; i < setup.count(); i++) setup.material_ids.push_back(static_cast<uint8_t>(i * 7 % 11 % 4));
  }
  setup.time_step = dem::usual_step(setup);
  setup.skin = 0.2;
  return setup;
}

uint64_t checksum(const dem::Snapshot &state) {
  uint64_t sum = 0;
  for (const auto *numbers : {&state.centers, &state.velocities}) {
    for (const double number : *numbers) {
      uint64_t bits = 0;
      std::memcpy(&bits, &number, sizeof bits);
      sum = (sum ^ bits) * 0x100000001b3u;
    }
  }
  return sum;
}

int run(const Options &options) {
  const dem::Setup setup = make_system(effects_of(options.effects), options.edge);
  const auto engine = dem::make_engine(setup);
  engine->run(5);  // memory grows to what it needs
  const double seconds = measure::seconds_of([&] { engine->run(options.steps); });
  const double count = static_cast<double>(setup.count());
  std::printf("%s particles=%zu pairs=%zu bytes=%.1f ns=%.2f state=%016llx\n", options.effects.c_str(), setup.count(),
              engine->pair_count(), static_cast<double>(engine->state_bytes()) / count,
              1e9 * seconds / (count * static_cast<double>(options.steps)),
              static_cast<unsigned long long>(checksum(engine->snapshot())));
  return 0;
}

void add_options(CLI::App &command, Options &options) {
  command.add_option("EFFECTS", options.effects, "Names with commas, or none")->required();
  command.add_option("EDGE", options.edge, "Spheres along an edge")->required()->check(CLI::Range(1, 1000));
  command.add_option("STEPS", options.steps, "Steps that are timed")->required();
}

}  // namespace

int main(int argc, char **argv) {
  return bench::run_program("hgrid_steps", "Time the steps of one dense system under chosen effects", argc, argv,
                            add_options, run);
}
