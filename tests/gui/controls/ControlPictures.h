// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Accessibility.h"
#include "theme/Theme.h"

#include <QDir>
#include <QTest>

namespace handwheel::test {

// Checks a widget in both themes. No text may be cut; every control must have a name and be reached by Tab. The scale
// is taken from the environment variable QT_SCALE_FACTOR. If HANDWHEEL_PICTURES names a folder, pictures of the widget
// are stored in it for inspection.
inline void lookAt(QWidget& widget, const QString& name, const QStringList& mayBeUnreached = {}) {
  widget.show();
  QVERIFY(QTest::qWaitForWindowExposed(&widget));
  for (ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark}) {
    applyTheme(*qApp, theme);
    QTest::qWait(20);
    const QString folder = qEnvironmentVariable("HANDWHEEL_PICTURES");
    const QString file = QStringLiteral("%1-%2-%3.png")
                             .arg(name, theme == ThemeKind::Dark ? "dark" : "light")
                             .arg(widget.devicePixelRatioF());
    if (!folder.isEmpty()) QVERIFY(widget.grab().save(QDir(folder).filePath(file)));
    QCOMPARE(cutTexts(widget).join("\n"), QString());
  }
  QCOMPARE(withoutAccessibleName(widget).join("\n"), QString());
  const auto otherwise = [&](const QWidget* w) { return mayBeUnreached.contains(w->objectName()); };
  QCOMPARE(notReachedByTab(widget, otherwise).join("\n"), QString());
}

}  // namespace handwheel::test
