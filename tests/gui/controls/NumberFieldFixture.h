// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/NumberField.h"

#include <QApplication>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <cmath>
#include <memory>

namespace handwheel::test {

// A NumberField in a window, with a spy on its signal.
struct Fixture {
  explicit Fixture(Quantity quantity = Quantity::Length, LengthUnit unit = LengthUnit::Millimetre,
                   const QLocale& locale = QLocale::c()) {
    window.setLocale(locale);
    field = new NumberField(&window);
    other = new QLineEdit(&window);
    auto* column = new QVBoxLayout(&window);
    column->addWidget(field);
    column->addWidget(other);
    field->setQuantity(quantity, unit);
    field->setLabel("Diameter");
    line = field->findChild<QLineEdit*>("numberLine");
    spy = std::make_unique<QSignalSpy>(field, &NumberField::valueEdited);
    window.show();
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window)) qFatal("the window does not appear");
    line->setFocus();
  }
  void type(const QString& text) {
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
  }
  void enter(const QString& text) {
    type(text);
    QTest::keyClick(line, Qt::Key_Return);
  }
  // Returns the rounded values emitted since the previous call, each with a flag that is true if it was emitted during
  // dragging.
  QList<std::pair<double, bool>> said() {
    QList<std::pair<double, bool>> values;
    for (const QList<QVariant>& call : *spy) {
      values << std::pair(std::round(call[0].toDouble() * 1e9) / 1e9, call[1].toBool());
    }
    spy->clear();
    return values;
  }
  bool turnWheel(int notches, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF middle = line->rect().center();
    QWheelEvent event(middle, line->mapToGlobal(middle), {}, QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(line, &event);
    return event.isAccepted();
  }

  QWidget window;
  NumberField* field;
  QLineEdit* other;
  QLineEdit* line;
  std::unique_ptr<QSignalSpy> spy;
};

using Said = QList<std::pair<double, bool>>;

}  // namespace handwheel::test
