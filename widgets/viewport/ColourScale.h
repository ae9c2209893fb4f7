// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <memory>
#include <vector>

namespace handwheel {

// One value to a vertex slot; those that are not finite have no colour of their own.
using VertexValues = std::shared_ptr<const std::vector<double>>;

// Colours for values below and above zero: from blue by white to red. Both halves are straight lines in CIELAB of the
// same length and lightness, so that equal steps look equal and the two signs weigh the same; people who confuse red
// with green tell the ends apart (Moreland, "Diverging color maps for scientific visualization", 2009).
struct ColourScale {
  double range = 1.0;  // mm, above zero: what lies beyond has the colour of the end

  QColor at(double value) const;

  bool operator==(const ColourScale&) const = default;
};

}  // namespace handwheel
