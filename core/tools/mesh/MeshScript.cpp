// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshScript.h"

#include "document/DisplayUnitEdit.h"
#include "document/UndoCommand.h"
#include "document/mesh/MeshDocument.h"
#include "document/mesh/MeshEdit.h"
#include "mesh/structure/Shells.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/ManualMeshChanges.h"
#include "tools/mesh/Placement.h"
#include "tools/mesh/boundary/BoundaryPicking.h"
#include "tools/mesh/operations/BoundaryEditOperations.h"
#include "tools/mesh/operations/DecimateOperation.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/MeshOperations.h"
#include "tools/mesh/operations/RepairOperation.h"
#include "tools/mesh/operations/SubdivideOperation.h"
#include "tools/mesh/repair/DefectFixes.h"
#include "tools/mesh/repair/HoleFixes.h"
#include "tools/mesh/repair/RepairChanges.h"
#include "tools/mesh/sculpt/SculptScript.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"

#include <algorithm>
#include <cassert>

namespace handwheel {
namespace {

// The change that a step makes; what is wrong with the words is in the reader.
using MakeChange = MeshChange (*)(ScriptLineReader&, const OperationValues&, const MeshDocument&);
using DoStep = ScriptLineOutcome (*)(ScriptLineReader&, const OperationValues&, MeshDocument&, Progress);

MeshChange readDebris(ScriptLineReader& reader, const OperationValues&, const MeshDocument& document) {
  if (!reader.hasWord()) return allDebrisFix();
  return debrisFix(reader.indices(reader.word("a triangle"), "triangle", document.mesh().faceSlots()));
}

// Named defects; none for all.
FaceSelection readFaces(ScriptLineReader& reader, const MeshDocument& document) {
  return reader.hasWord() ? reader.faces(reader.word("a list of triangles"), document.mesh().faceSlots())
                          : FaceSelection();
}

std::vector<Vertex> readVertices(ScriptLineReader& reader, const MeshDocument& document) {
  return reader.hasWord() ? reader.indices(reader.word("a vertex"), "vertex", document.mesh().vertexSlots())
                          : std::vector<Vertex>();
}

MeshChange readNearVertices(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  if (reader.hasWord()) pairs = reader.pairs(reader.word("a pair"), "vertex", document.mesh().vertexSlots());
  return nearVertexFix(values.number("near-weld"), std::move(pairs));
}

// Without pairs, all that are found.
MeshChange readCutCrossings(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  std::vector<std::pair<Face, Face>> pairs;
  if (reader.hasWord()) {
    pairs = reader.pairs(reader.word("a pair"), "triangle", document.mesh().faceSlots());
    for (const auto& [a, b] : pairs)
      if (!document.mesh().isProper(a) || !document.mesh().isProper(b) || a == b)
        reader.complain("there is no such pair of triangles any more");
  } else {
    pairs = findSelfIntersections(document.mesh()).value_or(pairs);
  }
  return intersectionFix(numbersFor(document, values), std::move(pairs));
}

MeshChange readDecimate(ScriptLineReader& reader, const OperationValues& values, const MeshDocument&) {
  reader.complain(problemOf(values));
  return decimateChange(decimationOptionsOf(values));
}

BoundaryPair readEnds(ScriptLineReader& reader, const MeshDocument& document) {
  const auto ends = reader.indices(reader.word("H,H"), "half-edge", document.mesh().halfEdgeSlots());
  if (reader.isGood() && ends.size() != 2) reader.complain("two half-edges are required: H,H");
  return reader.isGood() ? BoundaryPair{ends[0], ends[1]} : BoundaryPair();
}

MeshChange readFace(ScriptLineReader& reader, const OperationValues&, const MeshDocument& document) {
  const auto corners = reader.indices(reader.word("V,V,V"), "vertex", document.mesh().vertexSlots());
  if (reader.isGood() && corners.size() != 3) reader.complain("three vertices are required: V,V,V");
  return faceChange(reader.isGood() ? Triangle{corners[0], corners[1], corners[2]} : Triangle{kNone, kNone, kNone});
}

MeshChange readPull(ScriptLineReader& reader, const OperationValues&, const MeshDocument& document) {
  const Vertex v = reader.index(reader.word("a vertex"), "vertex", document.mesh().vertexSlots());
  return pullChange(v, reader.point(reader.word("a place X,Y,Z")));
}

Vertex readOneLoop(ScriptLineReader& reader, const MeshDocument& document) {
  const std::vector<Vertex> keys = readLoops(reader, reader.word("a loop"), document);
  if (reader.isGood() && keys.size() != 1) reader.complain("one loop is required");
  return reader.isGood() ? keys.front() : kNone;
}

MeshChange readSmoothEdge(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  const Vertex key = readOneLoop(reader, document);
  SmoothingOptions options = smoothingOptionsOf(values);
  options.numbers = numbersFor(document, values);
  return smoothEdgeChange(key, options);
}

MeshChange readRepair(ScriptLineReader&, const OperationValues& values, const MeshDocument& document) {
  RepairOptions options = repairOptionsOf(values);
  options.fill.numbers = numbersFor(document, values);
  options.keepOpen = keptLoops(document);
  return repairChange(options);
}

ScriptLineOutcome keepOpen(ScriptLineReader& reader, MeshDocument& document, bool keep) {
  for (const Vertex key : readLoops(reader, reader.word("a loop"), document)) {
    if (!reader.status()) return {};
    for (const BoundaryLoop& loop : document.defects().loops) {
      if (keyOf(document.mesh(), loop) != key) continue;
      document.setKeptOpen(loop, keep);
      break;
    }
  }
  return {};
}

ScriptLineOutcome fillLoop(ScriptLineReader& reader, const OperationValues& values, MeshDocument& document,
                           Progress progress) {
  const Vertex key = readOneLoop(reader, document);
  const auto& loops = document.defects().loops;
  const auto loop =
      std::find_if(loops.begin(), loops.end(), [&](const BoundaryLoop& l) { return keyOf(document.mesh(), l) == key; });
  const std::size_t size = loop == loops.end() ? 0 : loop->halfEdges.size();
  FillOptions options = fillOptionsFor(document, values);
  if (values.isSet("bridges")) {
    for (const auto& [a, b] : reader.pairs(values.text("bridges"), "vertex of the loop", size))
      options.bridges.push_back({a, b});
  }
  if (!reader.status()) return {};
  FillFailure failure = FillFailure::None;
  const MeshChange change = {fillOperation().title, [&](HalfEdgeMesh& mesh, Progress p) {
                               HoleFiller filler(mesh, p.part(0.0, 0.5));
                               if (p.cancelled()) return;
                               failure = fillHole(filler, *loop, options, std::nullopt, p.part(0.5, 1.0)).failure;
                               if (failure == FillFailure::None) mesh = filler.mesh();
                             }};
  const bool changed = commitChange(document, withStep(change, fillStep(key, options)), progress);
  return {changed, nullptr, failure};
}

ScriptLineOutcome sculpt(ScriptLineReader& reader, const OperationValues& values, MeshDocument& document,
                         Progress progress) {
  const SculptWork work = readSculptLine(reader, values, document);
  if (!reader.status()) return {};
  const SculptResult made = work(progress.part(0.0, 0.5));
  const bool changed = commitChange(
      document,
      withStep({meshOperation("stroke").title, [&made](HalfEdgeMesh& mesh, Progress) { mesh = made.levels.mesh(); }},
               made.step),
      progress.part(0.5, 1.0));
  if (changed) document.keepLevels(made.levels);
  return {changed, made.problem, FillFailure::None};
}

// A step that undoes the reversal on opening in the window is its undo here, too.
ScriptLineOutcome orient(ScriptLineReader& reader, const OperationValues&, MeshDocument& document, Progress progress) {
  const FaceSelection faces = readFaces(reader, document);
  if (!reader.status()) return {};
  QUndoStack& history = *document.history();
  if (document.openingSteps() == 1 && history.index() == 1 && faces.faces() == document.reversedFaces()) {
    history.undo();
    return {};
  }
  const MeshChange change = orientFix(faces);
  const bool changed = commitChange(document, change, progress);
  return {changed, changed ? nullptr : reasonOf(change), FillFailure::None};
}

ScriptLineOutcome setUnit(ScriptLineReader& reader, const OperationValues&, MeshDocument& document, Progress) {
  const std::string word = reader.word("mm, cm, m or in");
  const Property unit = displayUnitProperty(document.displayUnit());
  const auto choice = std::find(unit.choices.begin(), unit.choices.end(), word);
  if (reader.isGood() && choice == unit.choices.end()) reader.complain("the units are mm, cm, m and in");
  if (!reader.status()) return {};
  const auto before = document.displayUnit();
  [[maybe_unused]] const Status done =
      document.setProperty(unit.id, static_cast<double>(choice - unit.choices.begin()));
  return {before != document.displayUnit(), nullptr, FillFailure::None};
}

// The function that makes the change of an operation, or makes and commits it.
struct Verb {
  std::string_view verb;
  MakeChange make;
  DoStep act;
};

constexpr Verb kVerbs[] = {
    {"place",
     [](ScriptLineReader&, const OperationValues& v, const MeshDocument&) { return placementChange(placementOf(v)); },
     nullptr},
    {"delete",
     [](ScriptLineReader& r, const OperationValues& v, const MeshDocument& d) {
       return deleteChange(r.faces(r.word("a list of triangles"), d.mesh().faceSlots()), v.operation().title);
     },
     nullptr},
    {"fill", nullptr, fillLoop},
    {"keep-open", nullptr,
     [](ScriptLineReader& r, const OperationValues&, MeshDocument& d, Progress) { return keepOpen(r, d, true); }},
    {"no-longer-open", nullptr,
     [](ScriptLineReader& r, const OperationValues&, MeshDocument& d, Progress) { return keepOpen(r, d, false); }},
    {"repair", readRepair, nullptr},
    {"back",
     [](ScriptLineReader& r, const OperationValues& v, const MeshDocument& d) {
       return thickenFix(readLoops(r, r.word("a loop"), d), fillOptionsFor(d, v), v.given("thickness").value_or(0.0));
     },
     nullptr},
    {"cut-and-close",
     [](ScriptLineReader& r, const OperationValues& v, const MeshDocument& d) {
       return cutAndCloseFix(readOneLoop(r, d), fillOptionsFor(d, v));
     },
     nullptr},
    {"debris", readDebris, nullptr},
    {"degenerates",
     [](ScriptLineReader& r, const OperationValues&, const MeshDocument& d) { return degenerateFix(readFaces(r, d)); },
     nullptr},
    {"duplicates",
     [](ScriptLineReader& r, const OperationValues&, const MeshDocument& d) { return duplicateFix(readFaces(r, d)); },
     nullptr},
    {"reverse",
     [](ScriptLineReader& r, const OperationValues&, const MeshDocument& d) {
       return r.hasWord() ? reverseChange(r.faces(r.word("a list of triangles"), d.mesh().faceSlots()))
                          : insideOutFix();
     },
     nullptr},
    {"orient", nullptr, orient},
    {"near-vertices", readNearVertices, nullptr},
    {"split-nonmanifold",
     [](ScriptLineReader& r, const OperationValues& v, const MeshDocument& d) {
       return nonManifoldFix(numbersFor(d, v), readVertices(r, d));
     },
     nullptr},
    {"two-sides",
     [](ScriptLineReader& r, const OperationValues& v, const MeshDocument& d) {
       return nonOrientableFix(fillOptionsFor(d, v), readVertices(r, d));
     },
     nullptr},
    {"cut-crossings", readCutCrossings, nullptr},
    {"unite",
     [](ScriptLineReader&, const OperationValues& v, const MeshDocument& d) { return unionFix(numbersFor(d, v)); },
     nullptr},
    {"by-volume",
     [](ScriptLineReader&, const OperationValues& v, const MeshDocument& d) {
       return volumeRepairChange(
           {v.given("voxel").value_or(0.0), v.number("close-gaps"), v.number("wall"), v.flag("yes")}, numbersFor(d, v));
     },
     nullptr},
    {"decimate", readDecimate, nullptr},
    {"subdivide-mesh",
     [](ScriptLineReader&, const OperationValues& v, const MeshDocument& d) {
       return subdivideMeshChange(schemeSubdivisionOf(v), numbersFor(d, v));
     },
     nullptr},
    {"bridge",
     [](ScriptLineReader& r, const OperationValues&, const MeshDocument& d) { return bridgeChange(readEnds(r, d)); },
     nullptr},
    {"join",
     [](ScriptLineReader& r, const OperationValues&, const MeshDocument& d) { return joinChange(readEnds(r, d)); },
     nullptr},
    {"face", readFace, nullptr},
    {"pull", readPull, nullptr},
    {"smooth-edge", readSmoothEdge, nullptr},
    {"stroke", nullptr, sculpt},
    {"subdivide", nullptr, sculpt},
    {"refine", nullptr, sculpt},
    {"smooth-noise", nullptr, sculpt},
    {"level-back", nullptr, sculpt},
    {"unit", nullptr, setUnit},
};

// The stroke of a HistoryPoint before the first command, where the turn of faces on opening is undone.
constexpr int kAsInFile = -1;

// In a window the edge has changed while the change was pending; here it never existed.
constexpr const char* kImpossible =
    "there is no open edge, or a triangle would flip, intersect another or double an edge";

Result<ScriptLineOutcome> applyChange(MeshDocument& document, const MeshChange& change, Progress progress) {
  const bool changed = commitChange(document, change, progress);
  const char* reason = reasonOf(change);
  const char* why = reason == kEdgeChanged ? kImpossible : reason;
  return ScriptLineOutcome{changed,
                           changed ? nullptr : why,
                           FillFailure::None,
                           change.sheets ? *change.sheets : SheetOutcomes(),
                           changed && change.distance ? *change.distance : std::nullopt,
                           !changed && change.volume ? change.volume->error : std::nullopt};
}

Result<ScriptLineOutcome> addFile(ScriptLineReader& reader, MeshDocument& document, Progress progress,
                                  const MeshFileReader& readMesh) {
  const std::string path = reader.line("a file");
  if (!readMesh) reader.complain("no other file can be read here");
  if (const Status read = reader.status(); !read) return read.error();
  const Result<HalfEdgeMesh> other = readMesh(path, progress.part(0.0, 0.5));
  if (!other) return other.error();
  return applyChange(document, addChange(path, *other), progress.part(0.5, 1.0));
}

// By the tables. Ends with the reader's status.
Result<ScriptLineOutcome> applyOperation(ScriptLineReader& reader, const Operation& operation, std::string_view step,
                                         MeshDocument& document, Progress progress) {
  const OperationValues values = reader.values(operation);
  const auto standards = standardPlacements();
  const auto standard = std::find_if(standards.begin(), standards.end(),
                                     [&](const StandardPlacement& p) { return operation.id == p.id; });
  if (standard != standards.end()) {
    const Status read = reader.status();
    return read ? applyChange(document, placementChange(*standard), progress) : read.error();
  }
  const auto* verb =
      std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const Verb& v) { return v.verb == operation.id; });
  assert(verb != std::end(kVerbs));
  if (verb->act) {
    const ScriptLineOutcome outcome = verb->act(reader, values, document, progress);
    const Status read = reader.status();
    return read ? Result<ScriptLineOutcome>(outcome) : read.error();
  }
  MeshChange change = verb->make(reader, values, document);
  if (const Status read = reader.status(); !read) return read.error();
  if (change.step.empty()) change.step = std::string(step);
  return applyChange(document, change, progress);
}

}  // namespace

Result<ScriptLineOutcome> applyScriptLine(MeshDocument& document, std::string_view step, Progress progress,
                                          const MeshFileReader& readMesh) {
  ScriptLineReader reader(step);
  const Operation* operation = findMeshOperation(reader.verb());
  if (!operation) reader.complain("there is no step '" + reader.verb().substr(0, 40) + "'");
  if (!operation) return reader.status().error();
  Result<ScriptLineOutcome> outcome = operation->id == "add"
                                          ? addFile(reader, document, progress, readMesh)
                                          : applyOperation(reader, *operation, step, document, progress);
  if (outcome && progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return outcome;
}

MeshChange addChange(const std::string& path, const HalfEdgeMesh& mesh) {
  return withStep({meshOperation("add").title, [mesh](HalfEdgeMesh& to, Progress) { append(to, mesh); }},
                  ScriptLineWriter("add").word(path).text());
}

HistoryPoint presentPoint(const MeshDocument& document) {
  const QUndoStack& history = *document.history();
  if (history.index() <= document.openingSteps())
    return document.facesAsInFile().empty() ? HistoryPoint() : HistoryPoint{0, kAsInFile};
  return {history.index(), static_cast<const UndoCommand&>(*history.command(history.index() - 1)).stroke()};
}

std::optional<std::vector<std::string>> scriptLinesSince(const MeshDocument& document, const HistoryPoint& state) {
  const QUndoStack& history = *document.history();
  const auto at = [&history](int i) -> const UndoCommand& {
    return static_cast<const UndoCommand&>(*history.command(i));
  };
  if (state.commands > history.index()) return std::nullopt;
  if (state.commands > 0 && at(state.commands - 1).stroke() != state.stroke) return std::nullopt;
  std::vector<std::string> steps;
  const std::vector<Face> asInFile = document.facesAsInFile();
  if (state == HistoryPoint{0, kAsInFile} && asInFile.empty()) return std::nullopt;
  // Opening the file has reversed these faces.
  if (state == HistoryPoint() && !asInFile.empty()) steps.push_back(orientFix(FaceSelection(asInFile)).step);
  for (int i = std::max(state.commands, document.openingSteps()); i < history.index(); ++i) {
    if (!at(i).step().empty()) {
      steps.push_back(at(i).step());
    } else if (dynamic_cast<const MeshEdit*>(&at(i).edit())) {
      return std::nullopt;
    }
  }
  return steps;
}

}  // namespace handwheel
