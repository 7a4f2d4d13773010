// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random scenes.
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace hgtest {
namespace {

constexpr const char *kSizesNames[] = {"mono", "two", "uniform", "uniform-volume", "steep", "log-uniform", "some-zero"};
constexpr const char *kPlacesNames[] = {"uniform",  "negative",  "clusters",   "plummer",    "line",     "plane",
                                        "diagonal", "filaments", "dust",       "film",       "far-pair", "scales",
                                        "outlier",  "outliers",  "far-origin", "coincident", "lattice"};
static_assert(sizeof kSizesNames / sizeof *kSizesNames == kSizesCount, "a name for each size law");
static_assert(sizeof kPlacesNames / sizeof *kPlacesNames == kPlacesCount, "a name for each arrangement");

struct Point {
  double x[3] = {0, 0, 0};
};

Point in_cube(Rng &rng, double edge) {
  Point p;
  for (double &x : p.x) x = rng.uniform(0, edge);
  return p;
}

Point plummer(Rng &rng, double core) {
  const double u = rng.uniform(1e-6, 0.999);
  const double radius = core / std::sqrt(std::pow(u, -2.0 / 3.0) - 1);
  const double z = rng.uniform(-1, 1);
  const double phi = rng.uniform(0, 6.283185307179586);
  const double w = std::sqrt(1 - z * z);
  return {{radius * w * std::cos(phi), radius * w * std::sin(phi), radius * z}};
}

// The next place of a walk, now and then anywhere in the cube.
Point step_from(Rng &rng, const Point &last, double length, double edge) {
  if (rng.chance(0.02)) return in_cube(rng, edge);
  Point p = last;
  for (double &x : p.x) x += length * rng.uniform(-1, 1);
  return p;
}

// What places are drawn in.
struct Ground {
  int dimension;
  double edge;  // of the cube that would hold the particles closely; groups share it between them
  double unit;  // as long as the largest particles
  std::vector<Point> groups;
  Point last;  // of a walk
};

Point draw_place(Rng &rng, Places places, const Ground &ground) {
  const double edge = ground.edge;
  Point p = in_cube(rng, edge);
  const Point &group = ground.groups[rng.below(ground.groups.size())];
  const int thin = ground.dimension - 1;
  switch (places) {
    case Places::kFilaments:
      p = step_from(rng, ground.last, ground.unit, 4 * edge);
      break;
    case Places::kDust:
      p = step_from(rng, ground.last, ground.unit / (1e-6 + rng.uniform()), edge);
      break;
    case Places::kFilm:
      p.x[thin] = 0.3 * p.x[0] + (thin == 2 ? 0.2 * p.x[1] : 0) + 1e-3 * p.x[thin];
      for (double &x : p.x) x *= 2;
      break;
    case Places::kFarPair:
      if (rng.chance(0.5)) p = {{p.x[0] + 1e6 * edge, p.x[1] - 1e6 * edge, p.x[2]}};
      break;
    case Places::kNegative:
      for (double &x : p.x) x -= 2 * edge;
      break;
    case Places::kClusters:
    case Places::kFarOrigin:
      for (int k = 0; k < 3; k++) p.x[k] = group.x[k] + 0.6 * p.x[k];
      break;
    case Places::kPlummer:
      p = plummer(rng, 0.5 * edge);
      break;
    case Places::kLine:
      p.x[0] *= 8;
      p.x[1] = p.x[2] = 0.25 * edge;
      break;
    case Places::kPlane:
      p.x[0] *= 2;
      p.x[1] = 0.25 * edge;
      break;
    case Places::kDiagonal:
      p.x[1] = p.x[2] = p.x[0];
      break;
    case Places::kCoincident:
      p = group;
      break;
    case Places::kUniform:
    case Places::kScales:
    case Places::kOutlier:
    case Places::kOutliers:
    case Places::kLattice:
      break;
  }
  return p;
}

std::vector<Point> draw_groups(Rng &rng, Places places, double edge) {
  std::vector<Point> groups(1);
  if (places == Places::kClusters) {
    groups.resize(4);
    for (Point &g : groups) {
      for (double &x : g.x) x = rng.uniform(-1e12, 1e12) * edge;
    }
  } else if (places == Places::kFarOrigin) {
    for (double &x : groups[0].x) x = (rng.chance(0.5) ? 1e15 : -1e15) * edge * rng.uniform(0.01, 1);
  } else if (places == Places::kCoincident) {
    groups.resize(12);
    for (Point &g : groups) g = in_cube(rng, 2 * edge);
  }
  return groups;
}

// Each part of the particles to a part of the cube, with their radii, so small that they stay as dense as they are.
void shrink_groups(Rng &rng, Particles &particles, double edge) {
  const auto dimension = static_cast<size_t>(particles.dimension);
  for (size_t i = 0; i < particles.count();) {
    const size_t end = std::min(particles.count(), i + 1 + static_cast<size_t>(rng.below(80)));
    const double share = std::pow(10, rng.uniform(-6, 0));
    const Point corner = in_cube(rng, edge);
    for (; i < end; i++) {
      particles.radii[i] *= share;
      for (size_t k = 0; k < dimension; k++) {
        double &x = particles.centers[i * dimension + k];
        x = corner.x[k] + 0.5 * share * x;
      }
    }
  }
}

Particles lattice(Rng &rng, int dimension, size_t count, double unit) {
  Particles particles;
  particles.dimension = dimension;
  const double spacing = unit * (rng.chance(0.5) ? 1.0 : 0.1);  // 0.1 is not dyadic: touching up to rounding
  const int side = std::max(1, static_cast<int>(std::ceil(std::pow(static_cast<double>(count), 1.0 / dimension))));
  for (size_t i = 0; i < count; i++) {
    const int at = static_cast<int>(i);
    const int c[3] = {at % side - side / 2, at / side % side - side / 2, at / side / side - side / 2};
    const double center[3] = {c[0] * spacing, c[1] * spacing, c[2] * spacing};
    particles.add(center, 0.5 * spacing);
  }
  return particles;
}

void draw_options(Rng &rng, Scene &scene) {
  hg_grid_def &def = scene.def;
  def.dimension = scene.particles.dimension;
  def.thread_count = rng.integer(1, 2);
  def.index_base = rng.integer(0, 1);
  def.interaction = rng.chance(0.7) ? HG_CONTACT : HG_MAX_RANGE;
  const double largest =
      scene.particles.count() == 0 ? 1 : *std::max_element(scene.particles.radii.begin(), scene.particles.radii.end());
  if (rng.chance(0.4)) def.margin = rng.uniform(0, 0.2) * largest;
  def.touching = rng.chance(0.2) ? 1 : 0;
}

// Periodic axes of the mask: near the origin or far from it, of like lengths or one a million times the others, as long
// as the particles need or longer.
void draw_box(Rng &rng, Scene &scene, int axes) {
  const int dimension = scene.particles.dimension;
  const double shortest = 2.000001 * largest_reach(scene.def, scene.particles) + 1e-300;
  std::vector<double> &centers = scene.particles.centers;
  double edge = centers.empty() ? 1 : 0;
  for (const double x : centers) edge = std::max(edge, std::fabs(x));
  const double shift = rng.chance(0.3) ? std::pow(10, rng.uniform(3, 9)) * edge : 0;
  const int long_axis = rng.chance(0.2) ? rng.integer(0, dimension - 1) : -1;
  const double empty = rng.chance(0.3) ? std::pow(10, rng.uniform(0, 5)) : 1;
  for (int k = 0; k < dimension; k++) {
    if ((axes >> k & 1) == 0) continue;
    const double length = std::max(rng.uniform(0.8, 1.2) * edge, shortest) * empty * (k == long_axis ? 1e6 : 1);
    scene.def.periodic[k] = 1;
    scene.def.box_min[k] = rng.uniform(-2, 2) * edge + shift;
    scene.def.box_max[k] = scene.def.box_min[k] + length;
  }
  if (shift != 0) {
    for (double &x : centers) x += shift;
  }
}

double length_of(const hg_grid_def &def, int axis) { return def.box_max[axis] - def.box_min[axis]; }

// Nothing, little, halves, whole lengths, many lengths; each up to the last digit.
double draw_tilt(Rng &rng, double length) {
  switch (rng.below(8)) {
    case 0:
      return 0;
    case 1:
      return rng.uniform(-0.5, 0.5) * length;
    case 2:
      return rng.chance(0.5) ? 0.5 * length : -0.5 * length;
    case 3:
      return rng.chance(0.5) ? length : -length;
    case 4:
      return std::nextafter(0.5 * rng.integer(-3, 3) * length, rng.chance(0.5) ? length : -length);
    case 5:
      return rng.uniform(-3, 3) * length;
    case 6:
      return (rng.integer(-300, 300) + rng.uniform(-0.5, 0.5)) * length;
    default:
      return std::ldexp(length, -rng.integer(10, 60));
  }
}

void draw_tilts(Rng &rng, hg_grid_def &def) {
  constexpr int kAxes[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < (def.dimension == 2 ? 1 : 3); k++) {
    if (def.periodic[kAxes[k][0]] + def.periodic[kAxes[k][1]] != 2) continue;
    def.tilt[k] = draw_tilt(rng, length_of(def, kAxes[k][0]));
  }
}

// Some particles onto the faces, edges and middles of the cell, some many cells away.
void scatter(Rng &rng, Scene &scene) {
  const hg_grid_def &def = scene.def;
  for (size_t i = 0; i < scene.particles.count(); i++) {
    double *x = &scene.particles.centers[i * static_cast<size_t>(def.dimension)];
    double cells[3];
    if (rng.chance(0.1)) {
      for (int k = 0; k < def.dimension; k++) x[k] = def.periodic[k] != 0 ? def.box_min[k] : x[k];
      for (double &n : cells) n = rng.chance(0.5) ? 0.5 * rng.integer(0, 2) : rng.uniform();
      move_by_cells(def, cells, x);
    }
    if (rng.chance(0.2)) {
      for (double &n : cells) n = rng.integer(-400, 400);
      move_by_cells(def, cells, x);
    }
  }
}

std::string describe(const Scene &scene, Sizes sizes, const char *places) {
  return std::to_string(scene.particles.dimension) + "D " + kSizesNames[static_cast<int>(sizes)] + " " + places +
         " N=" + std::to_string(scene.particles.count()) +
         (scene.def.interaction == HG_CONTACT ? " contact" : " max-range") + (scene.def.margin > 0 ? " margin" : "") +
         (scene.def.touching != 0 ? " touching" : "");
}

}  // namespace

double draw_radius(Rng &rng, Sizes sizes, double largest) {
  const double u = rng.uniform();
  switch (sizes) {
    case Sizes::kMono:
      return largest;
    case Sizes::kTwo:
      return rng.chance(0.05) ? largest : 0.1 * largest;
    case Sizes::kUniform:
      return largest * rng.uniform(0.02, 1);
    case Sizes::kUniformVolume:  // p(r) ~ r^-3 between largest / 50 and largest
      return largest / 50 / std::sqrt(1 - u * (1 - 1.0 / 2500));
    case Sizes::kSteep:  // p(r) ~ r^-4 between largest / 1000 and largest
      return largest / 1000 / std::cbrt(1 - u * (1 - 1e-9));
    case Sizes::kLogUniform:
      return largest * std::pow(10.0, -6 * u);
    case Sizes::kSomeZero:
      return u < 0.5 ? 0 : largest * (u - 0.4);
  }
  return largest;
}

Particles draw_particles(Rng &rng, int dimension, size_t count, Sizes sizes, Places places) {
  const double units[] = {1, 0.37, 1e-6, 3e4};
  const double unit = units[rng.below(4)];
  if (places == Places::kLattice) return lattice(rng, dimension, count, unit);
  Particles particles;
  particles.dimension = dimension;
  double volume = 0;
  std::vector<double> radii(count);
  for (double &r : radii) {
    r = draw_radius(rng, sizes, unit);
    volume += std::pow(2 * r, dimension);
  }
  const double edge = std::max(unit, rng.uniform(0.7, 1.5) * std::pow(volume, 1.0 / dimension));
  Ground ground{dimension, edge, unit, draw_groups(rng, places, edge), in_cube(rng, edge)};
  for (double r : radii) {
    ground.last = draw_place(rng, places, ground);
    particles.add(ground.last.x, r);
  }
  if (places == Places::kScales) shrink_groups(rng, particles, edge);
  if (places == Places::kOutlier && count > 0) particles.centers[0] = 1e9 * edge;
  for (double &x : particles.centers) {
    if (places == Places::kOutliers && rng.chance(0.02)) x += edge * std::pow(10, rng.uniform(1, 120));
  }
  return particles;
}

Scene open_scene(Rng &rng, int dimension, size_t count, Sizes sizes, Places places) {
  Scene scene;
  scene.particles = draw_particles(rng, dimension, count, sizes, places);
  draw_options(rng, scene);
  scene.name = describe(scene, sizes, kPlacesNames[static_cast<int>(places)]);
  return scene;
}

double largest_reach(const hg_grid_def &def, const Particles &particles) {
  if (particles.count() == 0) return def.margin;
  const double largest = *std::max_element(particles.radii.begin(), particles.radii.end());
  return (def.interaction == HG_MAX_RANGE ? largest : 2 * largest) + def.margin;
}

Scene periodic_scene(Rng &rng, int dimension, int axes, size_t count, Sizes sizes) {
  Scene scene;
  const auto places = rng.chance(0.7) ? Places::kUniform : static_cast<Places>(rng.below(kPlacesCount));
  scene.particles = draw_particles(rng, dimension, count, sizes, places);
  draw_options(rng, scene);
  draw_box(rng, scene, axes);
  for (size_t i = 0; i < scene.particles.count(); i++) {
    for (int k = 0; k < dimension; k++) {
      double &x = scene.particles.centers[i * static_cast<size_t>(dimension) + static_cast<size_t>(k)];
      const double length = scene.def.box_max[k] - scene.def.box_min[k];
      if (rng.chance(0.05)) x = rng.chance(0.5) ? scene.def.box_min[k] : scene.def.box_max[k];
      if (rng.chance(0.2)) x += rng.integer(-1000, 1000) * length;
    }
  }
  scene.name =
      describe(scene, sizes, kPlacesNames[static_cast<int>(places)]) + " periodic axes " + std::to_string(axes);
  return scene;
}

void move_by_cells(const hg_grid_def &def, const double *cells, double *x) {
  const double n[3] = {def.periodic[0] != 0 ? cells[0] : 0, def.periodic[1] != 0 ? cells[1] : 0,
                       def.periodic[2] != 0 ? cells[2] : 0};
  x[0] += n[0] * length_of(def, 0) + n[1] * def.tilt[0] + n[2] * def.tilt[1];
  x[1] += n[1] * length_of(def, 1) + n[2] * def.tilt[2];
  if (def.dimension == 3) x[2] += n[2] * length_of(def, 2);
}

Scene tilted_scene(Rng &rng, int dimension, int axes, size_t count, Sizes sizes) {
  Scene scene;
  scene.particles = draw_particles(rng, dimension, count, sizes, Places::kUniform);
  draw_options(rng, scene);
  draw_box(rng, scene, axes);
  draw_tilts(rng, scene.def);
  scatter(rng, scene);
  scene.name = describe(scene, sizes, "tilted") + " periodic axes " + std::to_string(axes);
  return scene;
}

Scene many_images_scene(Rng &rng, int dimension, int axes, size_t count, Sizes sizes) {
  Scene scene;
  scene.particles = draw_particles(rng, dimension, count, sizes, Places::kUniform);
  draw_options(rng, scene);
  hg_grid_def &def = scene.def;
  def.images = HG_ALL_IMAGES;
  const double room = std::max(1.0, 0.5 * std::pow(static_cast<double>(count), 1.0 / dimension));
  double reach = largest_reach(def, scene.particles);
  if (!(reach > 0)) reach = 1e5;  // longer than the places of points are apart
  for (int k = 0; k < dimension; k++) {
    if ((axes >> k & 1) == 0) continue;
    def.periodic[k] = 1;
    def.box_min[k] = rng.uniform(-2, 2) * reach;
    def.box_max[k] = def.box_min[k] + rng.uniform(0.3, 1.5) * reach * room;
  }
  if (rng.chance(0.7)) draw_tilts(rng, def);
  scatter(rng, scene);
  scene.name = describe(scene, sizes, "many images") + " periodic axes " + std::to_string(axes);
  return scene;
}

int draw_tilted_axes(Rng &rng, int dimension) {
  constexpr int kAxes[] = {3, 5, 6, 7};
  return dimension == 2 ? 3 : kAxes[rng.below(4)];
}

Scene any_scene(Rng &rng, size_t count) {
  const int dimension = rng.integer(2, 3);
  const Sizes sizes = static_cast<Sizes>(rng.below(kSizesCount));
  const int axes = rng.integer(1, (1 << dimension) - 1);
  const uint64_t kind = rng.below(10);
  Scene scene = kind < 4   ? open_scene(rng, dimension, count, sizes, static_cast<Places>(rng.below(kPlacesCount)))
                : kind < 6 ? periodic_scene(rng, dimension, axes, count, sizes)
                : kind < 8 ? tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), count, sizes)
                           : many_images_scene(rng, dimension, axes, count, sizes);
  draw_levels(rng, scene);
  return scene;
}

void draw_levels(Rng &rng, Scene &scene) {
  hg_grid_def &def = scene.def;
  const double overheads[] = {-1, 0, 0.3, 7};
  def.cell_overhead = overheads[rng.below(4)];
  def.level_rule = rng.integer(HG_LEVELS_AUTO, HG_LEVELS_USER);
  scene.name += " levels " + std::to_string(def.level_rule);
  if (def.level_rule != HG_LEVELS_USER) {
    def.level_count = rng.chance(0.3) ? 0 : rng.integer(1, 10);
    return;
  }
  double widest = def.margin;
  for (double r : scene.particles.radii) widest = std::max(widest, 2 * r + def.margin);
  if (def.interaction == HG_MAX_RANGE) widest = largest_reach(def, scene.particles);
  if (!(widest > 0)) widest = 1;
  double cell = widest * (rng.chance(0.5) ? 1 + 0x1p-50 : rng.uniform(1, 3));
  const int count = rng.integer(1, 8);
  for (int level = 0; level < count; level++) {
    scene.cell_sizes.insert(scene.cell_sizes.begin(), cell);
    cell *= rng.uniform(0.05, 0.95);
  }
  def.level_count = count;
  def.cell_sizes = scene.cell_sizes.data();
}

}  // namespace hgtest
