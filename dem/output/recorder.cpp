// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run.
#include "dem/output/recorder.hpp"

#include "dem/base/error.hpp"
#include "dem/output/xyz.hpp"
#include "dem/state/checkpoint.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

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

Recorder::Recorder(const std::string &directory, const std::vector<std::string> &formats, const dem::Setup &setup,
                   uint64_t done)
    : directory_(directory), formats_(formats), setup_(&setup) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw dem::Error(directory + ": cannot make this folder: " + error.message());
  const std::string path = directory + "/energy.csv";
  const std::string kept = done > 0 ? table_until(path, done) : std::string(kHeader) + '\n';
  table_.reset(std::fopen(path.c_str(), "w"));
  if (!table_ || std::fputs(kept.c_str(), table_.get()) < 0) {
    throw dem::Error(path + ": cannot write: " + std::strerror(errno));
  }
  if (done == 0) return;
  for (const TimedFile &file : read_pvd(directory_ + "/states.pvd")) {
    if (file.name <= picture_name(done, "vtp")) animation_.push_back(file);
  }
}

void Recorder::picture(uint64_t step, const dem::Snapshot &state) {
  for (const std::string &format : formats_) {
    const std::string name = picture_name(step, format);
    const std::string path = directory_ + "/" + name;
    if (format == "xyz") {
      write_xyz(path, *setup_, state);
    } else {
      write_vtp(path, state);
      animation_.push_back({state.time, name});
      write_pvd(directory_ + "/states.pvd", animation_);
    }
  }
}

void Recorder::energies(uint64_t step, const dem::Measurement &m) {
  std::FILE *out = table_.get();
  std::fprintf(out, "%llu,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%zu,%zu,%.6g\n", static_cast<unsigned long long>(step),
               m.time, m.energy(), m.translation, m.rotation, m.contact, m.gravity, m.contacts, m.wall_contacts,
               m.largest_overlap);
  if (std::fflush(out) != 0) throw dem::Error(directory_ + "/energy.csv: cannot write: " + std::strerror(errno));
}

void Recorder::checkpoint(const dem::Engine &engine) {
  dem::Checkpoint checkpoint;
  engine.save(checkpoint);
  checkpoint.write(checkpoint_path());
}

}  // namespace output
