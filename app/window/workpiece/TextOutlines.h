// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <QString>
#include <vector>

namespace handwheel {

// A text as the outlines of its letters, drawn as lines in the view. x to the right, y up, from (0, 0) on its base
// line.
struct TextOutlines {
  std::vector<std::vector<Vec2>> lines;
  double width = 0.0;
};

// height: height of a capital letter, in the unit of the outlines. Any thread.
TextOutlines textOutlines(const QString& text, double height);

}  // namespace handwheel
