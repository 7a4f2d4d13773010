// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Size laws: those of Ogarko & Luding 2012, section 4.1, and others that are common or hard; their systematic sampling,
// and the box that a density asks for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace packing {

enum class Law {
  kMono,           // all radii 1
  kTwoSizes,       // 1 and omega, equal volume (2D: area) of both
  kUniformSize,    // p(r) constant on [1, omega]
  kUniformVolume,  // every size interval holds the same volume: p(r) ~ r^-d on [1, omega]
  kPowerLaw,       // p(r) ~ r^-a on [1, omega]
  kLogNormal,      // ln r is normal with mean 0 and deviation sigma; the median radius is 1
  kOneGiant        // one of radius omega, all others 1
};

// The smallest radius is 1, so `ratio` (omega) is the largest; log-normal radii have no ends but those of the sample.
struct SizeLaw {
  Law law = Law::kUniformVolume;
  double ratio = 50;
  int dimension = 3;
  int exponent = 3;  // a of the power law, 2 to 9
  double sigma = 1;  // of the log-normal law
};

// The names that law_from_name knows, in the order of the enum.
extern const char *const kLawNames[7];

// The law of a name as `hgrid pack --law` takes it; throws std::invalid_argument naming it if there is none.
Law law_from_name(const std::string &name);

// How many of `count` particles are the large ones of Law::kTwoSizes: round(N / (1 + omega^d)).
size_t large_count(const SizeLaw &law, size_t count);

// F^-1 of the laws that have a density, 0 <= f < 1.
double inverse_cdf(const SizeLaw &law, double f);

// Systematic sampling, r_i = F^-1((i + u) / N) with one u in [0, 1) for all: ascending, and no size class is left out
// by chance. The largest radius stays somewhat below omega unless N >> omega^(a - 1).
std::vector<double> sample_radii(const SizeLaw &law, size_t count, double u);

// Edge of the cube (square) in which spheres (disks) of these radii fill the fraction `density` of the volume.
double box_edge(const std::vector<double> &radii, double density, int dimension);

}  // namespace packing
