// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "machining/lathe/LatheCollisions.h"

#include <map>

namespace handwheel {

// The parts of a lathe as displayed parts. Their triangles are made once; afterwards only poses change. The tool comes
// from the side of +x, in the plane y = 0. Window thread.
class LatheDisplay {
 public:
  // gripped: mm, radius that the jaws are closed on. base: mm, z of the part's lower end in the scene.
  LatheDisplay(const LatheSetup& setup, const LatheTools& tools, double gripped, double base);

  // turns: spindle angle in revolutions; tip: (r, z) of the tool. If `tool` is null, none is shown.
  std::vector<DisplayPart> parts(double turns, const ProfilePoint& tip, const LatheTool* tool, double quillTip) const;

  // Return a cross at the tip, to which the read-out refers, and the outline of the tool's sections in the plane y = 0.
  std::vector<std::vector<Vec3>> tipMark(const ProfilePoint& tip) const;
  std::vector<std::vector<Vec3>> outline(const LatheTool& tool, const ProfilePoint& tip) const;

 private:
  using Shape = std::shared_ptr<const TriangleSoup>;
  std::vector<DisplayPart> toolParts(const LatheTool& tool) const;

  double m_base;
  std::vector<DisplayPart> m_chuck;
  std::vector<DisplayPart> m_quill;                         // at a tip of z = 0
  std::vector<DisplayPart> m_tailstock;                     // the part of the tailstock that does not move
  std::map<std::string, std::vector<DisplayPart>> m_tools;  // by id, with the tip at the origin
};

}  // namespace handwheel
