// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The laws that errors follow in the steps per contact, beside those that are derived.
#pragma once

#include "programs/accuracy/report/tables.hpp"

#include <string>
#include <vector>

namespace accuracy {

// How far a measured order may be from the derived one.
constexpr double kOrderTolerance = 0.15;

// Whether the point belongs into this table: those of the study "step" do.
bool has_law(const Point &point);

// A row for each scheme and error: derived and measured law, whether their orders agree, error and time at the usual
// step, and what ten times less error costs by the measured order. Errors without a law, a single random walk's, show
// no order. Empty without points that have a law.
std::string convergence_table(const std::vector<Point> &points, Style style);

}  // namespace accuracy
