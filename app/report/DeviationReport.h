// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Deviation.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// What was compared with what, and how far they are apart.
struct Comparison {
  std::string mesh, scan;  // names of the files, as the user gave them
  Deviation deviation;
};

// The figures as an aligned table for people. Numbers have six digits and a decimal point in every locale.
std::string readableText(const Comparison& comparison);

// All figures, histograms too; the distances at the vertices are left out.
nlohmann::ordered_json toJson(const Comparison& comparison);

// A page that needs no other file, with the histograms drawn in it (SVG).
std::string htmlOf(const Comparison& comparison);

// The same on paper (A4). Needs fonts, so a QGuiApplication.
std::string pdfOf(const Comparison& comparison);

}  // namespace handwheel
