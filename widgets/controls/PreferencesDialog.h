// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "controls/Preferences.h"

class QFormLayout;
class QListWidget;
class QStackedWidget;

namespace handwheel {

class ShortcutModel;

// A preset of mouse navigation that the user can choose. The caller supplies the presets, because the dialog does not
// depend on the viewport.
struct NavigationChoice {
  QString id;
  QString name;
  QString description;  // "Middle: orbit, Shift+middle: pan"
};

// The dialog for keys, mouse, units, language and autosave. It is not modal; every change is stored and applied at
// once.
class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  PreferencesDialog(ShortcutModel* keys, std::vector<NavigationChoice> navigation, QWidget* parent = nullptr);

 signals:
  void changed(const handwheel::Preferences& preferences);

 private:
  QWidget* mousePage();
  void addSpaceMouse(QFormLayout* form);
  QWidget* unitsPage();
  QWidget* languagePage();
  QWidget* autosavePage();
  QWidget* soundPage();
  void addPage(const char* iconName, const QString& title, QWidget* page);
  void store();

  std::vector<NavigationChoice> m_navigation;
  Preferences m_preferences;
  QListWidget* m_titles;
  QStackedWidget* m_pages;
};

}  // namespace handwheel
