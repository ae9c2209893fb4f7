// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/Scan.h"
#include "volume/segment/SegmentParts.h"
#include "window/volume/segmentation/SliceCanvas.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace handwheel {

class HistogramView;
class NumberField;

// What there is to say of a segment besides its parts.
struct SegmentStatistics {
  std::shared_ptr<const SegmentParts> parts;
  double faces = 0.0;  // facesOf(), mm²
};

// The controls of a segmentation. They are range, parts, smoothing, what the mouse does in the slices, greys, the
// surface. What is done comes out as signals. Window thread.
class SegmentationPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SegmentationPanel(QWidget* parent = nullptr);

  // What the brush is.
  struct Brush {
    SliceAction action = SliceAction::Look;
    double radius = 5.0;  // mm
    bool isBall = false;
  };
  // How the surface is made.
  struct Surface {
    double voxel = 1.0;  // mm
    bool isSmoothed = false;
  };

  void setScan(const std::shared_ptr<const Scan>& scan);
  void setSegment(const Segment& segment);
  // Null parts: they are being counted.
  void setFigures(const SegmentStatistics& figures);
  // They could not be counted: a surface can be made all the same.
  void setUncounted();
  void setGreys(const GreyWindow& greys);
  // The value and the place at the crosshair.
  void setPlace(const Vec3& index);
  Brush brush() const;
  void stepRadius(double factor);
  Surface surface() const;
  double surfaceBytes() const;  // that it is going to need; 0 until parts are counted

 signals:
  void rangeEdited(const handwheel::ValueRange& range, bool stillDragging);
  void firstPartsKept(int parts);  // the largest ones
  void smoothingRequested();
  void brushChanged();
  void greysEdited(const handwheel::GreyWindow& greys);
  void surfaceRequested();

 private:
  QWidget* makeRange();
  QWidget* makeParts();
  QWidget* makeActions();
  QWidget* makeGreys();
  QWidget* makeSurface();
  void take(const ValueRange& range, bool stillDragging);
  void showRange(const ValueRange& range);
  std::size_t debrisLimit() const;  // samples
  void showDebris();
  void showMemory();

  std::shared_ptr<const Scan> m_scan;
  Segment m_segment;
  SegmentStatistics m_figures;
  HistogramView* m_histogram;
  NumberField* m_lower;
  NumberField* m_upper;
  QList<QPushButton*> m_presets;  // of CTs alone
  QLabel* m_painted;
  QLabel* m_parts;
  QSpinBox* m_keep;
  QSlider* m_debris;
  QLabel* m_debrisText;
  QList<QPushButton*> m_ofParts;
  QButtonGroup* m_actions;
  NumberField* m_radius;
  QCheckBox* m_isBall;
  NumberField* m_level;
  NumberField* m_width;
  QLabel* m_place;
  NumberField* m_voxel;
  QCheckBox* m_isSmoothed;
  QLabel* m_memory;
  QPushButton* m_make;
};

}  // namespace handwheel
