// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Every table and key a scene can have, with what it means: what is read, refused and printed comes from here, and for
// effects from their own table.
#pragma once

#include "dem/scene/units.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace scene {

enum class Kind { kNumber, kVector, kList, kCount, kFlag, kText, kTexts, kTable };

struct Key {
  const char *table;  // "" for the top of the file; parts of [[particles]] as "particles.pack"
  const char *name;
  Kind kind;
  Unit unit;             // of numbers and vectors
  const char *fallback;  // what holds if the key is left out; "needed" if it cannot be
  const char *meaning;
};

struct TableDoc {
  const char *name;
  std::string meaning;
  bool in_stages = false;  // whether a stage may have one, too
};

constexpr const char *kStage = "stage";

const std::vector<TableDoc> &all_tables();
const std::vector<Key> &all_keys();

// The entry of a key that must exist.
const Key &key_of(std::string_view table, std::string_view name);

// The names of all keys and parts of a table.
std::vector<std::string> names_in(std::string_view table);

// A reference of all tables and keys, in Markdown.
std::string key_reference();

}  // namespace scene
