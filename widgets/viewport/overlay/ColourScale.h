// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <memory>
#include <vector>

namespace handwheel {

// One scalar value per vertex slot. Values that are not finite have no colour of their own.
using VertexValues = std::shared_ptr<const std::vector<double>>;

// A diverging colour scale from blue through white to red. Both halves are straight lines in CIELAB of the same length
// and lightness, so that equal steps look equal and both signs have equal weight; people who confuse red with green can
// distinguish the ends (Moreland, "Diverging color maps for scientific visualization", 2009).
struct ColourScale {
  double range = 1.0;  // mm, above zero; values beyond ±range have the colour of the end

  QColor at(double value) const;

  bool operator==(const ColourScale&) const = default;
};

}  // namespace handwheel
