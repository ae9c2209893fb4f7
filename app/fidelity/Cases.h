// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelitySweep.h"
#include "mesh/TriangleSoup.h"

#include <memory>

namespace handwheel {

// What the settings are measured on. Each on built-in shapes, where the truth is known in closed form or by
// construction, and most on a mesh that the user brings, where the truth is what was there before the case spoilt it.
// Asked when a case first runs; its mesh must have a face with area.
using SoupSource = std::function<std::shared_ptr<const TriangleSoup>()>;

// mesh.near_weld: a surface torn along one plane by rounding (1e-8 to 1e-5 of the diagonal), and slit along another by
// a real gap (2e-5 to 1e-3). Wrong is a torn vertex that stays torn and a slit one that is merged.
std::vector<FidelityCase> nearWeldCases();
FidelityCase nearWeldCaseOn(const std::string& name, SoupSource soup);

// mesh.fill_method, mesh.fill_continuity, mesh.patch_density and mesh.piece_edges: pieces cut out of a surface and
// filled again; for all but the last also out of parts with sharp edges as a scanner sees them, against the exact part.
std::vector<FidelityCase> fillMethodCases();
FidelityCase fillMethodCaseOn(const std::string& name, SoupSource soup);
std::vector<FidelityCase> fillContinuityCases();
FidelityCase fillContinuityCaseOn(const std::string& name, SoupSource soup);
std::vector<FidelityCase> patchDensityCases();
FidelityCase patchDensityCaseOn(const std::string& name, SoupSource soup);
std::vector<FidelityCase> pieceEdgesCases();
FidelityCase pieceEdgesCaseOn(const std::string& name, SoupSource soup);

// mesh.decimation_error: how far a mesh of fewer triangles is from what it was.
std::vector<FidelityCase> decimationErrorCases();
FidelityCase decimationErrorCaseOn(const std::string& name, SoupSource soup);

// document.undo_granularity: edits of a large mesh, kept and exchanged as an undo step does.
std::vector<FidelityCase> undoGranularityCases();
FidelityCase undoGranularityCaseOn(const std::string& name, SoupSource soup);

// nurbs.chord_mm: stock cylinders as triangles.
FidelitySetting chordSetting();
std::vector<FidelityCase> chordCases();

// view.block_faces: the blocks of the display that an edit of one face rebuilds.
FidelitySetting blockFacesSetting();
std::vector<FidelityCase> blockFacesCases();
FidelityCase blockFacesCaseOn(const std::string& name, SoupSource soup);

// view.coarse_triangles: what a slow display draws of a mesh while the camera moves, against the mesh.
FidelitySetting coarseTrianglesSetting();
std::vector<FidelityCase> coarseTrianglesCases();
FidelityCase coarseTrianglesCaseOn(const std::string& name, SoupSource soup);

// cell.shape_sides: round shapes of robots as triangles.
FidelitySetting shapeSidesSetting();
std::vector<FidelityCase> shapeSidesCases();

// snap.radius: a scripted hand that goes to one of many points, misses it a little and trembles.
std::vector<FidelityCase> snapRadiusCases();

// snap.features: the force where more features are in reach than pull.
std::vector<FidelityCase> snapFeaturesCases();

// proxy.tolerance: a tip below the surface of a bumpy ball, led along it.
std::vector<FidelityCase> proxyToleranceCases();

// contact.stiffness: a simulated hand that presses on a surface, at the rate which that stiffness needs.
std::vector<FidelityCase> contactStiffnessCases();

// servo.rate: the same hand on a wall as stiff as the rate allows; and a tip led along the bumpy ball, for the cost.
std::vector<FidelityCase> servoRateCases();

// servo.velocity_window: a hand that swings, read in the steps of a device.
std::vector<FidelityCase> velocityWindowCases();

}  // namespace handwheel
