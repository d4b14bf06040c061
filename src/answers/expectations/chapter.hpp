// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace berm::expectations {

/// What the examples of a chapter of the verification book are about.
enum class Chapter { motion, contact, laws, water, clay, sand, fem, settings, other };

/// The word for each chapter.
inline const std::vector<const char*> chapter_words = {"motion", "contact", "laws", "water", "clay", "sand", "fem", "settings", "other"};

/// The heading of each chapter.
inline constexpr std::array chapter_titles = {"Motion and waves",  "Contact and friction", "Soil laws",
                                              "Water in the soil", "Structures in clay",   "Structures in sand",
                                              "Finite elements",   "Settings and bands",   "Other examples"};

}  // namespace berm::expectations
