// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The walls around particles as flat faces and as lines, to be looked at.
#pragma once

#include "particles/clipping.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace particles {

enum class WallKind : int64_t { kBox, kPlane, kCylinder, kMesh };

// What goes on as far as it is looked at.
inline bool has_no_end(WallKind kind) { return kind == WallKind::kBox || kind == WallKind::kPlane; }

struct WallPart {
  WallKind kind = WallKind::kBox;
  int64_t wall = -1;          // its number in the scene, from 0; -1 for the box
  std::vector<Point> points;  // of a face, convex; or of a line from point to point
};

struct WallShapes {
  std::vector<WallPart> lines, faces;

  bool empty() const { return lines.empty() && faces.empty(); }
};

}  // namespace particles
