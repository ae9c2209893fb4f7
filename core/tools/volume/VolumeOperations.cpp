// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/VolumeOperations.h"

#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "volume/VolumeToSurface.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Parameter lengthParameter(const char* id, const char* label, std::string meaning) {
  return {.property = {.id = id,
                       .group = {},
                       .label = label,
                       .value = 0.0,
                       .quantity = Quantity::Length,
                       .least = 1e-9,
                       .largest = 1e9},
          .meaning = std::move(meaning),
          .word = "MM",
          .hasDefault = false};
}

}  // namespace

const Operation& voxelizeOperation() {
  static const Operation operation = {
      .id = "voxelize",
      .title = QT_TRANSLATE_NOOP("Tool", "Make volume"),
      .meaning = "Samples what a surface encloses",
      .parameters = {lengthParameter("voxel", QT_TRANSLATE_NOOP("Property", "Voxel"),
                                     "Edge of a voxel; default: a 256th of the largest extent"),
                     lengthParameter("wall", QT_TRANSLATE_NOOP("Property", "Wall thickness"),
                                     "Make walls of this thickness of the triangles: of open sheets, and of triangles "
                                     "that share no edges, which enclose nothing")}};
  return operation;
}

const Operation& remeshOperation() {
  static const Operation operation = [] {
    Parameter faces = {.property = {.id = "faces",
                                    .group = {},
                                    .label = QT_TRANSLATE_NOOP("Property", "Triangles"),
                                    .value = 0.0,
                                    .least = 0.0,
                                    .largest = 1e9},
                       .meaning = "Reduce to this many triangles; without it: as few as --error allows",
                       .word = "N",
                       .isWhole = true};
    return Operation{.id = "remesh",
                     .title = QT_TRANSLATE_NOOP("Tool", "Make mesh"),
                     .meaning = "Makes triangles of the surface of a volume",
                     .parameters = {lengthParameter("error", QT_TRANSLATE_NOOP("Property", "Largest distance"),
                                                    "Reduce triangles within this distance of the surface"),
                                    std::move(faces)}};
  }();
  return operation;
}

Result<Remeshed> remesh(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  const bool isReduced = values.given("error") || values.whole("faces") > 0;
  const Progress making = progress.part(0.0, isReduced ? 0.2 : 1.0);
  Remeshed done;
  const TriangleSoup surface = surfaceOf(volume, making.part(0.0, 0.5));
  done.before = surface.triangles.size();
  done.mesh = buildMesh(surface, making.part(0.5, 1.0)).mesh;
  if (isReduced && !progress.cancelled()) {
    DecimationOptions options;
    options.faces = values.whole("faces");
    options.error = values.given("error");
    options.avoidIntersections = true;
    options.measureDistance = true;
    done.largestDistance = decimate(done.mesh, options, progress.part(0.2, 1.0)).largestDistance;
  }
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return done;
}

}  // namespace handwheel
