// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewLayer.h"
#include "viewport/overlay/ColourScale.h"

#include <optional>

namespace handwheel {

// A view layer that draws the legend of a colour scale. The coloured geometry is in other layers.
class LegendLayer : public ViewLayer {
 public:
  void setScale(const std::optional<ColourScale>& scale);  // scale: nothing for no legend

  Box bounds() const override { return {}; }
  std::vector<Vec3> outline() const override { return {}; }
  void setStyle(const SurfaceStyle&) override {}
  void prepare(const LayerFrame&) override {}
  void paintOver(QPainter& painter, const QSizeF& size, LengthUnit unit, const SceneColours& colours) const override;

 private:
  std::optional<ColourScale> m_scale;
};

}  // namespace handwheel
