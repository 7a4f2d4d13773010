// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "dem/scene/settings.hpp"

#include "dem/base/error.hpp"

#include <charconv>
#include <string_view>

namespace scene {
namespace {

[[noreturn]] void fail(const Setting &setting, const std::string &why) {
  throw dem::Error("--set " + setting.path + "=" + setting.value + ": " + why);
}

// A table with the value under the key.
toml::table parsed(const Setting &setting) {
  try {
    return toml::parse("value = " + setting.value);
  } catch (const toml::parse_error &) {
    toml::table text;
    text.insert("value", setting.value);
    return text;
  }
}

void set(const Setting &setting, std::string_view path, toml::node &node, const toml::node &value);

// The elements of an array that the path speaks of.
void set_in_array(const Setting &setting, std::string_view path, toml::array &array, const toml::node &value) {
  const std::string_view first = path.substr(0, path.find('.'));
  size_t number = 0;
  const auto result = std::from_chars(first.data(), first.data() + first.size(), number);
  if (result.ec == std::errc() && result.ptr == first.data() + first.size()) {
    if (number < 1 || number > array.size()) {
      fail(setting, "there are " + std::to_string(array.size()) + " of these tables, counted from 1");
    }
    if (first.size() == path.size()) fail(setting, "names no key");
    return set(setting, path.substr(first.size() + 1), array[number - 1], value);
  }
  for (toml::node &element : array) set(setting, path, element, value);
}

void set(const Setting &setting, std::string_view path, toml::node &node, const toml::node &value) {
  if (toml::array *array = node.as_array()) return set_in_array(setting, path, *array, value);
  toml::table *table = node.as_table();
  if (table == nullptr) fail(setting, "'" + std::string(path) + "' lies in no table");
  const size_t dot = path.find('.');
  const std::string key(path.substr(0, dot));
  if (key.empty()) fail(setting, "names no key");
  if (dot == std::string_view::npos) {
    table->insert_or_assign(key, value);
    return;
  }
  if (!table->contains(key)) table->insert(key, toml::table());
  set(setting, path.substr(dot + 1), *table->get(key), value);
}

}  // namespace

void apply(const Setting &setting, toml::table &scene) {
  const toml::table value = parsed(setting);
  set(setting, setting.path, scene, *value.get("value"));
}

}  // namespace scene
