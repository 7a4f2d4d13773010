// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of arrangements.
#include "packing/arrangement.hpp"

#include "packing/arrangements/families.hpp"
#include "particles/error.hpp"
#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"

namespace packing {
namespace {

constexpr double kDense = 0.62;  // as in the paper

}  // namespace

const std::vector<Arrangement> &arrangements() {
  static const std::vector<Arrangement> rows = {
      {"even", "in the whole box, pushed apart", kDense, nullptr},
      {"gas", "at random in the whole of a cube", 0.01, lay_gas},
      {"clusters",
       "20 Plummer spheres, n(r) ~ (1 + (r/b)^2)^(-5/2), in a cube of 50 b; the density is that of their middles",
       kDense, lay_clusters},
      {"clumps", "80 % in 50 dense balls, the others thinly in a cube 30 times as long as one that all would fill",
       kDense, lay_clumps},
      {"crowd", "99 % in a cube, the others in one of 100 times its volume around it", kDense, lay_crowd},
      {"filaments", "30 winding tubes, 4 diameters thick, in a cube 30 times as long as one that all would fill",
       kDense, lay_filaments},
      {"film", "a tilted layer, 2 diameters thick", kDense, lay_film},
      {"shell", "a hollow sphere (ring), 2 diameters thick", kDense, lay_shell},
      {"jet", "45 % in a hopper, 10 % in a thinning jet of 200 times its height, the others in the pile below", kDense,
       lay_jet},
      {"far", "two cubes, 1e6 diameters apart", kDense, lay_far},
      {"outliers", "a cube and three particles at 1e15 to 1e200", kDense, lay_outliers},
      {"dust", "a Levy flight, P(step > s) ~ s^(-4/3), up to 1e6", kDense, lay_dust, false},
      {"scales", "groups of 5 at +-10^u on each axis, u even from 0 to 12", kDense, lay_scales},
      {"part", "a cube inside a periodic box, an eighth of it on each axis", kDense, lay_part},
      {"part-across", "the same across the corner of the box", kDense, lay_part_across},
  };
  return rows;
}

std::string usual_densities() {
  std::string result = particles::text(kDense);
  for (const Arrangement &row : arrangements()) {
    if (row.density != kDense) result += std::string("; ") + row.name + ": " + particles::text(row.density);
  }
  return result;
}

const Arrangement &arrangement_called(const std::string &name) {
  for (const Arrangement &row : arrangements()) {
    if (row.name == name) return row;
  }
  throw particles::Error("no arrangement is called '" + name + "': use one of " +
                         particles::joined(particles::names_of(arrangements())));
}

}  // namespace packing
