// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers and words found in text, and how they are quoted in messages.
#include "particles/text/number.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace particles {
namespace {

constexpr size_t kLongestQuote = 40;

// Fortran writes 1.0D-3: again with an e where reading stopped at the letter.
std::from_chars_result read_fortran(const char *first, const char *letter, const char *last, double &value) {
  std::string text(first, last);
  text[static_cast<size_t>(letter - first)] = 'e';
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
  return {first + (result.ptr - text.data()), result.ec};
}

bool is_blank(char letter) { return letter == ' ' || letter == '\t'; }

}  // namespace

const char *number_fault(std::string_view text, double &value) {
  const char *first = text.data();
  const char *last = first + text.size();
  // from_chars knows no plus sign; one before a sign or a word must stay a fault.
  if (last - first > 1 && *first == '+' && (first[1] == '.' || (first[1] >= '0' && first[1] <= '9'))) first++;
  std::from_chars_result result = std::from_chars(first, last, value);
  if (result.ptr != last && result.ptr != first && (*result.ptr == 'd' || *result.ptr == 'D'))
    result = read_fortran(first, result.ptr, last, value);
  if (result.ptr != last || result.ec == std::errc::invalid_argument) return "is not a number";
  if (result.ec == std::errc::result_out_of_range) return "is out of the range of a double";
  if (!std::isfinite(value)) return "is not finite";
  return nullptr;
}

bool read_count(std::string_view text, size_t &value) {
  const char *last = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), last, value);
  return result.ec == std::errc() && result.ptr == last;
}

std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.10g", number);
  return buffer;
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char letter : text.substr(0, kLongestQuote)) {
    const auto code = static_cast<unsigned char>(letter);
    result += code < 0x20 || code == 0x7f ? '?' : letter;
  }
  return result + (text.size() > kLongestQuote ? "...'" : "'");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char &letter : result)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return result;
}

std::string_view without_quotes(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && text.front() == text.back() && (text[0] == '"' || text[0] == '\'');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  size_t first = 0;
  while (first < text.size()) {
    while (first < text.size() && is_blank(text[first])) first++;
    size_t last = first;
    while (last < text.size() && !is_blank(text[last])) last++;
    if (last > first) words.push_back(text.substr(first, last - first));
    first = last;
  }
  return words;
}

}  // namespace particles
