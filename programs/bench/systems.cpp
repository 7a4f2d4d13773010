// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Files through the readers of the command, packings through its packing code.
#include "programs/bench/systems.hpp"

#include "packing/packing.hpp"
#include "particles/error.hpp"
#include "particles/files/reader.hpp"
#include "programs/bench/child.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

namespace bench {
namespace {

template <class T>
T number(const std::string &source, const char *first, const char *last) {
  T value{};
  const auto [end, fault] = std::from_chars(first, last, value);
  if (fault != std::errc() || end != last) {
    throw particles::Error("'" + source + "': '" + std::string(first, last) + "' is no number");
  }
  return value;
}

std::optional<packing::Request> request_of(const std::string &source, int sweeps) {
  const size_t ratio = source.find(':');
  if (ratio == std::string::npos || std::filesystem::exists(source)) return std::nullopt;
  const size_t count = source.find(':', ratio + 1);
  if (count == std::string::npos) throw particles::Error("'" + source + "' is neither a file nor LAW:RATIO:COUNT");
  const char *text = source.c_str();
  packing::Request request;
  request.law = packing::law_with(source.substr(0, ratio), number<double>(source, text + ratio + 1, text + count));
  request.count = number<size_t>(source, text + count + 1, text + source.size());
  request.sweeps = sweeps;
  packing::begin_packing(request);  // throws here rather than in the process that makes the packing
  return request;
}

// The packing code uses the library, whose first use fixes the instruction set of a process: so not of this one.
particles::ParticleSet make_elsewhere(const std::string &source, const packing::Request &request) {
  Child maker(source, [&request](Channel &channel) {
    const packing::Packing packing = packing::make_packing(request, nullptr);
    channel.send_array(packing.particles.radii);
    channel.send_array(packing.particles.centers);
  });
  particles::ParticleSet set;
  set.dimension = request.law.dimension;
  set.radii = maker.channel().receive_array<double>();
  set.centers = maker.channel().receive_array<double>();
  maker.wait();
  return set;
}

}  // namespace

double System::size_ratio() const {
  const auto [smallest, largest] = std::minmax_element(particles.radii.begin(), particles.radii.end());
  return *smallest > 0 ? *largest / *smallest : 0;
}

System load_system(const std::string &source, int sweeps) {
  System system;
  if (const std::optional<packing::Request> request = request_of(source, sweeps)) {
    system.name = source.substr(0, source.find(':'));
    system.particles = make_elsewhere(source, *request);
    return system;
  }
  system.name = std::filesystem::path(source).stem().string();
  system.particles = particles::read_particles(source);
  if (system.particles.count() == 0) throw particles::Error(source, 0, "no particles to time");
  // The peers and the plain searches know open axes only, and no box.
  system.particles.has_box = false;
  for (int &periodic : system.particles.periodic) periodic = 0;
  return system;
}

}  // namespace bench
