// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/VolumeLayer.h"

#include "viewport/LayerFrame.h"
#include "viewport/LayerProps.h"
#include "viewport/surface/PolyData.h"
#include "viewport/surface/SurfaceStyle.h"
#include "volume/VolumeSampler.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <cmath>
#include <deque>

namespace handwheel {

namespace {

const QColor kClay(0xc2, 0xa8, 0x8c), kProtected(0x4a, 0x4e, 0x5e);

using Key = VolumeSurface::Key;
using Piece = VolumeSurface::Piece;
using Mask = std::shared_ptr<const ClayMask>;

// Returns true if a piece of so many cells along each axis looks the same under two masks, which are compared by 64³ of
// them.
bool looksSame(const Key& key, int cells, const Mask& one, const Mask& other) {
  if (one == other) return true;
  const ClayMask none;
  const VoxelIndex number(key[2], key[1], key[0]);
  const auto regionOf = [](int voxel) { return voxel >> 6; };
  const VoxelIndex first = (cells * number).unaryExpr(regionOf);
  const VoxelIndex last = (cells * number + VoxelIndex::Constant(cells - 1)).unaryExpr(regionOf);
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x)
        if (!(one ? *one : none).isKnownSame(other ? *other : none, {x, y, z})) return false;
  return true;
}

// Colours points by their protection; no colours if nothing is protected.
void colour(vtkPolyData& data, const std::vector<float>& points, const Vec3& origin, const ClayMask& mask) {
  std::vector<unsigned char> colours;
  colours.reserve(points.size());
  bool isAny = false;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const double share = mask.shareAt(origin + Vec3(points[i], points[i + 1], points[i + 2]));
    isAny = isAny || share > 0.0;
    const auto mixed = [&](int free, int full) {
      return static_cast<unsigned char>(std::lround(free + share * (full - free)));
    };
    colours.push_back(mixed(kClay.red(), kProtected.red()));
    colours.push_back(mixed(kClay.green(), kProtected.green()));
    colours.push_back(mixed(kClay.blue(), kProtected.blue()));
  }
  if (isAny) setColours(data, colours);
}

// Returns some of the points of a piece.
std::vector<Vec3> outlineOf(const VolumePiece& piece) {
  constexpr std::size_t kStep = 3 * 16;
  const std::vector<float>& points = piece.coarse.points.empty() ? piece.fine.points : piece.coarse.points;
  std::vector<Vec3> outline;
  for (std::size_t i = 0; i + 2 < points.size(); i += kStep)
    outline.push_back(piece.origin + Vec3(points[i], points[i + 1], points[i + 2]));
  return outline;
}

}  // namespace

class VolumeLayer::Private {
 public:
  Private(LayerProps& of, Look its) : props(of), look(its) {}

  struct Shown {
    Piece piece;
    vtkSmartPointer<vtkActor> actor;
    vtkSmartPointer<vtkPolyData> fine, coarse;
    Mask mask;  // the mask that colours them
  };

  void want(const VolumeSurface& surface);
  bool isAsWanted(const Key& key, const Shown& made) const;
  std::size_t take();
  void showAll();
  void place(const Shown& shown) const;
  void choose(const Shown& shown) const;
  void paint(vtkActor* actor) const;

  LayerProps& props;
  Look look;
  SparseVolume volume;
  std::map<Key, Piece> wanted;
  int pieceCells = VolumeSurface::kPieceCells;  // size of those
  Mask mask;
  std::map<Key, Shown> shown;
  std::deque<Key> waiting;     // pieces to be built
  std::map<Key, Shown> built;  // shown when all of them are built
  bool isFirst = true;         // nothing was visible before: they are shown as they come
  SurfaceStyle style;
  Vec3 origin = Vec3::Zero();  // origin of the drawing
  bool isCoarse = false;
  int builtCount = 0;
};

void VolumeLayer::Private::want(const VolumeSurface& surface) {
  if (shown.empty()) isFirst = true;
  wanted = surface.pieces();
  pieceCells = surface.pieceCells();
  waiting.clear();
  std::erase_if(built, [&](const auto& entry) { return !isAsWanted(entry.first, entry.second); });
  for (const auto& [key, piece] : wanted) {
    const auto known = shown.find(key);
    const bool isShown = known != shown.end() && isAsWanted(key, known->second);
    if (isShown) known->second.mask = mask;  // an older one is not kept for it
    if (!isShown && !built.contains(key)) waiting.push_back(key);
  }
  if (waiting.empty()) showAll();
}

bool VolumeLayer::Private::isAsWanted(const Key& key, const Shown& made) const {
  const auto found = wanted.find(key);
  return found != wanted.end() && found->second == made.piece && looksSame(key, pieceCells, mask, made.mask);
}

std::size_t VolumeLayer::Private::take() {
  if (waiting.empty()) return 0;
  const Key key = waiting.front();
  waiting.pop_front();
  const Piece piece = wanted.at(key);
  Shown made{piece, nullptr, toPolyData(piece->fine.points, piece->fine.normals, piece->fine.corners),
             toPolyData(piece->coarse.points, piece->coarse.normals, piece->coarse.corners), mask};
  if (mask) {
    colour(*made.fine, piece->fine.points, piece->origin, *mask);
    colour(*made.coarse, piece->coarse.points, piece->origin, *mask);
  }
  built[key] = std::move(made);
  ++builtCount;
  if (waiting.empty() || isFirst) showAll();
  if (waiting.empty()) isFirst = false;
  return std::max<std::size_t>(piece->fine.count(), 1);
}

void VolumeLayer::Private::showAll() {
  for (auto it = shown.begin(); it != shown.end();) {
    if (wanted.contains(it->first)) {
      ++it;
      continue;
    }
    props.remove(it->second.actor);
    it = shown.erase(it);
  }
  for (auto& [key, made] : built) {
    Shown& present = shown[key];
    made.actor = present.actor;
    if (!made.actor) {
      made.actor = vtkSmartPointer<vtkActor>::New();
      made.actor->SetMapper(vtkNew<vtkPolyDataMapper>());
      made.actor->PickableOff();
      props.add(made.actor);
    }
    present = std::move(made);
    choose(present);
    place(present);
    paint(present.actor);
  }
  built.clear();
}

void VolumeLayer::Private::paint(vtkActor* actor) const {
  SurfaceMaterial material{look == Look::Mesh ? style.colours.front : kClay};
  material.isSolid = true;
  applyStyle(actor, style, material);
}

void VolumeLayer::Private::place(const Shown& of) const {
  const Vec3 at = of.piece->origin - origin;
  of.actor->SetPosition(at.x(), at.y(), at.z());
}

void VolumeLayer::Private::choose(const Shown& of) const {
  const bool hasCoarse = of.coarse->GetNumberOfPolys() > 0;
  static_cast<vtkPolyDataMapper*>(of.actor->GetMapper())->SetInputData(isCoarse && hasCoarse ? of.coarse : of.fine);
}

VolumeLayer::VolumeLayer(Look look) : d(std::make_unique<Private>(props(), look)) {}

VolumeLayer::~VolumeLayer() = default;

void VolumeLayer::setVolume(const SparseVolume& volume, const VolumeSurface& surface,
                            std::shared_ptr<const ClayMask> mask) {
  const bool isNew = d->wanted.empty() || surface.pieces().empty();
  d->volume = volume;
  d->mask = std::move(mask);
  d->want(surface);
  report(isNew ? LayerChange::Model : LayerChange::Look);
}

Box VolumeLayer::bounds() const {
  Box box;
  for (const auto& [key, piece] : d->wanted) box.extend(piece->box);
  return box;
}

std::vector<Vec3> VolumeLayer::outline() const {
  std::vector<Vec3> points;
  for (const auto& [key, piece] : d->wanted) {
    const std::vector<Vec3> some = outlineOf(*piece);
    points.insert(points.end(), some.begin(), some.end());
  }
  return points;
}

void VolumeLayer::setStyle(const SurfaceStyle& style) {
  d->style = style;
  for (const auto& [key, shown] : d->shown) d->paint(shown.actor);
}

void VolumeLayer::setCoarseShown(bool isReduced) {
  if (d->isCoarse == isReduced) return;
  d->isCoarse = isReduced;
  for (const auto& [key, shown] : d->shown) d->choose(shown);
}

std::size_t VolumeLayer::takePiece() {
  return d->take();
}

int VolumeLayer::builtCount() const {
  return d->builtCount;
}

void VolumeLayer::prepare(const LayerFrame& frame) {
  if (frame.origin == d->origin) return;
  d->origin = frame.origin;
  for (const auto& [key, shown] : d->shown) d->place(shown);
}

std::optional<LayerHit> VolumeLayer::firstHit(const Vec3& origin, const Vec3& direction) const {
  const auto hit = handwheel::firstHit(d->volume, origin, direction);
  if (!hit) return std::nullopt;
  return LayerHit{0, hit->point, hit->distance};
}

Vec3 VolumeLayer::normalNear(const Vec3& p) const {
  return VolumeSampler(d->volume).normalAt(p);
}

}  // namespace handwheel
