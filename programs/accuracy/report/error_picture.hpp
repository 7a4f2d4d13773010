// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture that tells at a glance what accuracy costs: error across, cost upwards, a line for each knob.
#pragma once

#include "programs/accuracy/figure.hpp"

#include <string>
#include <vector>

namespace accuracy {

// An SVG document. Both axes are logarithmic; points without error stand on a strip of their own. Settings that
// another of the same knob beats in both are pale. Knobs without a point are left out.
std::string error_picture(const Figure &figure, const std::vector<Point> &points);

}  // namespace accuracy
