/* SPDX-FileCopyrightText: The libhgrid developers
 * SPDX-License-Identifier: BSD-3-Clause */

/* What the typemaps of octave.i call, in C++: matrices to numbers and back, errors, visitors. */
#pragma once

#include "grid_object.h"

#include <octave/Cell.h>
#include <octave/oct-map.h>
#include <octave/ov.h>
#include <octave/parse.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <string>
#include <vector>

static void hgrid_raise_status(hg_status status) {
  error_with_id((std::string("hgrid:") + hg_status_string(status)).c_str(), "%s", hg_last_error());
}

/* For what is wrong before the library is asked. */
static void hgrid_check_matrix(const octave_value &given, const char *name) {
  if (!(given.isnumeric() || given.islogical()) || given.iscomplex()) {
    error_with_id("hgrid:HG_ERR_ARGUMENT", "%s is a %s, not a real matrix", name, given.class_name().c_str());
  }
  if (given.ndims() > 2) error_with_id("hgrid:HG_ERR_ARGUMENT", "%s has %d dimensions, not 2", name, given.ndims());
}

/* Octave keeps columns together, the library rows. */
template <class Number, class Matrix, class Convert>
void hgrid_copy_rows(const Matrix &matrix, std::vector<Number> &numbers, Convert &&convert) {
  numbers.clear();
  numbers.reserve(matrix.numel());
  for (octave_idx_type row = 0; row < matrix.rows(); ++row) {
    for (octave_idx_type column = 0; column < matrix.columns(); ++column) {
      numbers.push_back(convert(matrix(row, column)));
    }
  }
}

/* An integer of 64 bits as a double of the same value. */
template <class Integer>
double hgrid_exact_double(Integer value, const char *name) {
  const double rounded = static_cast<double>(value);
  /* 2^64 and 2^63 are doubles, the largest integers are not. */
  if (rounded >= std::ldexp(1.0, std::numeric_limits<Integer>::digits) || static_cast<Integer>(rounded) != value) {
    error_with_id("hgrid:HG_ERR_ARGUMENT", "%s holds %s, an integer that no double holds", name,
                  std::to_string(value).c_str());
  }
  return rounded;
}

static void hgrid_take_reals(const octave_value &given, const char *name, std::vector<double> &numbers,
                             hgrid_reals &table) {
  hgrid_check_matrix(given, name);
  if (given.is_int64_type()) {
    hgrid_copy_rows(given.int64_array_value(), numbers,
                    [name](octave_int64 each) { return hgrid_exact_double(each.value(), name); });
  } else if (given.is_uint64_type()) {
    hgrid_copy_rows(given.uint64_array_value(), numbers,
                    [name](octave_uint64 each) { return hgrid_exact_double(each.value(), name); });
  } else {
    hgrid_copy_rows(given.array_value(), numbers, [](double each) { return each; });
  }
  table.data = numbers.data();
  table.rows = given.rows();
  table.columns = given.columns();
}

static int64_t hgrid_exact_integer(double value, const char *name) {
  if (!(std::fabs(value) < std::ldexp(1.0, 63)) || std::floor(value) != value) {
    error_with_id("hgrid:HG_ERR_ARGUMENT", "%s holds %.17g, which is no integer of 64 bits", name, value);
  }
  return static_cast<int64_t>(value);
}

static void hgrid_take_integers(const octave_value &given, const char *name, std::vector<int64_t> &numbers,
                                hgrid_integers &table) {
  hgrid_check_matrix(given, name);
  if (given.is_int64_type()) {
    hgrid_copy_rows(given.int64_array_value(), numbers, [](octave_int64 each) { return each.value(); });
  } else {
    hgrid_copy_rows(given.array_value(), numbers, [name](double each) { return hgrid_exact_integer(each, name); });
  }
  table.data = numbers.data();
  table.rows = given.rows();
  table.columns = given.columns();
}

static double hgrid_take_number(const octave_value &given, const char *name) {
  hgrid_check_matrix(given, name);
  if (given.numel() != 1) error_with_id("hgrid:HG_ERR_ARGUMENT", "%s must be one number", name);
  return given.double_value();
}

static int32_t hgrid_take_integer(const octave_value &given, const char *name) {
  const int64_t value = hgrid_exact_integer(hgrid_take_number(given, name), name);
  if (value != static_cast<int32_t>(value)) {
    error_with_id("hgrid:HG_ERR_ARGUMENT", "%s does not fit in 32 bits", name);
  }
  return static_cast<int32_t>(value);
}

/* A definition that frees itself. */
struct HgridDefinition {
  hgrid_definition definition;
  HgridDefinition() { hgrid_definition_begin(&definition); }
  HgridDefinition(const HgridDefinition &) = delete;
  HgridDefinition &operator=(const HgridDefinition &) = delete;
  ~HgridDefinition() { free(definition.cell_sizes.data); }
};

/* From a struct with the names of members of hg_grid_def. */
static void hgrid_take_definition(const octave_value &given, HgridDefinition &made) {
  if (!given.isstruct() || given.numel() != 1) {
    error_with_id("hgrid:HG_ERR_ARGUMENT", "a definition is a struct, not a %s", given.class_name().c_str());
  }
  const octave_scalar_map members = given.scalar_map_value();
  const string_vector names = members.fieldnames();
  for (octave_idx_type k = 0; k < names.numel(); ++k) {
    std::vector<double> numbers;
    hgrid_reals values = {};
    hgrid_take_reals(members.contents(names(k)), names(k).c_str(), numbers, values);
    /* cell_sizes stay with the definition, others do not. */
    double *const copy = static_cast<double *>(malloc((numbers.size() + 1) * sizeof(double)));
    if (copy == nullptr) error_with_id("hgrid:HG_ERR_MEMORY", "no memory for %s", names(k).c_str());
    std::copy(numbers.begin(), numbers.end(), copy);
    values.data = copy;
    const hg_status status = hgrid_definition_put(&made.definition, names(k).c_str(), &values);
    free(values.data);
    if (status != HG_OK) hgrid_raise_status(status);
  }
}

/* A matrix of Octave's with what `take` makes of each number. */
template <class Made, class Take>
Made hgrid_fill(Made made, const hgrid_rows &rows, Take &&take) {
  for (size_t row = 0; row < rows.rows; ++row) {
    for (size_t column = 0; column < rows.columns; ++column) {
      made(static_cast<octave_idx_type>(row), static_cast<octave_idx_type>(column)) = take(&rows, row, column);
    }
  }
  return made;
}

/* Doubles, with which Octave computes; 64-bit integers where one of them is no double. */
static octave_value hgrid_matrix_of(const hgrid_rows &rows) {
  const auto height = static_cast<octave_idx_type>(rows.rows), width = static_cast<octave_idx_type>(rows.columns);
  bool exact = true;
  const Matrix numbers =
      hgrid_fill(Matrix(height, width), rows, [&](const hgrid_rows *from, size_t row, size_t column) {
        const double value = hgrid_real_at(from, row, column);
        exact = exact && (from->type != 'l' || std::fabs(value) <= std::ldexp(1.0, 53));
        return value;
      });
  if (exact) return numbers;
  return hgrid_fill(int64NDArray(dim_vector(height, width)), rows,
                    [](const hgrid_rows *from, size_t row, size_t column) {
                      return octave_int64(hgrid_integer_at(from, row, column));
                    });
}

/* Where the rows start in the list of all, counted from 1. */
static octave_value hgrid_offsets_of(const hgrid_lists &lists) {
  hgrid_rows offsets = hgrid_list_of(lists.offsets, 'l', lists.offsets == nullptr ? 0 : lists.count + 1);
  offsets.add = 1;
  return hgrid_matrix_of(offsets);
}

static octave_value hgrid_ids_of(const hgrid_lists &lists) {
  const size_t count = lists.offsets == nullptr ? 0 : static_cast<size_t>(lists.offsets[lists.count]);
  return hgrid_matrix_of(hgrid_list_of(lists.ids, 'i', count));
}

static octave_value hgrid_structs_of(const hgrid_records &records) {
  const auto width = static_cast<octave_idx_type>(records.count);
  octave_map structs(dim_vector(1, width));
  for (const hgrid_member *member = records.members; member->name != nullptr; ++member) {
    Cell values(1, width);
    for (octave_idx_type k = 0; k < width; ++k) {
      const hgrid_rows value = hgrid_member_at(&records, static_cast<size_t>(k), member);
      values(0, k) = hgrid_real_at(&value, 0, 0);
    }
    structs.setfield(member->name, values);
  }
  if (records.is_list) return structs;
  return octave_scalar_map(structs.checkelem(0));
}

/* A visit on its way. */
struct HgridVisit {
  octave_value function;
  std::exception_ptr error;
};

/* No exception may pass through the library. */
static int32_t hgrid_hand_over(HgridVisit &visit, const octave_value_list &tables) {
  try {
    const octave_value_list answer = octave::feval(visit.function, tables, 0);
    return answer.length() > 0 && answer(0).is_defined() && answer(0).is_true() ? 1 : 0;
  } catch (...) {
    visit.error = std::current_exception();
    return 1;
  }
}

static int32_t hgrid_visit_pairs_in(void *context, const hg_pair *pairs, size_t count) {
  octave_value_list tables;
  tables.append(hgrid_matrix_of(hgrid_rows_of(pairs, 'i', count, 2)));
  return hgrid_hand_over(*static_cast<HgridVisit *>(context), tables);
}

static int32_t hgrid_visit_contacts_in(void *context, const hg_contact_batch *batch) {
  hgrid_contact_tables arranged;
  octave_value_list tables;
  hgrid_arrange(batch, &arranged);
  for (const hgrid_rows &rows : arranged.rows) tables.append(hgrid_matrix_of(rows));
  return hgrid_hand_over(*static_cast<HgridVisit *>(context), tables);
}
