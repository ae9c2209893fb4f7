// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

class QLabel;

namespace handwheel {

// A picture of a target in its bar, with a button that turns it.
class TargetPlaceView : public QWidget {
  Q_OBJECT

 public:
  explicit TargetPlaceView(QWidget* parent = nullptr);

  // picture: the axis is horizontal, and the free end is on the right. Null: the view hides, as there is none.
  void setPicture(const QImage& picture);

 signals:
  void turned();

 private:
  QLabel* m_picture;
};

}  // namespace handwheel
