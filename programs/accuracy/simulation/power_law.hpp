// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors that fall as a power of the steps per contact: error = factor n^-order.
#pragma once

#include <vector>

namespace accuracy {

struct PowerLaw {
  double order = 0, factor = 0;
  double at(double steps) const;
};

// The law nearest to the errors > 0 at these steps, by least squares of the logarithms. An error that does not fall has
// the order 0.
PowerLaw fit_power_law(const std::vector<double> &steps, const std::vector<double> &errors);

}  // namespace accuracy
