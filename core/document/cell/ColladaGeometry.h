// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/formats/PolygonTriangulation.h"
#include "mesh/structure/TriangleSoup.h"
#include "xml/Xml.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Index of the elements of a COLLADA document by id.
class ColladaIds {
 public:
  explicit ColladaIds(const XmlElement& root) { collect(root); }

  // Returns the element that an attribute such as url="#id" refers to, if it has this name; null otherwise.
  const XmlElement* referred(const XmlElement& from, std::string_view attribute, std::string_view name) const;

 private:
  void collect(const XmlElement& element);

  std::map<std::string_view, const XmlElement*> m_elements;
};

// Reads the geometry elements of a COLLADA document. Damage in a primitive is recorded; polygons that cannot be read
// are left out.
class ColladaGeometry {
 public:
  ColladaGeometry(const ColladaIds& ids, std::vector<Error>& damage, Progress progress);

  // Returns the triangles in the geometry's own frame and unit.
  TriangleSoup read(const XmlElement& geometry);
  // Adds damage to the list, up to a hundred entries.
  void note(Error error);

 private:
  // Position of the vertex number in a primitive's list of indices.
  struct Layout {
    std::size_t stride = 0, vertex = 0;
    const XmlElement* positions = nullptr;  // The "source" element
  };

  std::optional<Layout> layoutOf(const XmlElement& primitive) const;
  std::optional<std::uint32_t> basePointOf(const XmlElement& source, TriangleSoup& soup);
  void readPrimitive(const XmlElement& primitive, TriangleSoup& soup);
  void addList(const XmlElement& primitive, std::string_view& counts, const std::vector<std::uint32_t>& corners,
               TriangleSoup& soup);
  void addStrip(std::string_view kind, const std::vector<std::uint32_t>& corners, TriangleSoup& soup);
  void addPolygon(std::span<const std::uint32_t> corners, TriangleSoup& soup);

  const ColladaIds& m_ids;
  std::vector<Error>& m_damage;
  Progress m_progress;
  PolygonTriangulation m_triangulation;
  std::map<const XmlElement*, std::uint32_t> m_basePoints;  // First point of each source read into the soup
  std::size_t m_read = 0;     // Number of bytes read for all geometries, which may share a source
  std::size_t m_dropped = 0;  // Number of polygons of the current primitive that were left out
};

}  // namespace handwheel
