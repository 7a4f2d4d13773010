// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A user's C++ program: the version of the library and the two contacts among three spheres.
#include <hgrid/hgrid.hpp>

#include <iostream>

int main() try {
  const double centers[] = {0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 3.0, 0.0, 0.0};
  const double radii[] = {1.0, 0.8, 0.9};
  hg_grid_def def = hg_default_grid_def();
  def.pair_order = HG_ORDER_ID;
  hgrid::Grid grid(def);
  grid.insert(3, centers, radii);
  int major = 0, minor = 0, patch = 0;
  hg_version(&major, &minor, &patch);
  std::cout << "hgrid " << major << '.' << minor << '.' << patch << '\n';
  for (const hg_pair pair : grid.query_pairs()) std::cout << pair.a << ' ' << pair.b << '\n';
  return 0;
} catch (const hgrid::Error &error) {
  std::cerr << error.what() << '\n';
  return 1;
}
