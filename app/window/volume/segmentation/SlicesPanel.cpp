// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/segmentation/SlicesPanel.h"

#include <QBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::array<const char*, 3> kNames{"axial", "coronal", "sagittal"};

QString titleOf(SlicePlane plane) {
  switch (plane) {
    case SlicePlane::Axial:
      return SlicesPanel::tr("Axial");
    case SlicePlane::Coronal:
      return SlicesPanel::tr("Coronal");
    case SlicePlane::Sagittal:
      return SlicesPanel::tr("Sagittal");
  }
  return {};
}

}  // namespace

SlicesPanel::SlicesPanel(QWidget* parent) : QWidget(parent), m_layout(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  setObjectName(QStringLiteral("slicesPanel"));
  m_layout->setContentsMargins(4, 4, 4, 4);
  m_layout->setSpacing(6);
  for (std::size_t i = 0; i < kSlicePlanes.size(); ++i) m_layout->addWidget(makePane(i), 1);
}

QWidget* SlicesPanel::makePane(std::size_t plane) {
  const QString name = QString::fromLatin1(kNames[plane]), title = titleOf(kSlicePlanes[plane]);
  auto* const pane = new QWidget(this);
  auto* const canvas = m_canvases[plane] = new SliceCanvas(kSlicePlanes[plane], pane);
  canvas->setObjectName(QStringLiteral("slice/") + name);
  canvas->setAccessibleName(title);
  canvas->setToolTip(
      tr("Wheel, Page up and down: slices. Right button: level and width of the greys. Ctrl+wheel, + and "
         "-: zoom; middle button: move. Shift+click, arrows: crosshair. Space: the chosen tool there."));
  auto* const slider = m_sliders[plane] = new QSlider(Qt::Horizontal, pane);
  slider->setObjectName(QStringLiteral("slider/") + name);
  slider->setAccessibleName(tr("%1 slice").arg(title));
  m_labels[plane] = new QLabel(title, pane);
  m_labels[plane]->setObjectName(QStringLiteral("sliceLabel/") + name);
  connect(slider, &QSlider::valueChanged, canvas, &SliceCanvas::goToSlice);
  connect(canvas, &SliceCanvas::crosshairMoved, this, [this](const Vec3& index) {
    setCrosshair(index);
    emit crosshairMoved(index);
  });
  auto* const row = new QHBoxLayout;
  row->addWidget(m_labels[plane]);
  row->addWidget(slider, 1);
  auto* const column = new QVBoxLayout(pane);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(canvas, 1);
  column->addLayout(row);
  return pane;
}

void SlicesPanel::setScan(const std::shared_ptr<const Scan>& scan) {
  m_scan = scan;
  for (SliceCanvas* canvas : m_canvases) canvas->setScan(scan);
  if (!scan) return;
  const std::array<int, 3>& size = scan->image.grid().size;
  setCrosshair(Vec3(size[0] / 2, size[1] / 2, size[2] / 2));
}

void SlicesPanel::setSegment(const Segment& segment) {
  for (SliceCanvas* canvas : m_canvases) canvas->setSegment(segment);
}

void SlicesPanel::setGreys(const GreyWindow& greys) {
  for (SliceCanvas* canvas : m_canvases) canvas->setGreys(greys);
}

void SlicesPanel::setMirrored(bool isMirrored) {
  for (SliceCanvas* canvas : m_canvases) canvas->setMirrored(isMirrored);
}

void SlicesPanel::setAction(SliceAction action, double radius) {
  for (SliceCanvas* canvas : m_canvases) canvas->setAction(action, radius);
}

void SlicesPanel::setCrosshair(const Vec3& index) {
  m_crosshair = index;
  for (SliceCanvas* canvas : m_canvases) canvas->setCrosshair(index);
  showSlices();
}

void SlicesPanel::showSlices() {
  if (!m_scan) return;
  for (std::size_t i = 0; i < m_canvases.size(); ++i) {
    const QSignalBlocker quiet(m_sliders[i]);
    m_sliders[i]->setRange(0, m_canvases[i]->view().slices - 1);
    m_sliders[i]->setValue(m_canvases[i]->slice());
    m_labels[i]->setText(tr("%1 %2 of %3")
                             .arg(titleOf(kSlicePlanes[i]))
                             .arg(m_canvases[i]->slice() + 1)
                             .arg(m_canvases[i]->view().slices));
  }
}

void SlicesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_layout->setDirection(width() >= height() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

}  // namespace handwheel
