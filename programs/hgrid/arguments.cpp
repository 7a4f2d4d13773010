// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the values of options must be, with messages that say so.
#include "programs/hgrid/arguments.hpp"

#include "particles/text/number.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace command {

CLI::Validator not_negative() {
  return CLI::Validator(
      [](std::string &text) {
        double value = 0;
        if (const char *fault = particles::number_fault(text, value)) return particles::in_quotes(text) + " " + fault;
        return value < 0 ? particles::in_quotes(text) + " is negative" : std::string();
      },
      ">=0");
}

CLI::Validator positive_count() {
  return CLI::Validator(
      [](std::string &text) {
        size_t value = 0;
        if (particles::read_count(text, value) && value > 0) return std::string();
        return particles::in_quotes(text) + " is not a whole number of 1 or more";
      },
      ">=1");
}

std::vector<std::string> word_list(const std::string &text) {
  std::vector<std::string> words;
  for (size_t first = 0; !text.empty() && first <= text.size();) {
    const size_t last = std::min(text.find(',', first), text.size());
    words.emplace_back(particles::trimmed(std::string_view(text).substr(first, last - first)));
    first = last + 1;
  }
  return words;
}

std::vector<double> number_list(const std::string &option, const std::string &text) {
  std::vector<double> values;
  for (const std::string &word : word_list(text)) {
    values.push_back(0);
    if (const char *fault = particles::number_fault(word, values.back()))
      throw CLI::ValidationError(option, particles::in_quotes(word) + " " + fault);
  }
  return values;
}

}  // namespace command
