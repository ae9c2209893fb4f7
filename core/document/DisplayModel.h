// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace handwheel {

// A rigid part of the displayed geometry of a document. The viewport compares soup pointers: a part of which only the
// pose changed is moved and not rebuilt.
struct DisplayPart {
  std::string name;                          // unique in its model; the result of picking
  std::shared_ptr<const TriangleSoup> soup;  // mm, in the part's own frame
  Pose pose = Pose::Identity();
  std::array<float, 3> colour{0.72f, 0.74f, 0.78f};  // sRGB, 0…1
  bool smooth = true;                                // shade across edges that are not sharp
  bool isSectioned = true;                           // cut by the clipping plane of the view; tools stay whole
  float gloss = 0.12f;                               // fraction of the light reflected as highlights, 0…1
  std::string group = {};                            // parts of one group change their shapes together; empty: no group
};

// The displayed geometry of a document.
struct DisplayModel {
  std::vector<DisplayPart> parts;
  Box bounds() const;  // bounds of all parts in their poses; O(points)
};

// Returns the triangles of all parts in their poses. Nothing is welded. O(points + triangles).
TriangleSoup placedSoup(const DisplayModel& model);

}  // namespace handwheel
