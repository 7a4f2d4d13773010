// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How cells are laid: never too many, rows never too narrow for the search, all of space covered.
#include "src/space/level_cells.hpp"
#include "tests/unit/checks.hpp"

#include <cmath>
#include <limits>

namespace {

using namespace hgtest;
using hg::FixedPoint;
using hg::LevelCells;

struct Layout {
  FixedPoint map;
  int dimension = 3;
  double cell_size = 0;
  size_t particles = 1;
};

void require_layout(const Layout &in) {
  const LevelCells laid = hg::lay_cells(in.map, in.dimension, in.cell_size, in.particles);
  const hg::CellTable &table = laid.table;
  double cells = 1, rows = 1;
  for (int axis = 0; axis < 3; axis++) {
    require(table.count[axis] >= 1 && table.count[axis] <= 1 << 18, "count[%d] = %d", axis, table.count[axis]);
    cells *= table.count[axis];
    if (axis > 0) rows *= table.count[axis];
    const double width = static_cast<double>(table.width[axis]), extent = axis < in.dimension ? in.map.extent[axis] : 0;
    const double slack = 1 + 0x1p-20;  // widths are floats
    require(width * table.count[axis] * slack >= extent, "axis %d: %d cells of %g do not cover %g", axis,
            table.count[axis], width, extent);
    require(std::fabs(static_cast<double>(table.inverse_width[axis]) * width - 1) < 0x1p-22 || std::isinf(width),
            "inverse of width %g is %g", width, static_cast<double>(table.inverse_width[axis]));
    if (axis >= in.dimension) require(table.count[axis] == 1, "%d layers in z of a plane", table.count[axis]);
    // A search visits next rows only: a row must hold the reach and what rounding adds at both ends.
    const double least = axis == 0 ? 4096 : in.cell_size + 2.0 * static_cast<double>(hg::kSearchSlack);
    if (axis < in.dimension) require(width * slack >= least, "axis %d: width %g is below %g", axis, width, least);
  }
  require(static_cast<double>(laid.cells) == cells && static_cast<double>(laid.rows) == rows,
          "%zu cells in %zu rows instead of %g in %g", laid.cells, laid.rows, cells, rows);
  require(cells <= hg::kCellsPerParticle * static_cast<double>(in.particles) + hg::kFewCells,
          "%g cells for %zu particles", cells, in.particles);
}

Layout any_layout(Rng &rng) {
  Layout in;
  in.dimension = rng.integer(2, 3);
  const int widest = rng.integer(0, in.dimension - 1);
  for (int axis = 0; axis < in.dimension; axis++) {
    in.map.extent[axis] = axis == widest ? rng.uniform(0x1p29, 0x1p30) : std::pow(2, rng.uniform(-5, 30));
    if (axis != widest && rng.chance(0.3)) in.map.extent[axis] = 0;
  }
  in.cell_size = rng.chance(0.1) ? 0 : std::pow(2, rng.uniform(-40, 32));
  in.particles = 1 + static_cast<size_t>(std::pow(2, rng.uniform(0, 27)));
  return in;
}

void check_any(uint64_t seed) {
  Rng rng(seed);
  require_layout(any_layout(rng));
}

// A table that is too large by less than the most stretch keeps its row width; a larger one keeps the stretch.
void check_stretch(uint64_t) {
  Layout in;
  in.map.extent[0] = in.map.extent[1] = in.map.extent[2] = 0x1p30;
  in.cell_size = 0x1p22;  // 256 cells along an edge, 128^2 * 512 cells in all
  const double cells = 128.0 * 128 * 512, row = hg::kRowWidth * in.cell_size, cell = hg::kCellLength * in.cell_size;
  for (double excess : {0.5, 1.0, 3.0, 7.9, 64.0}) {
    in.particles = static_cast<size_t>(cells / excess / hg::kCellsPerParticle);
    const LevelCells laid = hg::lay_cells(in.map, 3, in.cell_size, in.particles);
    const double wide = static_cast<double>(laid.table.width[1]) / row;
    const double longer = static_cast<double>(laid.table.width[0]) / cell;
    require(laid.widened == (excess > 1), "excess %g: widened %d", excess, laid.widened);
    require(excess > 8 || (wide == 1 && longer < excess * 1.1 + 0.6), "excess %g: rows %g, cells %g", excess, wide,
            longer);
    require(excess <= 8 || (wide > 1.9 && wide < 2.3 && longer > 15 && longer < 18), "excess %g: rows %g, cells %g",
            excess, wide, longer);
  }
}

void stretch(void **) { assert_true(holds(0, check_stretch)); }

void any_layouts(void **) { assert_true(sweep(20000, check_any)); }

void check_degenerate(uint64_t) {
  for (double extent : {0.0, 0.5, 1.0, 4095.0, 4096.0, 0x1p30}) {
    for (double cell_size : {0.0, 1e-300, 1.0, 0x1p30, 1e30, 1e300, std::numeric_limits<double>::infinity()}) {
      for (size_t particles : {size_t{1}, size_t{1000}, size_t{2147483647}}) {
        Layout in;
        in.map.extent[0] = in.map.extent[1] = in.map.extent[2] = extent;
        in.cell_size = cell_size;
        in.particles = particles;
        require_layout(in);
      }
    }
  }
}

void degenerate(void **) { assert_true(holds(0, check_degenerate)); }

// Where memory allows the widths asked for, they are given, but for dividing the extent evenly.
void check_widths(uint64_t) {
  Layout in;
  for (double &e : in.map.extent) e = 0x1p30;
  in.cell_size = 0x1p24;
  in.particles = 1000000;
  const LevelCells laid = hg::lay_cells(in.map, 3, in.cell_size, in.particles);
  require(!laid.widened, "widened without need");
  for (int axis = 0; axis < 3; axis++) {
    const double wanted = in.cell_size * (axis == 0 ? hg::kCellLength : hg::kRowWidth);
    const double width = static_cast<double>(laid.table.width[axis]);
    require(width >= wanted * (1 - 1e-6) && width < wanted * 1.05, "axis %d: width %g, wanted %g", axis, width, wanted);
  }
  in.particles = 1000;
  require(hg::lay_cells(in.map, 3, in.cell_size, in.particles).widened, "2^18 cells for 1000 particles");
}

void widths(void **) { assert_true(holds(0, check_widths)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(stretch), cmocka_unit_test(any_layouts), cmocka_unit_test(degenerate),
                              cmocka_unit_test(widths)};
  return cmocka_run_group_tests_name("level_cells", tests, nullptr, nullptr);
}
