// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/Scan.h"
#include "volume/segment/SegmentParts.h"
#include "window/volume/segmentation/SliceCanvas.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace handwheel {

class HistogramView;
class NumberField;

// Statistics of a segment.
struct SegmentStatistics {
  std::shared_ptr<const SegmentParts> parts;
  double faces = 0.0;  // area of the segment's boundary as from facesOf(), mm²
};

// The controls of a segmentation. They are for the range, parts, smoothing, the action of the mouse in the slices, the
// greys, and the surface. The panel reports actions by signals. All functions must be called on the window thread.
class SegmentationPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SegmentationPanel(QWidget* parent = nullptr);

  // The settings of the brush.
  struct Brush {
    SliceAction action = SliceAction::Look;
    double radius = 5.0;  // mm
    bool isBall = false;
  };
  // The settings of the surface.
  struct Surface {
    double voxel = 1.0;  // mm
    bool isSmoothed = false;
  };

  void setScan(const std::shared_ptr<const Scan>& scan);
  void setSegment(const Segment& segment);
  // Shows the statistics. If the parts are null, shows that they are still being counted.
  void setFigures(const SegmentStatistics& figures);
  // Shows that counting has failed. A surface can still be made.
  void setUncounted();
  // Shows whether the segment was changed after the volume was made from it.
  void setOlder(bool isOlder);
  void setGreys(const GreyWindow& greys);
  // Shows the value and the position at the crosshair.
  void setPosition(const Vec3& index);
  // Returns true if slices have the patient's left at the left.
  bool isLeftAtLeft() const;
  Brush brush() const;
  void stepRadius(double factor);
  Surface surface() const;
  double surfaceBytes() const;  // memory that the surface requires; 0: the parts are not counted yet

 signals:
  void rangeEdited(const handwheel::ValueRange& range, bool stillDragging);
  void firstPartsKept(int parts);  // emits the number of the largest parts to keep
  void smoothingRequested();
  void brushChanged();
  void greysEdited(const handwheel::GreyWindow& greys);
  void surfaceRequested();
  void sidesChanged(bool isLeftAtLeft);

 private:
  QWidget* makeRange();
  QWidget* makeParts();
  QWidget* makeActions();
  QWidget* makeGreys();
  QWidget* makeSurface();
  void take(const ValueRange& range, bool stillDragging);
  void showRange(const ValueRange& range);
  void fillLabels();
  void showLabel();
  std::size_t debrisLimit() const;  // largest part that counts as debris, in samples of the scan
  void showDebris();
  void showMemory();

  std::shared_ptr<const Scan> m_scan;
  Segment m_segment;
  SegmentStatistics m_figures;
  HistogramView* m_histogram;
  NumberField* m_lower;
  NumberField* m_upper;
  QList<QPushButton*> m_presets;  // shown only for CTs
  QPushButton* m_otsu;            // hidden for label maps
  QComboBox* m_labels;            // shown only for label maps
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
  QCheckBox* m_isLeftAtLeft;
  QLabel* m_position;
  NumberField* m_voxel;
  QCheckBox* m_isSmoothed;
  QLabel* m_memory;
  QLabel* m_older;
  QPushButton* m_make;
};

}  // namespace handwheel
