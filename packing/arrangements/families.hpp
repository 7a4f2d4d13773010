// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What lays the places of each arrangement; packing/arrangement.cpp says what they are.
#pragma once

#include "packing/arrangements/places.hpp"

namespace packing {

// clustered.cpp: places crowd here and are few there.
void lay_gas(Places &places);
void lay_clusters(Places &places);
void lay_clumps(Places &places);
void lay_crowd(Places &places);
// filaments.cpp
void lay_filaments(Places &places);
// sheets.cpp: of the thickness of a few particles.
void lay_film(Places &places);
void lay_shell(Places &places);
// jet.cpp
void lay_jet(Places &places);
// extents.cpp: of an extent without measure.
void lay_far(Places &places);
void lay_outliers(Places &places);
void lay_dust(Places &places);
void lay_scales(Places &places);
// parts.cpp: a part of a periodic box is filled.
void lay_part(Places &places);
void lay_part_across(Places &places);

}  // namespace packing
