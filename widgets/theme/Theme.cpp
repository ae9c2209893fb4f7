// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "theme/Theme.h"

#include "theme/Restyling.h"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QProxyStyle>
#include <array>

namespace handwheel {

namespace {

const ThemeColours kLight = {
    .window = QColor(0xf3f4f6),
    .base = QColor(0xffffff),
    .raised = QColor(0xffffff),
    .hover = QColor(0xe6e9ee),
    .border = QColor(0xd3d7de),
    .text = QColor(0x1d2128),
    .muted = QColor(0x616975),
    .accent = QColor(0x2f6fde),
    .accentText = QColor(0xffffff),
    .success = QColor(0x0b7d5f),
    .warning = QColor(0x9a5b00),
    .error = QColor(0xc02a25),
};

const ThemeColours kDark = {
    .window = QColor(0x24272c),
    .base = QColor(0x1c1f23),
    .raised = QColor(0x30343b),
    .hover = QColor(0x373c44),
    .border = QColor(0x3d424b),
    .text = QColor(0xe4e7eb),
    .muted = QColor(0x9ba3af),
    .accent = QColor(0x4c8dff),
    .accentText = QColor(0x0b1220),
    .success = QColor(0x3ecf9f),
    .warning = QColor(0xf0b24a),
    .error = QColor(0xff6b63),
};

// The style Fusion, without the old pictures on the buttons of dialogs.
class PlainFusion final : public QProxyStyle {
 public:
  PlainFusion() : QProxyStyle(QStringLiteral("Fusion")) {}

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
};

QColor withAlpha(QColor colour, int alpha) {
  colour.setAlpha(alpha);
  return colour;
}

QPalette paletteOf(const ThemeColours& c) {
  QPalette p;
  p.setColor(QPalette::Window, c.window);
  p.setColor(QPalette::WindowText, c.text);
  p.setColor(QPalette::Base, c.base);
  p.setColor(QPalette::Text, c.text);
  p.setColor(QPalette::Button, c.raised);
  p.setColor(QPalette::ButtonText, c.text);
  p.setColor(QPalette::BrightText, c.error);
  p.setColor(QPalette::Highlight, c.accent);
  p.setColor(QPalette::HighlightedText, c.accentText);
  p.setColor(QPalette::ToolTipBase, c.raised);
  p.setColor(QPalette::ToolTipText, c.text);
  p.setColor(QPalette::PlaceholderText, c.muted);
  p.setColor(QPalette::Link, c.accent);
  p.setColor(QPalette::Mid, c.border);
  p.setColor(QPalette::Midlight, c.hover);
  p.setColor(QPalette::Dark, c.border);
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    p.setColor(QPalette::Disabled, role, withAlpha(c.muted, 140));
  }
  p.setColor(QPalette::Disabled, QPalette::Highlight, c.border);
  // Roles that nothing in the window draws with pass colours without a palette role to the style sheet.
  p.setColor(QPalette::Shadow, c.muted);
  p.setColor(QPalette::AlternateBase, withAlpha(c.accent, 56));
  p.setColor(QPalette::LinkVisited, c.success);
  p.setColor(QPalette::Light, c.warning);
  p.setColor(QPalette::Disabled, QPalette::Light, c.raised);
  return p;
}

// The words of the style sheet for the roles that paletteOf() gives them.
struct SheetWord {
  const char* word;
  const char* role;
};
constexpr std::array kSheetWords = {
    SheetWord{"@accentText", "highlighted-text"},
    SheetWord{"@accentSoft", "alternate-base"},
    SheetWord{"@accent", "highlight"},
    SheetWord{"@window", "window"},
    SheetWord{"@base", "base"},
    SheetWord{"@raised", "button"},
    SheetWord{"@hover", "midlight"},
    SheetWord{"@border", "mid"},
    SheetWord{"@text", "window-text"},
    SheetWord{"@muted", "shadow"},
    SheetWord{"@success", "link-visited"},
    SheetWord{"@warning", "light"},
    SheetWord{"@error", "bright-text"},
};

// Returns the style sheet, which is the same for both themes.
QString styleSheet() {
  QFile file(QStringLiteral(":/theme/handwheel.qss"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString sheet = QString::fromUtf8(file.readAll());
  for (const auto& [word, role] : kSheetWords) {
    sheet.replace(QLatin1String(word), QStringLiteral("palette(%1)").arg(QLatin1String(role)));
  }
  return sheet;
}

ThemeKind kindOf(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? ThemeKind::Dark : ThemeKind::Light;
}

}  // namespace

const ThemeColours& themeColours(ThemeKind kind) {
  return kind == ThemeKind::Dark ? kDark : kLight;
}

ThemeKind systemTheme() {
  return kindOf(QApplication::palette());
}

ThemeKind currentTheme() {
  return kindOf(QApplication::palette());
}

void applyTheme(QApplication& application, ThemeKind kind) {
  const bool isFirst = application.styleSheet().isEmpty();
  if (isFirst) application.setStyle(new PlainFusion);
  application.setPalette(paletteOf(themeColours(kind)));
  isFirst ? application.setStyleSheet(styleSheet()) : Restyling::restyle(application);
}

}  // namespace handwheel
