// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/SectionView.h"

#include "viewport/Viewport.h"
#include "viewport/surface/MeshLayer.h"
#include "window/mesh/MeshTab.h"

namespace handwheel {

SectionView::SectionView(Viewport& viewport, MeshLayer& layer, QThreadPool& pool, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_layer(layer), m_cutting(JobRunner::Policy::Latest, pool) {
  connect(&m_viewport, &Viewport::clipPlaneChanged, this, &SectionView::cut);
}

void SectionView::setDocument(MeshTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_cutting.cancelAll();
  m_section.reset();  // the layer has another model by now
  m_document = document;
  if (!document) return;
  connect(&document->document, &MeshDocument::meshChanged, this, &SectionView::cut);
  connect(&document->document, &Document::fileChanged, this, &SectionView::changed);  // its unit
  cut();
}

void SectionView::cut() {
  if (!m_document) return;
  const ClipPlane& plane = m_viewport.clipPlane();
  if (!plane.on) {
    m_cutting.cancelAll();
    m_section.reset();
    show({});
    return emit changed();
  }
  Job job;
  job.name = tr("Cutting");
  job.work = [this, plane, mesh = m_document->document.mesh()](Progress progress) -> Job::Finish {
    Section section = sectionOf(mesh, plane.normal, plane.offset, progress);
    if (progress.cancelled()) return {};
    return [this, section = std::move(section)]() mutable {
      m_section = std::move(section);
      show(m_section);
      emit changed();
    };
  };
  m_cutting.start(std::move(job));
}

void SectionView::show(const std::optional<Section>& section) {
  std::vector<SectionMark> marks;
  if (section) {
    for (const SectionCurve& curve : section->curves) marks.push_back({curve.points, curve.closed});
  }
  m_layer.setSection(std::move(marks));
}

std::vector<Property> SectionView::statistics() const {
  if (!m_section || !m_document) return {};
  Property length;
  length.id = "section_length";
  length.label = QT_TRANSLATE_NOOP("Property", "Length of the outline");
  length.quantity = Quantity::Length;
  length.value = m_section->length;
  length.editable = false;
  if (m_section->curves.empty() && m_section->facesInPlane > 0)
    length.problem = QT_TRANSLATE_NOOP("Property", "the surface lies in the plane");
  if (!m_section->isClosed) {  // and has no area
    length.problem = QT_TRANSLATE_NOOP("Property", "the outline is open");
    return {length};
  }
  const LengthUnit unit = m_document->document.displayUnit();
  Property area = length;
  area.id = "section_area";
  area.label = tr("Area (%1)").arg(QLatin1String(symbolOf(unit)) + QStringLiteral("²")).toStdString();
  area.translated = false;
  area.quantity = Quantity::Number;
  area.value = m_section->area / (millimetresPer(unit) * millimetresPer(unit));
  return {length, area};
}

}  // namespace handwheel
