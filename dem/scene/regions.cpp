// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The regions of a scene.
#include "dem/scene/regions.hpp"

#include "dem/base/error.hpp"
#include "dem/base/vector.hpp"
#include "dem/scene/materials.hpp"
#include "dem/scene/particles.hpp"
#include "dem/scene/size_laws.hpp"
#include "packing/random.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scene {
namespace {

std::string name_of(const Table &table, const char *kind, size_t number) {
  return table.text("name", std::string(kind) + "-" + std::to_string(number + 1));
}

void read_box(const Table &table, int dimension, dem::Region &region) {
  const auto width = static_cast<size_t>(dimension);
  const std::vector<double> low = table.vector("min", width), high = table.vector("max", width);
  for (size_t axis = 0; axis < width; axis++) {
    if (!(high[axis] > low[axis])) table.fail("max", dem::text(high[axis]) + " is not above " + dem::text(low[axis]));
  }
  std::copy(low.begin(), low.end(), region.low);
  std::copy(high.begin(), high.end(), region.high);
}

void read_plane(const Table &table, const dem::Setup &setup, dem::Region &region) {
  const auto width = static_cast<size_t>(setup.dimension);
  region.is_box = false;
  const std::vector<double> point = table.vector("point", width), normal = table.vector("normal", width);
  std::copy(point.begin(), point.end(), region.point);
  std::copy(normal.begin(), normal.end(), region.normal);
  if (!(std::hypot(region.normal[0], region.normal[1], region.normal[2]) > 0)) table.fail("normal", "is no direction");
  for (size_t axis = 0; axis < width; axis++) {
    if (setup.periodic[axis] && region.normal[axis] != 0)
      table.fail("normal", std::string("the plane does not go along the periodic axis ") + "xyz"[axis]);
  }
}

// In the order in which they come.
std::vector<double> read_radii(const Table &table, const std::string &folder, int dimension,
                               const dem::Inflow &inflow) {
  constexpr uint64_t kMost = 10000;  // before the same sizes come again
  const auto radii = table.part("radii");
  if (!radii && !(table.number("radius") > 0)) table.fail("radius", "is not above 0");
  if (!radii) return {table.number("radius")};
  const packing::SizeLaw law = read_law(*radii, folder, dimension);
  const auto count = static_cast<size_t>(std::min(inflow.most, kMost));
  const std::string fault = packing::law_fault(law, count);
  if (!fault.empty()) table.fail("radii", fault);
  std::vector<double> result = packing::sample_radii(law, count, 0.5);
  const double first = packing::first_radius(law), radius = table.number("radius", first);
  if (!(radius > 0)) table.fail("radius", "is not above 0");
  for (double &value : result) value *= radius / first;
  packing::Random random(inflow.seed);
  packing::shuffle(result, random);
  return result;
}

dem::Inflow read_inflow(const Table &table, const std::string &folder, const dem::Setup &setup) {
  dem::Inflow inflow;
  inflow.box.name = name_of(table, "inflow", setup.inflows.size());
  read_box(table, setup.dimension, inflow.box);
  inflow.rate = table.number("rate");
  if (!(inflow.rate > 0)) table.fail("rate", dem::text(inflow.rate) + " is not above 0");
  inflow.most = table.count("count", inflow.most);
  if (inflow.most == 0) table.fail("count", "is 0: leave the table away");
  inflow.until = table.number("until", inflow.until);
  inflow.seed = table.count("seed", inflow.seed);
  const std::vector<double> velocity = table.vector("velocity", static_cast<size_t>(setup.dimension), 0);
  std::copy(velocity.begin(), velocity.end(), inflow.velocity);
  inflow.material = material_of_group(table, setup);
  inflow.radii = read_radii(table, folder, setup.dimension, inflow);
  const double density = density_of(table, setup, inflow.material);
  for (const double radius : inflow.radii)
    inflow.masses.push_back(density * dem::volume_of_particle(radius, setup.dimension));
  const double largest = *std::max_element(inflow.radii.begin(), inflow.radii.end());
  for (int axis = 0; axis < setup.dimension; axis++) {
    const double low = inflow.box.low[axis], high = inflow.box.high[axis];
    if (high - low < 2 * largest)
      table.fail("max", "the largest particle, of radius " + dem::text(largest) + ", does not fit into the box");
    if (setup.walled[axis] && (low < setup.box_min[axis] || high > setup.box_max[axis]))
      table.fail("max", std::string("the box reaches behind the walls of axis ") + "xyz"[axis]);
  }
  return inflow;
}

void expect(const dem::Inflow &inflow, int dimension, dem::ParticleArrays &expected) {
  const auto [smallest, largest] = std::minmax_element(inflow.radii.begin(), inflow.radii.end());
  for (const auto &radius : {smallest, smallest, largest, largest}) {
    // Two low, two high in the box: there are falls from either.
    const double(&corner)[3] = expected.count() % 2 == 0 ? inflow.box.low : inflow.box.high;
    expected.centers.insert(expected.centers.end(), corner, corner + dimension);
    expected.velocities.insert(expected.velocities.end(), inflow.velocity, inflow.velocity + dimension);
    expected.radii.push_back(*radius);
    expected.masses.push_back(inflow.masses[static_cast<size_t>(radius - inflow.radii.begin())]);
    if (inflow.material >= 0) expected.material_ids.push_back(static_cast<uint8_t>(inflow.material));
  }
}

template <class Item, class NameOf>
void require_own_name(const Table &table, const std::vector<Item> &others, const std::string &name, NameOf name_of) {
  const auto same = [&](const Item &other) { return name_of(other) == name; };
  if (std::any_of(others.begin(), others.end(), same)) table.fail("name", "'" + name + "' is there already");
}

}  // namespace

void read_exchange(const Table &top, const std::string &folder, dem::Setup &setup) {
  for (const Table &table : top.parts("inflow")) {
    dem::Inflow inflow = read_inflow(table, folder, setup);
    require_own_name(table, setup.inflows, inflow.box.name, [](const dem::Inflow &other) { return other.box.name; });
    expect(inflow, setup.dimension, setup.expected);
    setup.inflows.push_back(std::move(inflow));
  }
  for (const Table &table : top.parts("removal")) {
    dem::Region removal;
    removal.name = name_of(table, "removal", setup.removals.size());
    const bool by_plane = table.has("point") || table.has("normal");
    if (by_plane && (table.has("min") || table.has("max"))) table.fail("point", "stands instead of min and max");
    if (by_plane) {
      read_plane(table, setup, removal);
    } else {
      read_box(table, setup.dimension, removal);
    }
    require_own_name(table, setup.removals, removal.name, [](const dem::Region &other) { return other.name; });
    setup.removals.push_back(std::move(removal));
  }
  const auto is_taken = [&](const dem::Region &removal) {
    return std::any_of(setup.inflows.begin(), setup.inflows.end(),
                       [&](const dem::Inflow &inflow) { return inflow.box.name == removal.name; });
  };
  if (std::any_of(setup.removals.begin(), setup.removals.end(), is_taken))
    top.fail("removal", "an inflow has the same name");
}

std::vector<dem::Region> read_regions(const Table &top, int dimension) {
  std::vector<dem::Region> regions;
  for (const Table &table : top.parts("region")) {
    dem::Region region;
    region.name = name_of(table, "region", regions.size());
    read_box(table, dimension, region);
    require_own_name(table, regions, region.name, [](const dem::Region &other) { return other.name; });
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace scene
