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

// The result of a sculpting step on the levels of a patch.
struct SculptResult {
  PatchLevels levels;
  FaceSelection touched;  // empty: nothing was changed
  const char* problem =
      nullptr;  // the reason why nothing was changed; English text, translated in the context "Property"
  std::string step = {};
};

// Subdivides a patch. times: number of levels to add.
SculptResult subdivided(PatchLevels levels, int times, NumberType numbers, Progress progress);
// Remeshes a patch by remeshToSurroundings(). It has one level then.
SculptResult refined(const PatchLevels& levels, NumberType numbers, Progress progress);
// Options for smoothing noise, with the chosen method.
struct Denoising {
  NoiseMethod method = NoiseMethod::Bilateral;
  NoiseSmoothing bilateral;
  LaplaceSmoothing laplace;
};
Denoising denoisingOf(const OperationValues& values, NumberType numbers);

// Smooths noise on the patch, or along the border of the surface if the patch is empty.
SculptResult denoised(PatchLevels levels, Denoising options, Progress progress);
// Removes the finest level of a patch.
SculptResult coarsened(PatchLevels levels);
// Returns the result of a finished stroke.
SculptResult sculpted(const SculptStroke& stroke);

// Returns the subdivision levels of a patch on which a step works: those that the document stores for this patch if
// the finest of them is number `finest`, otherwise the patch as a single level if `finest` is 0. Returns nothing if
// neither is the case.
std::optional<PatchLevels> levelsOf(const MeshDocument& document, const FaceSelection& patch, std::size_t finest);

// A function that performs a step.
using SculptWork = std::function<SculptResult(Progress)>;
// Reads the rest of a step "stroke", "subdivide", "refine", "smooth-noise" or "level-back". Returns null if the step is
// invalid.
SculptWork readSculptLine(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document);

}  // namespace handwheel
