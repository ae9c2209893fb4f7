// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/MemoryQuestion.h"

#include "process/SystemMemory.h"
#include "volume/VolumeMemory.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {
struct MemoryQuestionWords {
  Q_DECLARE_TR_FUNCTIONS(MemoryQuestion)
};
}  // namespace

void askForMemory(QWidget* window, double bytes, std::function<void()> start) {
  if (!needsConsent(bytes)) return start();
  auto* const box = new QMessageBox(window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName(QStringLiteral("memoryQuestion"));
  box->setIcon(QMessageBox::Question);
  box->setWindowTitle(MemoryQuestionWords::tr("Memory for the voxels"));
  box->setText(MemoryQuestionWords::tr("The voxels need %1. Make them all the same?").arg(memoryText(bytes)));
  box->setInformativeText(MemoryQuestionWords::tr(
      "That is more than a quarter, and other programs may become slow. Larger voxels need less."));
  QPushButton* const make = box->addButton(MemoryQuestionWords::tr("&Make them"), QMessageBox::AcceptRole);
  make->setObjectName(QStringLiteral("memoryAccept"));
  box->setDefaultButton(box->addButton(QMessageBox::Cancel));
  QObject::connect(box, &QMessageBox::finished, window, [box, make, start = std::move(start)] {
    if (box->clickedButton() == make) start();
  });
  box->open();
}

QString memoryText(double bytes) {
  const auto megabytes = [](double number) { return QLocale().toString(std::ceil(number / 1e6), 'f', 0); };
  return MemoryQuestionWords::tr("about %1 MB of %2 MB available")
      .arg(megabytes(bytes), megabytes(static_cast<double>(systemMemory())));
}

}  // namespace handwheel
