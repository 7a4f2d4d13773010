// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/ranks/decomposition.hpp"

#include <algorithm>
#include <numeric>

namespace ranks {
namespace {

using Rows = std::vector<size_t>::iterator;

class Bisection {
 public:
  Bisection(const particles::ParticleSet &set, const std::vector<double> &weights, std::vector<int32_t> &owners)
      : set_(set), weights_(weights), owners_(owners) {}

  void divide(Rows first, Rows last, int32_t first_rank, int rank_count) {
    if (rank_count == 1 || first == last) {
      std::for_each(first, last, [&](size_t row) { owners_[row] = first_rank; });
      return;
    }
    const int axis = longest_axis(first, last);
    // Ties by row, so that the same particles go the same way everywhere.
    std::sort(first, last, [&](size_t p, size_t q) {
      const double xp = set_.center(p)[axis], xq = set_.center(q)[axis];
      return xp != xq ? xp < xq : p < q;
    });
    const int below = rank_count / 2;
    const double whole = std::accumulate(first, last, 0.0, [&](double sum, size_t row) { return sum + weights_[row]; });
    const double wanted = whole * below / rank_count;
    Rows cut = first;
    for (double sum = 0; cut != last && sum + 0.5 * weights_[*cut] < wanted; ++cut) sum += weights_[*cut];
    divide(first, cut, first_rank, below);
    divide(cut, last, first_rank + below, rank_count - below);
  }

 private:
  int longest_axis(Rows first, Rows last) const {
    int longest = 0;
    double most = -1;
    for (int axis = 0; axis < set_.dimension; axis++) {
      const auto [low, high] = std::minmax_element(
          first, last, [&](size_t p, size_t q) { return set_.center(p)[axis] < set_.center(q)[axis]; });
      const double extent = set_.center(*high)[axis] - set_.center(*low)[axis];
      if (extent > most) {
        most = extent;
        longest = axis;
      }
    }
    return longest;
  }

  const particles::ParticleSet &set_;
  const std::vector<double> &weights_;
  std::vector<int32_t> &owners_;
};

}  // namespace

std::vector<int32_t> bisect(const particles::ParticleSet &set, const std::vector<double> &weights, int rank_count) {
  std::vector<int32_t> owners(set.count(), 0);
  std::vector<size_t> rows(set.count());
  std::iota(rows.begin(), rows.end(), size_t{0});
  Bisection(set, weights, owners).divide(rows.begin(), rows.end(), 0, rank_count);
  return owners;
}

std::vector<Part> parts_of(const particles::ParticleSet &set, const std::vector<int32_t> &owners, int rank_count) {
  std::vector<Part> parts(static_cast<size_t>(rank_count));
  for (size_t row = 0; row < set.count(); row++) {
    Part &part = parts[static_cast<size_t>(owners[row])];
    part.centers.insert(part.centers.end(), set.center(row), set.center(row) + set.dimension);
    part.radii.push_back(set.radii[row]);
  }
  return parts;
}

}  // namespace ranks
