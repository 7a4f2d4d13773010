// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run over ranks: pictures in one piece for each rank with an index, the table of energies, checkpoints
// in parts.
#pragma once

#include "dem/output/recorder.hpp"
#include "dem_mpi/rank_engine.hpp"

#include <memory>
#include <string>
#include <vector>

namespace dem::ranks {

// What a checkpoint says of its parts, file by file: parts of one step and one run.
struct PartsIndex {
  std::string stem;  // of the names of their files, in the folder of the index
  uint64_t parts = 0, steps = 0;
};

// All are collective, and throw Error on all ranks if a rank cannot read or write: the text names rank and file.

// Of the index at `path` and the parts that are this rank's, dealt out in turn.
PartsIndex read_index(const Ranks &ranks, const std::string &path);
std::vector<Checkpoint> read_parts(const Ranks &ranks, const std::string &path, const PartsIndex &index);

class RankFiles {
 public:
  // `done`: what the run goes on from, none for a new one. Throws unless the folder can be made.
  RankFiles(const Ranks &ranks, std::string directory, const PartsIndex &done);

  // state-STEP-RANK.vtp, and then state-STEP.pvtp. `setup` gives the box.
  void picture(const Setup &setup, uint64_t step, RankEngine &engine);
  void measurement(uint64_t step, const Measurement &measurement);

  // Complete or not at all: the index changes only when each rank has written its part, and then the parts of the
  // former checkpoint go. If a rank cannot write, the former one stays, and all throw.
  void save(const RankEngine &engine);

  std::string checkpoint_path() const { return directory_ + "/checkpoint"; }

 private:
  std::string part_path(const std::string &stem, int rank) const;
  void remove_other_parts(const std::string &stem) const;

  const Ranks &ranks_;
  std::string directory_;
  std::string stem_;                            // of the last checkpoint in this folder
  std::unique_ptr<output::Recorder> recorder_;  // of the first rank
  std::vector<output::TimedFile> animation_;
};

}  // namespace dem::ranks
