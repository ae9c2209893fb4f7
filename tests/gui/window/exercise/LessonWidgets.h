// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../WindowDriver.h"

#include <QLabel>

namespace handwheel::test {

// Returns a widget of a lesson. There are two lessons: the page of a student's file, and the panel beside the work.
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
