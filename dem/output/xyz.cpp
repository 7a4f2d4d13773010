// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Extended XYZ, for OVITO.
#include "dem/output/xyz.hpp"

#include "dem/output/columns.hpp"
#include "particles/text/output.hpp"

#include <cmath>
#include <cstddef>

namespace output {
namespace {

void write_box(particles::Output &out, const dem::Setup &setup) {
  const double *low = setup.box_min, *high = setup.box_max;
  out << "Lattice=\"" << high[0] - low[0] << " 0 0 0 " << high[1] - low[1] << " 0 0 0 "
      << (setup.dimension == 3 ? high[2] - low[2] : 1.0) << "\" ";
  out << "Origin=\"" << low[0] << ' ' << low[1] << ' ' << low[2] << "\" ";
}

void write_columns(particles::Output &out, const std::vector<double> &rows, size_t i) {
  for (size_t k = 0; k < 3; k++) out << ' ' << rows[3 * i + k];
}

}  // namespace

void write_xyz(const std::string &path, const dem::Setup &setup, const dem::Snapshot &state) {
  particles::Output out(path);
  out << state.radii.size() << '\n';
  const bool bounded = setup.box_max[0] > setup.box_min[0];
  if (bounded) write_box(out, setup);
  out << "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:mass:R:1";
  if (!state.spins.empty()) out << ":angular_velocity:R:3";
  out << " Time=" << state.time << " pbc=\"";
  for (int k = 0; k < 3; k++) out << (k > 0 ? " " : "") << (setup.periodic[k] ? 'T' : 'F');
  out << "\"\n";
  const std::vector<double> centers = three_columns(state.centers, state.dimension);
  const std::vector<double> velocities = three_columns(state.velocities, state.dimension);
  const std::vector<double> spins = spin_columns(state);
  for (size_t i = 0; i < state.radii.size(); i++) {
    out << 'X';
    write_columns(out, centers, i);
    out << ' ' << state.radii[i];
    write_columns(out, velocities, i);
    // Readers know no infinity: particles that nothing moves get 0.
    out << ' ' << (std::isfinite(state.masses[i]) ? state.masses[i] : 0.0);
    if (!state.spins.empty()) write_columns(out, spins, i);
    out << '\n';
  }
  out.close();
}

}  // namespace output
