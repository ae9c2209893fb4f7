// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "viewport/camera/CameraState.h"

#include <QString>
#include <vector>

namespace handwheel {

// A text as the outlines of its letters, drawn as lines in the view. x points to the right and y up; the text begins at
// (0, 0) on its base line.
struct TextOutlines {
  std::vector<std::vector<Vec2>> lines;
  double width = 0.0;

  // Returns the text as it has to be drawn in a plane that is seen from behind: reversed within its width.
  TextOutlines reversed() const;
};

// Returns true if a camera is behind the plane that faces the operator of the lathe, in which Z is to the right and y
// points down.
bool isBehindLathe(const CameraState& camera);

// Returns the outlines of a text. height: the height of a capital letter, in the unit of the outlines. May be called on
// any thread.
TextOutlines textOutlines(const QString& text, double height);

}  // namespace handwheel
