// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random particle sets with their grid definitions: size laws, arrangements in space, options of the grid.
#pragma once

#include "particles/particle_set.hpp"
#include "tests/support/rng.hpp"

#include <hgrid/hgrid.h>

#include <string>
#include <vector>

namespace hgtest {

using Particles = particles::ParticleSet;

enum class Sizes { kMono, kTwo, kUniform, kUniformVolume, kSteep, kLogUniform, kSomeZero };
enum class Places {
  kUniform,
  kNegative,
  kClusters,    // tight groups with empty space of 1e12 sizes between them
  kPlummer,     // dense core, thin far halo
  kLine,        // along one axis
  kPlane,       // in 2D as kLine
  kDiagonal,    // all coordinates equal
  kFilaments,   // walks with steps as long as particles are wide
  kDust,        // walks whose steps have no typical length, up to 1e6 sizes
  kFilm,        // near one tilted plane, or line
  kFarPair,     // two groups 1e6 sizes apart
  kScales,      // groups whose particles are all smaller than those of others, down to 1e-6
  kOutlier,     // one particle far from all others
  kOutliers,    // some, at distances up to 1e120 sizes
  kFarOrigin,   // the whole set 1e15 sizes from the origin: coordinates are coarse
  kCoincident,  // few points with many particles each
  kLattice      // equal spheres that exactly touch, or do so up to rounding
};
inline constexpr int kSizesCount = static_cast<int>(Sizes::kSomeZero) + 1;
inline constexpr int kPlacesCount = static_cast<int>(Places::kLattice) + 1;

struct Scene {
  hg_grid_def def;
  std::vector<double> cell_sizes;  // what def.cell_sizes points to
  Particles particles;
  std::string name;

  Scene() : def(hg_default_grid_def()) {}
  Scene(Scene &&) = default;
  Scene &operator=(Scene &&) = default;
  Scene(const Scene &) = delete;
  Scene &operator=(const Scene &) = delete;
};

// One radius; the largest possible is of order `largest`.
double draw_radius(Rng &rng, Sizes sizes, double largest);

// Particles with a few contacts each. The length unit is drawn too.
Particles draw_particles(Rng &rng, int dimension, size_t count, Sizes sizes, Places places);

// A scene on open axes with random threads, margin, interaction and index base.
Scene open_scene(Rng &rng, int dimension, size_t count, Sizes sizes, Places places);

// A scene with the axes of the bit mask periodic; some particles lie many periods outside the box. Particles fill it
// evenly or, in any arrangement, a part of it.
Scene periodic_scene(Rng &rng, int dimension, int axes, size_t count, Sizes sizes);

// A scene whose periodic axes are tilted against each other, wherever two of them are periodic, from not at all to by
// hundreds of lengths; some particles lie on the faces or hundreds of cells away.
Scene tilted_scene(Rng &rng, int dimension, int axes, size_t count, Sizes sizes);

// Periodic axes with two or more.
int draw_tilted_axes(Rng &rng, int dimension);

// HG_ALL_IMAGES in a box that may be shorter than the largest reach, tilted or not.
Scene many_images_scene(Rng &rng, int dimension, int axes, size_t count, Sizes sizes);

// Moves x by so many edges of the periodic cell along each, as far as doubles tell it.
void move_by_cells(const hg_grid_def &def, const double *cells, double *x);

// Any of these, with any level rule.
Scene any_scene(Rng &rng, size_t count);

// Any level rule; USER cells are random but large enough for the scene.
void draw_levels(Rng &rng, Scene &scene);

// The largest distance at which two particles of the scene can interact.
double largest_reach(const hg_grid_def &def, const Particles &particles);

}  // namespace hgtest
