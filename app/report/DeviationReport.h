// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/Deviation.h"
#include "viewport/ColourScale.h"

#include <QImage>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// What was compared with what, and how far they are apart.
struct Comparison {
  std::string mesh, scan;  // names of the files, as the user gave them
  Deviation deviation;
  QImage picture;  // of the mesh in colours; null for none
};

// What the colours of a deviation map span: up to the 99th percentile; where so much of the surface is the very scan,
// as after the repair of a few holes, up to the largest distance. Above zero.
double usualRange(const SurfaceDeviation& deviation);

// The mesh in the colours of the values, from four sides between which all of it is seen, each with the scale; two
// beside each other. Needs an X display with GLX. Errors: WriteFailed {reason}, Cancelled.
Result<QImage> deviationPicture(const HalfEdgeMesh& mesh, const VertexValues& atVertex, const ColourScale& scale,
                                Progress progress = {});

// The figures as an aligned table for people. Numbers have six digits and a decimal point in every locale.
std::string readableText(const Comparison& comparison);

// All figures, histograms too; the distances at the vertices are left out.
nlohmann::ordered_json toJson(const Comparison& comparison);

// A page that needs no other file, with the histograms (SVG) and the picture in it.
std::string htmlOf(const Comparison& comparison);

// The same on paper (A4). Needs fonts, so a QGuiApplication.
std::string pdfOf(const Comparison& comparison);

// By the ending of the path: .html, .pdf or .json. The whole file or nothing. Error: WriteFailed.
Status writeReport(const Comparison& comparison, const std::filesystem::path& path);

}  // namespace handwheel
