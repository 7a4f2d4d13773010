// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The second line of a frame of extended XYZ: key=value among free text.
#pragma once

#include "particles/text/text_file.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace particles {

class XyzKeys {
 public:
  // Reads key=value, also with blanks around the sign; values bare, in quotes of both kinds with escapes (\"), in
  // braces or brackets. A word without a sign stands for true. Fails at the cursor's line where quotes or brackets do
  // not end.
  XyzKeys(const LineCursor &cursor, std::string_view line);

  // The value of a key: spelled so, else whatever the case; nullptr if there is none. Fails at the cursor's line if
  // there are two.
  const std::string *find(const LineCursor &cursor, std::string_view key) const;

 private:
  std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace particles
