// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A tissue of discs that grow, divide and push each other aside. Their number changes in every step, and pairs are
// found anew each time. Arguments: [COUNT [STEPS]]. Prints where each disc ends, with all digits; on standard error,
// the seconds that the search and the whole took.
#include <hgrid/hgrid.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

class Neighbors {
 public:
  // The pairs of discs that overlap, ascending: forces are then added up in the same order, whatever the cells.
  auto pairs(const std::vector<double> &centers, const std::vector<double> &radii) {
    hg_grid_def def = hg_default_grid_def();
    def.dimension = 2;
    def.accuracy = HG_DOUBLE;
    def.pair_order = HG_ORDER_ID;
    if (!grid_) grid_.emplace(def);
    grid_->set(radii.size(), centers.data(), radii.data());
    return grid_->query_pairs();
  }

 private:
  std::optional<hgrid::Grid> grid_;
};

class Tissue {
 public:
  explicit Tissue(int count) {
    const int row = static_cast<int>(std::sqrt(count));
    for (int i = 0, line = 0; i < count; i++) {
      if (i > 0 && i % row == 0) line++;
      add(1.8 * (i % row), 1.8 * line, 1 + 0.3 * noise_(random_));
    }
  }

  // Returns the number of contacts.
  size_t step() {
    const auto start = std::chrono::steady_clock::now();
    const auto pairs = neighbors_.pairs(centers_, radii_);
    search_time_ += std::chrono::steady_clock::now() - start;
    push(pairs);
    grow();
    return pairs.size();
  }

  void print() const {
    for (size_t i = 0; i < radii_.size(); i++)
      std::printf("%.17g %.17g %.17g\n", centers_[2 * i], centers_[2 * i + 1], radii_[i]);
  }
  size_t count() const { return radii_.size(); }
  double search_seconds() const { return search_time_.count(); }

 private:
  void add(double x, double y, double radius) {
    centers_.insert(centers_.end(), {x, y});
    radii_.push_back(radius);
  }

  // Discs in a viscous fluid move with the force.
  template <class Pairs>
  void push(const Pairs &pairs) {
    forces_.assign(centers_.size(), 0);
    pressure_.assign(radii_.size(), 0);
    for (const auto &[a, b] : pairs) {
      const double dx = centers_[2 * b] - centers_[2 * a], dy = centers_[2 * b + 1] - centers_[2 * a + 1];
      const double distance = std::sqrt(dx * dx + dy * dy), overlap = radii_[a] + radii_[b] - distance;
      const double fx = overlap * dx / distance, fy = overlap * dy / distance;
      forces_[2 * a] -= fx, forces_[2 * a + 1] -= fy;
      forces_[2 * b] += fx, forces_[2 * b + 1] += fy;
      pressure_[a] += overlap, pressure_[b] += overlap;
    }
    for (size_t k = 0; k < centers_.size(); k++) centers_[k] += 0.15 * forces_[k];
  }

  // Discs under pressure grow less; one that has doubled its area divides.
  void grow() {
    const size_t count = radii_.size();
    for (size_t i = 0; i < count; i++) {
      radii_[i] *= 1 + 0.02 * std::max(0.0, 1 - 0.5 * pressure_[i]) * noise_(random_);
      if (radii_[i] < 1.41421356) continue;
      const double angle = 6.28318531 * noise_(random_), away = 0.4 * radii_[i];
      const double x = centers_[2 * i], y = centers_[2 * i + 1];
      radii_[i] *= 0.70710678;
      centers_[2 * i] -= away * std::cos(angle), centers_[2 * i + 1] -= away * std::sin(angle);
      add(x + away * std::cos(angle), y + away * std::sin(angle), radii_[i]);
    }
  }

  struct Noise {  // between 0 and 1, the same with every compiler
    double operator()(std::minstd_rand &random) const { return static_cast<double>(random()) / 2147483647.0; }
  };

  std::minstd_rand random_{1};
  Noise noise_;
  std::vector<double> centers_, radii_, forces_, pressure_;
  Neighbors neighbors_;
  std::chrono::duration<double> search_time_{0};
};

int main(int argc, char **argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20000, steps = argc > 2 ? std::atoi(argv[2]) : 200;
  if (count < 1 || steps < 1) {
    std::fprintf(stderr, "arguments: [COUNT [STEPS]]\n");
    return 1;
  }
  Tissue tissue(count);
  const auto start = std::chrono::steady_clock::now();
  for (int s = 1; s <= steps; s++) {
    const size_t contacts = tissue.step();
    if (s % 20 == 0) std::printf("step %d: %zu discs, %zu contacts\n", s, tissue.count(), contacts);
  }
  const std::chrono::duration<double> all = std::chrono::steady_clock::now() - start;
  std::fprintf(stderr, "search %.3f s, all %.3f s\n", tissue.search_seconds(), all.count());
  tissue.print();
}
