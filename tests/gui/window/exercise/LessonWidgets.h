// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../WindowDriver.h"

#include <QLabel>

namespace handwheel::test {

// Returns a named widget in a lesson. lesson: the object name of the widget that shows the lesson, which is the page of
// a student's file or the panel beside the work.
template <class Widget>
Widget* partOfLesson(WindowDriver& driver, const char* lesson, const char* name) {
  auto* widget = driver.find<QWidget>(lesson)->findChild<Widget*>(QString::fromLatin1(name));
  if (!widget) qFatal("there is no %s", name);
  return widget;
}

inline QString labelsOf(QWidget* widget) {
  QString text;
  for (const QLabel* label : widget->findChildren<QLabel*>()) text += label->text() + QLatin1Char('\n');
  return text;
}

}  // namespace handwheel::test
