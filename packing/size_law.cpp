// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Radii from a size law and the box edge from a density, by arithmetic that gives the same bits on every machine.
#include "packing/size_law.hpp"

#include "packing/portable_math.hpp"
#include "packing/sizes/curve_laws.hpp"
#include "particles/error.hpp"
#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace packing {
namespace {

using particles::text;

constexpr double kAboveZero = std::numeric_limits<double>::denorm_min();
constexpr LawParameter kRatio = {"ratio", &SizeLaw::ratio, "largest over smallest radius", "1 to 1e6", 1, 1e6};
constexpr LawParameter kExponent = {"exponent", &SizeLaw::exponent, "a of p(r) ~ r^-a", "a whole number, 2 to 9", 2, 9,
                                    true};
constexpr LawParameter kSigma = {
    "sigma", &SizeLaw::sigma, "standard deviation of ln r", "above 0 and up to 3", kAboveZero, 3};

constexpr LawParameter kModulus = {
    "modulus", &SizeLaw::modulus, "q of the mass finer, (r / ratio)^q", "above 0 and up to 3", kAboveZero, 3};
constexpr LawParameter kD63 = {
    "d63", &SizeLaw::d63, "size over the smallest that 63.2 % of the mass is finer than", "1 to 1e6", 1, 1e6};
constexpr LawParameter kUniformity = {"uniformity",           &SizeLaw::uniformity, "n of 1 - exp(-(r / d63)^n)",
                                      "above 0 and up to 10", kAboveZero,           10};
constexpr LawParameter kMedian = {
    "median", &SizeLaw::median, "size over the smallest that half of the mass is finer than", "1 to 1e6", 1, 1e6};
constexpr LawParameter kFrom = {"from",
                                &SizeLaw::from,
                                "smallest size taken, in the file's column and unit",
                                "0 (all) or more",
                                0,
                                std::numeric_limits<double>::max()};
// Narrower curves fall between the knots that they are taken at.
constexpr double kLeastSigmaByMass = 0.05;

bool is_allowed(const LawParameter &parameter, double value) {
  return value >= parameter.least && value <= parameter.most && (!parameter.is_whole || value == std::floor(value));
}

// The f at which particle i is sampled.
double share_below(size_t i, size_t count, double u) {
  return (static_cast<double>(i) + u) / static_cast<double>(count);
}

// F(r) = (1 - r^(1-a)) / (1 - omega^(1-a)), a > 1.
double inverse_of_power_law(double omega, int a, double f) {
  return 1 / root(1 - f * (1 - 1 / power(omega, a - 1)), a - 1);
}

// How many are the large ones of two sizes: round(N / (1 + omega^d)).
size_t large_count(const SizeLaw &law, size_t count) {
  const double share = 1 / (1 + power(law.ratio, law.dimension));
  return static_cast<size_t>(std::floor(static_cast<double>(count) * share + 0.5));
}

double mono(const SizeLaw &, size_t, size_t, double) { return 1; }

double two_sizes(const SizeLaw &law, size_t i, size_t count, double) {
  return i < count - large_count(law, count) ? 1 : law.ratio;
}

double uniform_size(const SizeLaw &law, size_t i, size_t count, double u) {
  return 1 + (law.ratio - 1) * share_below(i, count, u);
}

double uniform_volume(const SizeLaw &law, size_t i, size_t count, double u) {
  return inverse_of_power_law(law.ratio, law.dimension, share_below(i, count, u));
}

double power_law(const SizeLaw &law, size_t i, size_t count, double u) {
  return inverse_of_power_law(law.ratio, static_cast<int>(law.exponent), share_below(i, count, u));
}

double log_normal(const SizeLaw &law, size_t i, size_t count, double u) {
  return exponential(law.sigma * normal_quantile(share_below(i, count, u)));
}

double one_giant(const SizeLaw &law, size_t i, size_t count, double) { return i + 1 < count ? 1 : law.ratio; }

std::string fault_of_two_sizes(const SizeLaw &law, size_t count) {
  const size_t large = large_count(law, count);
  if (large > 0 && large < count) return "";
  return "two sizes of ratio " + text(law.ratio) + " and equal volume need more than " + std::to_string(count) +
         " particles";
}

std::string fault_of_log_normal_mass(const SizeLaw &law, size_t) {
  if (law.sigma >= kLeastSigmaByMass) return "";
  return "the sigma of log-normal-mass is " + text(kLeastSigmaByMass) + " or more, not " + text(law.sigma);
}

std::string fault_of_table(const SizeLaw &law, size_t) {
  if (law.table == nullptr) return "the law table needs a file of sizes";
  const double last = law.table->size_of(law.table->knots.back().radius);
  if (law.from < last) return "";
  return "sizes are taken from below the largest, " + text(last) + ", not from " + text(law.from);
}

const TakenParameter *taken_by(const LawRow &row, const LawParameter &parameter) {
  for (const TakenParameter &taken : row.takes)
    if (taken.parameter == &parameter) return &taken;
  return nullptr;
}

// Those that a parameter can be given to.
std::vector<std::string> names_of_takers(const LawParameter &parameter) {
  std::vector<std::string> names;
  for (const LawRow &row : size_laws()) {
    const TakenParameter *taken = taken_by(row, parameter);
    if (taken != nullptr && !taken->is_fixed) names.emplace_back(row.name);
  }
  return names;
}

}  // namespace

const std::vector<LawRow> &size_laws() {
  static const std::vector<LawRow> rows = {
      {Law::kMono, "mono", "1", {{&kRatio, 1, true}}, mono},
      {Law::kTwoSizes,
       "two-sizes",
       "1 and ratio, equal volume of both",
       {{&kRatio, 10}},
       two_sizes,
       fault_of_two_sizes},
      {Law::kUniformSize, "uniform-size", "p(r) constant from 1 to ratio", {{&kRatio, 50}}, uniform_size},
      {Law::kUniformVolume,
       "uniform-volume",
       "p(r) ~ r^-3 (2D: r^-2) from 1 to ratio: each interval of sizes holds the same volume",
       {{&kRatio, 50}},
       uniform_volume},
      {Law::kPowerLaw,
       "power-law",
       "p(r) ~ r^-a from 1 to ratio, a = exponent",
       {{&kRatio, 50}, {&kExponent, 3}},
       power_law},
      {Law::kLogNormal, "log-normal", "ln r normal with deviation sigma, median 1", {{&kSigma, 1}}, log_normal},
      {Law::kOneGiant, "one-giant", "one of radius ratio, all others 1", {{&kRatio, 10}}, one_giant},
      {Law::kFuller,
       "fuller",
       "mass finer than r ~ r^q from 1 to ratio, q = modulus: Fuller 0.5, Andreasen 0.33 to 0.5, "
       "Gates-Gaudin-Schuhmann any",
       {{&kRatio, 16}, {&kModulus, 0.5}},
       nullptr,
       fault_of_nothing,
       fuller_curve},
      {Law::kRosinRammler,
       "rosin-rammler",
       "mass finer than r 1 - exp(-(r / d63)^n), n = uniformity, cut at 1 and ratio",
       {{&kRatio, 50}, {&kD63, 10}, {&kUniformity, 1}},
       nullptr,
       fault_of_nothing,
       rosin_rammler_curve},
      {Law::kLogNormalMass,
       "log-normal-mass",
       "ln r normal by mass with deviation sigma about median, cut at 1 and ratio",
       {{&kRatio, 50}, {&kMedian, 10}, {&kSigma, 1}},
       nullptr,
       fault_of_log_normal_mass,
       log_normal_mass_curve},
      {Law::kTable,
       "table",
       "of the file --sizes (key sizes), by mass or number, in its unit; the share is linear in ln r between its rows",
       {{&kFrom, 0}},
       nullptr,
       fault_of_table,
       table_curve},
  };
  return rows;
}

const std::vector<const LawParameter *> &law_parameters() {
  static const std::vector<const LawParameter *> parameters = {&kRatio, &kExponent,   &kSigma,  &kModulus,
                                                               &kD63,   &kUniformity, &kMedian, &kFrom};
  return parameters;
}

const LawRow &row_of(Law law) {
  return *std::find_if(size_laws().begin(), size_laws().end(), [&](const LawRow &row) { return row.law == law; });
}

SizeLaw usual_law(const std::string &name) {
  for (const LawRow &row : size_laws()) {
    if (row.name != name) continue;
    SizeLaw law;
    law.law = row.law;
    for (const TakenParameter &taken : row.takes) law.*taken.parameter->value = taken.usual;
    return law;
  }
  throw particles::Error("no size law is called '" + name + "': use one of " +
                         particles::joined(particles::names_of(size_laws())));
}

SizeLaw law_with(const std::string &name, double value) {
  SizeLaw law = usual_law(name);
  const LawParameter &parameter = *row_of(law.law).takes.front().parameter;
  const std::string fault = set_parameter(law, parameter, value);
  if (!fault.empty()) throw particles::Error(std::string(parameter.name) + " " + fault);
  return law;
}

std::string set_parameter(SizeLaw &law, const LawParameter &parameter, double value) {
  const LawRow &row = row_of(law.law);
  const TakenParameter *taken = taken_by(row, parameter);
  if (taken == nullptr)
    return "is for " + particles::joined(names_of_takers(parameter)) + ", not for the law " + row.name;
  if (taken->is_fixed && value != taken->usual)
    return "is " + text(taken->usual) + " for the law " + row.name + ", not " + text(value);
  law.*parameter.value = value;
  return "";
}

std::string set_sizes(SizeLaw &law, const std::string &path) {
  if (law.law != Law::kTable) return std::string("is for table, not for the law ") + row_of(law.law).name;
  law.table = std::make_shared<const SizeTable>(read_size_table(path));
  return "";
}

std::string law_fault(const SizeLaw &law, size_t count) {
  const LawRow &row = row_of(law.law);
  for (const TakenParameter &taken : row.takes) {
    const double value = law.*taken.parameter->value;
    if (!is_allowed(*taken.parameter, value))
      return std::string("the ") + taken.parameter->name + " is " + taken.parameter->range + ", not " + text(value);
  }
  std::string fault = row.fault(law, count);
  // Where nothing lies between the ends, shares are nothing over nothing.
  if (fault.empty() && row.curve != nullptr && !std::isfinite(row.curve(law).number_below().front()))
    fault = std::string("nothing of the law ") + row.name + " lies between its ends";
  return fault;
}

std::string describe(const LawParameter &parameter) {
  const std::vector<std::string> takers = names_of_takers(parameter);
  return (takers.size() == 1 ? takers.front() + ": " : "") + parameter.meaning + ", " + parameter.range;
}

std::string usual_values(const LawParameter &parameter) {
  const double usual = SizeLaw().*parameter.value;
  std::string result = text(usual);
  for (const LawRow &row : size_laws()) {
    const TakenParameter *taken = taken_by(row, parameter);
    if (taken != nullptr && taken->usual != usual) result += std::string("; ") + row.name + ": " + text(taken->usual);
  }
  return result;
}

std::vector<double> sample_radii(const SizeLaw &law, size_t count, double u) {
  const LawRow &row = row_of(law.law);
  std::vector<double> radii(count);
  if (row.radius != nullptr) {
    for (size_t i = 0; i < count; i++) radii[i] = row.radius(law, i, count, u);
    return radii;
  }
  const SizeCurve curve = row.curve(law);
  for (size_t i = 0; i < count; i++) radii[i] = curve.radius_at(share_below(i, count, u));
  return radii;
}

double first_radius(const SizeLaw &law) { return law.law == Law::kTable ? table_curve(law).radii().front() : 1; }

double box_edge(const std::vector<double> &radii, double density, int dimension) {
  return root(volume_of(radii, dimension) / density, dimension);
}

}  // namespace packing
