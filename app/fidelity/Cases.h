// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/FidelitySweep.h"
#include "mesh/structure/TriangleSoup.h"

#include <memory>

namespace handwheel {

// Test cases that measure the error and the cost of the fidelity settings. Each comment begins with the ids of the
// settings that the functions below it measure. Most cases use built-in shapes, whose true result is known in closed
// form or by construction. Functions ending in "On" return cases for a mesh of the user; the true result is then
// the mesh before the case damaged it.

// A function that provides the mesh of a test case. It is called when the case first runs; the mesh must have a face
// with area.
using SoupSource = std::function<std::shared_ptr<const TriangleSoup>()>;

// mesh.near_weld: a surface torn along one plane and slit along another. The tear is due to rounding (1e-8 to 1e-5 of
// the diagonal), the slit is a real gap (2e-5 to 1e-3). An error is a torn vertex that stays torn, or a slit vertex
// that is merged.
std::vector<FidelityCase> nearWeldCases();
FidelityCase nearWeldCaseOn(const std::string& name, SoupSource soup);

// mesh.fill_method, mesh.fill_continuity, mesh.patch_density, mesh.piece_edges: holes cut into a surface and filled
// again. The first three settings are also measured on simulated scans of parts with sharp edges, which are compared
// with the exact part.
std::vector<FidelityCase> fillMethodCases();
FidelityCase fillMethodCaseOn(const std::string& name, SoupSource soup);
std::vector<FidelityCase> fillContinuityCases();
FidelityCase fillContinuityCaseOn(const std::string& name, SoupSource soup);
std::vector<FidelityCase> patchDensityCases();
FidelityCase patchDensityCaseOn(const std::string& name, SoupSource soup);
std::vector<FidelityCase> pieceEdgesCases();
FidelityCase pieceEdgesCaseOn(const std::string& name, SoupSource soup);

// mesh.decimation_error: distance of a decimated mesh from the original.
std::vector<FidelityCase> decimationErrorCases();
FidelityCase decimationErrorCaseOn(const std::string& name, SoupSource soup);

// mesh.decimation_method: distance and time at half, a tenth and a fiftieth of the triangles. A method that does not
// reach the number of triangles has no result.
std::vector<FidelityCase> decimationMethodCases();
std::vector<FidelityCase> decimationMethodCasesOn(const std::string& name, const SoupSource& soup);

// volume.voxels, volume.method, volume.reduction: a ball, and a block at an angle to the grid, converted to volumes and
// back to meshes.
std::vector<FidelityCase> volumeVoxelsCases();
std::vector<FidelityCase> volumeMethodCases();
std::vector<FidelityCase> volumeReductionCases();

// volume.polygons: the edges of a block along the grid and of a rotated block.
std::vector<FidelityCase> volumePolygonsCases();

// volume.pieces: a ball of clay that is carved at several positions.
std::vector<FidelityCase> volumePiecesCases();

// drill.erosion: a head that advances evenly through material, along the grid and across it.
std::vector<FidelityCase> drillErosionCases();

// document.undo_granularity: edits of a large mesh, stored and exchanged as in an undo step.
std::vector<FidelityCase> undoGranularityCases();
FidelityCase undoGranularityCaseOn(const std::string& name, SoupSource soup);

// nurbs.chord_mm: stock cylinders as triangles, and a turned part as a fitted curve and triangles.
FidelitySetting chordSetting();
std::vector<FidelityCase> chordCases();

// step.chord: a bar and a ball in STEP files, read as triangles.
std::vector<FidelityCase> stepChordCases();

// turn.force_model: cutting forces compared with published tables.
std::vector<FidelityCase> forceModelCases();

// turn.spacing: grooves turned into a bar.
std::vector<FidelityCase> turnSpacingCases();

// turn.method, turn.resolution: a shoulder and a cone, each turned in one pass.
std::vector<FidelityCase> turnMethodCases();
std::vector<FidelityCase> turnResolutionCases();

// turn.step: a lathe whose lever is operated and whose tool is moved by hand.
std::vector<FidelityCase> turnIncrementCases();

// view.block_faces: display blocks that are rebuilt after an edit of one face.
FidelitySetting blockFacesSetting();
std::vector<FidelityCase> blockFacesCases();
FidelityCase blockFacesCaseOn(const std::string& name, SoupSource soup);

// view.coarse_triangles: the simplified mesh drawn while the camera moves, against the full mesh.
FidelitySetting coarseTrianglesSetting();
std::vector<FidelityCase> coarseTrianglesCases();
FidelityCase coarseTrianglesCaseOn(const std::string& name, SoupSource soup);

// cell.shape_sides: round shapes of robots as triangles.
FidelitySetting shapeSidesSetting();
std::vector<FidelityCase> shapeSidesCases();

// ik.tolerance: poses that an arm reaches.
std::vector<FidelityCase> ikToleranceCases();

// plan.resolution: motions of an arm that keep a clearance by a small or a large margin.
std::vector<FidelityCase> planResolutionCases();

// verify.step: motions of an arm that collide, checked in fixed steps.
std::vector<FidelityCase> verifyStepCases();

// plan.shortcuts: tasks of an arm among boxes.
std::vector<FidelityCase> planShortcutsCases();

// proximity.tolerance: the distance between meshes that are moved past each other.
std::vector<FidelityCase> proximityToleranceCases();

// snap.radius: a scripted hand that moves to one of many points, misses it a little and trembles.
std::vector<FidelityCase> snapRadiusCases();

// snap.features: the force when more features are within reach than may act at once.
std::vector<FidelityCase> snapFeaturesCases();

// proxy.tolerance: a tip that moves along below the surface of a bumpy ball.
std::vector<FidelityCase> proxyToleranceCases();

// contact.stiffness: a simulated hand that presses on a surface. The servo loop runs at the rate that the stiffness
// needs.
std::vector<FidelityCase> contactStiffnessCases();

// servo.rate: the simulated hand on a wall as stiff as the rate allows. The cost is measured with a tip moving along
// the bumpy ball.
std::vector<FidelityCase> servoRateCases();

// servo.velocity_window: an oscillating hand whose position is measured with the resolution of a device.
std::vector<FidelityCase> velocityWindowCases();

}  // namespace handwheel
