// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/overlay/LegendLayer.h"

#include "viewport/overlay/Legend.h"

namespace handwheel {

void LegendLayer::setScale(const std::optional<ColourScale>& scale) {
  if (scale == m_scale) return;
  m_scale = scale;
  report(LayerChange::Look);
}

void LegendLayer::paintOver(QPainter& painter, const QSizeF& size, LengthUnit unit, const SceneColours& colours) const {
  if (m_scale) paintLegend(painter, size, *m_scale, unit, colours);
}

}  // namespace handwheel
