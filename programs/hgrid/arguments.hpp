// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the values of options must be, with messages that say so.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class Validator;
}

namespace command {

// A finite number >= 0, and a whole number >= 1.
CLI::Validator not_negative();
CLI::Validator positive_count();

// The words between the commas of `text`, without blanks around; none for an empty text.
std::vector<std::string> word_list(const std::string &text);

// The numbers between the commas of `text`, such as "0,0,0,1,1,1"; none for an empty text. Throws CLI::ValidationError
// for `option`.
std::vector<double> number_list(const std::string &option, const std::string &text);

}  // namespace command
