// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What somebody may have meant by a word that is not known.
#include "dem/scene/suggestion.hpp"

#include <algorithm>

namespace scene {

size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); j++) last[j] = j;
  for (size_t i = 1; i <= a.size(); i++) {
    row[0] = i;
    for (size_t j = 1; j <= b.size(); j++) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

std::string suggestion(std::string_view word, const std::vector<std::string> &known) {
  std::string nearest, all;
  size_t least = 0;
  for (const std::string &candidate : known) {
    const size_t distance = edit_distance(word, candidate);
    if (nearest.empty() || distance < least) {
      nearest = candidate;
      least = distance;
    }
    all += (all.empty() ? "" : ", ") + candidate;
  }
  if (nearest.empty()) return "";
  const size_t tolerable = std::max<size_t>(1, std::max(word.size(), nearest.size()) / 3);
  if (least <= tolerable) return ": did you mean '" + nearest + "'?";
  return "; known are " + all;
}

}  // namespace scene
