// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/StateCard.h"

#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "WindowTestMain.h"
#include "panels/defects/DefectList.h"

#include <QLabel>
#include <QtTest>

using namespace handwheel;

class StateCardTest : public QObject {
  Q_OBJECT

 private slots:
  // Nothing is called watertight before its self-intersections were looked for.
  void isSoundOnceAllIsKnown() {
    const auto document = test::meshDocument(test::cube());
    DefectList defectList(*document);
    StateCard card;
    const auto text = [&](const char* label) { return card.findChild<QLabel*>(label)->text(); };
    card.showState(defectList);
    QCOMPARE(text("stateHeadline"), QString("Closed"));
    QVERIFY(!card.findChild<QLabel*>("stateHeadline")->property("good").toBool());
    const QString details = text("stateDetails").replace(QChar::Nbsp, ' ').replace(QChar(0x2011), '-');
    QVERIFY2(details.contains("self-intersections not known yet"), qPrintable(details));
    defectList.setSelfIntersections(document->revision(), {});
    card.showState(defectList);
    QCOMPARE(text("stateHeadline"), QString("Watertight"));
    QVERIFY(card.findChild<QLabel*>("stateHeadline")->property("good").toBool());
    defectList.setSelfIntersections(document->revision(), {{0, 6}});
    card.showState(defectList);
    QCOMPARE(text("stateHeadline"), QString("Self-intersecting"));
  }
};

HANDWHEEL_WINDOW_TEST(StateCardTest)
#include "StateCardTest.moc"
