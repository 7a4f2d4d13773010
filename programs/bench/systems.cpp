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
#include <vector>

namespace bench {
namespace {

// LAW, RATIO, COUNT and, where it is not even, ARRANGEMENT.
std::vector<std::string> parts_of(const std::string &source) {
  std::vector<std::string> parts(1);
  for (const char letter : source) {
    if (letter == ':') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

template <class T>
T number(const std::string &source, const std::string &text) {
  T value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) {
    throw particles::Error("'" + source + "': '" + text + "' is no number");
  }
  return value;
}

packing::Request request_of(const std::string &source, const std::vector<std::string> &parts, int sweeps) {
  if (parts.size() < 3 || parts.size() > 4) {
    throw particles::Error("'" + source + "' is neither a file nor LAW:RATIO:COUNT[:ARRANGEMENT]");
  }
  packing::Request request;
  request.law = packing::law_with(parts[0], number<double>(source, parts[1]));
  request.count = number<size_t>(source, parts[2]);
  if (parts.size() > 3) request.arrangement = &packing::arrangement_called(parts[3]);
  request.density = request.arrangement->density;
  request.sweeps = sweeps;
  return request;
}

// The packing code uses the library, whose first use fixes the instruction set of a process: so not of this one.
particles::ParticleSet make_elsewhere(const std::string &source, const packing::Request &request) {
  packing::begin_packing(request);  // throws here rather than in the process that makes the packing
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
  if (const auto parts = parts_of(source); parts.size() > 1 && !std::filesystem::exists(source)) {
    const packing::Request request = request_of(source, parts, sweeps);
    const bool is_even = request.arrangement->is_even();
    system.name = is_even ? parts[0] : parts[3] + "-" + parts[0];
    system.particles = is_even ? make_elsewhere(source, request) : packing::lay_particles(request);
    return system;
  }
  system.name = std::filesystem::path(source).stem().string();
  system.particles = particles::read_particles(source);
  if (system.particles.count() == 0) throw particles::Error(source, 0, "no particles to time");
  particles::require_upright(system.particles, source);
  return system;
}

void open_axes(System &system) {
  for (int &periodic : system.particles.periodic) periodic = 0;
}

}  // namespace bench
