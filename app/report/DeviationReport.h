// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/measure/Deviation.h"
#include "viewport/overlay/ColourScale.h"

#include <QImage>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// A comparison of a mesh with a scan.
struct Comparison {
  std::string mesh, scan;  // file names as the user gave them
  Deviation deviation;
  QImage picture;  // picture of the coloured mesh; null: none
};

// Returns the default range of the colour scale of a deviation map. It is the 99th percentile of the distances, or the
// largest distance if nearly all of the surface is the scan itself, as after the repair of a few holes. The range is
// above zero.
double defaultRange(const SurfaceDeviation& deviation);

// Renders the coloured mesh from four sides that together show all of it. The views are arranged in rows of two, each
// with the colour scale. Requires an X display with GLX. Errors: WriteFailed {reason}, OutOfMemory, Cancelled.
Result<QImage> deviationPicture(const HalfEdgeMesh& mesh, const VertexValues& atVertex, const ColourScale& scale,
                                Progress progress = {});

// Returns the statistics as an aligned table for people. Numbers have six digits and a decimal point in every locale.
std::string readableText(const Comparison& comparison);

// Returns all statistics and histograms as JSON, without the distances at the vertices.
nlohmann::ordered_json toJson(const Comparison& comparison);

// Returns the report as a self-contained HTML page. It embeds the histograms (SVG) and the picture.
std::string htmlOf(const Comparison& comparison);

// Returns the report as PDF (A4). Requires a QGuiApplication, because the fonts depend on it.
std::string pdfOf(const Comparison& comparison);

// Writes the report as .html, .pdf or .json, according to the extension of the path. It names the files without their
// folders, which may be called after patients. Either the whole file is written
// or nothing. Error: WriteFailed.
Status writeReport(const Comparison& comparison, const std::filesystem::path& path);

}  // namespace handwheel
