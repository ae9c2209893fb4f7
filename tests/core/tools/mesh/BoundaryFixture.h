// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HoleShapes.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "ToolEvents.h"
#include "WaitingServices.h"
#include "mesh/structure/MeshValidator.h"
#include "tools/mesh/boundary/BoundaryTool.h"

namespace handwheel::test {

// A document with a boundary tool.
class BoundaryFixture {
 protected:
  void start(const TriangleSoup& soup) {
    m_tool.reset();
    m_document = meshDocument(soup);
    m_tool = std::make_unique<BoundaryTool>(*m_document, immediateServices(*m_document));
    QObject::connect(m_document.get(), &Document::changed, [this] { m_tool->documentChanged(); });
  }
  // Presses and drags the pointer, without releasing it.
  void drag(const Vec3& from, const Vec3& to, Modifiers modifiers = {}) {
    m_tool->pointer(above(Kind::Press, from.x(), from.y(), modifiers));
    const Vec3 middle = 0.5 * (from + to);
    m_tool->pointer(above(Kind::Drag, middle.x(), middle.y(), modifiers));
    m_tool->pointer(above(Kind::Drag, to.x(), to.y(), modifiers));
  }
  const HalfEdgeMesh& mesh() const { return m_document->mesh(); }
  std::size_t loops() const { return m_document->defects().loops.size(); }
  std::string problemOf(const char* property) const {
    const std::vector<Property> all = m_tool->settings();
    const Property* shown = propertyNamed(all, property);
    return shown ? shown->problem : "it is not shown";
  }
  // Returns an empty string if exactly one valid step was made and undo restores the previous mesh.
  std::string oneStep(const HalfEdgeMesh& before) {
    QUndoStack& history = *m_document->history();
    if (history.count() != 1 || history.index() != 1) return "not one step";
    if (const std::string broken = validate(mesh()); !broken.empty()) return broken;
    const HalfEdgeMesh after = mesh();
    if (sameMesh(before, after)) return "nothing changed";
    history.undo();
    if (!sameMesh(mesh(), before)) return "undo does not lead back";
    history.redo();
    if (!sameMesh(mesh(), after)) return "redo does not lead forth";
    return {};
  }

  std::unique_ptr<MeshDocument> m_document;
  std::unique_ptr<BoundaryTool> m_tool;
};

}  // namespace handwheel::test
