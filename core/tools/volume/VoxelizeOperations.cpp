// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/VoxelizeOperations.h"

#include "base/ThreadClock.h"
#include "mesh/simplify/Decimation.h"
#include "mesh/structure/MeshBuilder.h"
#include "volume/surface/SharpSurface.h"
#include "volume/surface/VolumeToSurface.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {
namespace {

Parameter methodParameter() {
  return {.property = {.id = "method",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Method"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "Distances"),
                                   QT_TRANSLATE_NOOP("Property", "Density")}},  // in the order of VoxelMethod
          .meaning =
              "sign: distances from the surface, signed by winding numbers; density: the share of each voxel that "
              "is inside, by rays along three axes, less exact",
          .word = "METHOD",
          .words = {"sign", "density"}};
}

Parameter polygonsParameter() {
  return {.property = {.id = "method",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Method"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "Marching cubes"),
                                   QT_TRANSLATE_NOOP("Property", "Dual contouring")}},
          .meaning =
              "marching: marching cubes, which cut edges off by up to half a voxel; dual: with sharp edges and "
              "corners, as dual contouring finds them",
          .word = "METHOD",
          .words = {"marching", "dual"}};
}

// Its blocks have points of their own, which are the same where they meet.
HalfEdgeMesh meshOf(const VolumeTriangles& triangles) {
  TriangleSoup soup;
  for (std::size_t i = 0; i + 2 < triangles.points.size(); i += 3)
    soup.points.emplace_back(triangles.points[i], triangles.points[i + 1], triangles.points[i + 2]);
  for (std::size_t i = 0; i + 2 < triangles.corners.size(); i += 3)
    soup.triangles.push_back({static_cast<std::uint32_t>(triangles.corners[i]),
                              static_cast<std::uint32_t>(triangles.corners[i + 1]),
                              static_cast<std::uint32_t>(triangles.corners[i + 2])});
  return buildMesh(soup).mesh;
}

bool isReduced(const OperationValues& values) {
  return values.given("error") || values.whole("faces") > 0;
}

DecimationOptions optionsOf(const OperationValues& values) {
  DecimationOptions options;
  options.faces = values.whole("faces");
  options.error = values.given("error");
  options.avoidIntersections = true;
  options.measureDistance = true;
  return options;
}

// Counts the faces of a piece of a surface that are not near its borders, where it is reduced in another way than in
// the whole surface. If too few are left, all count.
class AwayFromBorders {
 public:
  explicit AwayFromBorders(const HalfEdgeMesh& piece) {
    Box box;
    for (HalfEdge h = 0; h < piece.halfEdgeSlots(); ++h) {
      if (!piece.isLive(HalfEdgeMesh::face(h))) continue;
      box.extend(piece.position(piece.from(h)));
      if (!piece.hasOpposite(h)) m_borders.push_back(piece.position(piece.from(h)));
    }
    if (box.isEmpty()) return;
    constexpr double kMargin = 0.1, kLeastShare = 0.2;
    m_margin = kMargin * box.sizes().maxCoeff();
    if (count(piece) < kLeastShare * static_cast<double>(piece.liveFaceCount())) m_borders.clear();
  }

  double count(const HalfEdgeMesh& mesh) const {
    double faces = 0.0;
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      if (!mesh.isLive(f)) continue;
      const TrianglePoints t = mesh.points(f);
      const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
      const auto isNear = [&](const Vec3& p) { return (p - middle).squaredNorm() < m_margin * m_margin; };
      if (std::none_of(m_borders.begin(), m_borders.end(), isNear)) ++faces;
    }
    return faces;
  }

 private:
  std::vector<Vec3> m_borders;  // vertices at open edges
  double m_margin = 0.0;        // mm
};

struct SamplePiece {
  const VolumePiece* piece;
  double weight;  // relative to other samples
};

// Returns all pieces of a small surface, weighted by their triangles; of a larger one, systematic samples: the pieces
// of every nth triangle.
std::vector<SamplePiece> samplePieces(const VolumeSurface& surface) {
  constexpr double kTried = 40'000.0;  // triangles in all
  const auto sizeOf = [](const VolumePiece& piece) { return static_cast<double>(piece.fine.corners.size() / 3); };
  double total = 0.0, squares = 0.0;
  for (const auto& [key, piece] : surface.pieces()) {
    total += sizeOf(*piece);
    squares += sizeOf(*piece) * sizeOf(*piece);
  }
  std::vector<SamplePiece> samples;
  // A piece that is chosen in this way has squares / total triangles on average.
  const double step = std::max(1.0, squares / kTried);
  double end = 0.0, next = 0.5 * step;
  for (const auto& [key, piece] : surface.pieces()) {
    end += sizeOf(*piece);
    double weight = total <= kTried ? sizeOf(*piece) : 0.0;
    for (; total > kTried && next < end; next += step) ++weight;
    if (weight > 0.0) samples.push_back({piece.get(), weight});
  }
  return samples;
}

constexpr double kSecondsAtLeast = 0.05;  // for starting and showing the mesh

}  // namespace

Parameter lengthParameter(const char* id, const char* label, std::string meaning, double least, double largest) {
  return {.property = {.id = id,
                       .group = {},
                       .label = label,
                       .value = 0.0,
                       .quantity = Quantity::Length,
                       .least = least,
                       .largest = largest},
          .meaning = std::move(meaning),
          .word = "MM",
          .hasDefault = false};
}

const Operation& voxelizeOperation() {
  static const Operation operation = {
      .id = "voxelize",
      .title = QT_TRANSLATE_NOOP("Tool", "Make volume"),
      .meaning = "Samples the space that a surface encloses",
      .parameters = {lengthParameter("voxel", QT_TRANSLATE_NOOP("Property", "Voxel"),
                                     "Edge of a voxel; default: a 256th of the largest extent"),
                     methodParameter(),
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
                       .meaning = "Reduce to this many triangles; default: as few as --error allows",
                       .word = "N",
                       .isWhole = true};
    return Operation{.id = "remesh",
                     .title = QT_TRANSLATE_NOOP("Tool", "Make mesh"),
                     .meaning = "Creates a mesh of the surface of a volume",
                     .parameters = {lengthParameter("error", QT_TRANSLATE_NOOP("Property", "Largest distance"),
                                                    "Reduce triangles within this distance of the surface"),
                                    std::move(faces), polygonsParameter()}};
  }();
  return operation;
}

RemeshPrediction predictRemesh(const VolumeSurface& surface, const OperationValues& values, Progress progress) {
  const auto total = static_cast<double>(surface.triangleCount());
  const double wanted = values.whole("faces") > 0 ? static_cast<double>(values.whole("faces")) : total;
  DecimationOptions options = optionsOf(values);
  const std::vector<SamplePiece> pieces = samplePieces(surface);
  double weights = 0.0, left = 0.0, milliseconds = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (progress.cancelled()) return {};
    progress.set(static_cast<double>(i) / static_cast<double>(pieces.size()));
    HalfEdgeMesh mesh;
    double spent = cpuMilliseconds([&] { mesh = meshOf(pieces[i].piece->fine); });
    const auto faces = static_cast<double>(mesh.liveFaceCount());
    if (faces == 0.0) continue;
    double share = 1.0;
    if (isReduced(values)) {
      const AwayFromBorders inner(mesh);
      const double before = inner.count(mesh);
      options.faces = values.given("error") ? 0 : static_cast<std::size_t>(faces * std::min(1.0, wanted / total));
      spent += cpuMilliseconds([&] { (void)decimate(mesh, options, progress.part(0.0, 1.0)); });
      share = inner.count(mesh) / before;
    }
    weights += pieces[i].weight;
    left += pieces[i].weight * share;
    milliseconds += pieces[i].weight * spent / faces;
  }
  if (weights == 0.0) return {};
  const double least = values.whole("faces") > 0 ? wanted : 0.0;
  return {values.given("error") ? std::max(least, total * left / weights) : std::min(wanted, total),
          kSecondsAtLeast + 1e-3 * total * milliseconds / weights};
}

Result<Remeshed> remesh(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  const Progress making = progress.part(0.0, isReduced(values) ? 0.2 : 1.0);
  Remeshed done;
  const bool isSharp = values.whole("method") == 1;
  const TriangleSoup surface =
      isSharp ? sharpSurfaceOf(volume, making.part(0.0, 0.5)) : surfaceOf(volume, making.part(0.0, 0.5));
  done.before = surface.triangles.size();
  done.mesh = buildMesh(surface, making.part(0.5, 1.0)).mesh;
  if (isReduced(values) && !progress.cancelled()) {
    const DecimationOptions options = optionsOf(values);
    done.largestDistance = decimate(done.mesh, options, progress.part(0.2, 1.0)).largestDistance;
  }
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return done;
}

}  // namespace handwheel
