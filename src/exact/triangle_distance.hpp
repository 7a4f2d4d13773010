// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How far points are from a triangle in space, in doubles: off by less than 2^-45 of the largest coordinate, whatever
// the shape of the triangle. docs/theory/exactness.md, section 6, adds it up.
#pragma once

namespace hg {

class Triangle {
 public:
  // Three corners of three finite coordinates each.
  explicit Triangle(const double *corners);

  // The largest of the coordinates, in size.
  double size() const { return size_; }
  // Of a point that is finite, too.
  double distance(const double *point) const;

 private:
  double square_in_plane(double along, double across, double ratio) const;

  double origin_[3];  // where the longest edge begins
  double size_ = 0;
  double scale_ = 1;  // a power of two that makes coordinates small, so that squares do not overflow
  // A frame there: along the longest edge, and across it in the plane; and where the other corners are in it, scaled.
  double axis_[2][3] = {};
  double length_ = 0, apex_along_ = 0, apex_across_ = 0;
};

}  // namespace hg
