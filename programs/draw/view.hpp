// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A part of a slice as it appears in a frame of the picture: disks, cells, and the cells where partners lie.
#pragma once

#include "programs/draw/slice.hpp"
#include "programs/draw/svg.hpp"

#include <string>

namespace draw {

// Maps the window of a plane to a frame; v points up, as in a plot.
struct View {
  Window window;
  Frame frame;

  // The window at the given place, its longer side `side` pixels long.
  static View fit(const Window &window, Point corner, double side);

  double scale() const { return frame.width / window.width; }  // pixels per length
  Point point(double u, double v) const {
    return {frame.x + (u - window.u) * scale(), frame.y + frame.height - (v - window.v) * scale()};
  }
};

// All disks that show, coloured by level.
void draw_disks(Svg &svg, const Slice &slice, const View &view);

// The lines between the cells of a level, counted from the corner of the box.
void draw_cells(Svg &svg, const Slice &slice, const View &view, double cell_size, const std::string &style);

// The cells of a finer level in which partners of a particle can lie (Eq. 4 of the paper) as one shaded rectangle.
void draw_partner_cells(Svg &svg, const Slice &slice, const View &view, const Disk &disk, double cell_size,
                        const std::string &style);

}  // namespace draw
