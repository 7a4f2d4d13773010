// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run.
#include "dem/output/recorder.hpp"

#include "dem/engine/region_content.hpp"
#include "dem/output/network.hpp"
#include "dem/output/picture.hpp"
#include "dem/output/wall_shapes.hpp"
#include "particles/error.hpp"
#include "particles/files/walls_vtp.hpp"
#include "particles/files/writer.hpp"
#include "particles/text/formatted.hpp"

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <utility>

namespace output {
namespace {

constexpr const char *kEnergies =
    "step,time,energy,translation,rotation,contact,gravity,contacts,wall_contacts,largest_overlap,"
    "wall_work";
constexpr const char *kWork = ",dashpot,friction,rolling,drag,input,balance";
constexpr const char *kBulk =
    "step,time,pressure,stress_xx,stress_yy,stress_zz,stress_xy,stress_xz,stress_yz,kinetic_xx,kinetic_yy,kinetic_zz,"
    "kinetic_xy,kinetic_xz,kinetic_yz,coordination,backbone,rattlers,fabric_xx,fabric_yy,fabric_zz,fabric_xy,fabric_xz,"
    "fabric_yz,temperature";

constexpr const char *kWalls = "step,time,wall,shift_x,shift_y,shift_z,angle,force_x,force_y,force_z,torque,work";
constexpr const char *kRegions = "step,time,region,count,mass,fraction,flow_x,flow_y,flow_z";
constexpr const char *kPassages = "step,time,name,count,mass,waiting";

std::string bulk_row(const dem::Measurement &m) {
  const dem::Bulk &bulk = m.bulk;
  std::vector<double> numbers = {m.time, bulk.pressure};
  numbers.insert(numbers.end(), std::begin(bulk.stress), std::end(bulk.stress));
  numbers.insert(numbers.end(), std::begin(bulk.kinetic_stress), std::end(bulk.kinetic_stress));
  numbers.insert(numbers.end(), {bulk.coordination, bulk.backbone, static_cast<double>(bulk.rattlers)});
  numbers.insert(numbers.end(), std::begin(bulk.fabric), std::end(bulk.fabric));
  numbers.push_back(bulk.temperature);
  return row_of(numbers);
}

std::string energy_row(const dem::Measurement &m, bool work) {
  const std::string counts =
      particles::formatted(",%zu,%zu,%.6g,%.17g", m.contacts, m.wall_contacts, m.largest_overlap, m.wall_work);
  const std::string energies = row_of({m.time, m.energy(), m.translation, m.rotation, m.contact, m.gravity}) + counts;
  if (!work) return energies;
  return energies + "," +
         row_of({m.work.dashpot, m.work.friction, m.work.rolling, m.work.drag, m.work.input, m.balance()});
}

}  // namespace

Recorder::Recorder(std::string directory, Asked asked, uint64_t done)
    : directory_(std::move(directory)), asked_(std::move(asked)), done_(done) {
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  if (error) throw particles::Error(directory_ + ": cannot make this folder: " + error.message());
  const std::string header = std::string(kEnergies) + (asked_.work ? kWork : "");
  energies_ = std::make_unique<CsvTable>(directory_ + "/energy.csv", header, done);
  if (asked_.bulk) bulk_ = std::make_unique<CsvTable>(directory_ + "/bulk.csv", kBulk, done);
  if (done == 0) return;
  animation_ = files_until(directory_ + "/states.pvd", name_of_step("state", done, "vtp"));
  wall_pictures_ = files_until(directory_ + "/walls.pvd", name_of_step("walls", done, "vtp"));
  if (asked_.contacts) networks_ = files_until(directory_ + "/contacts.pvd", name_of_step("contacts", done, "vtp"));
}

void Recorder::picture(const dem::Setup &setup, uint64_t step, dem::Engine &engine) {
  dem::Snapshot state = engine.snapshot();
  const double time = state.time;
  const particles::ParticleSet set = picture_of(setup, step, std::move(state));
  for (const std::string &format : asked_.formats) {
    const std::string name = name_of_step("state", step, format);
    particles::write_picture(directory_ + "/" + name, *particles::format_of_word(format), set);
    if (format != "vtp") continue;
    animation_.push_back({time, name});
    write_animation(directory_ + "/states.pvd", animation_);
  }
  const particles::WallShapes walls = wall_shapes(setup, engine.walls_now(), set);
  if (!walls.empty()) {
    wall_pictures_.push_back({time, name_of_step("walls", step, "vtp")});
    particles::write_walls(directory_ + "/" + wall_pictures_.back().name, time, walls);
    write_animation(directory_ + "/walls.pvd", wall_pictures_);
  }
  if (!asked_.contacts) return;
  networks_.push_back({time, name_of_step("contacts", step, "vtp")});
  write_network(directory_ + "/" + networks_.back().name, time, engine.contacts());
  write_animation(directory_ + "/contacts.pvd", networks_);
}

void Recorder::measurement(uint64_t step, const dem::Measurement &m) {
  energies_->add(step, energy_row(m, asked_.work));
  if (bulk_) bulk_->add(step, bulk_row(m));
}

void Recorder::walls(uint64_t step, double time, const std::vector<dem::WallReport> &walls) {
  if (walls.empty()) return;
  CsvTable &rows = table(walls_, "walls.csv", kWalls);
  for (const dem::WallReport &wall : walls) {
    const double *shift = wall.place.shift, *push = wall.push;
    rows.add(step, row_of({time}) + "," + wall.name + "," +
                       row_of({shift[0], shift[1], shift[2], wall.place.angle, push[0], push[1], push[2], wall.torque,
                               wall.work}));
  }
}

void Recorder::regions(uint64_t step, const std::vector<dem::Region> &regions, dem::Engine &engine) {
  if (regions.empty()) return;
  CsvTable &rows = table(regions_, "regions.csv", kRegions);
  const dem::Snapshot state = engine.snapshot();
  for (const dem::Region &region : regions) {
    const dem::RegionContent in = dem::content_of(region, state);
    rows.add(step, row_of({state.time}) + "," + region.name + "," + std::to_string(in.count) + "," +
                       row_of({in.mass, in.fraction, in.flow[0], in.flow[1], in.flow[2]}));
  }
}

void Recorder::passages(uint64_t step, double time, const std::vector<dem::Passage> &passages) {
  if (passages.empty()) return;
  CsvTable &rows = table(passages_, "exchange.csv", kPassages);
  for (const dem::Passage &passage : passages) {
    rows.add(step, row_of({time}) + "," + passage.name + "," + std::to_string(passage.count) + "," +
                       row_of({passage.mass}) + "," + std::to_string(passage.waiting));
  }
}

CsvTable &Recorder::table(std::unique_ptr<CsvTable> &table, const char *name, const char *header) const {
  if (!table) table = std::make_unique<CsvTable>(directory_ + "/" + name, header, done_);
  return *table;
}

}  // namespace output
