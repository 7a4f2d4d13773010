// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Base64 of RFC 4648, section 4.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace particles {

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t k = 0; k < bytes.size(); k += 3) {
    const size_t left = bytes.size() - k;
    const auto byte = [&](size_t n) { return n < left ? static_cast<unsigned char>(bytes[k + n]) : 0u; };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    result += kLetters[group >> 18];
    result += kLetters[group >> 12 & 63];
    result += left > 1 ? kLetters[group >> 6 & 63] : '=';
    result += left > 2 ? kLetters[group & 63] : '=';
  }
  return result;
}

}  // namespace particles
