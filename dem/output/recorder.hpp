// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run: pictures of the state and of its walls, tables of energies, averages, walls and regions, networks
// of contacts, the checkpoint.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/output/animation.hpp"
#include "dem/output/csv_table.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace output {

// What is recorded besides.
struct Asked {
  std::vector<std::string> formats;  // of pictures, their words
  bool work = false;                 // columns of the energies
  bool bulk = false;                 // averages over the box
  bool contacts = false;             // a network beside each picture
};

// All files lie in one folder, which is made if it is not there. A run that goes on from a checkpoint adds to the
// table and the list of pictures; pictures carry the number of their step. Throws particles::Error if something cannot
// be written.
class Recorder {
 public:
  // `done`: the step that the run goes on from, 0 for a new one. What an earlier run has entered for later steps, past
  // its last checkpoint, is dropped, since it comes again.
  Recorder(std::string directory, Asked asked, uint64_t done);

  // `setup` gives the box and the walls.
  void picture(const dem::Setup &setup, uint64_t step, dem::Engine &engine);
  // A row of each table.
  void measurement(uint64_t step, const dem::Measurement &measurement);
  // A row for each wall beside the box's in walls.csv, each region in regions.csv, each inflow and removal in
  // exchange.csv, which are there once there is one.
  void walls(uint64_t step, double time, const std::vector<dem::WallReport> &walls);
  void regions(uint64_t step, const std::vector<dem::Region> &regions, dem::Engine &engine);
  void passages(uint64_t step, double time, const std::vector<dem::Passage> &passages);

  std::string checkpoint_path() const { return directory_ + "/checkpoint"; }

 private:
  // The table of this name, with what an earlier run has entered.
  CsvTable &table(std::unique_ptr<CsvTable> &table, const char *name, const char *header) const;

  std::string directory_;
  Asked asked_;
  uint64_t done_;
  std::unique_ptr<CsvTable> energies_, bulk_, walls_, regions_, passages_;
  std::vector<TimedFile> animation_, networks_, wall_pictures_;
};

}  // namespace output
