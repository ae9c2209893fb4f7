// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "machining/lathe/LatheCollisions.h"

#include <map>

namespace handwheel {

// The displayed parts of a lathe. Their triangles are made once; afterwards only poses change. The tool comes from the
// side of +x, in the plane y = 0. It must be used on the window thread.
class LatheDisplay {
 public:
  // gripped: the radius that the jaws are closed on, mm. base: z of the part's lower end in the scene, mm.
  LatheDisplay(const LatheSetup& setup, const LatheTools& tools, double gripped, double base);

  // Returns the displayed parts. turns: the spindle angle in revolutions; tip: the position (r, z) of the tool, mm. If
  // `tool` is null, no tool is shown.
  std::vector<DisplayPart> parts(double turns, const ProfilePoint& tip, const LatheTool* tool, double quillTip) const;

  // Return a cross at the tip, to which the read-out refers, and the outline of the tool's sections in the plane y = 0.
  std::vector<std::vector<Vec3>> tipMark(const ProfilePoint& tip) const;
  std::vector<std::vector<Vec3>> outline(const LatheTool& tool, const ProfilePoint& tip) const;

 private:
  using Shape = std::shared_ptr<const TriangleSoup>;
  std::vector<DisplayPart> toolParts(const LatheTool& tool) const;

  double m_base;
  std::vector<DisplayPart> m_chuck;
  std::vector<DisplayPart> m_quill;                         // the quill with its tip at z = 0
  std::vector<DisplayPart> m_tailstock;                     // the part of the tailstock that does not move
  std::map<std::string, std::vector<DisplayPart>> m_tools;  // tools by id, with their tips at the origin
};

}  // namespace handwheel
