// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageHistogram.h"

#include <QWidget>

namespace handwheel {

// A histogram with a logarithmic scale and two handles for the ends of a range. A handle is dragged or moved by the
// arrow keys: left and right move it by a hundredth (with Ctrl by a thousandth), up and down select the other handle.
class HistogramView : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramView(QWidget* parent = nullptr);

  void setHistogram(const ImageHistogram& histogram);
  // Sets the range. The handle of an infinite end is shown at the end of the values.
  void setRange(const ValueRange& range);
  const ValueRange& range() const { return m_range; }

  QSize sizeHint() const override { return {260, 120}; }
  QSize minimumSizeHint() const override { return {120, 80}; }

 signals:
  // Signals that the user changes the range. stillDragging is true while a handle is dragged; the final range is sent
  // again with false.
  void rangeEdited(const handwheel::ValueRange& range, bool stillDragging);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Handle { Lower, Upper };

  double end(Handle handle) const;
  double positionOf(double value) const;  // pixels
  double valueAt(double x) const;
  void move(double value, bool stillDragging);

  ImageHistogram m_histogram;  // copy of the histogram with wider bins
  ValueRange m_range{0.0, 0.0};
  Handle m_handle = Handle::Lower;  // handle that keys and the mouse move
  bool m_isDragging = false;
};

}  // namespace handwheel
