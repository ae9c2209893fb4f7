// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/sculpt/SculptScript.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/sculpt/PatchRemeshing.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/MeshOperations.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {
namespace {

constexpr int kBorderRings = 2;                // rings of faces around a border that are smoothed without a patch
constexpr std::size_t kMostFaces = 1'000'000;  // largest number of faces of a patch
constexpr const char* kBrushes[] = {"drag", "smooth", "inflate", "flatten"};  // in the order of SculptSettings::Brush

const char* problemOf(SubdivisionFailure failure) {
  switch (failure) {
    case SubdivisionFailure::NoEdgeInside:
      return QT_TRANSLATE_NOOP("Property", "It has no inner edge to split.");
    case SubdivisionFailure::TooManyFaces:
      return QT_TRANSLATE_NOOP("Property", "It would have too many triangles.");
    case SubdivisionFailure::TooFine:
      return QT_TRANSLATE_NOOP("Property", "The precision of the file does not allow finer triangles.");
    case SubdivisionFailure::NotManifold:
      return QT_TRANSLATE_NOOP("Property", "Its triangles touch without a common edge, or more than two share one.");
    case SubdivisionFailure::None:
    case SubdivisionFailure::Cancelled:
      break;
  }
  return nullptr;
}

// The patch at its finest level, and how many levels are below that.
OperationValues patchValues(const char* verb, const PatchLevels& levels) {
  OperationValues values(meshOperation(verb));
  if (!levels.patch().empty()) values.setValid("patch", rangesText(levels.patch()));
  values.setValid("finest", static_cast<double>(levels.finest()));
  return values;
}

std::string positionText(const SurfacePosition& position) {
  return std::to_string(position.face) + ":" + pointText(position.point);
}

SurfacePosition readPosition(ScriptLineReader& reader, std::string_view word, const HalfEdgeMesh& mesh) {
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos) reader.complain("a place is TRIANGLE:X,Y,Z");
  if (!reader.isGood()) return {};
  SurfacePosition position{reader.index(word.substr(0, colon), "triangle", mesh.faceSlots()),
                           reader.point(word.substr(colon + 1))};
  if (reader.isGood() && !mesh.isProper(position.face))
    reader.complain("there is no triangle " + std::to_string(position.face) + " any more");
  return position;
}

std::optional<PatchLevels> readPatch(ScriptLineReader& reader, const OperationValues& values,
                                     const MeshDocument& document) {
  FaceSelection patch;
  if (values.isSet("patch")) patch = reader.faces(values.text("patch"), document.mesh().faceSlots());
  patch.dropDead(document.mesh());
  if (!reader.isGood()) return std::nullopt;
  auto found = levelsOf(document, patch, values.whole("finest"));
  if (!found) reader.complain("the patch has not been subdivided that often");
  return found;
}

SculptStroke::Settings readStrokeSettings(ScriptLineReader& reader, const OperationValues& values,
                                          const MeshDocument& document, const PatchLevels& levels) {
  SculptStroke::Settings settings;
  const std::string brush = reader.word("the brush");
  const auto* known = std::find(std::begin(kBrushes), std::end(kBrushes), brush);
  if (known == std::end(kBrushes)) reader.complain("the brushes are drag, smooth, inflate and flatten");
  settings.brush = static_cast<SculptSettings::Brush>(known - std::begin(kBrushes));
  if (!values.isSet("radius")) reader.complain("--radius MM is missing");
  settings.radius = values.given("radius").value_or(1.0);
  settings.strength = values.number("strength");
  settings.movesBorder = values.flag("borders");
  settings.level = levels.finest();
  if (const auto level = values.given("level"); level) settings.level = static_cast<std::size_t>(*level);
  if (settings.level > levels.finest())
    reader.complain("there is no level " + std::to_string(settings.level) + ", only 0 to " +
                    std::to_string(levels.finest()));
  settings.numbers = numbersFor(document, values);
  return settings;
}

SculptWork readStroke(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  const auto levels = readPatch(reader, values, document);
  if (!levels) return nullptr;
  const SculptStroke::Settings settings = readStrokeSettings(reader, values, document, *levels);
  std::vector<SurfacePosition> positions = {
      readPosition(reader, reader.word("the place TRIANGLE:X,Y,Z"), levels->mesh())};
  Vec3 displacement = Vec3::Zero();
  const bool drags = settings.brush == SculptSettings::Brush::Drag;
  if (drags != values.isSet("by")) reader.complain(drags ? "--by X,Y,Z is missing" : "only drag takes --by");
  if (drags && reader.isGood()) {
    const std::vector<double> by = values.numbers("by");
    displacement = {by[0], by[1], by[2]};
  }
  while (!drags && reader.hasWord() && reader.isGood())
    positions.push_back(readPosition(reader, reader.word("a place"), levels->mesh()));
  return [levels = *levels, settings, positions, displacement, drags](Progress progress) {
    SculptStroke stroke(levels, settings, positions.front(), {positions.front().point, Vec3::UnitZ()});
    if (drags) stroke.dragBy(displacement);
    for (std::size_t i = 0; i < positions.size() && !drags && !progress.cancelled(); ++i) stroke.dab(positions[i]);
    return sculpted(stroke);
  };
}

SculptWork readNoise(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  const auto levels = readPatch(reader, values, document);
  const Denoising options = denoisingOf(values, numbersFor(document, values));
  const bool isOurs = options.method == NoiseMethod::Bilateral;
  if (!isOurs && values.flag("borders")) reader.complain("only --method bilateral moves open edges: omit --borders");
  if (values.isSet(isOurs ? "passes" : "angle"))
    reader.complain(isOurs ? "--passes needs --method laplace or bending" : "--angle needs --method bilateral");
  if (!levels) return nullptr;
  return [levels = *levels, options](Progress progress) { return denoised(levels, options, progress); };
}

SculptWork readSubdivision(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  const auto levels = readPatch(reader, values, document);
  const NumberType numbers = numbersFor(document, values);
  const int more = static_cast<int>(values.whole("times"));
  if (levels && levels->patch().empty()) reader.complain("--patch TRIANGLES is missing");
  if (!levels) return nullptr;
  return [=, levels = *levels](Progress progress) { return subdivided(levels, more, numbers, progress); };
}

SculptWork readRefinement(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  const auto levels = readPatch(reader, values, document);
  const NumberType numbers = numbersFor(document, values);
  if (levels && levels->patch().empty()) reader.complain("--patch TRIANGLES is missing");
  if (!levels) return nullptr;
  return [=, levels = *levels](Progress progress) { return refined(levels, numbers, progress); };
}

}  // namespace

std::optional<PatchLevels> levelsOf(const MeshDocument& document, const FaceSelection& patch, std::size_t finest) {
  const PatchLevels* remembered = document.levels(patch);
  if (remembered && remembered->patch() == patch && remembered->finest() == finest) return *remembered;
  return finest == 0 ? std::optional(PatchLevels(document.mesh(), patch)) : std::nullopt;
}

SculptResult subdivided(PatchLevels levels, int times, NumberType numbers, Progress progress) {
  OperationValues values = patchValues("subdivide", levels);
  const std::size_t before = levels.finest();
  const char* problem = nullptr;
  for (int i = 0; i < times && !problem && !progress.cancelled(); ++i)
    problem = problemOf(levels.refine({kMostFaces, numbers, progress}));
  if (levels.finest() > before) values.setValid("times", static_cast<double>(levels.finest() - before));
  setNumbers(values, numbers);
  FaceSelection touched = levels.finest() > before ? levels.patch() : FaceSelection();
  return {std::move(levels), std::move(touched), problem, ScriptLineWriter("subdivide").options(values).text()};
}

SculptResult refined(const PatchLevels& levels, NumberType numbers, Progress progress) {
  OperationValues values = patchValues("refine", levels);
  setNumbers(values, numbers);
  if (isEven(levels.mesh(), levels.patch()))
    return {levels, {}, QT_TRANSLATE_NOOP("Property", "It is as fine as its surroundings, and even.")};
  HalfEdgeMesh mesh = levels.mesh();
  RemeshedPatch remeshed = remeshToSurroundings(mesh, levels.patch(), {kMostFaces, numbers, progress});
  if (remeshed.failure != SubdivisionFailure::None) return {levels, {}, problemOf(remeshed.failure)};
  return {PatchLevels(std::move(mesh), remeshed.faces), remeshed.faces, nullptr,
          ScriptLineWriter("refine").options(values).text()};
}

Denoising denoisingOf(const OperationValues& values, NumberType numbers) {
  Denoising options;
  options.method = static_cast<NoiseMethod>(values.whole("method"));
  options.bilateral.normalSpread = values.number("angle");
  options.bilateral.movesBorder = values.flag("borders");
  options.laplace.isBending = options.method == NoiseMethod::Bending;
  options.laplace.passes = static_cast<int>(values.whole("passes"));
  options.bilateral.numbers = options.laplace.numbers = numbers;
  return options;
}

SculptResult denoised(PatchLevels levels, Denoising options, Progress progress) {
  OperationValues values = patchValues("smooth-noise", levels);
  values.setValid("method", static_cast<double>(options.method));
  setNumbers(values, options.bilateral.numbers);
  HalfEdgeMesh mesh = levels.mesh();
  const FaceSelection part = levels.patch().empty() ? facesAtBorder(mesh, kBorderRings) : levels.patch();
  std::vector<Face> moved;
  const char* problem = nullptr;
  if (options.method == NoiseMethod::Bilateral) {
    values.setValid("angle", options.bilateral.normalSpread);
    values.setValid("borders", options.bilateral.movesBorder);
    options.bilateral.progress = progress;
    if (auto smooth = smoothNoise(mesh, part, options.bilateral)) moved = std::move(smooth->faces);
  } else {
    values.setValid("passes", static_cast<double>(options.laplace.passes));
    options.laplace.progress = progress;
    LaplaceSmoothed smooth = smoothByLaplace(mesh, part, options.laplace);
    moved = std::move(smooth.moved.faces);
    if (smooth.refusal != OpenMeshRefusal::None)
      problem =
          QT_TRANSLATE_NOOP("Property", "This filter does not support degenerate or duplicate triangles or edges.");
  }
  levels.replace(levels.finest(), std::move(mesh));
  return {std::move(levels), FaceSelection(moved), problem, ScriptLineWriter("smooth-noise").options(values).text()};
}

SculptResult coarsened(PatchLevels levels) {
  ScriptLineWriter step("level-back");
  step.options(patchValues("level-back", levels));
  FaceSelection touched = levels.patch();
  levels.coarsen();
  return {std::move(levels), std::move(touched), nullptr, step.text()};
}

SculptResult sculpted(const SculptStroke& stroke) {
  const SculptStroke::Settings& settings = stroke.settings();
  const bool drags = settings.brush == SculptSettings::Brush::Drag;
  ScriptLineWriter step("stroke");
  step.word(kBrushes[static_cast<std::size_t>(settings.brush)]);
  if (drags) step.word(positionText(stroke.start()));
  for (const SurfacePosition& position : stroke.dabs()) step.word(positionText(position));
  OperationValues values = patchValues("stroke", stroke.levels());
  if (drags) values.setValid("by", pointText(stroke.displacement()));
  values.setValid("radius", settings.radius);
  if (!drags) values.setValid("strength", settings.strength);
  values.setValid("borders", settings.movesBorder);
  if (settings.level != stroke.levels().finest()) values.setValid("level", static_cast<double>(settings.level));
  setNumbers(values, settings.numbers);
  step.options(values);
  return {stroke.levels(), stroke.changedAnything() ? stroke.touched() : FaceSelection(), nullptr, step.text()};
}

SculptWork readSculptLine(ScriptLineReader& reader, const OperationValues& values, const MeshDocument& document) {
  const std::string& verb = values.operation().id;
  if (verb == "stroke") return readStroke(reader, values, document);
  if (verb == "smooth-noise") return readNoise(reader, values, document);
  if (verb == "subdivide") return readSubdivision(reader, values, document);
  if (verb == "refine") return readRefinement(reader, values, document);
  const auto levels = readPatch(reader, values, document);
  if (levels && levels->finest() == 0) reader.complain("the patch has one level only");
  if (!reader.isGood()) return nullptr;
  return [levels = *levels](Progress) { return coarsened(levels); };
}

}  // namespace handwheel
