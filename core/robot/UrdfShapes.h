// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/UrdfReader.h"
#include "xml/Xml.h"

#include <map>
#include <string>
#include <utility>

namespace handwheel {

// A reader of the visual and collision shapes of links in URDF. Errors do not stop the reading; an invalid element is
// noted, and the link keeps its name.
class UrdfShapes {
 public:
  explicit UrdfShapes(ImportedRobot& read) : m_read(read) {}

  // Collects the colours of all materials of the description, because a link may refer to a material that another link
  // defines.
  void collectMaterials(const XmlElement& robot);
  // Reads the visual and collision elements of a link.
  void readInto(Link& link, const XmlElement& element);
  void note(Error error);

 private:
  void collectMaterial(const XmlElement& material);
  std::optional<ShapeColour> colourOf(const XmlElement& visual);
  void readShape(const XmlElement& element, std::vector<PlacedShape>& shapes, std::vector<std::string>& unread);
  Result<Shape> readGeometry(const XmlElement& element) const;
  Result<Shape> readMesh(const XmlElement& mesh) const;
  std::uint32_t numberOf(const Shape& shape);

  ImportedRobot& m_read;
  std::map<std::string, ShapeColour> m_materials;
  std::map<std::pair<std::string, std::array<double, 3>>, std::uint32_t> m_meshes;  // by file and scale
};

}  // namespace handwheel
