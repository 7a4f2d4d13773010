// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Triangle meshes in STL files: text with lines "vertex x y z", or after 80 bytes the number of triangles and for each
// of them twelve floats, the normal and three corners, and two more bytes, all little-endian.
#include "dem/scene/stl.hpp"

#include "dem/base/error.hpp"
#include "particles/text/number.hpp"
#include "particles/text/text_file.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

namespace scene {
namespace {

constexpr size_t kHead = 80, kTriangle = 50;

uint32_t little_endian(const char *bytes) {
  uint32_t value = 0;
  for (int k = 3; k >= 0; k--) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

double float_at(const char *bytes) {
  const uint32_t bits = little_endian(bytes);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

bool is_binary(const std::string &bytes) {
  return bytes.size() >= kHead + 4 &&
         bytes.size() == kHead + 4 + kTriangle * static_cast<size_t>(little_endian(bytes.data() + kHead));
}

std::vector<double> read_binary(const std::string &path, const std::string &bytes) {
  std::vector<double> corners;
  for (size_t start = kHead + 4; start < bytes.size(); start += kTriangle) {
    for (size_t k = 3; k < 12; k++) {
      corners.push_back(float_at(bytes.data() + start + 4 * k));
      if (!std::isfinite(corners.back())) {
        throw dem::Error(path + ": a corner of triangle " + std::to_string((start - kHead) / kTriangle + 1) +
                         " is not finite");
      }
    }
  }
  return corners;
}

std::vector<double> read_text(const std::string &path) {
  const particles::TextFile file = particles::load_text(path);
  particles::LineCursor lines(file);
  std::vector<double> corners;
  for (std::string_view line; lines.next(line);) {
    const std::vector<std::string_view> words = particles::split_words(line);
    if (words.empty() || words[0] != "vertex") continue;
    if (words.size() != 4) lines.fail("a vertex has three numbers, not " + std::to_string(words.size() - 1));
    for (size_t k = 1; k < words.size(); k++) {
      double value = 0;
      if (const char *fault = particles::number_fault(words[k], value)) {
        lines.fail(particles::in_quotes(words[k]) + " " + fault);
      }
      corners.push_back(value);
    }
  }
  if (corners.size() % 9 != 0) {
    throw dem::Error(path + ": has " + std::to_string(corners.size() / 3) + " vertices, which are no whole triangles");
  }
  return corners;
}

}  // namespace

std::vector<double> read_stl(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw dem::Error(path + ": cannot open");
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::vector<double> corners = is_binary(bytes) ? read_binary(path, bytes) : read_text(path);
  if (corners.empty()) throw dem::Error(path + ": holds no triangle: is it an STL file?");
  return corners;
}

}  // namespace scene
