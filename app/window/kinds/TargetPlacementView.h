// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

class QLabel;

namespace handwheel {

// A picture of a target in its bar stock, with a button that turns it.
class TargetPlacementView : public QWidget {
  Q_OBJECT

 public:
  explicit TargetPlacementView(QWidget* parent = nullptr);

  // Sets the picture, in which the axis is horizontal and the free end is on the right. A null picture hides the view.
  void setPicture(const QImage& picture);

 signals:
  void turned();

 private:
  QLabel* m_picture;
};

}  // namespace handwheel
