// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/ManualMeshChanges.h"

#include "mesh/boundary/BoundaryWelding.h"
#include "mesh/boundary/VertexDrag.h"
#include "mesh/search/LargestDistance.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/OpenMeshReasons.h"
#include "tools/mesh/boundary/BoundaryPicking.h"
#include "tools/mesh/operations/BoundaryEditOperations.h"
#include "tools/mesh/operations/DecimateOperation.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/MeshOperations.h"
#include "tools/mesh/operations/SubdivideOperation.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {
namespace {

bool isOpenBorder(const HalfEdgeMesh& mesh, HalfEdge h) {
  return h < mesh.halfEdgeSlots() && mesh.isProper(HalfEdgeMesh::face(h)) && !mesh.hasOpposite(h);
}

bool areOpen(const HalfEdgeMesh& mesh, const BoundaryPair& ends) {
  return isOpenBorder(mesh, ends.a) && isOpenBorder(mesh, ends.b);
}

std::string pairStep(const char* verb, const BoundaryPair& ends) {
  return ScriptLineWriter(verb).word(listText({ends.a, ends.b})).text();
}

bool areVertices(const HalfEdgeMesh& mesh, const Triangle& face) {
  return std::all_of(face.begin(), face.end(), [&](Vertex v) { return v < mesh.vertexSlots(); });
}

}  // namespace

MeshChange deleteChange(FaceSelection faces, const char* text, const char* reason) {
  ScriptLineWriter step("delete");
  step.word(rangesText(faces));
  MeshChange change{
      text, [faces = std::move(faces)](HalfEdgeMesh& mesh, Progress progress) { removeFaces(mesh, faces, progress); },
      reason};
  change.isDeletion = true;
  return withStep(std::move(change), step.text());
}

MeshChange decimateChange(const DecimationOptions& options) {
  const auto distance = std::make_shared<std::optional<double>>();
  DecimationOptions measured = options;
  measured.measureDistance = true;
  MeshChange change = explainedChange(
      meshOperation("decimate").title,
      [measured, distance](HalfEdgeMesh& mesh, Progress p) {
        const DecimationReport report = decimate(mesh, measured, p);
        *distance = report.largestDistance;
        return reasonOf(report.refusal);
      },
      QT_TRANSLATE_NOOP("Tool", "no triangle can be removed within the given limits"));
  change.distance = distance;
  if (!options.avoidIntersections) change.crossed = [](std::size_t) {};  // they are counted and reported
  return withStep(std::move(change), ScriptLineWriter("decimate").options(valuesOf(options)).text());
}

MeshChange subdivideMeshChange(const SchemeSubdivision& subdivision, NumberType numbers) {
  OperationValues values = valuesOf(subdivision);
  setNumbers(values, numbers);
  const auto distance = std::make_shared<std::optional<double>>();
  MeshChange change = explainedChange(subdivideMeshOperation().title, [=](HalfEdgeMesh& mesh, Progress p) {
    const HalfEdgeMesh before = mesh;
    const SchemeOutcome outcome = subdivideAll(mesh, subdivision, {.numbers = numbers, .progress = p.part(0.0, 0.6)});
    *distance = std::nullopt;
    if (outcome.isDone() && subdivision.scheme != SubdivisionScheme::Midpoint)
      *distance = largestDistance(mesh, before, p.part(0.6, 1.0));
    return reasonOf(outcome);
  });
  change.distance = distance;
  if (subdivision.scheme != SubdivisionScheme::Midpoint) change.crossed = [](std::size_t) {};
  return withStep(std::move(change), ScriptLineWriter("subdivide-mesh").options(values).text());
}

MeshChange faceChange(const Triangle& face) {
  return withStep({meshOperation("face").title,
                   [face](HalfEdgeMesh& mesh, Progress) {
                     if (!areVertices(mesh, face)) return;
                     Box box;
                     for (const Vertex v : face) box.extend(mesh.position(v));
                     addFaces(mesh, {&face, 1}, FaceLocator(mesh, box));
                   },
                   kEdgeChanged},
                  ScriptLineWriter("face").word(listText({face[0], face[1], face[2]})).text());
}

MeshChange joinChange(const BoundaryPair& ends) {
  return withStep({meshOperation("join").title,
                   [ends](HalfEdgeMesh& mesh, Progress) {
                     if (!areOpen(mesh, ends)) return;
                     BoundaryWeld weld = weldBoundary(FaceLocator(mesh, reachOf(mesh, ends)), ends);
                     if (weld.problem == JoinProblem::None) mesh = std::move(weld.mesh);
                   },
                   kEdgeChanged},
                  pairStep("join", ends));
}

MeshChange bridgeChange(const BoundaryPair& ends) {
  return withStep({meshOperation("bridge").title,
                   [ends](HalfEdgeMesh& mesh, Progress) {
                     if (!areOpen(mesh, ends)) return;
                     const FaceLocator near(mesh, reachOf(mesh, ends));
                     addFaces(mesh, findBridge(near, ends).triangles, near);
                   },
                   kEdgeChanged},
                  pairStep("bridge", ends));
}

MeshChange pullChange(Vertex vertex, const Vec3& position) {
  return withStep(
      {meshOperation("pull").title,
       [vertex, position](HalfEdgeMesh& mesh, Progress) {
         if (vertex >= mesh.vertexSlots()) return;
         const Vec3& start = mesh.position(vertex);
         VertexDrag(std::make_shared<const FaceLocator>(mesh, Box(start, start)), vertex).apply(mesh, position);
       },
       kEdgeChanged},
      ScriptLineWriter("pull").word(std::to_string(vertex)).word(pointText(position)).text());
}

MeshChange smoothEdgeChange(Vertex key, const SmoothingOptions& options) {
  ScriptLineWriter step("smooth-edge");
  step.word(loopsText({key})).options(valuesOf(options));
  return withStep({meshOperation("smooth-edge").title,
                   [key, options](HalfEdgeMesh& mesh, Progress) {
                     const FaceLocator near(mesh, std::make_shared<const FaceHierarchy>(mesh));
                     for (const BoundaryLoop& loop : findBoundaryLoops(mesh))
                       if (keyOf(mesh, loop) == key)
                         return (void)moveVertices(mesh, smoothBoundary(near, loop, options).moves);
                   },
                   kEdgeChanged},
                  step.text());
}

}  // namespace handwheel
