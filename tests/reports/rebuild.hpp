// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What reports are rebuilt from: crystals, clouds, periodic boxes, atoms in other images, floats.
#pragma once

#include "tests/reports/report.hpp"
#include "tests/support/rng.hpp"

namespace hgtest {

// Points that meet within `cutoff`; in two dimensions the third numbers are ignored.
System within(double cutoff, std::vector<Point> centers, std::optional<size_t> pairs = {});

// Axes of a length above 0 are periodic, from 0 to it.
System periodic(System system, const Point &lengths);

// Its periodic edges b and c lean by xy, xz, yz.
System tilted(System system, const Point &tilts);

// Each image in reach is a pair.
System all_images(System system);

// The edges (lx, 0, 0), (xy, ly, 0), (xz, yz, lz) of a crystal's cell.
struct Edges {
  Point lengths;
  Point tilts = {0, 0, 0};
};

// A cell of atoms repeated along its edges, all axes periodic. The pairs are counted from the neighbours of one cell in
// endless space, so no distance may be near the cut-off, and without all images no vector of the whole shorter than
// twice that.
System crystal(double cutoff, const Edges &cell, const std::vector<Point> &atoms, const std::array<int, 3> &repeats);
std::vector<Point> fcc(double edge);
std::vector<Point> diamond(double edge);

// The cells of one atom of fcc and bcc lattices whose cubes have this edge.
Edges primitive_fcc(double edge);
Edges primitive_bcc(double edge);

// Evenly distributed in [low, high).
std::vector<Point> cloud(uint64_t seed, size_t count, const Point &low, const Point &high);

// Every atom moved by whole edges of the box, up to so many, on the periodic axes: the sums are rounded.
System in_other_images(System system, uint64_t seed, int boxes);

// Every coordinate rounded to a float.
System in_floats(System system);

// Every coordinate moved.
System moved(System system, const Point &by);

System named(std::string name, System system);

// Of a step of a life: equal spheres.
Particles spheres(const std::vector<Point> &centers, double radius);

}  // namespace hgtest
