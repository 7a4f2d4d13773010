// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The one exception of the simulations: what went wrong, with the value that did.
#ifndef HGRID_SIM_ERROR_HPP
#define HGRID_SIM_ERROR_HPP

#include <stdexcept>

namespace hgrid_sim {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hgrid_sim

#endif
