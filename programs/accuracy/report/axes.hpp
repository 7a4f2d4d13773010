// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The frame of a picture with two logarithmic axes. Lengths are pixels.
#pragma once

#include "programs/draw/log_axis.hpp"
#include "programs/draw/svg.hpp"

#include <string>

namespace accuracy {

constexpr double kWords = 11, kTitle = 15;  // sizes of letters

// Grid lines and numbers of both axes, their names, the frame. Numbers across that would stand left of `from` are left
// out.
void draw_axes(draw::Svg &svg, const draw::Frame &frame, const draw::LogAxis &across, const draw::LogAxis &upwards,
               const std::string &name_across, const std::string &name_upwards, double from);

}  // namespace accuracy
