// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The tables of a scene file: typed values, faults named by file and line.
#include "dem/scene/table.hpp"

#include "dem/base/error.hpp"
#include "dem/scene/suggestion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scene {
namespace {

[[noreturn]] void fail_at_line(const std::string &file, toml::source_index line, const std::string &message) {
  // What was set from outside stands on no line.
  throw dem::Error(file + (line > 0 ? ":" + std::to_string(line) : " with --set") + ": " + message);
}

const char *kind_name(const toml::node &node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

}  // namespace

Table::Table(const std::string &file, std::string name, const toml::table &table)
    : file_(&file), name_(std::move(name)), table_(&table) {
  const std::vector<std::string> known = names_in(name_);
  for (const auto &[key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    const std::string where = name_.empty() ? "the top of the file" : "[" + name_ + "]";
    fail_at_line(file, key.source().begin.line,
                 "'" + std::string(key.str()) + "' is no key of " + where + suggestion(key.str(), known));
  }
}

Table Table::under(const Table &stage) const {
  Table result = *this;
  result.over_ = stage.table_;
  return result;
}

const toml::node *Table::find(const char *key) const {
  if (const toml::node *node = over_ != nullptr ? over_->get(key) : nullptr) {
    const bool taken_away = node->is_boolean() && !*node->value<bool>();
    return taken_away ? nullptr : node;
  }
  return table_->get(key);
}

bool Table::has(const char *key) const { return find(key) != nullptr; }

std::string Table::full_name(const char *key) const { return (name_.empty() ? "" : name_ + ".") + key; }

// What stands in a stage is as at the top of the file.
std::string Table::part_name(const char *name) const { return name_ == kStage ? name : full_name(name); }

void Table::fail_at(const toml::node &node, const std::string &message) const {
  fail_at_line(*file_, node.source().begin.line, message);
}

void Table::fail(const char *key, const std::string &message) const {
  const toml::node *node = find(key);
  fail_at(node != nullptr ? *node : *table_, full_name(key) + ": " + message);
}

const toml::node &Table::need(const char *key) const {
  const toml::node *node = find(key);
  if (node == nullptr) {
    const std::string table = name_.empty() ? "the scene" : "[" + name_ + "]";
    const toml::source_index line = table_->source().begin.line;
    fail_at_line(*file_, name_.empty() ? std::max<toml::source_index>(1, line) : line,
                 table + " needs the key '" + key + "': " + key_of(name_, key).meaning);
  }
  return *node;
}

double Table::measure(const toml::node &node, const char *key, Unit unit) const {
  double value = 0;
  if (node.is_number()) {
    value = *node.value<double>();
  } else if (const auto text = node.value_exact<std::string>()) {
    try {
      value = in_si(*text, unit);
    } catch (const dem::Error &error) {
      fail_at(node, full_name(key) + ": " + error.what());
    }
  } else {
    fail_at(node, full_name(key) + " is " + kind_name(node) + " where a number is wanted");
  }
  if (!std::isfinite(value)) fail_at(node, full_name(key) + " is not finite");
  return value;
}

double Table::number(const char *key) const { return measure(need(key), key, key_of(name_, key).unit); }

double Table::number(const char *key, double fallback) const { return number(key, fallback, key_of(name_, key).unit); }

double Table::number(const char *key, double fallback, Unit unit) const {
  const toml::node *node = find(key);
  return node != nullptr ? measure(*node, key, unit) : fallback;
}

std::vector<double> Table::measures(const toml::node &node, const char *key, size_t size) const {
  const toml::array *array = node.as_array();
  if (array == nullptr || array->size() != size) {
    const std::string found = array != nullptr ? "a list of " + std::to_string(array->size()) : kind_name(node);
    fail_at(node, full_name(key) + " is " + found + " where a list of " + std::to_string(size) + " is wanted");
  }
  std::vector<double> values;
  for (const toml::node &item : *array) values.push_back(measure(item, key, key_of(name_, key).unit));
  return values;
}

std::vector<double> Table::vector(const char *key, size_t size) const { return measures(need(key), key, size); }

std::vector<double> Table::vector(const char *key, size_t size, double fallback) const {
  const toml::node *node = find(key);
  return node != nullptr ? measures(*node, key, size) : std::vector<double>(size, fallback);
}

std::vector<std::vector<double>> Table::list(const char *key, size_t size) const {
  const toml::node &node = need(key);
  const toml::array *array = node.as_array();
  if (array == nullptr) fail_at(node, full_name(key) + " is " + kind_name(node) + " where a list of lists is wanted");
  std::vector<std::vector<double>> rows;
  for (const toml::node &item : *array) rows.push_back(measures(item, key, size));
  return rows;
}

uint64_t Table::count(const char *key) const {
  need(key);
  return count(key, 0);
}

uint64_t Table::count(const char *key, uint64_t fallback) const {
  const toml::node *node = find(key);
  if (node == nullptr) return fallback;
  auto value = node->value_exact<int64_t>();
  // 1e5 is a whole number too, as far as doubles count.
  const auto real = node->value_exact<double>();
  if (real && *real == std::floor(*real) && std::fabs(*real) < 0x1p53) value = static_cast<int64_t>(*real);
  if (!value) fail_at(*node, full_name(key) + " is " + kind_name(*node) + " where a whole number is wanted");
  if (*value < 0) fail_at(*node, full_name(key) + " is negative: " + std::to_string(*value));
  return static_cast<uint64_t>(*value);
}

bool Table::flag(const char *key, bool fallback) const {
  const toml::node *node = find(key);
  if (node == nullptr) return fallback;
  const auto value = node->value_exact<bool>();
  if (!value) fail_at(*node, full_name(key) + " is " + kind_name(*node) + " where true or false is wanted");
  return *value;
}

std::string Table::text(const char *key, const std::string &fallback) const {
  const toml::node *node = find(key);
  if (node == nullptr) return fallback;
  const auto value = node->value_exact<std::string>();
  if (!value) fail_at(*node, full_name(key) + " is " + kind_name(*node) + " where a text is wanted");
  return *value;
}

std::string Table::word(const toml::node &node, const char *key, const std::vector<std::string> &words) const {
  const auto value = node.value_exact<std::string>();
  if (!value) fail_at(node, full_name(key) + " is " + kind_name(node) + " where a word is wanted");
  if (std::find(words.begin(), words.end(), *value) == words.end()) {
    fail_at(node, full_name(key) + " cannot be '" + *value + "'" + suggestion(*value, words));
  }
  return *value;
}

std::string Table::choice(const char *key, const std::vector<std::string> &words) const {
  const toml::node *node = find(key);
  return node != nullptr ? word(*node, key, words) : words.front();
}

std::vector<std::string> Table::choices(const char *key, const std::vector<std::string> &words) const {
  const toml::node *node = find(key);
  if (node == nullptr) return {words.front()};
  const toml::array *array = node->as_array();
  if (array == nullptr) fail_at(*node, full_name(key) + " is " + kind_name(*node) + " where a list is wanted");
  std::vector<std::string> result;
  for (const toml::node &item : *array) result.push_back(word(item, key, words));
  return result;
}

void Table::axes(const char *key, int dimension, bool (&flags)[3]) const {
  need(key);
  for (bool &flag : flags) flag = false;
  const std::string letters = text(key, "");
  for (const char letter : letters) {
    const int axis = letter - 'x';
    if (axis < 0 || axis >= dimension || flags[axis]) {
      fail(key, "'" + letters + "' does not name axes of " + std::to_string(dimension) + " dimensions, each once");
    }
    flags[axis] = true;
  }
}

std::optional<Table> Table::part(const char *name) const {
  const toml::node *node = find(name);
  if (node == nullptr) return std::nullopt;
  const toml::table *table = node->as_table();
  if (table == nullptr) fail_at(*node, full_name(name) + " is " + kind_name(*node) + " where a table is wanted");
  const std::string place = part_name(name);
  const Table result(*file_, place, *table);
  // Of two tables the stage's lies over the scene's.
  const toml::node *below = over_ != nullptr ? table_->get(name) : nullptr;
  if (below == nullptr || below == node || !below->is_table()) return result;
  return Table(*file_, place, *below->as_table()).under(result);
}

std::vector<Table> Table::parts(const char *name) const {
  const toml::node *node = find(name);
  std::vector<Table> result;
  if (node == nullptr) return result;
  const toml::array *array = node->as_array();
  if (array == nullptr || !array->is_array_of_tables()) {
    fail_at(*node,
            full_name(name) + " is " + kind_name(*node) + " where tables [[" + full_name(name) + "]] are wanted");
  }
  for (const toml::node &item : *array) result.emplace_back(*file_, part_name(name), *item.as_table());
  return result;
}

bool Table::has_units() const {
  const auto is_text = [](const toml::node &node) { return node.is_string(); };
  const auto has_text = [&](const toml::node &node) {
    const toml::array *array = node.as_array();
    return is_text(node) || (array != nullptr && std::any_of(array->begin(), array->end(), is_text));
  };
  for (const auto &[name, node] : *table_) {
    const std::string word(name.str());
    const toml::array *array = node.as_array();
    if (node.is_table()) {
      if (part(word.c_str())->has_units()) return true;
    } else if (array != nullptr && array->is_array_of_tables()) {
      for (const Table &one : parts(word.c_str())) {
        if (one.has_units()) return true;
      }
    } else if (!node.is_boolean()) {  // false in a stage may take a table away
      const Key &key = key_of(name_, word);
      const bool measured = key.kind == Kind::kNumber || key.kind == Kind::kVector || key.kind == Kind::kList;
      if (!measured || key.unit == kPure) continue;
      if (has_text(node) || (array != nullptr && std::any_of(array->begin(), array->end(), has_text))) return true;
    }
  }
  return false;
}

SceneFile::SceneFile(const std::string &path, const std::vector<Setting> &settings) : path_(path) {
  try {
    table_ = toml::parse_file(path);
  } catch (const toml::parse_error &error) {
    const toml::source_index line = error.source().begin.line;
    const std::string place = line > 0 ? path + ":" + std::to_string(line) : path;
    throw dem::Error(place + ": " + std::string(error.description()));
  }
  for (const Setting &setting : settings) apply(setting, table_);
}

}  // namespace scene
