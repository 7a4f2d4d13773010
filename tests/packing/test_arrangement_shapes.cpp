// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What makes each arrangement what it is, measured on its places alone. All spheres (disks) have the radius 1 here:
// tests/packing/test_arrangement.cpp has the other sizes.
#include "packing/packing.hpp"
#include "tests/support/frame.h"

#include <hgrid/hgrid.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

namespace {

constexpr uint64_t kSeed = 5;
constexpr double kDensity = 0.62;

double ball(int d) { return d == 2 ? M_PI : 4 * M_PI / 3; }
double spacing(int d) { return std::pow(ball(d) / kDensity, 1.0 / d); }

// The places of an arrangement, with what can be measured of them.
class World {
 public:
  World(const char *name, int dimension, size_t count) {
    packing::Request request;
    request.arrangement = &packing::arrangement_called(name);
    request.law = packing::usual_law("mono");
    request.law.dimension = dimension;
    request.density = request.arrangement->density;
    request.count = count;
    request.seed = kSeed;
    set_ = packing::lay_particles(request);
  }

  int d() const { return set_.dimension; }
  size_t count() const { return set_.count(); }
  double x(size_t i, int axis) const { return set_.center(i)[axis]; }
  const particles::ParticleSet &set() const { return set_; }

  std::vector<double> sorted(int axis) const {
    std::vector<double> values(count());
    for (size_t i = 0; i < count(); i++) values[i] = x(i, axis);
    std::sort(values.begin(), values.end());
    return values;
  }
  double extent(int axis) const {
    const std::vector<double> values = sorted(axis);
    return values.back() - values.front();
  }
  double volume() const {  // of the box around
    double product = 1;
    for (int axis = 0; axis < d(); axis++) product *= extent(axis);
    return product;
  }
  Eigen::VectorXd place(size_t i) const { return Eigen::Map<const Eigen::VectorXd>(set_.center(i), d()); }
  Eigen::VectorXd mean() const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(d());
    for (size_t i = 0; i < count(); i++) sum += place(i);
    return sum / static_cast<double>(count());
  }
  // Ascending eigenvalues of the covariance, with their directions.
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principal_axes() const {
    const Eigen::VectorXd middle = mean();
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(d(), d());
    for (size_t i = 0; i < count(); i++) covariance += (place(i) - middle) * (place(i) - middle).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(covariance / static_cast<double>(count()));
  }
  std::vector<hg_pair> pairs_within(double reach) const {
    hg_grid_def def = hg_default_grid_def();
    def.dimension = d();
    def.thread_count = 1;
    hgrid::Grid grid(def);
    const std::vector<double> radii(count(), 0.5 * reach);
    grid.insert(count(), set_.centers.data(), radii.data());
    const hgrid::View<hg_pair> pairs = grid.query_pairs();
    return {pairs.begin(), pairs.end()};
  }
  std::vector<int> neighbours_within(double reach) const {
    std::vector<int> neighbours(count(), 0);
    for (const hg_pair &pair : pairs_within(reach)) {
      ++neighbours[static_cast<size_t>(pair.a)];
      ++neighbours[static_cast<size_t>(pair.b)];
    }
    return neighbours;
  }
  // Sizes of the sets that are connected by pairs, large ones first.
  std::vector<size_t> connected_sizes(double reach) const {
    std::vector<size_t> parent(count());
    std::iota(parent.begin(), parent.end(), size_t{0});
    const auto root = [&parent](size_t i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    for (const hg_pair &pair : pairs_within(reach))
      parent[root(static_cast<size_t>(pair.a))] = root(static_cast<size_t>(pair.b));
    std::vector<size_t> sizes(count(), 0);
    for (size_t i = 0; i < count(); i++) ++sizes[root(i)];
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes;
  }
  // D of (number of pairs within r) ~ r^D, between two reaches.
  double correlation_dimension(double near, double far) const {
    const auto pairs = [this](double reach) { return static_cast<double>(pairs_within(reach).size()); };
    return std::log(pairs(far) / pairs(near)) / std::log(far / near);
  }

 private:
  particles::ParticleSet set_;
};

bool within(const char *what, double found, double low, double high) {
  if (found >= low && found <= high) return true;
  std::fprintf(stderr, "%s: %.17g lies outside %.17g to %.17g, seed %llu\n", what, found, low, high,
               static_cast<unsigned long long>(kSeed));
  return false;
}

bool near(const char *what, double found, double expected, double relative) {
  return within(what, found, expected * (1 - relative), expected * (1 + relative));
}

template <class Where>
double share(const World &world, Where where) {
  size_t inside = 0;
  for (size_t i = 0; i < world.count(); i++) inside += where(i) ? 1 : 0;
  return static_cast<double>(inside) / static_cast<double>(world.count());
}

bool is_gas(int d) {
  const World world("gas", d, 20000);
  const double pairs = static_cast<double>(world.pairs_within(2).size()) / static_cast<double>(world.count());
  return near("density", static_cast<double>(world.count()) * ball(d) / world.volume(), 0.01, 0.02) &&
         near("pairs of places that know nothing of each other", pairs, 0.5 * 0.01 * std::pow(2, d), 0.12);
}

// The density at a place of the mass: the mean of (1 + u^2)^(-5/2) is 3 * integral of u^2 (1 + u^2)^-5 = 3 * 5 pi /
// 256.
bool clusters_are_plummer_spheres() {
  const World world("clusters", 3, 40000);
  const double count = static_cast<double>(world.count()), reach = 1.7;
  const double b = std::cbrt(count / 20 / kDensity);
  const double in_the_middle = kDensity * reach * reach * reach;  // others within reach
  const double pairs = static_cast<double>(world.pairs_within(reach).size());
  bool good = near("close pairs", pairs, 0.5 * count * in_the_middle * 15 * M_PI / 256, 0.06);
  for (int axis = 0; axis < 3; axis++) good = within("extent", world.extent(axis), 35 * b, 50 * b) && good;
  return good;
}

bool is_clumped(int d) {
  const World world("clumps", d, 20000);
  const double reach = 1.3 * spacing(d);
  const std::vector<int> neighbours = world.neighbours_within(reach);
  const std::vector<size_t> sizes = world.connected_sizes(reach);
  const auto clumps = std::count_if(sizes.begin(), sizes.end(), [](size_t size) { return size >= 100; });
  const double room = static_cast<double>(world.count()) * ball(d) / kDensity;
  return near("share of the lonely", share(world, [&](size_t i) { return neighbours[i] == 0; }), 0.2, 0.05) &&
         near("share of the crowded", share(world, [&](size_t i) { return neighbours[i] >= 2; }), 0.8, 0.05) &&
         within("clumps", static_cast<double>(clumps), 44, 56) &&
         near("room", world.volume() / room, std::pow(30, d), 0.05);
}

// The cube of a hundredth of the volume around the median.
bool is_crowded(int d) {
  const World world("crowd", d, 20000);
  const double half = 0.5 * std::pow(0.01 * world.volume(), 1.0 / d);
  std::vector<double> middle;
  for (int axis = 0; axis < d; axis++) middle.push_back(world.sorted(axis)[world.count() / 2]);
  const double inside = share(world, [&](size_t i) {
    for (int axis = 0; axis < d; axis++)
      if (std::fabs(world.x(i, axis) - middle[static_cast<size_t>(axis)]) > 1.02 * half) return false;
    return true;
  });
  return within("share of the crowd", inside, 0.988, 0.992);
}

// Thin tubes are lines seen from afar, and solid seen from near.
bool has_filaments(int d) {
  const World world("filaments", d, 30000);
  const std::vector<size_t> sizes = world.connected_sizes(3 * spacing(d));
  const auto tubes = std::count_if(sizes.begin(), sizes.end(), [](size_t size) { return size >= 900; });
  return within("tubes", static_cast<double>(tubes), d == 2 ? 15 : 25, 30) &&
         within("dimension afar", world.correlation_dimension(20, 40), 0.8, 1.3) &&
         within("dimension nearby", world.correlation_dimension(0.5, 1), 0.9 * d, 1.1 * d);
}

bool is_film(int d) {
  const World world("film", d, 20000);
  const auto axes = world.principal_axes();
  const Eigen::VectorXd normal = axes.eigenvectors().col(0);
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < world.count(); i++) {
    low = std::min(low, world.place(i).dot(normal));
    high = std::max(high, world.place(i).dot(normal));
  }
  bool good = within("thickness", high - low, 3.98, 4.12) &&
              near("spread along the normal", axes.eigenvalues()[0], 16.0 / 12, 0.03) &&
              within("spread in the film over that", axes.eigenvalues()[1] / axes.eigenvalues()[0], 100, 1e9);
  for (int axis = 0; axis < d; axis++) good = within("tilt", std::fabs(normal[axis]), 0.25, 0.9) && good;
  return good;
}

// The middle of the sphere that fits best: x^2 = 2 m.x + constant for all x on it.
Eigen::VectorXd middle_of_sphere(const World &world) {
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(world.d() + 1, world.d() + 1);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(world.d() + 1);
  for (size_t i = 0; i < world.count(); i++) {
    Eigen::VectorXd row(world.d() + 1);
    row << world.place(i), 1;
    squares += row * row.transpose();
    sums += row * world.place(i).squaredNorm();
  }
  return 0.5 * squares.ldlt().solve(sums).head(world.d());
}

bool is_shell(int d) {
  const World world("shell", d, 20000);
  const Eigen::VectorXd middle = middle_of_sphere(world), spread = world.principal_axes().eigenvalues();
  double low = INFINITY, high = 0;
  for (size_t i = 0; i < world.count(); i++) {
    low = std::min(low, (world.place(i) - middle).norm());
    high = std::max(high, (world.place(i) - middle).norm());
  }
  return within("thickness", high - low, 3.98, 4.1) && within("hollow", low / (high - low), 8, 1e9) &&
         near("roundness", spread[0] / spread[d - 1], 1, 0.05);
}

bool is_jet(int d) {
  const World world("jet", d, 20000);
  const std::vector<double> heights = world.sorted(d - 1);
  const double top = heights.back(), hole = heights[world.count() * 55 / 100],
               summit = heights[world.count() * 45 / 100];
  const double thick = share(world, [&](size_t i) {  // amid the fall, more than 6 off its axis
    const double height = world.x(i, d - 1);
    return height < hole - 3 && height > summit + 3 &&
           std::hypot(world.x(i, 0), d == 3 ? world.x(i, 1) : 0) > 6 * M_SQRT2;
  });
  return near("fall over the hopper's height", -summit / top, 200, 0.03) && within("hole", hole, -3, 3) &&
         within("pile over the fall", (heights.front() - summit) / summit, 0, 0.02) &&
         within("share off the jet", thick, 0, 0);
}

bool are_far(int d) {
  const World world("far", d, 20000);
  const std::vector<double> x = world.sorted(0);
  const double between = 0.5 * (x.front() + x.back());
  Eigen::VectorXd sums[2] = {Eigen::VectorXd::Zero(d), Eigen::VectorXd::Zero(d)};
  for (size_t i = 0; i < world.count(); i++) sums[world.x(i, 0) > between ? 1 : 0] += world.place(i);
  const double half = 0.5 * static_cast<double>(world.count()), edge = std::pow(half, 1.0 / d) * spacing(d);
  return near("half of all", share(world, [&](size_t i) { return world.x(i, 0) > between; }), 0.5, 1e-9) &&
         near("distance in diameters", (sums[1] - sums[0]).norm() / half / 2, 1e6, 1e-3) &&
         near("one cube", x[world.count() / 2 - 1] - x.front(), edge, 0.1) &&
         near("the other", x.back() - x[world.count() / 2], edge, 0.1);
}

bool has_outliers(int d) {
  const World world("outliers", d, 1000);
  const auto is_far = [&](size_t i) { return world.place(i).cwiseAbs().maxCoeff() > 1e9; };
  double farthest = 0, among_others = 0;
  for (size_t i = 0; i < world.count(); i++) {
    const double distance = world.place(i).cwiseAbs().maxCoeff();
    double &largest = is_far(i) ? farthest : among_others;
    largest = std::max(largest, distance);
  }
  const double edge = std::pow(1000, 1.0 / d) * spacing(d);
  return near("outliers", share(world, is_far), 0.003, 1e-9) && near("the farthest", farthest, 1e200, 1e-9) &&
         within("all others", among_others, 0.9 * edge, 1.1 * edge);
}

bool is_dust(int d) {
  const World world("dust", d, 8000);
  return within("dimension", world.correlation_dimension(2, 20), 1.1, 1.6) &&
         within("and farther", world.correlation_dimension(20, 200), 1.0, 1.7) &&
         within("extent", world.extent(0), 500, 1e9);
}

bool has_scales(int d) {
  const World world("scales", d, 20000);
  const std::vector<int> neighbours =
      world.neighbours_within(1.0001 * std::sqrt(d) * spacing(d) * std::pow(5, 1.0 / d));
  bool good = within("lonely", share(world, [&](size_t i) { return neighbours[i] < 4; }), 0, 0);
  for (int axis = 0; axis < d; axis++) {
    for (int decade = 0; decade < 12; decade += 3) {
      const double part = share(world, [&](size_t i) {
        const double at = std::log10(std::fabs(world.x(i, axis)));
        return at < decade + 3 && (decade == 0 || at >= decade);
      });
      good = near("share of three decades", part, 0.25, 0.1) && good;
    }
    good = near("below 0", share(world, [&](size_t i) { return world.x(i, axis) < 0; }), 0.5, 0.05) && good;
  }
  return good;
}

// What is occupied of a periodic axis: all but the widest gap.
bool is_part(const char *name, bool across, int d) {
  const World world(name, d, d == 2 ? 140 * 140 : 27 * 27 * 27);
  bool good = world.set().has_box;
  for (int axis = 0; axis < d; axis++) {
    const double edge = world.set().box_max[axis];
    const std::vector<double> x = world.sorted(axis);
    double gap = across ? 0 : edge - x.back() + x.front();
    for (size_t i = 1; i < x.size(); i++) gap = std::max(gap, x[i] - x[i - 1]);
    const bool wraps = x.front() < 0.01 * edge && x.back() > 0.99 * edge;
    good = good && world.set().periodic[axis] == 1 && world.set().box_min[axis] == 0 && x.front() >= 0 &&
           x.back() < edge && wraps == across && within("occupied", 1 - gap / edge, 0.12, 0.126);
  }
  return good;
}

bool gas() { return is_gas(2) && is_gas(3); }
bool clumps() { return is_clumped(2) && is_clumped(3); }
bool crowd() { return is_crowded(2) && is_crowded(3); }
bool filaments() { return has_filaments(2) && has_filaments(3); }
bool film() { return is_film(2) && is_film(3); }
bool shell() { return is_shell(2) && is_shell(3); }
bool jet() { return is_jet(2) && is_jet(3); }
bool far() { return are_far(2) && are_far(3); }
bool outliers() { return has_outliers(2) && has_outliers(3); }
bool dust() { return is_dust(2) && is_dust(3); }
bool scales() { return has_scales(2) && has_scales(3); }
bool parts() {
  return is_part("part", false, 2) && is_part("part", false, 3) && is_part("part-across", true, 2) &&
         is_part("part-across", true, 3);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<gas>),       cmocka_unit_test(passes<clusters_are_plummer_spheres>),
      cmocka_unit_test(passes<clumps>),    cmocka_unit_test(passes<crowd>),
      cmocka_unit_test(passes<filaments>), cmocka_unit_test(passes<film>),
      cmocka_unit_test(passes<shell>),     cmocka_unit_test(passes<jet>),
      cmocka_unit_test(passes<far>),       cmocka_unit_test(passes<outliers>),
      cmocka_unit_test(passes<dust>),      cmocka_unit_test(passes<scales>),
      cmocka_unit_test(passes<parts>),
  };
  return cmocka_run_group_tests_name("arrangement_shapes", tests, nullptr, nullptr);
}
