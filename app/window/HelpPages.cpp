// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/HelpPages.h"

#include "controls/ActionText.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>
#include <utility>
#include <vector>

namespace handwheel {

namespace {

struct HelpPagesWords {
  Q_DECLARE_TR_FUNCTIONS(HelpPages)
};

// A heading with lines of keys and effects, as rows of a table.
struct Section {
  QString title;
  std::vector<std::pair<QString, QString>> lines;
};

void collect(const QList<QAction*>& actions, Section& section) {
  for (const QAction* action : actions) {
    if (action->menu()) {
      collect(action->menu()->actions(), section);
      continue;
    }
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
    if (!keys.isEmpty()) section.lines.emplace_back(keys.join(QStringLiteral(", ")), withoutMnemonic(action->text()));
  }
}

std::vector<Section> sectionsOf(const QMenuBar& menus, const std::vector<Hint>& now) {
  std::vector<Section> all{{HelpPagesWords::tr("Currently available"), {}}};
  for (const Hint& hint : now) all[0].lines.emplace_back(hint.input, hint.effect);
  for (const QAction* menu : menus.actions()) {
    if (!menu->menu() || !menu->isVisible()) continue;
    all.push_back({withoutMnemonic(menu->text()), {}});
    collect(menu->menu()->actions(), all.back());
  }
  std::erase_if(all, [](const Section& section) { return section.lines.empty(); });
  return all;
}

// The section with which a second column begins, so that the two are about as high.
std::size_t middleOf(const std::vector<Section>& sections) {
  const auto height = [&sections](std::size_t from, std::size_t to) {
    std::size_t lines = 0;
    for (std::size_t i = from; i < to; ++i) lines += sections[i].lines.size() + 1;
    return lines;
  };
  std::size_t middle = 0;
  while (middle < sections.size() && height(0, middle + 1) <= height(middle, sections.size())) ++middle;
  return middle;
}

QString columnOf(const std::vector<Section>& sections, std::size_t from, std::size_t to) {
  QString html = QStringLiteral("<td><table cellpadding='3'>");
  for (std::size_t i = from; i < to; ++i) {
    html += QStringLiteral("<tr><td colspan='2'><b>%1</b></td></tr>").arg(sections[i].title.toHtmlEscaped());
    for (const auto& [key, effect] : sections[i].lines) {
      html += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                  .arg(key.toHtmlEscaped(), effect.toHtmlEscaped());
    }
  }
  return html + QStringLiteral("</table></td>");
}

QString tableOf(const std::vector<Section>& sections) {
  const std::size_t middle = middleOf(sections);
  return QStringLiteral("<table><tr>") + columnOf(sections, 0, middle) + QStringLiteral("<td width='32'></td>") +
         columnOf(sections, middle, sections.size()) + QStringLiteral("</tr></table>");
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

void showKeys(QMainWindow& window, const std::vector<Hint>& now) {
  showPage(window, "keysPage", HelpPagesWords::tr("Keys and mouse"), tableOf(sectionsOf(*window.menuBar(), now)),
           false);
}

void showAbout(QMainWindow& window) {
  const QString html =
      QStringLiteral("<h2>Handwheel %1</h2><p>%2</p><p>%3</p>")
          .arg(QCoreApplication::applicationVersion(),
               HelpPagesWords::tr("Repairs scanned meshes, shapes and drills volumes, turns workpieces, plans robot "
                                  "cells, and sets and marks exercises."),
               HelpPagesWords::tr("Free software under the GNU General Public Licence, version 3 or later.<br>"
                                  "Built with Qt, VTK, CGAL, Open CASCADE, Eigen, libzip and expat."));
  showPage(window, "aboutPage", HelpPagesWords::tr("About Handwheel"), html, true);
}

}  // namespace handwheel
