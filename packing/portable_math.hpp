// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Functions made of + - * / sqrt alone, which give the same bits on every machine. Those of the C library may differ in
// their last bit between versions, and with it every coordinate of a packing.
#pragma once

#include <vector>

namespace packing {

// base^exponent, exponent >= 0.
double power(double base, int exponent);

// x^(1/degree), x >= 0, degree >= 1.
double root(double x, int degree);

// e^x.
double exponential(double x);

// ln x, x > 0.
double logarithm(double x);

// base^exponent, base > 0.
double real_power(double base, double exponent);

// The x with Phi(x) = p, Phi the standard normal distribution, 0 <= p <= 1. The ends, which are infinitely far away,
// give the places where Phi rounds to them, about -8 and 8.
double normal_quantile(double p);

// The volume (area) of the unit sphere (disk), and that of all spheres (disks) of these radii.
double unit_ball(int dimension);
double volume_of(const std::vector<double> &radii, int dimension);

}  // namespace packing
