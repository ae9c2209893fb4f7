// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/volume/segmentation/SliceCanvas.h"

#include <QWidget>
#include <array>

class QBoxLayout;
class QLabel;
class QSlider;

namespace handwheel {

// Axial, coronal and sagittal slices of a scan with a common crosshair. Each has a slider. They are side by side, or
// one above the other if the panel is higher than wide. All functions must be called on the window thread.
class SlicesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SlicesPanel(QWidget* parent = nullptr);

  void setScan(const std::shared_ptr<const Scan>& scan);  // moves the crosshair to the centre
  void setSegment(const Segment& segment);
  void setGreys(const GreyWindow& greys);
  // Shows the patient's left at the left.
  void setMirrored(bool isMirrored);
  void setAction(SliceAction action, double radius);
  void setCrosshair(const Vec3& index);
  const Vec3& crosshair() const { return m_crosshair; }
  const std::array<SliceCanvas*, 3>& canvases() const { return m_canvases; }

 signals:
  void crosshairMoved(const handwheel::Vec3& index);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makePane(std::size_t plane);
  void showSlices();

  std::shared_ptr<const Scan> m_scan;
  Vec3 m_crosshair = Vec3::Zero();
  QBoxLayout* m_layout;
  std::array<SliceCanvas*, 3> m_canvases{};
  std::array<QSlider*, 3> m_sliders{};
  std::array<QLabel*, 3> m_labels{};
};

}  // namespace handwheel
