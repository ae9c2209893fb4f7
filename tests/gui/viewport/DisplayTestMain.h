// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "TestClass.h"
#include "viewport/Viewport.h"
#include "viewport/surface/MeshLayer.h"
#include "viewport/surface/PartsLayer.h"

#include <QApplication>
#include <QtTest>
#include <memory>

namespace handwheel {

// A fixture with a new viewport of 600 × 500 pixels for each test. The viewport shows a mesh layer and a parts layer.
class ViewportFixture : public QObject {
  Q_OBJECT

 protected:
  std::unique_ptr<Viewport> m_view;
  std::shared_ptr<MeshLayer> m_mesh;
  std::shared_ptr<PartsLayer> m_parts;

  void clear() {
    m_mesh->clear();
    m_parts->setParts({});
  }

  void makeView() {
    m_view = std::make_unique<Viewport>();
    m_view->resize(600, 500);
    m_mesh = std::make_shared<MeshLayer>();
    m_parts = std::make_shared<PartsLayer>();
    m_view->addLayer(m_mesh);
    m_view->addLayer(m_parts);
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
  }

  // Waits until everything is built and no further frame is drawn.
  void settle() {
    m_view->grabImage();
    int frames = -1;
    while (frames != m_view->framesDrawn()) {
      frames = m_view->framesDrawn();
      QTest::qWait(250);
    }
  }

 private slots:
  void initTestCase() {
    qRegisterMetaType<handwheel::Pick>();
    Viewport probe;
    probe.resize(200, 150);
    probe.show();
    QVERIFY(QTest::qWaitForWindowExposed(&probe));
    QTRY_VERIFY(probe.isValid() || !probe.graphicsProblem().isEmpty());
    if (!probe.graphicsProblem().isEmpty()) QSKIP("the display offers no GLX");
  }

  void init() { makeView(); }

  void cleanup() { m_view.reset(); }
};

// Replaces the tests if there is no display to run them on.
class WithoutDisplay : public QObject {
  Q_OBJECT

 private slots:
  void viewport() { QSKIP("DISPLAY is not set: the viewport cannot be tested"); }
};

template <class Test>
int runOnDisplay(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("DISPLAY")) {
    WithoutDisplay skipped;
    return QTest::qExec(&skipped, argc, argv);
  }
  Viewport::prepareApplication();
  QApplication app(argc, argv);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace handwheel

#define HANDWHEEL_DISPLAY_TEST(Test) HANDWHEEL_TEST_RUN(Test, handwheel::runOnDisplay<Test>)
