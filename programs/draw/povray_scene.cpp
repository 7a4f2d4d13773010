// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "programs/draw/povray_scene.hpp"

#include "particles/clipping.hpp"
#include "particles/text/formatted.hpp"
#include "programs/draw/palette.hpp"
#include "programs/draw/povray_space.hpp"
#include "programs/draw/povray_walls.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace draw {
namespace {

using particles::Bounds;
using particles::formatted;
using particles::Point;

constexpr int kSteps = 64;  // of colour
constexpr double kBar = 0.7, kThick = 0.022, kLetter = 0.045, kMargin = 0.05;

// The axes of the picture: to its right, upwards, and away from the viewer.
struct Camera {
  Vector right, up, away;
};

Camera camera_of(int dimension) {
  if (dimension == 2) return {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  const Vector view{4, -6, 4.2};
  const double flat = std::hypot(view.x, view.y), length = std::hypot(flat, view.z);
  const Vector away = (-1 / length) * view, right = {-view.y / flat, view.x / flat, 0};
  // right x away, for right has no height.
  const Vector up = {right.y * away.z, -right.x * away.z, right.x * away.y - right.y * away.x};
  return {right, up, away};
}

Point center_of(const particles::ParticleSet &set, size_t i) {
  const double *center = set.center(i);
  return upright({center[0], center[1], set.dimension == 2 ? 0 : center[2]}, set.dimension);
}

// The edges of a box are drawn where no walls are known.
bool shows_edges(const particles::ParticleSet &set, const particles::WallShapes &walls) {
  return set.has_box && set.dimension == 3 && walls.empty();
}

// Discs are seen whole, whatever their box; it may be far larger than what is left in it.
Bounds view_of(const particles::ParticleSet &set, const particles::WallShapes &walls) {
  Bounds view;
  for (size_t i = 0; i < set.count(); i++) view.hold(center_of(set, i), set.radii[i]);
  if (shows_edges(set, walls)) {
    view.hold({set.box_min[0], set.box_min[1], set.box_min[2]});
    view.hold({set.box_max[0], set.box_max[1], set.box_max[2]});
  }
  if (!walls.empty()) hold_walls(view, walls, set.dimension);
  return view;
}

// Of a share from 0, dark, to 1, light.
std::string color_of(double share) {
  constexpr size_t kLast = std::size(kShades) - 1;
  const double place = (1 - share) * static_cast<double>(kLast);
  const size_t below = std::min(static_cast<size_t>(place), kLast - 1);
  const Color color = mix(kShades[below], kShades[below + 1], place - static_cast<double>(below));
  return formatted("srgb <%.3f,%.3f,%.3f>", color.red / 255, color.green / 255, color.blue / 255);
}

class Scale {
 public:
  explicit Scale(const Shading &shading) : logarithmic_(shading.logarithmic) {
    const auto [low, high] = std::minmax_element(shading.values.begin(), shading.values.end());
    low_ = *low;
    high_ = *high;
  }

  bool is_one() const { return !(high_ > low_); }
  double low() const { return low_; }
  double high() const { return high_; }
  // Equal values have the shade of a single level in slices.
  double share(double value) const {
    if (is_one()) return 1 - 2.0 / (static_cast<double>(std::size(kShades)) - 1);
    if (logarithmic_) return std::log(value / low_) / std::log(high_ / low_);
    return (value - low_) / (high_ - low_);
  }

 private:
  bool logarithmic_;
  double low_ = 0, high_ = 0;
};

// How far the corners of the box reach to the sides and upwards in the picture.
struct Reach {
  double right = 0, up = 0;
};

Reach reach_of(const Bounds &view, const Camera &camera) {
  const Vector half = placed(view.high, view);
  const auto reach = [&](const Vector &axis) {
    return std::fabs(axis.x) * half.x + std::fabs(axis.y) * half.y + std::fabs(axis.z) * half.z;
  };
  return {reach(camera.right), reach(camera.up)};
}

std::string edges_of(const particles::ParticleSet &set, const Bounds &view) {
  std::string text;
  const double low[3] = {set.box_min[0], set.box_min[1], set.box_min[2]},
               high[3] = {set.box_max[0], set.box_max[1], set.box_max[2]};
  const auto corner = [&](int bits) {
    double c[3];
    for (int axis = 0; axis < 3; axis++) c[axis] = (bits >> axis & 1) != 0 ? high[axis] : low[axis];
    // Layers of a tilted cell are shifted along x and y.
    const double up = c[2] - low[2], deep = c[1] - low[1], z = high[2] - low[2], y = high[1] - low[1];
    c[0] += set.tilt[0] * deep / y + set.tilt[1] * up / z;
    c[1] += set.tilt[2] * up / z;
    return placed({c[0], c[1], c[2]}, view);
  };
  for (int from = 0; from < 8; from++) {
    for (int axis = 0; axis < 3; axis++) {
      const int to = from | 1 << axis;
      if (to != from)
        text += "cylinder{" + text_of(corner(from)) + "," + text_of(corner(to)) + ",0.0015 texture{Edge}}\n";
    }
  }
  return text;
}

// Flat, in front of everything, below the particles.
std::string bar_of(const Shading &shading, const Scale &scale, const Camera &camera, double below) {
  std::string text = "union{\n";
  for (int k = 0; k < kSteps; k++) {
    const double left = kBar * (static_cast<double>(k) / kSteps - 0.5), share = (k + 0.5) / kSteps;
    text += formatted("box{<%.4f,0,0>,<%.4f,%.4f,0.001> pigment{color %s}}\n", left, left + 1.01 * kBar / kSteps,
                      kThick, color_of(share).c_str());
  }
  const auto word = [&](const std::string &words, double place, double share) {
    // Letters are about half as wide as high.
    return formatted("text{internal 1 \"%s\" 0.01,0 scale %.3f translate <%.4f,%.4f,0> pigment{color rgb 0.1}}\n",
                     words.c_str(), kLetter, place - share * 0.5 * kLetter * static_cast<double>(words.size()),
                     -kLetter);
  };
  text += word(formatted("%.3g", scale.low()), -kBar / 2, 0) + word(shading.name, 0, 0.5) +
          word(formatted("%.3g", scale.high()), kBar / 2, 1);
  const Vector &r = camera.right, &u = camera.up, &a = camera.away;
  const Vector origin = {-below * u.x - 3 * a.x, -below * u.y - 3 * a.y, -below * u.z - 3 * a.z};
  return text +
         formatted("matrix<%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,", r.x, r.y, r.z, u.x, u.y, u.z, a.x, a.y,
                   a.z) +
         formatted("%.5f,%.5f,%.5f> no_shadow finish{ambient 1 diffuse 0}}\n", origin.x, origin.y, origin.z);
}

}  // namespace

RenderedScene povray_scene(const particles::ParticleSet &set, const Shading &shading, bool cut,
                           const particles::WallShapes &walls) {
  const Bounds view = view_of(set, walls);
  const Camera camera = camera_of(set.dimension);
  const Scale scale(shading);
  const Reach reach = reach_of(view, camera);
  const double under = scale.is_one() ? 0 : kThick + 2 * kLetter;  // for the bar
  const double width = 2 * std::max(reach.right, 0.62 * kBar) + 2 * kMargin,
               height = 2 * reach.up + 2 * kMargin + under;
  const Vector eye = -8.0 * camera.away, middle = -under / 2 * camera.up;
  RenderedScene scene;
  scene.aspect = width / height;
  scene.text =
      "#version 3.7;\nglobal_settings { assumed_gamma 1.0 max_trace_level 64 }\nbackground { color rgb 1 }\n"
      "camera { orthographic location " +
      text_of({eye.x + middle.x, eye.y + middle.y, eye.z + middle.z}) + " direction " + text_of(camera.away) +
      " right " + text_of(width * camera.right) + " up " + text_of(height * camera.up) + " }\n" +
      "light_source { <5,-14,16> color rgb 0.86 parallel point_at 0 }\n"
      "light_source { <12,-4,3> color rgb 0.3 parallel point_at 0 shadowless }\n"
      "#default { finish { ambient 0.16 diffuse 0.72 specular 0.12 roughness 0.05 } }\n"
      "#declare Edge = texture { pigment { color rgb 0.45 } finish { ambient 1 diffuse 0 } }\n";
  for (int k = 0; k <= kSteps; k++) {
    scene.text += formatted("#declare T%d = texture { pigment { color %s } }\n", k,
                            color_of(static_cast<double>(k) / kSteps).c_str());
  }
  const double edge = view.edge();
  for (size_t i = 0; i < set.count(); i++) {
    const Vector place = placed(center_of(set, i), view);
    if (cut && place.x > 0 && place.y < 0 && place.z > 0) continue;
    const int step = static_cast<int>(std::lround(kSteps * scale.share(shading.values[i])));
    scene.text += "sphere{" + text_of(place) + formatted(",%.5f texture{T%d}}\n", set.radii[i] / edge, step);
  }
  if (shows_edges(set, walls)) scene.text += edges_of(set, view);
  scene.text += povray_walls(walls, view, set.dimension);
  if (!scale.is_one()) scene.text += bar_of(shading, scale, camera, reach.up + kMargin / 2 + kThick);
  return scene;
}

}  // namespace draw
