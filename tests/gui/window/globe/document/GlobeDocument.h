// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "globe/document/GlobeSurface.h"

// A document that the program does not have: a globe of points.
namespace handwheel::test {

struct GlobeSnapshot : Snapshot {
  explicit GlobeSnapshot(GlobeSurface s) : surface(std::move(s)) {}
  GlobeSurface surface;
};

// Limits of the radius, mm.
inline constexpr double kLeastRadius = 1.0, kLargestRadius = 1000.0;

SnapshotPointer globe(double radius);
const GlobeSurface& surfaceOf(const Snapshot& content);
inline double radiusOf(const Snapshot& content) {
  return surfaceOf(content).radius();
}

class GlobeDocument : public Document {
 public:
  explicit GlobeDocument(OpenedFile opened);

  SnapshotPointer snapshot() const override { return m_content; }
  const GlobeSurface& surface() const { return surfaceOf(*m_content); }
  std::vector<Property> properties() const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

 private:
  friend class GlobeEdit;
  SnapshotPointer m_content;
};

// Exchanges the surface of a globe.
class GlobeEdit : public Edit {
 public:
  explicit GlobeEdit(GlobeSurface surface) : m_surface(std::move(surface)) {}
  void exchange(Document& document) override;
  std::size_t bytes() const override { return sizeof *this + kGlobePoints * sizeof(double); }

 private:
  GlobeSurface m_surface;
};

}  // namespace handwheel::test
