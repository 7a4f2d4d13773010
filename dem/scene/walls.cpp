// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The walls of a scene beside those of its box.
#include "dem/scene/walls.hpp"

#include "dem/base/error.hpp"
#include "dem/scene/materials.hpp"
#include "dem/scene/stl.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace scene {
namespace {

void read_vector(const Table &table, const char *key, const dem::Setup &setup, double (&vector)[3]) {
  const std::vector<double> numbers = table.vector(key, static_cast<size_t>(setup.dimension));
  std::copy(numbers.begin(), numbers.end(), vector);
}

void read_direction(const Table &table, const char *key, const dem::Setup &setup, double (&direction)[3]) {
  read_vector(table, key, setup, direction);
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(length > 0)) table.fail(key, "is no direction");
  for (double &component : direction) component /= length;
}

void refuse(const Table &table, std::initializer_list<const char *> keys, const char *why) {
  for (const char *key : keys) {
    if (table.has(key)) table.fail(key, why);
  }
}

void read_plane(const Table &table, const dem::Setup &setup, dem::WallBody &wall) {
  refuse(table, {"axis", "pivot"}, "a plane turns about its normal");
  refuse(table, {"scale"}, "is for the mesh of a file");
  if (setup.dimension == 2) refuse(table, {"turning"}, "a plane turns about its normal, which discs do not feel");
  wall.shape = dem::WallShape::kPlane;
  read_vector(table, "point", setup, wall.point);
  read_direction(table, "normal", setup, wall.normal);
  if (setup.dimension == 3) std::copy_n(wall.normal, 3, wall.axis);
  std::copy_n(wall.point, 3, wall.pivot);
  if (table.has("force") != table.has("speed")) table.fail("force", "and speed go together");
  if (!table.has("force")) return;
  wall.force = table.number("force");
  wall.fastest = table.number("speed");
  if (!(wall.force > 0)) table.fail("force", dem::text(wall.force) + " is not above 0");
  if (!(wall.fastest > 0)) table.fail("speed", dem::text(wall.fastest) + " is not above 0");
}

void read_cylinder(const Table &table, const dem::Setup &setup, dem::WallBody &wall) {
  refuse(table, {"normal", "force", "speed"}, "is for planes");
  refuse(table, {"pivot"}, "a cylinder turns about its own axis");
  refuse(table, {"scale"}, "is for the mesh of a file");
  wall.shape = dem::WallShape::kCylinder;
  wall.radius = table.number("radius");
  if (!(wall.radius > 0)) table.fail("radius", dem::text(wall.radius) + " is not above 0");
  read_vector(table, "point", setup, wall.point);
  std::copy_n(wall.point, 3, wall.pivot);
  if (setup.dimension == 2) refuse(table, {"axis"}, "in two dimensions there is one axis only");
  if (setup.dimension == 2) return;
  read_direction(table, "axis", setup, wall.axis);
  std::copy_n(wall.axis, 3, wall.normal);
}

void read_mesh(const Table &table, const std::string &folder, const dem::Setup &setup, dem::WallBody &wall) {
  refuse(table, {"normal", "force", "speed"}, "is for planes");
  refuse(table, {"radius"}, "is for cylinders");
  if (setup.dimension == 2) table.fail("file", "in two dimensions there are no triangle meshes");
  if (has(setup.effects, dem::kPeriodic)) table.fail("file", "triangle meshes do not go together with periodic axes");
  wall.shape = dem::WallShape::kMesh;
  try {
    wall.corners = read_stl((std::filesystem::path(folder) / table.text("file", "")).string());
  } catch (const std::exception &error) {
    table.fail("file", error.what());
  }
  const double scale = table.number("scale", 1);
  if (!(scale > 0)) table.fail("scale", dem::text(scale) + " is not above 0");
  const std::vector<double> origin = table.vector("point", 3, 0);
  for (size_t k = 0; k < wall.corners.size(); k++) wall.corners[k] = scale * wall.corners[k] + origin[k % 3];
  if (table.has("axis")) read_direction(table, "axis", setup, wall.axis);
  if (table.has("pivot")) read_vector(table, "pivot", setup, wall.pivot);
}

// A plane or cylinder across a periodic axis would stand in one image only.
void check_periodic(const Table &table, const dem::Setup &setup, const dem::WallBody &wall) {
  for (size_t axis = 0; axis < static_cast<size_t>(setup.dimension); axis++) {
    if (!setup.periodic[axis]) continue;
    const bool along = wall.shape == dem::WallShape::kPlane ? wall.normal[axis] == 0
                                                            : setup.dimension == 3 && std::fabs(wall.normal[axis]) == 1;
    if (!along) {
      table.fail(wall.shape == dem::WallShape::kPlane ? "normal" : "axis",
                 std::string("the wall does not go along the periodic axis ") + "xyz"[axis]);
    }
  }
}

dem::WallBody read_wall(const Table &table, const std::string &folder, const dem::Setup &setup) {
  dem::WallBody wall;
  if (table.has("file")) {
    read_mesh(table, folder, setup, wall);
  } else if (table.has("radius")) {
    read_cylinder(table, setup, wall);
  } else {
    read_plane(table, setup, wall);
  }
  if (wall.shape != dem::WallShape::kMesh) check_periodic(table, setup, wall);
  wall.material = material_in(table, setup);
  if (table.has("velocity")) read_vector(table, "velocity", setup, wall.velocity);
  if (table.has("swing") != table.has("frequency")) table.fail("swing", "and frequency go together");
  if (table.has("swing")) read_vector(table, "swing", setup, wall.swing);
  wall.frequency = table.number("frequency", 0);
  wall.turning = table.number("turning", 0);
  return wall;
}

}  // namespace

void read_walls(const Table &top, const std::string &folder, dem::Setup &setup) {
  for (const Table &table : top.parts("wall")) {
    dem::WallBody wall = read_wall(table, folder, setup);
    wall.name = table.text("name", "wall-" + std::to_string(setup.walls.size() + 1));
    for (const dem::WallBody &other : setup.walls) {
      if (other.name == wall.name) table.fail("name", "'" + wall.name + "' is the name of another wall");
    }
    for (const dem::NamedPlace &left : setup.beginning.wall_places) {
      if (left.name == wall.name) wall.start = left.place;
    }
    setup.walls.push_back(std::move(wall));
  }
  if (!setup.walls.empty()) setup.effects |= dem::kSurfaces;
}

}  // namespace scene
