// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

#include "accuracy/search_knobs.hpp"

namespace accuracy {

const std::vector<Knob> &search_knobs() {
  static const std::vector<Knob> knobs = {};
  return knobs;
}

}  // namespace accuracy
