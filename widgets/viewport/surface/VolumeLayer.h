// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewLayer.h"
#include "volume/clay/ClayMask.h"
#include "volume/surface/VolumeSurface.h"

namespace handwheel {

// A view layer for the surface of a volume, which may change every frame. It has one element, 0. While the camera moves
// on a slow display, a simplified version is drawn.
class VolumeLayer : public ViewLayer {
 public:
  enum class Look { Clay, Mesh };  // Mesh: in the style of the mesh to which it belongs
  explicit VolumeLayer(Look look = Look::Clay);
  ~VolumeLayer() override;

  // Shows the surface of a volume; an empty volume shows nothing. Protected material is dark; null: no material is
  // protected. Only changed pieces are uploaded, and the changes of one call appear in one frame. Returns at once.
  void setVolume(const SparseVolume& volume, const VolumeSurface& surface,
                 std::shared_ptr<const ClayMask> mask = nullptr);

  Box bounds() const override;
  std::vector<Vec3> outline() const override;
  void setStyle(const SurfaceStyle& style) override;
  void setCoarseShown(bool isReduced) override;
  std::size_t takePiece() override;
  int builtCount() const override;
  void prepare(const LayerFrame& frame) override;
  std::optional<LayerHit> firstHit(const Vec3& origin, const Vec3& direction) const override;
  Vec3 normalNear(const Vec3& p) const override;

 private:
  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace handwheel
