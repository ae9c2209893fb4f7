// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The functions of a mesh layer that a view calls.
#include "viewport/LinePicking.h"
#include "viewport/overlay/Legend.h"
#include "viewport/surface/MeshLayerPrivate.h"

namespace handwheel {

namespace {

constexpr std::uint64_t kLoop = std::uint64_t{1} << 32;  // bit of the numbers of elements that are loops

}  // namespace

Box MeshLayer::bounds() const {
  return d->box;
}

Box MeshLayer::drawnBounds() const {
  return d->box.merged(d->previewBox);
}

std::vector<Vec3> MeshLayer::outline() const {
  return d->outline;
}

void MeshLayer::setStyle(const SurfaceStyle& style) {
  d->blocks.setStyle(style);
  d->marks.setColours(style.colours);
}

void MeshLayer::setCoarseShown(bool isReduced) {
  d->blocks.setCoarseShown(isReduced);
}

std::size_t MeshLayer::takePiece() {
  return d->blocks.takeOne();
}

std::size_t MeshLayer::takeMarks() {
  return d->marks.buildPendingFaces();
}

bool MeshLayer::owesMarks() const {
  return d->marks.hasPendingFaces();
}

void MeshLayer::finish() {
  d->preparation.finishBlocks();
}

int MeshLayer::builtCount() const {
  return d->blocks.builtCount();
}

void MeshLayer::prepare(const LayerFrame& frame) {
  const LayerFrame own = frame.about(d->origin);
  d->blocks.setOffset(own.offset);
  d->marks.prepare(own);
}

void MeshLayer::paintOver(QPainter& painter, const QSizeF& size, LengthUnit unit, const SceneColours& colours) const {
  if (d->values) paintLegend(painter, size, d->colourScale, unit, colours);
}

bool MeshLayer::isSearchable() const {
  return !d->areFacesAwaited;
}

std::optional<LayerHit> MeshLayer::firstHit(const Vec3& origin, const Vec3& direction) const {
  const auto hit = d->faces ? d->faces->firstHit({origin, direction}) : std::nullopt;
  if (!hit) return std::nullopt;
  return LayerHit{hit->face, hit->point, hit->distance};
}

// Lines are not found before their visibility can be determined.
void MeshLayer::findNear(const CameraNavigation& view, const Vec2& cursor, std::vector<LayerHit>& found) const {
  if (d->areFacesAwaited) return;
  for (const LoopMark& loop : d->marks.loops())
    findNearLine(loop.points, true, kLoop | static_cast<std::uint32_t>(loop.id), view, cursor, found);
}

Vec3 MeshLayer::normalNear(const Vec3& p) const {
  return d->faces ? d->faces->normalNear(p) : Vec3(Vec3::Zero());
}

std::shared_ptr<const FaceHierarchy> MeshLayer::faces() const {
  return d->faces;
}

void MeshLayer::setHovered(std::optional<std::uint64_t> element) {
  const bool isLoop = element && (*element & kLoop) != 0;
  d->hoveredLoop = isLoop ? static_cast<int>(*element & ~kLoop) : -1;
  d->hoveredFace = element && !isLoop ? static_cast<Face>(*element) : kNone;
  d->markHovered();
}

Face faceOf(const Pick& pick) {
  const bool isFace = dynamic_cast<const MeshLayer*>(pick.layer) && (pick.element & kLoop) == 0;
  return isFace ? static_cast<Face>(pick.element) : kNone;
}

int loopOf(const Pick& pick) {
  const bool isLoop = dynamic_cast<const MeshLayer*>(pick.layer) && (pick.element & kLoop) != 0;
  return isLoop ? static_cast<int>(pick.element & ~kLoop) : -1;
}

}  // namespace handwheel
