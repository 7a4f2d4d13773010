// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run: pictures of the state, the table of energies, the checkpoint.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/output/animation.hpp"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace output {

// All files lie in one folder, which is made if it is not there. A run that goes on from a checkpoint adds to the
// table and the list of pictures; pictures carry the number of their step. Throws particles::Error if something cannot
// be written.
class Recorder {
 public:
  // `done`: the step that the run goes on from, 0 for a new one. What an earlier run has entered for later steps, past
  // its last checkpoint, is dropped, since it comes again. `formats`: their words.
  Recorder(std::string directory, std::vector<std::string> formats, const dem::Setup &setup, uint64_t done);

  void picture(uint64_t step, dem::Snapshot state);
  void energies(uint64_t step, const dem::Measurement &measurement);
  void checkpoint(const dem::Engine &engine);

  std::string checkpoint_path() const { return directory_ + "/checkpoint"; }

 private:
  struct CloseFile {
    void operator()(std::FILE *file) const { std::fclose(file); }
  };

  std::string directory_;
  std::vector<std::string> formats_;
  const dem::Setup *setup_;
  std::unique_ptr<std::FILE, CloseFile> table_;
  std::vector<TimedFile> animation_;
};

}  // namespace output
