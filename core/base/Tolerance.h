// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace handwheel::tolerance {

// The tolerances of the program: limits for equal, flat, parallel and near. A bound that guards a single formula
// against its own rounding is defined beside that formula. Lengths are fractions of the model's bounding-box diagonal
// unless the comment indicates otherwise.

// A shell is an open sheet if its area vector (the sum of its faces' areas times normals) exceeds this fraction of its
// area. A flat sheet has 1, half a sphere 0.5, and a cube without a side 0.2. Of 70 scans, sheets had at least 0.5, and
// bodies at most 0.43.
inline constexpr double kSheetAreaVector = 0.45;
// A part is thin if its volume is less than this fraction of its area to the power 3/2. A sphere has 0.094, half a
// sphere 0.13.
inline constexpr double kSheetVolume = 0.06;
// A part is an open sheet if the square of its longest boundary loop exceeds this multiple of its area. The value is
// eight times that of a flat disc, for the frayed edge of a single-view scan. A toothed hole in a box has 81, a
// single-view scan 125.
inline constexpr double kRaggedOutline = 100.0;
// A part is debris if its area and its number of faces are less than these fractions of those of the largest part.
inline constexpr double kDebrisArea = 0.01;
inline constexpr double kDebrisFaces = 0.01;
// An open piece with fewer faces is a crumb of a scan, whatever it lies on.
inline constexpr std::size_t kCrumbFaces = 12;
// Second layers of a scan are at most this fraction of the diagonal from the first, and the sides of cracks from each
// other.
inline constexpr double kLayerReach = 0.006;
inline constexpr double kCrackReach = 0.006;
// A face attached to a non-manifold edge is removed as a flap if none of its edges is longer than this.
inline constexpr double kFlap = 0.01;
// Vertices on open borders nearer than this count as one vertex that was split by the rounding of the file. A repair
// merges them. This is the default of the fidelity setting mesh.near_weld.
inline constexpr double kNearWeld = 1e-5;
// Vertices on open borders are merged only if their distance is at most this fraction of the longer border edge at
// either vertex. Larger distances are detail.
inline constexpr double kNearWeldEdge = 0.25;
// A patch may extend beyond the box of its loop by this fraction of the diagonal of that box.
inline constexpr double kPatchSwelling = 0.5;
// A patch may extend beyond the model's box by this fraction of the model's diagonal, or by kCapSlack times the height
// of a cap that continues the surroundings. If the mean cosine between the normals of the surroundings and the normal
// of the loop is less than kCapCosine, the surroundings are too steep for a cap.
inline constexpr double kModelSwelling = 0.01;
inline constexpr double kCapSlack = 1.5;
inline constexpr double kCapCosine = 0.4;
// CGAL's cubic hole triangulation is used for up to this many edges. With many more it takes too long (90 s for 2,554
// edges).
inline constexpr int kCubicFillEdges = 300;
// A loop of more edges is cut into pieces of at most this number of edges before it is triangulated. A loop of 2,554
// edges then takes 60 ms, while a loop that is filled in one piece has better triangles. This is the default of the
// fidelity setting mesh.piece_edges.
inline constexpr int kPieceEdges = 1000;
// The optimal triangulation by a criterion of this program, O(n³), is computed for up to this number of edges. Pieces
// of longer loops have half this number, so that 2,554 edges take less than 0.1 s.
inline constexpr int kOptimalFillEdges = 300;
// A patch is reported as unlike its surroundings if its largest bend exceeds theirs by more than kNoticeableBend
// (radian), or if its heights exceed the range of heights of the surroundings by more than kNoticeableRise times the
// hole's size. A cap of a sphere exceeds neither limit.
inline constexpr double kNoticeableBend = 0.5;
inline constexpr double kNoticeableRise = 0.35;
// CGAL's hole triangulation recurses once per edge at worst: 40,000 edges overflow a stack of 2 MB, 100,000 edges a
// stack of 8 MB.
inline constexpr int kLibraryFillEdges = 20'000;
// CGAL builds a vertex with n faces in O(n²): 0.2 s for 5,000 faces, 3 s for 20,000 faces.
inline constexpr int kLibraryFanFaces = 5'000;
// Density to which a patch is refined. Its edges become about as long as the edges around the hole, times √2, divided
// by this number. This is the default of the fidelity setting mesh.patch_density.
inline constexpr double kPatchDensity = 1.4142135623730951;
// A crease is continued through a hole at which it ends if its sides meet at more than this angle (radian; 30°).
inline constexpr double kCreaseAngle = 0.52;
// Limits on the new vertices of a patch, per boundary edge and in total. If the density of the surroundings requires
// more vertices, the patch is coarser. Fairing 10,000 vertices takes 0.15 s, which cannot be interrupted.
inline constexpr int kPatchVerticesPerEdge = 20;
inline constexpr int kPatchVertices = 10'000;
// A winding number that differs from an integer by at most this counts as that integer. Holes elsewhere in a surface
// change winding numbers by their solid angle, and a value midway between two integers is undecided.
inline constexpr double kWindingDoubt = 0.25;
// The thickness of a sheet after thickenSheets().
inline constexpr double kSheetThickness = 1e-3;
// An open sheet that a repair thickens without a request gets a thickness of at most this fraction of its shortest
// edge.
inline constexpr double kSheetOffsetEdge = 0.25;
// Clusters with more self-intersections than this are not removed, because that would take minutes.
inline constexpr std::size_t kMaxSelfIntersectionPairs = 50'000;
// Intersecting triangles are not cut along each other if a triangle would be cut more often than this.
inline constexpr std::size_t kCutsPerFace = 200;
// Coordinates that need more bits than this, from the largest number to the last digit of the smallest, are not those
// of a part: a double has 53 bits, and coordinates in metres with noise of 1e-17 instead of zeros need about 120. The
// time of exact arithmetic grows with the square of the number of bits.
inline constexpr int kCutBits = 512;
// Filling the holes of a mesh of n faces takes at most n log2 n times this number of steps (WorkBudget) of a
// microsecond each, or kLeastRepairBudget, which small folded meshes may need. Closing obstructed holes by cutting may
// take the same number of steps again.
inline constexpr double kRepairBudget = 1'000.0;
inline constexpr std::size_t kLeastRepairBudget = 2'000'000;
// Trials take at most this fraction of the steps for obstructed holes, and at most about 20 s in addition to the passes
// over the mesh.
inline constexpr double kObstructedHoleShare = 0.5;
inline constexpr std::size_t kObstructedHoleBudget = 20'000'000;
// Replacing folded regions takes at most this fraction of the steps for obstructed holes, and at most about 10 s in
// addition to the passes over the mesh. Separating coincident vertices takes at most the fraction kSeparationShare.
inline constexpr double kFoldedRegionShare = 0.25;
inline constexpr std::size_t kFoldedRegionBudget = 10'000'000;
inline constexpr double kSeparationShare = 0.25;
// Steps per face that passes over the whole mesh may take in addition to the fixed numbers of steps. A pass takes about
// one step per face, thickening a sound sheet about five, and a trial may take a quarter of the remaining steps.
inline constexpr std::size_t kPassBudget = 40;
// A folded region around a hole is removed and refilled if that moves the surface by at most this fraction of the
// diagonal. A larger displacement would change the shape of the part.
inline constexpr double kFoldedRegionMove = 0.01;
// A folded body is removed as a whole if that moves the surface by at most this fraction of the diagonal.
inline constexpr double kFoldedRegionBodyMove = 1e-3;
// Material that a repair removed is reported if it projected by more than this fraction of the diagonal.
inline constexpr double kRemovedPart = 0.01;
// A non-orientable surface is made orientable by cuts no longer than this fraction of the diagonal. Longer cuts change
// the shape, and are made only on request.
inline constexpr double kOneSidedCut = 0.01;
// A polygon of a file is planar if no corner is further from its plane than this fraction of its size. The right
// triangulation of other polygons depends on more than the outline, and a fan is expected for them.
inline constexpr double kPlanarPolygon = 1e-3;

// Faces that meet at no more than this angle (radian; 1°) count as coplanar in edge detection. Files in single
// precision rotate faces by less, and the sides of a finely tessellated cylinder meet at a larger angle.
inline constexpr double kFlatEdge = 0.0175;

// Points nearer to a plane than this count as points in the plane when the program searches for a flat face on which a
// part can rest. The value is a hundred times the rounding of single precision. It is so small that a smooth ball has
// no flat face: a cap of this height has at most sqrt(3) times this fraction of the area of the ball.
inline constexpr double kFlatBaseFlatness = 1e-5;
// A flat face has at least this fraction of the part's area. A smaller face is a facet of a curved surface rather than
// a base.
inline constexpr double kFlatBaseShare = 1e-3;
// Neighbouring faces are in one plane if the cosine of the angle between their normals is at least this (0.08°). Single
// precision rotates faces with a thousandth of the size of the part by less.
inline constexpr double kFlatCosine = 1.0 - 1e-6;

// The distance of a haptic proxy from the surface that it touches. It is far above the effect of rounding, and far
// below a visible distance.
inline constexpr double kContactSkin = 0x1p-27;
// The width up to which gaps are closed before a scan is used for haptic contact.
inline constexpr double kContactGap = 0x1p-12;
// Corners across a gap are merged if the gap is narrower than this fraction of the open edges at the corners. A strip
// of triangles would form a step there: the borders are rarely equally high, and a proxy stops at a step of a
// micrometre.
inline constexpr double kContactGapEdge = 0.25;
// The distance within which the surface is searched after an edit that may have buried a haptic proxy.
inline constexpr double kContactBuried = 0.01;
// Two contact planes count as one if the square of the sine of their angle is less than this.
inline constexpr double kOnePlane = 1e-14;
// A third contact plane is redundant if the square of the volume that the three normals span is less than this.
inline constexpr double kSpannedVolume = 1e-18;

// A face counts as a needle if its height divided by its longest side is less than this, unless it was nearly a needle
// before.
inline constexpr double kNeedle = 1e-4;
// A triangle with a smaller sine at a corner may be degenerate, and is tested exactly.
inline constexpr double kLeastSine = 1e-12;
// If the sine of the angle between a vector and an axis is less than this, their cross product has no significant
// digits.
inline constexpr double kAlongAxis = 1e-9;
// The distance after an ignored face at which the search for the opposite wall continues.
inline constexpr double kPastFace = 1e-9;

// Knots that differ by less than this fraction of their range are one knot that was written inexactly. A curve with
// such knots is refused.
inline constexpr double kKnotSpan = 1e-12;
// A point is on the axis if its radius is less than this fraction of the largest radius.
inline constexpr double kOnAxis = 1e-12;
// The relative accuracy of integrated volumes and areas of NURBS solids. The result of the library's default is wrong
// by 1 % on rational surfaces, and its estimate of its own error is too small where weights differ much (the error is
// 4e-6 if 1e-9 is requested, 5e-7 if 1e-11 is requested). The volume of a written solid must agree with the intended
// one to the relative accuracy kWrittenVolume.
inline constexpr double kQuadrature = 1e-11;
inline constexpr double kWrittenVolume = 1e-6;

// A direction read from a file is valid if its length after normalisation differs from one by less than this.
inline constexpr double kUnitLength = 1e-9;
// A robot has reached a point if the distance between its tool and the point is less than this fraction of the robot's
// reach.
inline constexpr double kReached = 1e-9;
// A point nearer to a joint's axis than kLeastLever (mm) does not determine a rotation. A joint is at rest if it moves
// by less than kStillJoint (rad or mm), which is less than any pointer resolves.
inline constexpr double kLeastLever = 0.01;
inline constexpr double kStillJoint = 1e-7;
// A pointer's ray is parallel to an axis if the sine of their angle is less than this.
inline constexpr double kParallelLines = 1e-3;

}  // namespace handwheel::tolerance
