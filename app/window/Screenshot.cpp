// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/Screenshot.h"

#include "viewport/Viewport.h"
#include "window/MainWindow.h"

#include <QApplication>
#include <QPixmap>
#include <QTimer>

namespace handwheel {

namespace {
constexpr int kSettleMs = 100;
constexpr int kCalmLooks = 8;  // camera flights and uploads are over by then
constexpr QSize kSize(1280, 800);
}  // namespace

void takeScreenshot(MainWindow& window, const QString& path) {
  window.setWindowState(Qt::WindowNoState);
  window.resize(kSize);
  auto* timer = new QTimer(&window);
  QObject::connect(timer, &QTimer::timeout, &window, [&window, timer, path, calm = 0]() mutable {
    calm = window.isSettled() ? calm + 1 : 0;
    if (calm < kCalmLooks) return;
    timer->stop();
    if (auto* viewport = window.findChild<Viewport*>(); viewport && viewport->isVisible()) viewport->grabImage();
    QApplication::exit(window.grab().save(path) ? 0 : 1);
  });
  timer->start(kSettleMs);
}

}  // namespace handwheel
