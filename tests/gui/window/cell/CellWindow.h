// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../WindowDriver.h"
#include "controls/property/PropertyList.h"
#include "panels/bodies/BodyList.h"
#include "viewport/surface/PartsLayer.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QMimeData>
#include <memory>

namespace handwheel::test {

// A window with the sample robot and access to its bodies.
class CellWindow : public WindowDriver {
 public:
  CellWindow() {
    choose("openRobotSample");
    if (!settle()) qFatal("the sample does not open");
  }
  Viewport* view() { return find<Viewport>("viewport"); }
  // Fits the view at once, without the camera's flight.
  void showAll() {
    view()->fit();
    view()->setCamera(view()->camera());
  }
  QString figures() { return text("figures"); }

  // Returns the text of a field of the selected body in the panel of the cell; empty if it is not listed.
  QString field(const char* property) {
    const auto* line = lineOf(property);
    return line ? line->text() : QString();
  }
  // Edits a property in the panel of the cell, which follows the view.
  void editInPanel(const char* property, const QString& value) {
    auto* line = lineOf(property);
    if (!line) qFatal("%s is not in the panel", property);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, value);
    QTest::keyClick(line, Qt::Key_Return);
  }
  QLineEdit* lineOf(const char* property) {
    const QString name = QStringLiteral("property/") + QString::fromLatin1(property);
    for (auto* row : find<QDockWidget>("kindDock")->findChildren<QWidget*>(name)) {
      // A hidden row is about to be deleted; a new one is shown with the next event.
      const bool isLeaving = row->isHidden() && row->testAttribute(Qt::WA_WState_ExplicitShowHide);
      if (!isLeaving) return row->findChild<QLineEdit*>();
    }
    return nullptr;
  }

  // Returns a position in the view where this part is seen; null if there is none.
  QPoint pixelOf(const std::string& part) {
    if (!QTest::qWaitFor([this] { return view()->isPickingReady(); }, kPatienceMs)) return {};
    for (int y = 10; y < view()->height(); y += 6) {
      for (int x = 10; x < view()->width(); x += 6) {
        const ViewRay ray = view()->rayAt(QPointF(x, y));
        if (partOf(view()->pickAlong(ray.origin, ray.direction)) == part) return {x, y};
      }
    }
    return {};
  }

  BodyList* list() { return find<BodyList>("bodyList"); }
  BodyModel& rows() { return *qobject_cast<BodyModel*>(list()->model()); }
  int listedBodies() {
    int count = 0;
    for (BodyId id = 1; id < 100; ++id) count += rows().indexOf(id).isValid() ? 1 : 0;
    return count;
  }
  void clickRow(int row, BodyModel::Column column = BodyModel::Name) {
    const QModelIndex index = list()->model()->index(row, column);
    list()->scrollTo(index);
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualRect(index).center());
  }

  // Drags rows of the list onto another one, as a user who has pressed on one of them. Returns false if it is not
  // accepted there.
  bool dropOn(const QModelIndexList& bodies, const QModelIndex& onto) {
    const std::unique_ptr<QMimeData> data(rows().mimeData(bodies));
    list()->scrollTo(onto);
    const QPoint pixel = list()->visualRect(onto).center();
    QDragEnterEvent enter(pixel, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(list()->viewport(), &enter);
    QDragMoveEvent over(pixel, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(list()->viewport(), &over);
    QDropEvent drop(pixel, Qt::MoveAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(list()->viewport(), &drop);
    return enter.isAccepted() && over.isAccepted() && drop.isAccepted();
  }

  void move(const QPoint& to) {
    QMouseEvent moved(QEvent::MouseMove, to, view()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view(), &moved);
  }
};

}  // namespace handwheel::test
