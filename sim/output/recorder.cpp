// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The files of a run.
#include "sim/output/recorder.hpp"

#include "sim/dem/checkpoint.hpp"
#include "sim/dem/error.hpp"
#include "sim/output/xyz.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace output {

Recorder::Recorder(const std::string &directory, const std::vector<std::string> &formats, const dem::Setup &setup,
                   bool continued)
    : directory_(directory), formats_(formats), setup_(&setup) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw dem::Error(directory + ": cannot make this folder: " + error.message());
  const std::string path = directory + "/energy.csv";
  const bool fresh = !continued || !std::filesystem::exists(path);
  table_.reset(std::fopen(path.c_str(), fresh ? "w" : "a"));
  if (!table_) throw dem::Error(path + ": cannot write: " + std::strerror(errno));
  if (fresh) {
    std::fputs("step,time,energy,translation,rotation,contact,gravity,contacts,wall_contacts,largest_overlap\n",
               table_.get());
  }
}

void Recorder::picture(std::uint64_t step, const dem::Snapshot &state) {
  char name[48];
  for (const std::string &format : formats_) {
    std::snprintf(name, sizeof name, "state-%012llu.%s", static_cast<unsigned long long>(step), format.c_str());
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

void Recorder::energies(std::uint64_t step, const dem::Measurement &m) {
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
