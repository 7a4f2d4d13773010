// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Size laws: those of Ogarko & Luding 2012, section 4.1, others that are common or hard, curves by mass and tables;
// their systematic sampling, and the box that a density asks for.
#pragma once

#include "packing/sizes/curve.hpp"
#include "packing/sizes/table.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace packing {

enum class Law {
  kMono,
  kTwoSizes,
  kUniformSize,
  kUniformVolume,
  kPowerLaw,
  kLogNormal,
  kOneGiant,
  kFuller,
  kRosinRammler,
  kLogNormalMass,
  kTable
};

// The smallest radius is 1, so `ratio` (omega) is the largest; log-normal radii have no ends but those of the sample,
// tables have radii of their own.
struct SizeLaw {
  Law law = Law::kUniformVolume;
  double ratio = 50;
  int dimension = 3;
  double exponent = 3;              // a of the power law, a whole number
  double sigma = 1;                 // of the log-normal laws
  double modulus = 0.5;             // q of Fuller's curve
  double d63 = 10, uniformity = 1;  // of Rosin and Rammler's
  double median = 10;               // by mass
  double from = 0;                  // the smallest size taken from the table
  std::shared_ptr<const SizeTable> table = nullptr;
};

// A parameter of size laws: an option of `hgrid pack` and a key of [particles.pack].
struct LawParameter {
  const char *name;
  double SizeLaw::*value;
  const char *meaning;
  const char *range;  // in words
  double least, most;
  bool is_whole = false;  // number
};

// What a law takes.
struct TakenParameter {
  const LawParameter *parameter;
  double usual;
  bool is_fixed = false;  // at the usual value
};

inline std::string fault_of_nothing(const SizeLaw & /*law*/, size_t /*count*/) { return ""; }

struct LawRow {
  Law law;
  const char *name;
  const char *radii;  // in words
  std::vector<TakenParameter> takes;
  // The radius of particle i of `count`, in ascending order, sampled at (i + u) / count; nullptr: by the curve.
  double (*radius)(const SizeLaw &law, size_t i, size_t count, double u);
  // Why `count` particles cannot have this law, "" if they can.
  std::string (*fault)(const SizeLaw &law, size_t count) = fault_of_nothing;
  SizeCurve (*curve)(const SizeLaw &law) = nullptr;
};

constexpr const char *kSizesMeaning =
    "table: CSV file with a column diameter or radius and one of passing (or volume) or number, the share of what is "
    "smaller, up to 100 or 1";

// All laws and all parameters: what is offered, described, checked and sampled comes from here.
const std::vector<LawRow> &size_laws();
const std::vector<const LawParameter *> &law_parameters();

const LawRow &row_of(Law law);

// The law called `name`, with the usual values of what it takes. Throws particles::Error if there is none.
SizeLaw usual_law(const std::string &name);

// The same with one value: that of the first parameter it takes, the ratio of most.
SizeLaw law_with(const std::string &name, double value);

// Sets a parameter. Returns "", or what is wrong: the law does not take it, or only one value of it. Ranges are left to
// law_fault.
std::string set_parameter(SizeLaw &law, const LawParameter &parameter, double value);

// Reads the file of the law `table`. Returns "", or that the law takes none. Throws particles::Error naming file and
// line of what is wrong.
std::string set_sizes(SizeLaw &law, const std::string &path);

// What is wrong with a law for so many particles: a value that is not allowed, or too few of them; "" if nothing is.
std::string law_fault(const SizeLaw &law, size_t count);

// For help and references: the parameter with the law that it belongs to, and its usual value, by law where laws
// differ.
std::string describe(const LawParameter &parameter);
std::string usual_values(const LawParameter &parameter);

// Systematic sampling, r_i = F^-1((i + u) / N) with one u in [0, 1) for all: ascending, and no size class is left out
// by chance. The largest radius stays somewhat below omega unless N >> omega^(a - 1).
std::vector<double> sample_radii(const SizeLaw &law, size_t count, double u);

// The radius that laws start at: of the smallest particle, of log-normal laws by number the median.
double first_radius(const SizeLaw &law);

// Edge of the cube (square) in which spheres (disks) of these radii fill the fraction `density` of the volume.
double box_edge(const std::vector<double> &radii, double density, int dimension);

}  // namespace packing
