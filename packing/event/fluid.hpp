// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What theory says of the pressure of hard spheres (disks) of many sizes in equilibrium.
#pragma once

#include <vector>

namespace packing::event {

// Mean powers of the radii: all that the pressure depends on besides the density.
class Fluid {
 public:
  Fluid(const std::vector<double> &radii, int dimension);

  double mean_radius() const { return mean_[0]; }

  // The compressibility factor Z = p V / (N kT) at the share `density` of the volume (area). Spheres: Boublik 1970 and
  // Mansoori, Carnahan, Starling & Leland 1971, which is Carnahan & Starling's for one size. Disks: scaled particle
  // theory (Lebowitz, Helfand & Praestgaard 1965).
  double compressibility(double density) const;

 private:
  int dimension_;
  double mean_[3]{};  // <r>, <r^2>, <r^3>
};

}  // namespace packing::event
