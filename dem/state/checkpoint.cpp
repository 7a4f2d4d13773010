// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints: named blocks of bytes in one file with a checksum.
//
// The file: a line with kTitle, the word kByteOrder, the number of blocks; for each block the length of its name, its
// own length, name and bytes; last the checksum of all that. Numbers are 64-bit.
#include "dem/state/checkpoint.hpp"

#include "particles/text/output.hpp"
#include "particles/text/text_file.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace dem {
namespace {

constexpr std::string_view kTitle = "hgrid checkpoint 1\n";
constexpr uint64_t kByteOrder = 0x0102030405060708u;

void append(std::string &bytes, uint64_t number) {
  bytes.append(reinterpret_cast<const char *>(&number), sizeof number);
}

[[noreturn]] void fail(const std::string &path, const std::string &what) { throw Error(path + ": " + what); }

// Walks over the bytes of a file; every length is checked before it is believed.
class Walk {
 public:
  Walk(const std::string &path, std::string_view bytes) : path_(path), rest_(bytes) {}

  std::string_view take(uint64_t count) {
    if (count > rest_.size()) fail(path_, "the checkpoint ends too early");
    const std::string_view taken = rest_.substr(0, static_cast<size_t>(count));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  uint64_t number() {
    uint64_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

 private:
  const std::string &path_;
  std::string_view rest_;
};

}  // namespace

// FNV-1a, taken in words: finds damage, does not guard against forgery.
uint64_t Checkpoint::checksum(const char *bytes, size_t count) {
  uint64_t sum = 0xcbf29ce484222325u;
  for (size_t k = 0; k < count; k += sizeof sum) {
    uint64_t word = 0;
    std::memcpy(&word, bytes + k, std::min(sizeof word, count - k));
    sum = (sum ^ word) * 0x100000001b3u;
    sum ^= sum >> 29;
  }
  return sum;
}

// One after the other, each with a 0 at its end.
void Checkpoint::put_texts(const std::string &name, const std::vector<std::string> &texts) {
  std::string all;
  for (const std::string &text : texts) all += text + '\0';
  put(name, all.data(), all.size());
}

std::vector<std::string> Checkpoint::get_texts(const std::string &name) const {
  std::vector<std::string> texts;
  const std::vector<char> &all = block(name);
  for (auto begin = all.begin(); begin != all.end();) {
    const auto end = std::find(begin, all.end(), '\0');
    texts.emplace_back(begin, end);
    begin = end == all.end() ? end : end + 1;
  }
  return texts;
}

void Checkpoint::write(const std::string &path) const {
  std::string bytes(kTitle);
  append(bytes, kByteOrder);
  append(bytes, blocks_.size());
  for (const auto &[name, block] : blocks_) {
    append(bytes, name.size());
    append(bytes, block.size());
    bytes += name;
    bytes.append(block.data(), block.size());
  }
  append(bytes, checksum(bytes.data(), bytes.size()));
  const std::string partial = path + ".partial";
  particles::Output file(partial);
  file << bytes;
  file.close();
  std::error_code error;
  std::filesystem::rename(partial, path, error);
  if (error) fail(path, "cannot write: " + error.message());
}

Checkpoint Checkpoint::read(const std::string &path) {
  const std::string bytes = particles::load_text(path).text;
  if (bytes.compare(0, kTitle.size(), kTitle) != 0) fail(path, "is no checkpoint of this version");
  Walk walk(path, std::string_view(bytes).substr(kTitle.size()));
  if (walk.number() != kByteOrder) fail(path, "was written on a machine with another order of bytes");
  uint64_t stored = 0;
  const size_t covered = bytes.size() - sizeof stored;
  std::memcpy(&stored, bytes.data() + covered, sizeof stored);
  if (checksum(bytes.data(), covered) != stored) fail(path, "is damaged: its checksum does not fit");
  Checkpoint result;
  for (uint64_t left = walk.number(); left > 0; left--) {
    const uint64_t name_length = walk.number(), length = walk.number();
    const std::string name(walk.take(name_length));
    const std::string_view block = walk.take(length);
    result.blocks_[name].assign(block.begin(), block.end());
  }
  return result;
}

const std::vector<char> &Checkpoint::block(const std::string &name) const {
  const auto found = blocks_.find(name);
  if (found == blocks_.end()) throw Error("the checkpoint holds no '" + name + "': it is of another scene");
  return found->second;
}

Error Checkpoint::wrong_size(const std::string &name, size_t found, size_t wanted) {
  return Error("the checkpoint holds " + std::to_string(found) + " bytes of '" + name + "' where the scene has " +
               std::to_string(wanted));
}

}  // namespace dem
