// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Walls as they are looked at: each shape against what geometry says, and their file.
#include "dem/output/wall_shapes.hpp"
#include "particles/error.hpp"
#include "particles/files/walls_vtp.hpp"
#include "tests/dem/wall_bodies.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using bodies::near;
using particles::Bounds;
using particles::Point;
using particles::WallPart;
using particles::WallShapes;

// Walls of a box that ends in walls along the axes of these bits, without particles.
struct Scene {
  dem::Setup setup;
  particles::ParticleSet state;
  std::vector<dem::WallReport> reports;

  Scene(int dimension, const std::vector<dem::WallBody> &walls) : setup(bodies::with_walls(dimension, walls)) {
    state.dimension = dimension;
    for (const dem::WallBody &wall : walls) reports.push_back({wall.name, {}, {}, 0, 0});
  }

  Scene &box(const Point &high, unsigned walled, unsigned periodic = 0) {
    state.has_box = true;
    for (size_t axis = 0; axis < 3; axis++) {
      setup.box_max[axis] = state.box_max[axis] = high[axis];
      setup.walled[axis] = (walled >> axis & 1) != 0;
      setup.periodic[axis] = (periodic >> axis & 1) != 0;
    }
    return *this;
  }

  WallShapes shapes() const { return output::wall_shapes(setup, reports, state); }
};

// Of all parts of a wall.
Bounds bounds_of(const std::vector<WallPart> &parts, int64_t wall) {
  Bounds bounds;
  for (const WallPart &part : parts) {
    for (const Point &point : part.points) {
      if (part.wall == wall) bounds.hold(point);
    }
  }
  return bounds;
}

size_t count_of(const std::vector<WallPart> &parts, int64_t wall) {
  size_t count = 0;
  for (const WallPart &part : parts) count += part.wall == wall ? 1 : 0;
  return count;
}

double area_of(const std::vector<WallPart> &faces, int64_t wall) {
  double sum = 0;
  for (const WallPart &face : faces) {
    for (size_t k = 1; face.wall == wall && k + 1 < face.points.size(); k++) {
      double u[3], v[3];
      for (size_t c = 0; c < 3; c++) {
        u[c] = face.points[k][c] - face.points[0][c];
        v[c] = face.points[k + 1][c] - face.points[0][c];
      }
      sum += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    }
  }
  return sum;
}

bool spans(const Bounds &bounds, const Point &low, const Point &high, const char *what) {
  bool good = true;
  for (size_t axis = 0; axis < 3; axis++) {
    good = near(bounds.low[axis], low[axis], 1e-6, what) && near(bounds.high[axis], high[axis], 1e-6, what) && good;
  }
  return good;
}

// x + z = 3 in a box of edges 2, 3, 4: from (0, 3) to (2, 1), and y across.
void planes_reach_the_box(void **) {
  const double s = std::sqrt(0.5);
  Scene scene(3, {bodies::plane({1, 1.5, 2}, {s, 0, s})});
  WallShapes shapes = scene.box({2, 3, 4}, 7).shapes();
  assert_true(spans(bounds_of(shapes.faces, 0), {0, 0, 1}, {2, 3, 3}, "tilted plane"));
  assert_true(near(area_of(shapes.faces, 0), 6 * std::sqrt(2.0), 1e-6, "its area"));
  // Shifted by 2 along its normal's components it is x + z = 5, which cuts a corner off.
  scene.reports[0].place.shift[0] = scene.reports[0].place.shift[2] = 1;
  shapes = scene.shapes();
  assert_true(spans(bounds_of(shapes.faces, 0), {1, 0, 3}, {2, 3, 4}, "shifted plane"));
  scene.reports[0].place.shift[2] = 9;
  assert_int_equal(count_of(scene.shapes().faces, 0), 0);

  Scene flat(2, {bodies::plane({0, 1}, {0, 1})});
  assert_true(spans(bounds_of(flat.box({4, 3, 0}, 3).shapes().lines, 0), {0, 1, 0}, {4, 1, 0}, "in two dimensions"));
}

void without_a_box_planes_reach_what_there_is(void **) {
  Scene scene(3, {bodies::plane({0, 0, -1}, {0, 0, 1}), bodies::cylinder({0, 0, 0}, 5)});
  scene.setup.walls[0].name = "floor";
  const double centers[2][3] = {{1, 0, 0}, {-2, 1, 6}};
  for (const double(&center)[3] : centers) scene.state.add(center, 1);
  const WallShapes shapes = scene.shapes();
  const Bounds tube = bounds_of(shapes.faces, 1);
  assert_true(near(tube.low[2], -1, 1e-9, "cylinder from") && near(tube.high[2], 7, 1e-9, "to"));
  const Bounds floor = bounds_of(shapes.faces, 0);
  assert_true(near(floor.low[0], tube.low[0], 1e-6, "floor from") && near(floor.high[1], tube.high[1], 1e-6, "to"));
}

void cylinders_are_round(void **) {
  Scene scene(3, {bodies::cylinder({2, 3, 0}, 1.5)});
  scene.reports[0].place.shift[0] = 0.25;
  const WallShapes shapes = scene.box({5, 6, 7}, 0).shapes();
  for (const WallPart &line : shapes.lines) {
    for (const Point &point : line.points) {
      if (line.wall == 0) assert_true(std::fabs(std::hypot(point[0] - 2.25, point[1] - 3) - 1.5) < 1e-12);
    }
  }
  assert_int_equal(count_of(shapes.lines, 0), 2);
  assert_true(near(area_of(shapes.faces, 0), 2 * dem::kPi * 1.5 * 7, 0.1, "area"));
}

// A cube of edge 2 about (5, 0, 0), two triangles a side, one of which goes round the other way.
dem::WallBody cube() {
  std::vector<bodies::Corner> corners;
  for (size_t axis = 0; axis < 3; axis++) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](double u, double v) {
        bodies::Corner corner(3, 0.0);
        corner[axis] = side;
        corner[(axis + 1) % 3] = u;
        corner[(axis + 2) % 3] = v;
        corner[0] += 5;
        return corner;
      };
      for (const bodies::Corner &corner : {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1), at(1, 1), at(-1, -1)})
        corners.push_back(corner);
    }
  }
  return bodies::mesh(corners);
}

void meshes_show_their_edges(void **) {
  Scene scene(3, {cube(), bodies::tiled_floor(3, 4)});
  scene.reports[0].place.angle = dem::kPi / 2;  // about z through the origin
  const WallShapes shapes = scene.shapes();
  assert_int_equal(count_of(shapes.lines, 0), 12);
  assert_int_equal(count_of(shapes.faces, 0), 12);
  assert_true(spans(bounds_of(shapes.faces, 0), {-1, 4, -1}, {1, 6, 1}, "turned cube"));
  assert_int_equal(count_of(shapes.lines, 1), 4 * 4);  // the rim of a flat floor
}

void boxes_show_their_sides(void **) {
  const auto counts = [](const WallShapes &shapes, size_t lines, size_t faces) {
    std::printf("%zu lines, %zu faces\n", shapes.lines.size(), shapes.faces.size());
    return shapes.lines.size() == lines && shapes.faces.size() == faces;
  };
  assert_true(counts(Scene(3, {}).box({2, 3, 4}, 4, 3).shapes(), 12, 2));
  assert_true(counts(Scene(3, {}).box({2, 3, 4}, 4, 0).shapes(), 8, 2));  // open sideways: floor and lid
  assert_true(counts(Scene(2, {}).box({2, 3, 0}, 1).shapes(), 2, 0));
  assert_true(counts(Scene(2, {}).box({2, 3, 0}, 0, 3).shapes(), 4, 0));
  assert_true(counts(Scene(3, {}).shapes(), 0, 0));
  Scene tilted(3, {});
  tilted.box({2, 3, 4}, 0, 7).state.tilt[1] = 0.5;
  assert_true(spans(bounds_of(tilted.shapes().lines, -1), {0, 0, 0}, {2.5, 3, 4}, "tilted box"));
}

void files_come_back(void **) {
  Scene scene(3, {cube(), bodies::plane({1, 1.5, 2}, {0.6, 0, 0.8})});
  const WallShapes shapes = scene.box({2, 3, 4}, 7).shapes();
  const std::string path = "walls-test.vtp";
  particles::write_walls(path, 0.5, shapes);
  const WallShapes read = particles::read_walls(path);
  const auto same = [](const std::vector<WallPart> &a, const std::vector<WallPart> &b) {
    bool good = a.size() == b.size();
    for (size_t k = 0; good && k < a.size(); k++)
      good = a[k].kind == b[k].kind && a[k].wall == b[k].wall && a[k].points == b[k].points;
    return good;
  };
  assert_true(same(read.lines, shapes.lines) && same(read.faces, shapes.faces));
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string head = "\" NumberOfComponents=\"1\" format=\"ascii\">";
  const std::pair<std::string, std::string> faults[] = {
      {"\"kind\"", "\"kinds\""},
      {"\"points\"", "\"corners\""},
      {"<Polys>", "<Polygons>"},
      {"offsets", "ends"},
      {"kind" + head + "0 ", "kind" + head + "1e300 "},
      {"connectivity" + head + "0 ", "connectivity" + head + "99999 "},
      {"offsets" + head + "2 ", "offsets" + head + "1e300 "}};
  for (const auto &[word, instead] : faults) {
    std::string broken = text;
    assert_true(broken.find(word) != std::string::npos);
    broken.replace(broken.find(word), word.size(), instead);
    std::ofstream(path) << broken;
    std::string said;
    try {
      particles::read_walls(path);
    } catch (const particles::Error &error) {
      said = error.what();
    }
    std::printf("%s: %s\n", instead.c_str(), said.c_str());
    assert_int_equal(said.find(path), 0);
  }
  std::remove(path.c_str());
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(planes_reach_the_box),   cmocka_unit_test(without_a_box_planes_reach_what_there_is),
      cmocka_unit_test(cylinders_are_round),    cmocka_unit_test(meshes_show_their_edges),
      cmocka_unit_test(boxes_show_their_sides), cmocka_unit_test(files_come_back),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
