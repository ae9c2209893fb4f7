// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/LaplaceSmoothing.h"
#include "mesh/sculpt/NoiseSmoothing.h"
#include "tools/mesh/ScriptLine.h"
#include "tools/mesh/sculpt/SculptSettings.h"
#include "tools/mesh/sculpt/SculptStroke.h"

#include <functional>
#include <optional>

namespace handwheel {

class MeshDocument;

// Result of a sculpting step on the levels of a patch.
struct SculptResult {
  PatchLevels levels;
  FaceSelection touched;          // empty: nothing was changed
  const char* problem = nullptr;  // the reason if nothing was changed; English, context "Property"
  std::string step = {};
};

// Subdivides a patch. times: number of levels to add; none: until it is as fine as its surroundings.
SculptResult subdivided(PatchLevels levels, std::optional<int> times, NumberType numbers, Progress progress);
// Options for smoothing noise, with the chosen method.
struct Denoising {
  NoiseMethod method = NoiseMethod::Bilateral;
  NoiseSmoothing bilateral;
  LaplaceSmoothing laplace;
};
Denoising denoisingOf(const OperationValues& values, NumberType numbers);

// Smooths noise on the patch, or along the border without one.
SculptResult denoised(PatchLevels levels, Denoising options, Progress progress);
// Removes the finest level of a patch.
SculptResult coarsened(PatchLevels levels);
// The result of a finished stroke.
SculptResult sculpted(const SculptStroke& stroke);

// Returns the subdivision levels of a patch on which a step works: those that the document stores for this patch, if
// their number fits `finest`, or the patch alone.
std::optional<PatchLevels> levelsOf(const MeshDocument& document, const FaceSelection& patch, std::size_t finest);

// Reads the rest of a step "stroke", "subdivide", "smooth-noise" or "level-back". Null if it is wrong.
using SculptWork = std::function<SculptResult(Progress)>;
SculptWork readSculptLine(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document);

}  // namespace handwheel
