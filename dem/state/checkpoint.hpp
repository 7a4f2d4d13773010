// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints: named blocks of bytes in one file with a checksum.
#pragma once

#include "dem/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace dem {

class Checkpoint {
 public:
  template <class T>
  void put(const std::string &name, const T *items, size_t count) {
    std::vector<char> &block = blocks_[name];
    block.resize(count * sizeof(T));
    if (count > 0) std::memcpy(block.data(), static_cast<const void *>(items), block.size());
  }
  template <class T, class Memory>
  void put(const std::string &name, const std::vector<T, Memory> &items) {
    put(name, items.data(), items.size());
  }
  template <class T>
  void put_value(const std::string &name, const T &value) {
    put(name, &value, 1);
  }

  // Of any length, without the character 0.
  void put_texts(const std::string &name, const std::vector<std::string> &texts);

  bool holds(const std::string &name) const { return blocks_.count(name) > 0; }

  // Throw Error if there is no such block or it does not hold `count` items.
  template <class T>
  void get(const std::string &name, T *items, size_t count) const {
    const std::vector<char> &stored = block(name);
    if (stored.size() != count * sizeof(T)) throw wrong_size(name, stored.size(), count * sizeof(T));
    if (count > 0) std::memcpy(static_cast<void *>(items), stored.data(), stored.size());
  }
  template <class T, class Memory>
  void get(const std::string &name, std::vector<T, Memory> &items) const {
    get(name, items.data(), items.size());
  }
  // As many items as the block holds.
  template <class T>
  void get_all(const std::string &name, std::vector<T> &items) const {
    items.resize(block(name).size() / sizeof(T));
    get(name, items);
  }
  std::vector<std::string> get_texts(const std::string &name) const;
  template <class T>
  T get_value(const std::string &name) const {
    T value;
    get(name, &value, 1);
    return value;
  }

  // The file appears under its name only when it is complete. Numbers are stored as this machine holds them; a file of
  // a machine with another order of bytes is refused, a damaged one too.
  void write(const std::string &path) const;
  static Checkpoint read(const std::string &path);
  // What a file ends with, of all bytes before.
  static uint64_t checksum(const char *bytes, size_t count);

 private:
  const std::vector<char> &block(const std::string &name) const;
  static Error wrong_size(const std::string &name, size_t found, size_t wanted);

  std::map<std::string, std::vector<char>> blocks_;
};

}  // namespace dem
