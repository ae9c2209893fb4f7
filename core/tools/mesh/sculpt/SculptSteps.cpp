// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/sculpt/SculptSteps.h"

#include "base/NumberText.h"
#include "base/Units.h"
#include "document/mesh/MeshDocument.h"
#include "tools/mesh/FillOptionsText.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {
namespace {

constexpr int kBorderRings = 2;                // of faces around a border that are smoothed without a patch
constexpr std::size_t kMostFaces = 1'000'000;  // of a patch
constexpr int kMostLevels = 20;                // of which each has about four times the faces
constexpr Limits kStepRadius = {1e-9, 1e9};    // mm
constexpr Limits kStepStrength = {-1.0, 1.0};
constexpr Limits kSpread = {0.02, 1.5};                                       // radian
constexpr const char* kBrushes[] = {"drag", "smooth", "inflate", "flatten"};  // as SculptSettings::Brush

const char* problemOf(SubdivisionFailure failure) {
  switch (failure) {
    case SubdivisionFailure::NoEdgeInside:
      return QT_TRANSLATE_NOOP("Property", "It has no edge inside to split.");
    case SubdivisionFailure::TooManyFaces:
      return QT_TRANSLATE_NOOP("Property", "It would have too many triangles.");
    case SubdivisionFailure::TooFine:
      return QT_TRANSLATE_NOOP("Property", "The numbers of the file show no finer triangles.");
    case SubdivisionFailure::None:
    case SubdivisionFailure::Cancelled:
      break;
  }
  return nullptr;
}

// The patch at its finest level, and how many levels are below that.
void addPatch(StepWriter& step, const PatchLevels& levels) {
  if (!levels.patch().empty()) step.option("patch", rangesText(levels.patch()));
  if (levels.finest() > 0) step.option("finest", std::to_string(levels.finest()));
}

std::string placeText(const SurfacePlace& place) {
  return std::to_string(place.face) + ":" + pointText(place.point);
}

SurfacePlace readPlace(StepReader& reader, std::string_view word, const HalfEdgeMesh& mesh) {
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos) reader.complain("a place is TRIANGLE:X,Y,Z");
  if (!reader.isGood()) return {};
  SurfacePlace place{reader.index(word.substr(0, colon), "triangle", mesh.faceSlots()),
                     reader.point(word.substr(colon + 1))};
  if (reader.isGood() && !mesh.isProper(place.face))
    reader.complain("there is no triangle " + std::to_string(place.face) + " any more");
  return place;
}

std::optional<PatchLevels> readPatch(StepReader& reader, const MeshDocument& document) {
  FaceSelection patch;
  if (const auto ranges = reader.option("patch"); ranges) patch = reader.faces(*ranges, document.mesh().faceSlots());
  const auto finest = reader.option("finest");
  const std::size_t levels = finest ? reader.index(*finest, "level", kMostLevels + 1) : 0;
  patch.dropDead(document.mesh());
  if (!reader.isGood()) return std::nullopt;
  auto found = levelsOf(document, patch, levels);
  if (!found) reader.complain("the patch has not been subdivided so often");
  return found;
}

SculptStroke::Settings readStrokeSettings(StepReader& reader, const MeshDocument& document, const PatchLevels& levels) {
  SculptStroke::Settings settings;
  const std::string brush = reader.word("the brush");
  const auto* known = std::find(std::begin(kBrushes), std::end(kBrushes), brush);
  if (known == std::end(kBrushes)) reader.complain("the brushes are drag, smooth, inflate and flatten");
  settings.brush = static_cast<SculptSettings::Brush>(known - std::begin(kBrushes));
  const auto radius = reader.option("radius");
  if (!radius) reader.complain("--radius MM is missing");
  if (reader.isGood()) settings.radius = reader.number(*radius, kStepRadius);
  settings.strength = reader.number("strength", 0.5, kStepStrength);
  settings.movesBorder = reader.flag("borders");
  const auto level = reader.option("level");
  settings.level = level ? reader.index(*level, "level", levels.finest() + 1) : levels.finest();
  settings.numbers = readNumbers(reader, document);
  return settings;
}

SculptWork readStroke(StepReader& reader, const MeshDocument& document) {
  const auto levels = readPatch(reader, document);
  if (!levels) return nullptr;
  const SculptStroke::Settings settings = readStrokeSettings(reader, document, *levels);
  std::vector<SurfacePlace> places = {readPlace(reader, reader.word("the place TRIANGLE:X,Y,Z"), levels->mesh())};
  Vec3 way = Vec3::Zero();
  const bool drags = settings.brush == SculptSettings::Brush::Drag;
  const auto by = drags ? reader.option("by") : std::nullopt;
  if (drags && !by) reader.complain("--by X,Y,Z is missing");
  if (by) way = reader.point(*by);
  while (!drags && reader.hasWord() && reader.isGood())
    places.push_back(readPlace(reader, reader.word("a place"), levels->mesh()));
  return [levels = *levels, settings, places, way, drags](Progress progress) {
    SculptStroke stroke(levels, settings, places.front(), {places.front().point, Vec3::UnitZ()});
    if (drags) stroke.dragBy(way);
    for (std::size_t i = 0; i < places.size() && !drags && !progress.cancelled(); ++i) stroke.dab(places[i]);
    return sculpted(stroke);
  };
}

SculptWork readNoise(StepReader& reader, const MeshDocument& document) {
  const auto levels = readPatch(reader, document);
  NoiseSmoothing options;
  if (const auto angle = reader.option("angle"); angle) options.normalSpread = reader.angle(*angle, kSpread);
  options.movesBorder = reader.flag("borders");
  options.numbers = readNumbers(reader, document);
  if (!levels) return nullptr;
  return [levels = *levels, options](Progress progress) {
    NoiseSmoothing told = options;
    told.progress = progress;
    return withoutNoise(levels, told);
  };
}

SculptWork readSubdivision(StepReader& reader, const MeshDocument& document) {
  const auto levels = readPatch(reader, document);
  const NumberType numbers = readNumbers(reader, document);
  const auto times = reader.option("times");
  const int more = times ? static_cast<int>(reader.index(*times, "level", kMostLevels + 1)) : 1;
  if (levels && levels->patch().empty()) reader.complain("--patch TRIANGLES is missing");
  if (!levels) return nullptr;
  return [=, levels = *levels](Progress progress) { return subdivided(levels, more, numbers, progress); };
}

}  // namespace

std::optional<PatchLevels> levelsOf(const MeshDocument& document, const FaceSelection& patch, std::size_t finest) {
  const PatchLevels* remembered = document.levels();
  if (remembered && remembered->patch() == patch && remembered->finest() == finest) return *remembered;
  return finest == 0 ? std::optional(PatchLevels(document.mesh(), patch)) : std::nullopt;
}

Sculpted subdivided(PatchLevels levels, std::optional<int> times, NumberType numbers, Progress progress) {
  StepWriter step("subdivide");
  addPatch(step, levels);
  const std::size_t before = levels.finest();
  const int more = times.value_or(levelsToDensity(levels.mesh(), levels.patch()));
  const char* problem = more == 0 ? QT_TRANSLATE_NOOP("Property", "It is as fine as its surroundings.") : nullptr;
  for (int i = 0; i < more && !problem && !progress.cancelled(); ++i)
    problem = problemOf(levels.refine({kMostFaces, numbers, progress}));
  if (levels.finest() > before + 1) step.option("times", std::to_string(levels.finest() - before));
  step.option("numbers", wordFor(numbers));
  FaceSelection touched = levels.finest() > before ? levels.patch() : FaceSelection();
  return {std::move(levels), std::move(touched), problem, step.text()};
}

Sculpted withoutNoise(PatchLevels levels, const NoiseSmoothing& options) {
  StepWriter step("smooth-noise");
  addPatch(step, levels);
  step.option("angle", angleText(options.normalSpread));
  if (options.movesBorder) step.option("borders");
  step.option("numbers", wordFor(options.numbers));
  HalfEdgeMesh mesh = levels.mesh();
  const FaceSelection part = levels.patch().empty() ? facesAtBorder(mesh, kBorderRings) : levels.patch();
  FaceSelection touched;
  if (const auto moved = smoothNoise(mesh, part, options))
    for (const Face f : moved->faces) touched.add(f);
  levels.replace(levels.finest(), std::move(mesh));
  return {std::move(levels), std::move(touched), nullptr, step.text()};
}

Sculpted levelBack(PatchLevels levels) {
  StepWriter step("level-back");
  addPatch(step, levels);
  FaceSelection touched = levels.patch();
  levels.coarsen();
  return {std::move(levels), std::move(touched), nullptr, step.text()};
}

Sculpted sculpted(const SculptStroke& stroke) {
  const SculptStroke::Settings& settings = stroke.settings();
  const bool drags = settings.brush == SculptSettings::Brush::Drag;
  StepWriter step("stroke");
  step.word(kBrushes[static_cast<std::size_t>(settings.brush)]);
  if (drags) step.word(placeText(stroke.start()));
  for (const SurfacePlace& place : stroke.dabs()) step.word(placeText(place));
  if (drags) step.option("by", pointText(stroke.way()));
  step.option("radius", shortestText(settings.radius));
  if (!drags) step.option("strength", shortestText(settings.strength));
  if (settings.movesBorder) step.option("borders");
  addPatch(step, stroke.levels());
  if (settings.level != stroke.levels().finest()) step.option("level", std::to_string(settings.level));
  step.option("numbers", wordFor(settings.numbers));
  return {stroke.levels(), stroke.changedAnything() ? stroke.touched() : FaceSelection(), nullptr, step.text()};
}

SculptWork readSculptStep(StepReader& reader, const MeshDocument& document) {
  if (reader.verb() == "stroke") return readStroke(reader, document);
  if (reader.verb() == "smooth-noise") return readNoise(reader, document);
  if (reader.verb() == "subdivide") return readSubdivision(reader, document);
  const auto levels = readPatch(reader, document);
  if (levels && levels->finest() == 0) reader.complain("the patch has one level only");
  if (!reader.isGood()) return nullptr;
  return [levels = *levels](Progress) { return levelBack(levels); };
}

}  // namespace handwheel
