// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks that a text, taken as a particle file, is read or refused as expected.
//
// They return plain values and print what differs: cmocka leaves a failed test by a jump, so nothing with a destructor
// may be alive where a test asserts.
#pragma once

#include "particles/error.hpp"
#include "particles/files/reader.hpp"
#include "particles/particle_set.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace test {

// A file in the current folder that is gone at the end.
class ScratchFile {
 public:
  ScratchFile(const std::string &ending, const std::string &text)
      : name_("scratch_" + std::to_string(getpid()) + ending) {
    std::ofstream(name_, std::ios::binary) << text;
  }
  ~ScratchFile() { std::remove(name_.c_str()); }
  ScratchFile(const ScratchFile &) = delete;
  ScratchFile &operator=(const ScratchFile &) = delete;
  const std::string &name() const { return name_; }

 private:
  std::string name_;
};

inline bool same(const particles::ParticleSet &a, const particles::ParticleSet &b) {
  bool equal = a.dimension == b.dimension && a.centers == b.centers && a.radii == b.radii && a.has_box == b.has_box;
  for (int axis = 0; axis < 3; axis++)
    equal = equal && a.box_min[axis] == b.box_min[axis] && a.box_max[axis] == b.box_max[axis] &&
            a.periodic[axis] == b.periodic[axis] && a.tilt[axis] == b.tilt[axis];
  return equal;
}

inline void print(const char *title, const particles::ParticleSet &set) {
  std::fprintf(stderr, "%s: dimension %d, box %d\n", title, set.dimension, set.has_box);
  for (int axis = 0; axis < 3; axis++)
    std::fprintf(stderr, "  axis %d: %.17g .. %.17g periodic %d, tilt %.17g\n", axis, set.box_min[axis],
                 set.box_max[axis], set.periodic[axis], set.tilt[axis]);
  for (const double place : set.centers) std::fprintf(stderr, "  center %.17g\n", place);
  for (const double radius : set.radii) std::fprintf(stderr, "  radius %.17g\n", radius);
}

// Whether the text is read as `expected`.
inline bool reads(const std::string &ending, const std::string &text, const particles::ParticleSet &expected,
                  const particles::ReadOptions &options = {}) {
  const ScratchFile file(ending, text);
  try {
    const particles::ParticleSet found = particles::read_particles(file.name(), options);
    if (same(found, expected)) return true;
    print("found", found);
    print("expected", expected);
  } catch (const particles::Error &error) {
    std::fprintf(stderr, "refused: %s\n", error.what());
  }
  return false;
}

// Whether the text is refused with "NAME:" and exactly this message.
inline bool refuses(const std::string &ending, const std::string &text, const std::string &message,
                    const particles::ReadOptions &options = {}) {
  const ScratchFile file(ending, text);
  try {
    const particles::ParticleSet found = particles::read_particles(file.name(), options);
    print("read instead of refused", found);
  } catch (const particles::Error &error) {
    if (error.what() == file.name() + ":" + message) return true;
    std::fprintf(stderr, "refused with  %s\ninstead of    %s:%s\n", error.what(), file.name().c_str(), message.c_str());
  }
  return false;
}

struct Refusal {
  std::string text, message;
};

inline bool refuses_each(const std::string &ending, const std::vector<Refusal> &refusals) {
  return std::all_of(refusals.begin(), refusals.end(),
                     [&](const Refusal &refusal) { return refuses(ending, refusal.text, refusal.message); });
}

inline particles::ReadOptions of_dimension(int dimension) {
  particles::ReadOptions options;
  options.dimension = dimension;
  return options;
}

inline particles::ReadOptions of_frame(size_t frame) {
  particles::ReadOptions options;
  options.frame = frame;
  return options;
}

inline particles::ParticleSet set_of(int dimension, std::vector<double> centers, std::vector<double> radii) {
  particles::ParticleSet set;
  set.dimension = dimension;
  set.centers = std::move(centers);
  set.radii = std::move(radii);
  return set;
}

inline particles::ParticleSet with_box(particles::ParticleSet set, const double (&low)[3], const double (&high)[3],
                                       const int (&periodic)[3]) {
  set.has_box = true;
  for (int axis = 0; axis < 3; axis++) {
    set.box_min[axis] = low[axis];
    set.box_max[axis] = high[axis];
    set.periodic[axis] = periodic[axis];
  }
  return set;
}

inline particles::ParticleSet with_tilt(particles::ParticleSet set, const double (&tilt)[3]) {
  std::copy_n(tilt, 3, set.tilt);
  return set;
}

}  // namespace test
