// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Embree, rtcCollide: a bounding volume hierarchy of user geometry in floats, collided with itself.
#include "programs/bench/peers/peer.hpp"

#include <embree3/rtcore.h>

#include <memory>
#include <stdexcept>

namespace bench {
namespace {

void bounds_of(const RTCBoundsFunctionArguments *arguments) {
  const Sphere &s = static_cast<const Sphere *>(arguments->geometryUserPtr)[arguments->primID];
  RTCBounds &box = *arguments->bounds_o;
  box.lower_x = float_below(s.x[0] - s.r);
  box.lower_y = float_below(s.x[1] - s.r);
  box.lower_z = float_below(s.x[2] - s.r);
  box.upper_x = float_above(s.x[0] + s.r);
  box.upper_y = float_above(s.x[1] + s.r);
  box.upper_z = float_above(s.x[2] + s.r);
}

class Finder {
 public:
  Finder(const Particles &particles, RTCBuildQuality quality)
      : particles_(particles), quality_(quality), device_(rtcNewDevice("threads=1")) {
    if (device_ == nullptr) throw std::runtime_error("Embree gives no device");
  }
  ~Finder() { rtcReleaseDevice(device_); }
  Finder(const Finder &) = delete;
  Finder &operator=(const Finder &) = delete;

  void operator()(std::vector<hg_pair> &pairs) {
    copy_spheres(particles_, spheres_);
    pairs_ = &pairs;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres_.size()));
    rtcSetGeometryUserData(geometry, spheres_.data());
    rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
    rtcCommitGeometry(geometry);
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene, quality_);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    rtcCollide(scene, scene, collect, this);
    rtcReleaseScene(scene);
    const RTCError error = rtcGetDeviceError(device_);
    if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree reports error " + std::to_string(error));
  }

 private:
  // A scene collided with itself reports both orders of a pair, and each particle with itself.
  static void collect(void *self, RTCCollision *collisions, unsigned count) {
    Finder &finder = *static_cast<Finder *>(self);
    for (unsigned k = 0; k < count; k++) {
      const int32_t a = static_cast<int32_t>(collisions[k].primID0);
      const int32_t b = static_cast<int32_t>(collisions[k].primID1);
      if (a < b) keep_if_overlapping(finder.spheres_, a, b, *finder.pairs_);
    }
  }

  Particles particles_;
  RTCBuildQuality quality_;
  RTCDevice device_;
  std::vector<Sphere> spheres_;
  std::vector<hg_pair> *pairs_ = nullptr;
};

}  // namespace

void add_embree(std::vector<Peer> &peers) {
  const std::pair<const char *, RTCBuildQuality> qualities[] = {
      {"low", RTC_BUILD_QUALITY_LOW}, {"medium", RTC_BUILD_QUALITY_MEDIUM}, {"high", RTC_BUILD_QUALITY_HIGH}};
  for (const auto &[word, quality] : qualities) {
    peers.push_back({"embree", word, [quality = quality](const Particles &particles) {
                       auto finder = std::make_shared<Finder>(particles, quality);
                       return [finder](std::vector<hg_pair> &pairs) { (*finder)(pairs); };
                     }});
  }
}

}  // namespace bench
