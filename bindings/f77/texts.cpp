// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/f77/texts.hpp"

#include <utility>

namespace hgrid::f77 {
namespace {

constexpr std::pair<const char *, const char *> kArrays[] = {
    {"radii", "R"}, {"def.box_min", "BOXMIN"}, {"def.box_max", "BOXMAX"}, {"def.periodic", "IPER"}};
constexpr std::pair<const char *, const char *> kNumbers[] = {
    {"def.margin", "MARGIN"}, {"def.dimension", "IDIM"}, {"def.interaction", "MODE"}};

// Reads "[12]" at `place` and steps over it.
bool read_subscript(const std::string &text, size_t &place, unsigned long &number) {
  if (place >= text.size() || text[place] != '[') return false;
  const size_t end = text.find_first_not_of("0123456789", place + 1);
  if (end == std::string::npos || end == place + 1 || text[end] != ']') return false;
  number = std::stoul(text.substr(place + 1));
  place = end + 1;
  return true;
}

std::string element(const char *array, unsigned long from_zero) {
  return array + ("(" + std::to_string(from_zero + 1) + ")");
}

}  // namespace

std::string translated(std::string text) {
  constexpr const char *kAxes[] = {"X", "Y", "Z"};
  for (size_t at = 0; (at = text.find("centers[", at)) != std::string::npos; at++) {
    size_t end = at + 7;
    unsigned long row = 0, axis = 0;
    if (!read_subscript(text, end, row) || !read_subscript(text, end, axis) || axis > 2) continue;
    text.replace(at, end - at, element(kAxes[axis], row));
  }
  for (const auto &[name, array] : kArrays) {
    const std::string before = name;
    for (size_t at = 0; (at = text.find(before, at)) != std::string::npos; at++) {
      size_t end = at + before.size();
      unsigned long number = 0;
      if (read_subscript(text, end, number)) text.replace(at, end - at, element(array, number));
    }
  }
  for (const auto &[name, argument] : kNumbers) {
    const std::string before = name;
    if (const size_t at = text.find(before); at != std::string::npos) text.replace(at, before.size(), argument);
  }
  return text;
}

}  // namespace hgrid::f77
