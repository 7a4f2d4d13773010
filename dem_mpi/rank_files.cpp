// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The files of a run over ranks.
#include "dem_mpi/rank_files.hpp"

#include "dem/output/picture.hpp"
#include "particles/files/format.hpp"
#include "particles/files/vtp_index.hpp"
#include "particles/files/writer.hpp"
#include "particles/text/formatted.hpp"

#include <filesystem>
#include <utility>

namespace dem::ranks {
namespace {

std::string ending(const std::string &stem, int rank) { return stem + particles::formatted("-%04d", rank); }

// "state-000000000100" and the like.
std::string stem_of(const char *what, uint64_t step) {
  const std::string name = output::name_of_step(what, step, "");
  return name.substr(0, name.size() - 1);
}

}  // namespace

PartsIndex read_index(const Ranks &ranks, const std::string &path) {
  PartsIndex index;
  ranks.together([&] {
    const Checkpoint file = Checkpoint::read(path);
    try {
      std::vector<char> stem;
      file.get_all("stem of parts", stem);
      index = {std::string(stem.begin(), stem.end()), file.get_value<uint64_t>("parts"),
               file.get_value<uint64_t>("steps")};
    } catch (const Error &) {
      throw Error(path + ": is no checkpoint of a run over ranks: hgrid run may go on with it");
    }
  });
  return index;
}

std::vector<Checkpoint> read_parts(const Ranks &ranks, const std::string &path, const PartsIndex &index) {
  std::vector<Checkpoint> parts;
  ranks.together([&] {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    for (int k = ranks.rank(); k < static_cast<int>(index.parts); k += ranks.size()) {
      const std::string name = (std::filesystem::path(folder) / ending(index.stem, k)).string();
      parts.push_back(Checkpoint::read(name));
      if (parts.back().get_value<uint64_t>("steps") != index.steps)
        throw Error(name, 0, "is a part of another checkpoint than " + path);
    }
  });
  return parts;
}

RankFiles::RankFiles(const Ranks &ranks, std::string directory, const PartsIndex &done)
    : ranks_(ranks), directory_(std::move(directory)) {
  ranks_.together([&] {
    if (!ranks_.is_first()) return;
    recorder_ = std::make_unique<output::Recorder>(directory_, output::Asked{}, done.steps);
    if (done.steps > 0)
      animation_ = output::files_until(directory_ + "/states.pvd", output::name_of_step("state", done.steps, "pvtp"));
  });
  if (std::filesystem::exists(part_path(done.stem, 0))) stem_ = done.stem;
}

std::string RankFiles::part_path(const std::string &stem, int rank) const {
  return directory_ + "/" + ending(stem, rank);
}

void RankFiles::picture(const Setup &setup, uint64_t step, RankEngine &engine) {
  OwnedParticles state = engine.owned();
  const double time = state.time;
  std::vector<double> ids(state.numbers.begin(), state.numbers.end());
  particles::ParticleSet set = output::picture_of(setup, step, std::move(state));
  set.columns.push_back({"id", 1, std::move(ids)});
  const std::string stem = stem_of("state", step);
  const bool empty = set.count() == 0;
  ranks_.together([&] {
    const std::string path = directory_ + "/" + ending(stem, ranks_.rank()) + ".vtp";
    if (!empty) particles::write_picture(path, *particles::format_of_word("vtp"), set);
  });
  // Only pieces with particles have all columns; the first of them writes the index.
  std::vector<int64_t> there(static_cast<size_t>(ranks_.size()), 0);
  there[static_cast<size_t>(ranks_.rank())] = empty ? 0 : 1;
  ranks_.add_up(there);
  std::vector<std::string> pieces;
  int first = -1;
  for (int rank = 0; rank < ranks_.size(); rank++) {
    if (there[static_cast<size_t>(rank)] == 0) continue;
    if (first < 0) first = rank;
    pieces.push_back(ending(stem, rank) + ".vtp");
  }
  ranks_.together([&] {
    if (ranks_.rank() == first) particles::write_vtp_index(directory_ + "/" + stem + ".pvtp", set, pieces);
  });
  ranks_.together([&] {
    if (!ranks_.is_first()) return;
    animation_.push_back({time, stem + ".pvtp"});
    output::write_animation(directory_ + "/states.pvd", animation_);
  });
}

void RankFiles::measurement(uint64_t step, const Measurement &measurement) {
  ranks_.together([&] {
    if (ranks_.is_first()) recorder_->measurement(step, measurement);
  });
}

void RankFiles::save(const RankEngine &engine) {
  std::string stem = stem_of("checkpoint", engine.steps_done());
  // Parts that an index names are never written over.
  if (ranks_.of_first(stem == stem_)) stem += "b";
  const std::string path = part_path(stem, ranks_.rank());
  try {
    ranks_.together([&] {
      Checkpoint part;
      engine.save(part);
      part.write(path);
    });
    ranks_.together([&] {
      if (!ranks_.is_first()) return;
      Checkpoint index;
      index.put("stem of parts", stem.data(), stem.size());
      index.put_value("parts", static_cast<uint64_t>(ranks_.size()));
      index.put_value("steps", engine.steps_done());
      index.write(checkpoint_path());
    });
  } catch (const Error &) {
    std::error_code ignored;
    for (const char *also : {"", ".partial"}) std::filesystem::remove(path + also, ignored);
    throw;
  }
  stem_ = stem;
  if (ranks_.is_first()) remove_other_parts(stem);
}

void RankFiles::remove_other_parts(const std::string &stem) const {
  std::error_code ignored;
  std::vector<std::filesystem::path> others;
  for (const auto &entry : std::filesystem::directory_iterator(directory_, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("checkpoint-", 0) == 0 && name.rfind(stem + "-", 0) != 0) others.push_back(entry.path());
  }
  for (const std::filesystem::path &other : others) std::filesystem::remove(other, ignored);
}

}  // namespace dem::ranks
