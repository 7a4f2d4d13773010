// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Walls beside those of the box: planes, cylinders and triangle meshes, rigid bodies that move as they are told.
#pragma once

#include <string>
#include <vector>

namespace dem {

enum class WallShape { kPlane, kCylinder, kMesh };

// How far a wall has come from where the scene puts it.
struct WallPlace {
  double shift[3]{};
  double angle = 0;
  double press_speed = 0;  // of a plane that presses
};

// Vectors have as many components that count as the setup has dimensions. With t the time since the setup began, the
// wall is shifted by velocity t + swing sin(2 pi frequency t) and turned by turning t about the axis through the pivot,
// which the shift takes along; both on top of `start`.
struct WallBody {
  std::string name;
  WallShape shape = WallShape::kPlane;
  double point[3]{};   // on the plane, on the cylinder's axis
  double normal[3]{};  // of length 1: of the plane, to the side of the particles; along the cylinder's axis (3D)
  double radius = 0;   // of the cylinder, which holds particles inside
  std::vector<double> corners;  // of the mesh, [count][3 corners][3]

  int material = -1;  // -1: none (materials)

  double velocity[3]{}, swing[3]{};
  double frequency = 0;
  double turning = 0;  // angle per time
  double axis[3]{0, 0, 1}, pivot[3]{};

  // A plane that presses: it moves along its normal so that particles bear this force, no faster than `fastest`.
  double force = 0, fastest = 0;

  WallPlace start;

  bool presses() const { return force > 0; }
};

}  // namespace dem
