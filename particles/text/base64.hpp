// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Base64 of RFC 4648, section 4.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace particles {

constexpr std::string_view kBase64Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

inline std::string base64(std::string_view bytes) {
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t k = 0; k < bytes.size(); k += 3) {
    const size_t left = bytes.size() - k;
    const auto byte = [&](size_t n) { return n < left ? static_cast<unsigned char>(bytes[k + n]) : 0u; };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    result += kBase64Letters[group >> 18];
    result += kBase64Letters[group >> 12 & 63];
    result += left > 1 ? kBase64Letters[group >> 6 & 63] : '=';
    result += left > 2 ? kBase64Letters[group & 63] : '=';
  }
  return result;
}

// The first bytes of what a text holds, of several stretches with padding too; fewer if it ends before. Blanks and line
// ends are passed over, any other letter ends it.
inline std::string from_base64(std::string_view text, size_t count) {
  std::string result;
  unsigned group = 0;
  int letters = 0, padding = 0;
  for (const char letter : text) {
    if (result.size() >= count) break;
    if (letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r') continue;
    const size_t value = kBase64Letters.find(letter);
    if (value == std::string_view::npos && letter != '=') break;
    padding += letter == '=' ? 1 : 0;
    group = group << 6 | (letter == '=' ? 0 : static_cast<unsigned>(value));
    if (++letters < 4) continue;
    for (int k = 0; k < 3 - padding; k++) result += static_cast<char>(group >> (16 - 8 * k) & 255);
    group = 0;
    letters = padding = 0;
  }
  if (result.size() > count) result.resize(count);
  return result;
}

}  // namespace particles
