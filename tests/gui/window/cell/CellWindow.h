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
  // Fits the view to the cell at once. The camera does not fly there.
  void showAll() {
    view()->fit();
    view()->setCamera(view()->camera());
  }
  // Makes the view small for tests that do not look at it, or large again. Software draws each of its pixels.
  void setViewSmall(bool isSmall) {
    const int unlimited = QWIDGETSIZE_MAX;
    view()->setMaximumSize(isSmall ? QSize(320, 240) : QSize(unlimited, unlimited));
    QTest::qWait(0);
  }
  QString figures() { return text("figures"); }

  QString latestStep() { return find<QAction>("undo")->text(); }
  // Takes the cell back to its state after this step, closes the messages and shows the whole cell.
  void takeBack(const QString& step) {
    release();
    while (latestStep() != step) click("quickActions/undo");
    QTest::qWait(0);  // Deletes the fields of bodies that no longer exist
    if (!settle()) qFatal("a step is not undone");
    closeMessages();
    showAll();
  }
  void closeMessages() {
    while (find<QWidget>("messageBar")->isVisible()) click("messageClose");
  }
  // Returns true if a message with this text is visible.
  bool says(const QString& message) {
    return find<QWidget>("messageBar")->isVisible() && text("messageText").contains(message);
  }

  // Returns the text of a field of the selected body in the panel of the cell. The text is empty if the panel does not
  // list the field.
  QString field(const char* property) {
    const auto* line = lineOf(property);
    return line ? line->text() : QString();
  }
  // Types the value of a property into its field in the panel of the cell.
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

  // Returns a pixel of the view that shows this part. The point is null if the part is not visible.
  QPoint pixelOf(const std::string& part) {
    const Viewport& seen = *view();  // It takes longer to find the view than to pick in it
    if (!QTest::qWaitFor([&seen] { return seen.isPickingReady(); }, kPatienceMs)) return {};
    for (int y = 10; y < seen.height(); y += 6) {
      for (int x = 10; x < seen.width(); x += 6) {
        const ViewRay ray = seen.rayAt(QPointF(x, y));
        if (partOf(seen.pickAlong(ray.origin, ray.direction)) == part) return {x, y};
      }
    }
    return {};
  }

  BodyList* list() { return find<BodyList>("bodyList"); }
  BodyModel& rows() { return *qobject_cast<BodyModel*>(list()->model()); }
  int listedBodies() {
    const BodyModel& model = rows();
    int count = 0;
    for (BodyId id = 1; id < 100; ++id) count += model.indexOf(id).isValid() ? 1 : 0;
    return count;
  }
  void clickRow(int row, BodyModel::Column column = BodyModel::Name) {
    const QModelIndex index = list()->model()->index(row, column);
    list()->scrollTo(index);
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualRect(index).center());
  }

  // Drags rows of the list onto another row, as a user does with the mouse. Returns false if the list does not accept
  // the drop.
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

// A window that several tests of a class share. Each of them begins with the cell in its state after the window was
// made.
template <class Window>
class SharedWindow {
 public:
  Window& begin() {
    if (m_window) {
      m_window->takeBack(m_step);
    } else {
      m_window = std::make_unique<Window>();
      m_step = m_window->latestStep();
    }
    return *m_window;
  }
  // Returns a new window. The tests after this one share it.
  Window& beginAnew() {
    end();
    return begin();
  }
  // Tests that make a window of their own call this first: only one exists at a time.
  void end() { m_window.reset(); }

 private:
  std::unique_ptr<Window> m_window;
  QString m_step;
};

}  // namespace handwheel::test
