// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/TargetPlacementView.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace handwheel {

namespace {
constexpr QSize kPlacePicture(440, 150);  // pixels, at most
}

TargetPlacementView::TargetPlacementView(QWidget* parent) : QWidget(parent), m_picture(new QLabel(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  m_picture->setObjectName(QStringLiteral("targetPlacePicture"));
  m_picture->setAlignment(Qt::AlignCenter);
  m_picture->setAccessibleName(tr("The target in its bar; the free end is on the right"));
  m_picture->setToolTip(tr("Grey: the target. Blue: what is cut off the bar"));
  grid->addWidget(m_picture, 0, 0, 1, 3);
  grid->addWidget(new QLabel(tr("← chuck"), this), 1, 0, Qt::AlignLeft);
  auto* turn = new QPushButton(tr("Turn &end for end"), this);
  turn->setObjectName(QStringLiteral("turnTarget"));
  turn->setToolTip(tr("Make the end at the chuck the free one, whose face is finished"));
  turn->setAutoDefault(false);
  grid->addWidget(turn, 1, 1, Qt::AlignCenter);
  grid->addWidget(new QLabel(tr("free end →"), this), 1, 2, Qt::AlignRight);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(2, 1);
  connect(turn, &QPushButton::clicked, this, &TargetPlacementView::turned);
}

void TargetPlacementView::setPicture(const QImage& picture) {
  setVisible(!picture.isNull());
  if (!picture.isNull())
    m_picture->setPixmap(QPixmap::fromImage(picture.convertToFormat(QImage::Format_RGB32)
                                                .scaled(kPlacePicture, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
}

}  // namespace handwheel
