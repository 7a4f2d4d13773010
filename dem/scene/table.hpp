// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The tables of a scene file: typed values, faults named by file and line. The only part that knows the TOML library.
#pragma once

#include "dem/scene/keys.hpp"
#include "dem/scene/settings.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scene {

// A table whose keys are all known: anything else is refused when it is made. Values of the wrong kind are refused when
// they are asked for. Points into the file it comes from.
class Table {
 public:
  Table(const std::string &file, std::string name, const toml::table &table);

  // This table where `stage` says nothing: its keys come first, and one that is false takes away what stands here.
  Table under(const Table &stage) const;

  bool has(const char *key) const;

  // Without a fallback the key is needed.
  double number(const char *key) const;
  double number(const char *key, double fallback) const;
  double number(const char *key, double fallback, Unit unit) const;
  std::vector<double> vector(const char *key, size_t size) const;
  std::vector<double> vector(const char *key, size_t size, double fallback) const;
  std::vector<std::vector<double>> list(const char *key, size_t size) const;
  uint64_t count(const char *key) const;
  uint64_t count(const char *key, uint64_t fallback) const;
  bool flag(const char *key, bool fallback) const;
  std::string text(const char *key, const std::string &fallback) const;
  // One of several words.
  std::string choice(const char *key, const std::vector<std::string> &words) const;  // the first is the fallback
  std::vector<std::string> choices(const char *key, const std::vector<std::string> &words) const;
  // Letters of axes, each once; the key is needed.
  void axes(const char *key, int dimension, bool (&flags)[3]) const;

  std::optional<Table> part(const char *name) const;
  std::vector<Table> parts(const char *name) const;  // of an array of tables

  // Whether any number in it or in its parts has a unit.
  bool has_units() const;

  // Throws dem::Error for the line of the key, or of the table if it has no such key.
  [[noreturn]] void fail(const char *key, const std::string &message) const;

 private:
  const toml::node *find(const char *key) const;
  const toml::node &need(const char *key) const;
  [[noreturn]] void fail_at(const toml::node &node, const std::string &message) const;
  double measure(const toml::node &node, const char *key, Unit unit) const;
  std::vector<double> measures(const toml::node &node, const char *key, size_t size) const;
  std::string word(const toml::node &node, const char *key, const std::vector<std::string> &words) const;
  std::string full_name(const char *key) const;
  std::string part_name(const char *name) const;

  const std::string *file_;
  std::string name_;
  const toml::table *table_;
  const toml::table *over_ = nullptr;  // of a stage
};

// A parsed file.
class SceneFile {
 public:
  // Throws dem::Error naming the line if it is no TOML. `settings` stand instead of what the file says.
  explicit SceneFile(const std::string &path, const std::vector<Setting> &settings = {});

  const std::string &path() const { return path_; }
  Table top() const { return Table(path_, "", table_); }

 private:
  std::string path_;
  toml::table table_;
};

}  // namespace scene
