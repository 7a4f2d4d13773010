// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run.
#include "dem/output/recorder.hpp"

#include "dem/output/picture.hpp"
#include "dem/state/checkpoint.hpp"
#include "particles/error.hpp"
#include "particles/files/writer.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace output {
namespace {

constexpr const char *kHeader =
    "step,time,energy,translation,rotation,contact,gravity,contacts,wall_contacts,largest_overlap";

// Pictures sort by step, by name too.
std::string picture_name(uint64_t step, const std::string &format) {
  char name[48];
  std::snprintf(name, sizeof name, "state-%012llu.", static_cast<unsigned long long>(step));
  return name + format;
}

// The table up to a step, with its header; the header alone if there is none.
std::string table_until(const std::string &path, uint64_t done) {
  std::string kept = std::string(kHeader) + '\n', line;
  std::ifstream table(path);
  std::getline(table, line);
  while (std::getline(table, line) && std::strtoull(line.c_str(), nullptr, 10) <= done) kept += line + '\n';
  return kept;
}

}  // namespace

Recorder::Recorder(std::string directory, std::vector<std::string> formats, const dem::Setup &setup, uint64_t done)
    : directory_(std::move(directory)), formats_(std::move(formats)), setup_(&setup) {
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  if (error) throw particles::Error(directory_ + ": cannot make this folder: " + error.message());
  const std::string path = directory_ + "/energy.csv";
  const std::string kept = done > 0 ? table_until(path, done) : std::string(kHeader) + '\n';
  table_.reset(std::fopen(path.c_str(), "w"));
  if (!table_ || std::fputs(kept.c_str(), table_.get()) < 0) {
    throw particles::Error(path + ": cannot write: " + std::strerror(errno));
  }
  if (done == 0) return;
  for (const TimedFile &file : read_animation(directory_ + "/states.pvd")) {
    if (file.name <= picture_name(done, "vtp")) animation_.push_back(file);
  }
}

void Recorder::picture(uint64_t step, dem::Snapshot state) {
  const double time = state.time;
  const particles::ParticleSet set = picture_of(*setup_, step, std::move(state));
  for (const std::string &format : formats_) {
    const std::string name = picture_name(step, format);
    particles::write_picture(directory_ + "/" + name, *particles::format_of_word(format), set);
    if (format != "vtp") continue;
    animation_.push_back({time, name});
    write_animation(directory_ + "/states.pvd", animation_);
  }
}

void Recorder::energies(uint64_t step, const dem::Measurement &m) {
  std::FILE *out = table_.get();
  std::fprintf(out, "%llu,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%zu,%zu,%.6g\n", static_cast<unsigned long long>(step),
               m.time, m.energy(), m.translation, m.rotation, m.contact, m.gravity, m.contacts, m.wall_contacts,
               m.largest_overlap);
  if (std::fflush(out) != 0) throw particles::Error(directory_ + "/energy.csv: cannot write: " + std::strerror(errno));
}

void Recorder::checkpoint(const dem::Engine &engine) {
  dem::Checkpoint checkpoint;
  engine.save(checkpoint);
  checkpoint.write(checkpoint_path());
}

}  // namespace output
