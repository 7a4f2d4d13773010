// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a target may do with bad input: refuse it with a text, itself or through the library.
#pragma once

#include "fuzz/expect.hpp"
#include "particles/error.hpp"

namespace fuzz {

template <class Work>
void done_or_refused(Work work) {
  const auto refused = [](const std::exception &error) { expect(error.what()[0] != '\0', "a refusal without a text"); };
  try {
    work();
  } catch (const particles::Error &error) {
    refused(error);
  } catch (const hgrid::Error &error) {
    refused(error);
  }
}

}  // namespace fuzz
