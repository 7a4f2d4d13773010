// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture of a study whose settings change the time alone: time over their numbers.
#pragma once

#include "programs/accuracy/study.hpp"

#include <string>
#include <vector>

namespace accuracy {

// An SVG document, a line for each system. `study.number_of` must be there.
std::string number_picture(const Study &study, const std::vector<Point> &points);

}  // namespace accuracy
