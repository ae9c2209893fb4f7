// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshSteps.h"

#include "base/NumberText.h"
#include "document/DisplayUnitEdit.h"
#include "document/EditCommand.h"
#include "document/mesh/MeshDocument.h"
#include "document/mesh/MeshEdit.h"
#include "mesh/measure/MeshFidelity.h"
#include "mesh/structure/Shells.h"
#include "tools/mesh/DefectFixes.h"
#include "tools/mesh/FillOptionsText.h"
#include "tools/mesh/ManualMeshChanges.h"
#include "tools/mesh/Placement.h"
#include "tools/mesh/boundary/BorderPicking.h"
#include "tools/mesh/sculpt/SculptSteps.h"

#include <QCoreApplication>
#include <algorithm>
#include <numbers>

namespace handwheel {
namespace {

constexpr Limits kLength = {1e-12, 1e12};  // mm
constexpr Limits kCrease = {1e-6, std::numbers::pi};
constexpr Limits kWavelength = {0.0, 100.0};  // edges
constexpr Limits kShare = {0.0, 1.0};
constexpr const char* kRims[] = {"keep", "back", "fill"};  // as RimHandling

// The wish of a step that is a change; what is wrong with the words is in the reader.
using MakeChange = MeshChange (*)(StepReader&, const MeshDocument&);
using DoStep = StepOutcome (*)(StepReader&, MeshDocument&, Progress);

MeshChange readDebris(StepReader& reader, const MeshDocument& document) {
  if (!reader.hasWord()) return allDebrisFix();
  return debrisFix(reader.indices(reader.word("a triangle"), "triangle", document.mesh().faceSlots()));
}

MeshChange readNearVertices(StepReader& reader, const MeshDocument& document) {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  if (reader.hasWord()) pairs = reader.pairs(reader.word("a pair"), "vertex", document.mesh().vertexSlots());
  return nearVertexFix(reader.number("near-weld", nearWeldSetting().standard, kShare), std::move(pairs));
}

// Without pairs, all that are found.
MeshChange readCutCrossings(StepReader& reader, const MeshDocument& document) {
  std::vector<std::pair<Face, Face>> pairs;
  if (reader.hasWord()) {
    pairs = reader.pairs(reader.word("a pair"), "triangle", document.mesh().faceSlots());
    for (const auto& [a, b] : pairs)
      if (!document.mesh().isProper(a) || !document.mesh().isProper(b) || a == b)
        reader.complain("there is no such pair of triangles any more");
  } else {
    pairs = findSelfIntersections(document.mesh()).value_or(pairs);
  }
  return crossingFix(readNumbers(reader, document), std::move(pairs));
}

MeshChange readDecimate(StepReader& reader, const MeshDocument&) {
  DecimationOptions options;
  if (const auto faces = reader.option("faces"); faces)
    options.faces = reader.index(*faces, "triangle", std::numeric_limits<std::uint32_t>::max());
  if (const auto error = reader.option("error"); error) options.error = reader.number(*error, kLength);
  if (options.faces == 0 && !options.error) reader.complain("say how far to go: --faces N, --error MM or both");
  options.keepBorders = reader.flag("keep-borders");
  if (const auto angle = reader.option("keep-creases"); angle) options.creaseAngle = reader.angle(*angle, kCrease);
  options.avoidIntersections = reader.flag("no-crossings");
  return decimateChange(options);
}

BorderPair readEnds(StepReader& reader, const MeshDocument& document) {
  const auto ends = reader.indices(reader.word("H,H"), "half-edge", document.mesh().halfEdgeSlots());
  if (reader.isGood() && ends.size() != 2) reader.complain("two half-edges are wanted: H,H");
  return reader.isGood() ? BorderPair{ends[0], ends[1]} : BorderPair();
}

MeshChange readFace(StepReader& reader, const MeshDocument& document) {
  const auto corners = reader.indices(reader.word("V,V,V"), "vertex", document.mesh().vertexSlots());
  if (reader.isGood() && corners.size() != 3) reader.complain("three vertices are wanted: V,V,V");
  return faceChange(reader.isGood() ? Triangle{corners[0], corners[1], corners[2]} : Triangle{kNone, kNone, kNone});
}

MeshChange readPull(StepReader& reader, const MeshDocument& document) {
  const Vertex v = reader.index(reader.word("a vertex"), "vertex", document.mesh().vertexSlots());
  return pullChange(v, reader.point(reader.word("a place X,Y,Z")));
}

Vertex readOneLoop(StepReader& reader, const MeshDocument& document) {
  const std::vector<Vertex> keys = readLoops(reader, reader.word("a loop"), document);
  if (reader.isGood() && keys.size() != 1) reader.complain("one loop is wanted");
  return reader.isGood() ? keys.front() : kNone;
}

MeshChange readSmoothEdge(StepReader& reader, const MeshDocument& document) {
  const Vertex key = readOneLoop(reader, document);
  SmoothingOptions options;
  options.wavelength = reader.number("wavelength", options.wavelength, kWavelength);
  options.evenly = !reader.flag("uneven");
  return smoothEdgeChange(key, options);
}

RimHandling readRims(StepReader& reader) {
  const auto word = reader.option("rims");
  if (!word) return RimHandling::Back;
  const auto* known = std::find(std::begin(kRims), std::end(kRims), *word);
  if (known == std::end(kRims)) reader.complain("--rims takes keep, back or fill");
  return static_cast<RimHandling>(known - std::begin(kRims));
}

MeshChange readRepair(StepReader& reader, const MeshDocument& document) {
  RepairOptions options;
  options.fill = readFillOptions(reader, document);
  options.fill.keptCorners.clear();
  options.nearWeld = reader.number("near-weld", options.nearWeld, kShare);
  options.rims = readRims(reader);
  if (const auto most = reader.option("max-hole"); most)
    options.maxEdges = reader.index(*most, "edge", std::numeric_limits<std::uint32_t>::max());
  options.removeDebris = reader.flag("remove-debris");
  options.replaceFoldedRegions =
      !reader.flag("keep-folded-regions") && !reader.flag("keep-tangles");  // its former name
  options.cutCrossings = reader.flag("cut-crossings");
  options.keepOpen = keptLoops(document);
  return {"Repair all", [options](HalfEdgeMesh& mesh, Progress progress) { repair(mesh, options, progress); }};
}

StepOutcome keepOpen(StepReader& reader, MeshDocument& document, bool keep) {
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

StepOutcome fillLoop(StepReader& reader, MeshDocument& document, Progress progress) {
  const Vertex key = readOneLoop(reader, document);
  const auto& loops = document.defects().loops;
  const auto loop =
      std::find_if(loops.begin(), loops.end(), [&](const BoundaryLoop& l) { return keyOf(document.mesh(), l) == key; });
  const std::size_t size = loop == loops.end() ? 0 : loop->halfEdges.size();
  const FillOptions options = readFillOptions(reader, document, size);
  if (!reader.status()) return {};
  FillFailure failure = FillFailure::None;
  const MeshChange change = {"Fill hole", [&](HalfEdgeMesh& mesh, Progress p) {
                               HoleFiller filler(mesh, p.part(0.0, 0.5));
                               if (p.cancelled()) return;
                               const FillAttempt attempt = filler.propose(*loop, options, p.part(0.5, 1.0));
                               failure = attempt.failure;
                               if (failure != FillFailure::None) return;
                               filler.accept(*loop, attempt.patch);
                               mesh = filler.mesh();
                             }};
  const bool changed = commitChange(document, withStep(change, fillStep(key, options)), progress);
  return {changed, nullptr, failure};
}

StepOutcome sculpt(StepReader& reader, MeshDocument& document, Progress progress) {
  const SculptWork work = readSculptStep(reader, document);
  if (!reader.status()) return {};
  const Sculpted made = work(progress.part(0.0, 0.5));
  const bool changed = commitChange(
      document, withStep({"Sculpt", [&made](HalfEdgeMesh& mesh, Progress) { mesh = made.levels.mesh(); }}, made.step),
      progress.part(0.5, 1.0));
  if (changed) document.keepLevels(made.levels);
  return {changed, made.problem, FillFailure::None};
}

StepOutcome setUnit(StepReader& reader, MeshDocument& document, Progress) {
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

struct Verb {
  std::string_view verb;
  MakeChange make;
  DoStep act;
  std::string_view formerName = {};  // still understood, in no help
};

constexpr Verb kVerbs[] = {
    {"place", [](StepReader& r, const MeshDocument&) { return placeChange(readPlacement(r)); }, nullptr},
    {"delete",
     [](StepReader& r, const MeshDocument& d) {
       return deleteChange(r.faces(r.word("a list of triangles"), d.mesh().faceSlots()),
                           QT_TRANSLATE_NOOP("Tool", "Delete faces"));
     },
     nullptr},
    {"fill", nullptr, fillLoop},
    {"keep-open", nullptr, [](StepReader& r, MeshDocument& d, Progress) { return keepOpen(r, d, true); }},
    {"no-longer-open", nullptr, [](StepReader& r, MeshDocument& d, Progress) { return keepOpen(r, d, false); }},
    {"repair", readRepair, nullptr},
    {"back",
     [](StepReader& r, const MeshDocument& d) {
       auto keys = readLoops(r, r.word("a loop"), d);
       return thickenFix(std::move(keys), readFillOptions(r, d));
     },
     nullptr},
    {"cut-and-close",
     [](StepReader& r, const MeshDocument& d) {
       const Vertex key = readOneLoop(r, d);
       return cutAndCloseFix(key, readFillOptions(r, d));
     },
     nullptr},
    {"debris", readDebris, nullptr},
    {"degenerates", [](StepReader&, const MeshDocument&) { return degenerateFix(); }, nullptr},
    {"duplicates", [](StepReader&, const MeshDocument&) { return duplicateFix(); }, nullptr},
    {"near-vertices", readNearVertices, nullptr},
    {"split-nonmanifold", [](StepReader& r, const MeshDocument& d) { return nonManifoldFix(readNumbers(r, d)); },
     nullptr, "part"},
    {"two-sides", [](StepReader& r, const MeshDocument& d) { return nonOrientableFix(readFillOptions(r, d)); },
     nullptr},
    {"cut-crossings", readCutCrossings, nullptr, "uncross"},
    {"decimate", readDecimate, nullptr},
    {"bridge", [](StepReader& r, const MeshDocument& d) { return bridgeChange(readEnds(r, d)); }, nullptr},
    {"join", [](StepReader& r, const MeshDocument& d) { return joinChange(readEnds(r, d)); }, nullptr},
    {"face", readFace, nullptr},
    {"pull", readPull, nullptr},
    {"smooth-edge", readSmoothEdge, nullptr},
    {"stroke", nullptr, sculpt},
    {"subdivide", nullptr, sculpt},
    {"smooth-noise", nullptr, sculpt},
    {"level-back", nullptr, sculpt},
    {"unit", nullptr, setUnit},
};

constexpr StepForm kForms[] = {
    {"place [--unit U] [--scale N] [--turn A,B,C] [--move X,Y,Z]",
     "From unit U to mm about the origin; then scale, and turn about x, y, z (degrees), about the middle; then move "
     "(mm)"},
    {"flat | axes | centre | corner", "Onto the largest flat face, along the main axes, to the origin"},
    {"delete TRIANGLES", "1-20,33"},
    {"fill LOOP [FILL] [--bridges P:P,...]",
     "Close one hole; bridges run between points of it, counted along it from 0"},
    {"keep-open LOOPS, no-longer-open LOOPS", "Mark openings that are meant to be there"},
    {"repair [FILL] [--rims HOW] [--near-weld SHARE] [--max-hole N] [--remove-debris] [--keep-folded-regions] "
     "[--cut-crossings]",
     "As 'handwheel repair', but in the numbers of the document, and leaving open what is marked"},
    {"back LOOPS [FILL]", "Make a thin body of each sheet that has such an outer edge"},
    {"cut-and-close LOOP [FILL]", "Close it across the part, and cut where that crosses"},
    {"debris [TRIANGLES]", "Remove all small pieces, or those with these triangles: 7,9"},
    {"degenerates, duplicates, split-nonmanifold, two-sides [FILL]",
     "Mend triangles without area, double ones, what only touches, one side"},
    {"near-vertices [V:V,...] [--near-weld SHARE]", "Merge what is nearer than this share of the diagonal"},
    {"cut-crossings [T:T,...]", "Cut pairs of crossing triangles apart; all without a list"},
    {"decimate [--faces N] [--error MM] [--keep-borders] [--keep-creases DEGREES] [--no-crossings]",
     "As 'handwheel decimate'"},
    {"bridge H,H; join H,H",
     "Between two points of open edges; H: 3 times a triangle, plus the corner that it leaves: 0, 1, 2"},
    {"face V,V,V", "Over three points of open edges"},
    {"pull V X,Y,Z", "Move a vertex, where no triangle turns over or crosses another"},
    {"smooth-edge LOOP [--wavelength EDGES] [--uneven]", "Draw an open edge onto a smooth curve"},
    {"stroke BRUSH PLACE... --radius MM [--by X,Y,Z] [--strength N] [--borders] [PATCH] [--level N]",
     "A stroke of the brush drag, smooth, inflate or flatten; PLACE: TRIANGLE:X,Y,Z; drag has one, and goes --by a "
     "way"},
    {"subdivide PATCH [--times N]; level-back PATCH", "Finer by levels, and back"},
    {"smooth-noise [PATCH] [--angle DEGREES] [--borders]", "Of a patch; without one along open edges"},
    {"add FILE", "Put the mesh of another file into this one, where it stands"},
    {"unit U", "In which lengths are shown: mm, cm, m, in"},
};

// In a window the edge has changed while the change was on its way; here it never was so.
constexpr const char* kImpossible =
    "nothing is open there, or a triangle would turn over, cross another or double an edge";

Result<StepOutcome> applyChange(MeshDocument& document, const MeshChange& change, Progress progress) {
  const bool changed = commitChange(document, change, progress);
  const char* reason = reasonOf(change);
  const char* why = reason == kEdgeChanged ? kImpossible : reason;
  return StepOutcome{changed, changed ? nullptr : why, FillFailure::None};
}

}  // namespace

std::span<const StepForm> stepForms() {
  return kForms;
}

namespace {

Result<StepOutcome> addFile(StepReader& reader, MeshDocument& document, Progress progress,
                            const MeshFileReader& readMesh) {
  const std::string path = reader.line("a file");
  if (!readMesh) reader.complain("no other file can be read here");
  if (const Status read = reader.status(); !read) return read.error();
  const Result<HalfEdgeMesh> other = readMesh(path, progress.part(0.0, 0.5));
  if (!other) return other.error();
  return applyChange(document, addChange(path, *other), progress.part(0.5, 1.0));
}

// By the table. Ends with the reader's status.
Result<StepOutcome> applyVerb(StepReader& reader, std::string_view step, MeshDocument& document, Progress progress) {
  const auto* verb = std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const Verb& v) {
    return v.verb == reader.verb() || (!v.formerName.empty() && v.formerName == reader.verb());
  });
  if (verb == std::end(kVerbs)) {
    reader.complain("there is no step '" + reader.verb().substr(0, 40) + "'");
    return reader.status().error();
  }
  if (verb->act) {
    const StepOutcome outcome = verb->act(reader, document, progress);
    const Status read = reader.status();
    return read ? Result<StepOutcome>(outcome) : read.error();
  }
  MeshChange change = verb->make(reader, document);
  if (const Status read = reader.status(); !read) return read.error();
  if (change.step.empty()) change.step = std::string(step);
  return applyChange(document, change, progress);
}

}  // namespace

Result<StepOutcome> applyStep(MeshDocument& document, std::string_view step, Progress progress,
                              const MeshFileReader& readMesh) {
  StepReader reader(step);
  const auto places = standardPlaces();
  const auto place =
      std::find_if(places.begin(), places.end(), [&](const StandardPlace& p) { return reader.verb() == p.id; });
  const auto apply = [&]() -> Result<StepOutcome> {
    if (reader.verb() == "add") return addFile(reader, document, progress, readMesh);
    if (place == places.end()) return applyVerb(reader, step, document, progress);
    const Status read = reader.status();
    return read ? applyChange(document, placeChange(*place), progress) : read.error();
  };
  Result<StepOutcome> outcome = apply();
  if (outcome && progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return outcome;
}

MeshChange addChange(const std::string& path, const HalfEdgeMesh& mesh) {
  return withStep({QT_TRANSLATE_NOOP("Tool", "Add a mesh"), [mesh](HalfEdgeMesh& to, Progress) { append(to, mesh); }},
                  StepWriter("add").word(path).text());
}

std::string fillStep(Vertex loop, const FillOptions& options) {
  StepWriter step("fill");
  step.word(loopsText({loop}));
  addFillOptions(step, options);
  return step.text();
}

// What is kept open stands in the document.
std::string repairStep(const RepairOptions& options) {
  StepWriter step("repair");
  addFillOptions(step, options.fill);
  if (options.nearWeld != RepairOptions().nearWeld) step.option("near-weld", shortestText(options.nearWeld));
  if (options.rims != RepairOptions().rims) step.option("rims", kRims[static_cast<std::size_t>(options.rims)]);
  if (options.maxEdges > 0) step.option("max-hole", std::to_string(options.maxEdges));
  if (options.removeDebris) step.option("remove-debris");
  if (!options.replaceFoldedRegions) step.option("keep-folded-regions");
  if (options.cutCrossings) step.option("cut-crossings");
  return step.text();
}

HistoryPoint presentPoint(const MeshDocument& document) {
  const QUndoStack& history = *document.history();
  if (history.index() == 0) return {};
  return {history.index(), static_cast<const EditCommand&>(*history.command(history.index() - 1)).stroke()};
}

std::optional<std::vector<std::string>> stepsSince(const MeshDocument& document, const HistoryPoint& state) {
  const QUndoStack& history = *document.history();
  const auto at = [&history](int i) -> const EditCommand& {
    return static_cast<const EditCommand&>(*history.command(i));
  };
  if (state.commands > history.index()) return std::nullopt;
  if (state.commands > 0 && at(state.commands - 1).stroke() != state.stroke) return std::nullopt;
  std::vector<std::string> steps;
  for (int i = state.commands; i < history.index(); ++i) {
    if (!at(i).step().empty()) {
      steps.push_back(at(i).step());
    } else if (dynamic_cast<const MeshEdit*>(&at(i).edit())) {
      return std::nullopt;
    }
  }
  return steps;
}

}  // namespace handwheel
