// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the reader of checkpoints: a damaged one of a small scene is refused with a text, or goes on.
//
// The input is a list of changes to a sound checkpoint; the checksum is made to fit, else nothing would come past it.
#include "dem/base/error.hpp"
#include "dem/engine/engine.hpp"
#include "dem/setup/time_step.hpp"
#include "fuzz/memory_file.hpp"
#include "fuzz/refusal.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {

// Four rough spheres in a box, two of them in contact with another and one with a wall.
dem::Setup small_setup() {
  dem::Setup setup;
  setup.effects = dem::kFriction | dem::kRolling | dem::kDissipation | dem::kWalls;
  setup.centers = {1, 1, 0.95, 2.9, 1, 1, 5, 5, 5, 5, 6.9, 5};
  setup.radii.assign(4, 1.0);
  setup.masses.assign(4, 1.0);
  setup.velocities.assign(12, 0.1);
  for (int k = 0; k < 3; k++) {
    setup.box_max[k] = 8;
    setup.walled[k] = true;
  }
  setup.contact.stiffness = 1000;
  setup.contact.restitution = 0.8;
  setup.contact.friction = 0.5;
  setup.contact.tangential_stiffness = 2.0 / 7;
  setup.contact.rolling_friction = 0.1;
  setup.contact.rolling_stiffness = 2.0 / 7;
  setup.time_step = dem::shortest_contact(setup).duration / 50;
  return setup;
}

std::string sound_checkpoint(const dem::Setup &setup) {
  const auto engine = dem::make_engine(setup);
  engine->run(5);
  dem::Checkpoint checkpoint;
  engine->save(checkpoint);
  const std::string path = (std::filesystem::temp_directory_path() / "hgrid-fuzz-checkpoint").string();
  checkpoint.write(path);
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::filesystem::remove(path);
  return bytes;
}

// Changes of three bytes each: where (of 2^16), then what to write there; a long one at the end cuts the file.
std::string changed(std::string bytes, const uint8_t *data, size_t size) {
  for (; size >= 3; data += 3, size -= 3) bytes[(data[0] + 256u * data[1]) % bytes.size()] = static_cast<char>(data[2]);
  if (size == 2) bytes.resize((data[0] + 256u * data[1]) % bytes.size());
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const dem::Setup setup = small_setup();
  static const std::string sound = sound_checkpoint(setup);
  std::string bytes = changed(sound, data, size);
  const size_t covered = bytes.size() < sizeof(uint64_t) ? 0 : bytes.size() - sizeof(uint64_t);
  const uint64_t sum = dem::Checkpoint::checksum(bytes.data(), covered);
  if (covered > 0) std::memcpy(&bytes[covered], &sum, sizeof sum);
  fuzz::done_or_refused([&] {
    const fuzz::MemoryFile file(bytes);
    const auto engine = dem::make_engine(setup);
    engine->restore(dem::Checkpoint::read(file.path()));
    engine->run(2);
    engine->measure();
  });
  return 0;
}
