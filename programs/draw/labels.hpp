// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Words beside points of a picture, placed where they cover nothing.
#pragma once

#include "programs/draw/svg.hpp"

#include <optional>
#include <string>
#include <vector>

namespace draw {

// Remembers what is taken and finds free places. What must not be covered is told first.
class Labels {
 public:
  // Words stay inside the frame.
  explicit Labels(const Frame &inside) : inside_(inside) {}

  void avoid_point(Point center, double radius);
  void avoid_line(Point from, Point to);

  // The nearest free place at most `reach` pixels from the point, its lower left corner: taken from now on. None if all
  // are taken.
  std::optional<Point> place(Point point, const std::string &words, double size, double reach);

  // The width of words in the font of all pictures, on average.
  static double width_of(const std::string &words, double size);

 private:
  bool is_free(const Frame &box) const;

  Frame inside_;
  std::vector<Frame> taken_;
  std::vector<Point> lines_;  // pairs of ends
};

}  // namespace draw
