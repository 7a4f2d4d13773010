// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture of a slice: an overview with the coarse cells, a close-up with the fine ones, and a legend.
#pragma once

#include "programs/draw/slice.hpp"

#include <string>

namespace draw {

// An SVG document. If the plane cuts very many spheres, the overview shows the middle of the box only and says so.
std::string slice_picture(const Slice &slice);

}  // namespace draw
