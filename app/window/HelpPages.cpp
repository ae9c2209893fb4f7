// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/HelpPages.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>
#include <utility>
#include <vector>

namespace handwheel {

namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(HelpPages)
};

std::vector<std::pair<QString, QString>> keys() {
  return {
      {Text::tr("Click"), Text::tr("select a hole")},
      {Text::tr("Double-click"), Text::tr("go to a hole")},
      {Text::tr("Middle drag"), Text::tr("orbit")},
      {Text::tr("Shift+middle drag"), Text::tr("pan")},
      {Text::tr("Wheel"), Text::tr("zoom to the cursor")},
      {Text::tr("N or Space"), Text::tr("next hole")},
      {Text::tr("Shift+N"), Text::tr("previous hole")},
      {Text::tr("Enter"), Text::tr("fill the selected hole")},
      {Text::tr("K"), Text::tr("keep the selected hole open")},
      {Text::tr("P"), Text::tr("preview on or off")},
      {Text::tr("Esc"), Text::tr("clear selection and preview")},
      {Text::tr("Ctrl+R"), Text::tr("repair all")},
      {Text::tr("F"), Text::tr("show the whole model")},
      {Text::tr("1 to 7"), Text::tr("front, back, right, left, top, bottom, isometric")},
      {Text::tr("Ctrl+O, Ctrl+S, Ctrl+Shift+S"), Text::tr("open, save, save as")},
      {Text::tr("Ctrl+Z, Ctrl+Shift+Z"), Text::tr("undo, redo")},
      {Text::tr("Ctrl+W, Ctrl+Q"), Text::tr("close the document, quit")},
  };
}

void showPage(QWidget& parent, const char* name, const QString& title, const QString& html, bool withSign) {
  auto* page = new QDialog(&parent);
  page->setObjectName(QString::fromLatin1(name));
  page->setWindowTitle(title);
  page->setAttribute(Qt::WA_DeleteOnClose);
  auto* text = new QLabel(html, page);
  text->setTextFormat(Qt::RichText);
  text->setTextInteractionFlags(Qt::TextBrowserInteraction);
  text->setOpenExternalLinks(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, page);
  QObject::connect(buttons, &QDialogButtonBox::rejected, page, &QDialog::close);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(24, 24, 24, 16);
  column->setSpacing(16);
  if (withSign) {
    auto* sign = new QLabel(page);
    sign->setPixmap(icon(QStringLiteral("handwheel"), themeColours(currentTheme()).accent)
                        .pixmap(QSize(48, 48), parent.devicePixelRatioF()));
    column->addWidget(sign);
  }
  column->addWidget(text);
  column->addWidget(buttons);
  page->show();
}

}  // namespace

void showKeys(QWidget& parent) {
  QString html = QStringLiteral("<table cellspacing='0' cellpadding='4'>");
  for (const auto& [key, effect] : keys()) {
    html += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>").arg(key, effect);
  }
  showPage(parent, "keysPage", Text::tr("Keys and mouse"), html + QStringLiteral("</table>"), false);
}

void showAbout(QWidget& parent) {
  const QString html = QStringLiteral("<h2>Handwheel %1</h2><p>%2</p><p>%3</p>")
                           .arg(QCoreApplication::applicationVersion(),
                                Text::tr("Repairs scanned meshes: finds their defects, fills their holes."),
                                Text::tr("Free software under the GNU General Public Licence, version 3 or later.<br>"
                                         "Built with Qt, VTK, CGAL and Eigen."));
  showPage(parent, "aboutPage", Text::tr("About Handwheel"), html, true);
}

}  // namespace handwheel
